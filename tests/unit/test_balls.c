/* SPDX-License-Identifier: MIT */
/*
 * Balls by the row cover the pixels that they cover one by one, from near and far and in parallel;
 * which are too close to the eye for that is said of each.
 */
#define DICE_SEED 5

#include <stdio.h>

#include "check.h"
#include "crowd/balls.h"
#include "dice.h"
#include "pack/ball.h"

enum { num_rows = 300, width = 640, height = 200 };

static struct csg_vec3 random_direction(void)
{
    const double x = random_between(-1, 1), y = random_between(-1, 1), z = random_between(-1, 1);
    return csg_normalize(csg_vec3(x, y, z));
}

/* From anywhere, past the middle of the scene, the picture turned by any angle. */
static struct csg_screen random_screen(void)
{
    const bool orthographic = random_between(0, 1) < 0.3;
    const double half = orthographic ? random_between(1, 9) : random_between(0.1, 1);
    const struct csg_vec3 side = random_direction(), forward = random_direction();
    const struct csg_vec3 right = csg_normalize(csg_cross(forward, side));
    const struct csg_vec3 up = csg_cross(right, forward);
    const double x = random_between(-2, 2), y = random_between(-2, 2);
    const struct csg_vec3 eye =
        csg_add(csg_scale(-10, forward), csg_add(csg_scale(x, right), csg_scale(y, up)));
    const struct csgcast_frustum frustum = {.eye = {eye.x, eye.y, eye.z},
                                            .right = {right.x, right.y, right.z},
                                            .up = {up.x, up.y, up.z},
                                            .forward = {forward.x, forward.y, forward.z},
                                            .half_width = half,
                                            .half_height = half * height / width,
                                            .orthographic = orthographic};
    const struct csg_box box = {{-5, -5, -5}, {5, 5, 5}};
    struct csg_screen screen;
    csg_screen_init(&screen, &frustum, width, height, &box, true);
    return screen;
}

static bool is_plain(const struct csg_screen *screen, const struct csg_seen_ball *ball)
{
    const double square = ball->c[0] * ball->c[0] + ball->c[1] * ball->c[1] + ball->t * ball->t;
    return screen->orthographic || (ball->t > CSG_BALL_FRONT * ball->radius &&
                                    sqrt(square) >= CSG_BALL_NEAR * ball->radius);
}

/* Whether it covers a pixel. */
static bool check_ball(const struct csg_camera *camera, const struct csg_seen_ball *ball, size_t i,
                       const struct csg_ball_prints *prints)
{
    struct csg_footprint one;
    const bool shows = csg_outline_project(camera, CSG_OUTLINE_BALL, NULL, ball, &one);
    const bool shown = prints->lo[0][i] <= prints->hi[0][i] && prints->lo[1][i] <= prints->hi[1][i];
    CHECK(shows == shown, "ball %zu: %d and %d", i, shows, shown);
    for (int axis = 0; axis < 2 && shows && shown; axis++)
        CHECK(one.lo[axis] == prints->lo[axis][i] && one.hi[axis] == prints->hi[axis][i],
              "ball %zu: from %d to %d and from %d to %d", i, one.lo[axis], one.hi[axis],
              (int)prints->lo[axis][i], (int)prints->hi[axis][i]);
    CHECK(!shows || fabs(one.near - prints->near[i]) < 1e-9, "ball %zu: begins at %g", i,
          prints->near[i]);
    return shows;
}

int main(void)
{
    double at[4][CSG_BALLS_MAX];
    size_t num_shown = 0, num_close = 0;
    for (int row = 0; row < num_rows; row++) {
        const struct csg_screen screen = random_screen();
        const struct csg_camera camera = csg_camera_of(&screen);
        const size_t num = row % 3 ? CSG_BALLS_MAX : (size_t)(row / 3 % CSG_BALLS_MAX);
        struct csg_ball_prints prints;
        for (size_t i = 0; i < num; i++)
            for (int j = 0; j < 4; j++)
                at[j][i] = j < 3 ? random_between(-11, 11) : exp(random_between(-7, 1));
        csg_balls_project(&camera, at[0], at[1], at[2], at[3], num, &prints);
        for (size_t i = 0; i < num; i++) {
            const struct csg_seen_ball ball =
                csg_camera_see(&camera, csg_vec3(at[0][i], at[1][i], at[2][i]), at[3][i]);
            CHECK(is_plain(&screen, &ball) == (prints.plain[i] != 0), "row %d, ball %zu: %d", row,
                  i, (int)prints.plain[i]);
            if (prints.plain[i])
                num_shown += check_ball(&camera, &ball, i, &prints);
            else
                num_close++;
        }
    }
    CHECK(num_shown > 1000 && num_close > 100, "only %zu show, %zu are close", num_shown,
          num_close);
    if (num_failed)
        fprintf(stderr, "%d checks failed\n", num_failed);
    return num_failed != 0;
}
