/* SPDX-License-Identifier: MIT */
#include "crowd/cull.h"

#include <stdlib.h>
#include <string.h>

#include "common/parallel.h"
#include "crowd/occlusion.h"
#include "pack/ball.h"
#include "pack/precision.h"

/* Part of a pixel by which bounds grow: rounding, here and in the vertex stage. */
#define MARGIN 0.01

/* The camera: a point's c = p - origin has the pixel (c.x / t) scale - shift in perspective. */
struct camera {
    struct csg_vec3 origin, axis[2], forward;
    double scale[2], shift[2]; /* pixels per unit (perspective: of the tangent) */
    double size[2];
    double lo[2], hi[2];           /* tangents of the picture's borders */
    double lo_norm[2], hi_norm[2]; /* lengths of the border planes' normals */
};

static struct camera camera_of(const struct csg_screen *screen)
{
    const bool flat = screen->orthographic;
    const struct csg_vec3 steps[2] = {flat ? screen->origin_dx : screen->direction_dx,
                                      flat ? screen->origin_dy : screen->direction_dy};
    struct camera camera = {.origin = screen->origin,
                            .forward = screen->forward,
                            .size = {screen->width, screen->height}};
    for (int i = 0; i < 2; i++) {
        const double step = csg_length(steps[i]);
        camera.axis[i] = csg_scale(1 / step, steps[i]);
        camera.scale[i] = 1 / step;
        camera.shift[i] = flat ? 0 : csg_dot(screen->direction, camera.axis[i]) / step;
        camera.lo[i] = camera.shift[i] * step;
        camera.hi[i] = camera.lo[i] + camera.size[i] * step;
        camera.lo_norm[i] = sqrt(1 + camera.lo[i] * camera.lo[i]);
        camera.hi_norm[i] = sqrt(1 + camera.hi[i] * camera.hi[i]);
    }
    return camera;
}

/* A ball in the camera's axes. */
struct ball {
    double c[2], t, radius;
};

static bool crosses_picture(const struct camera *camera, const struct ball *ball)
{
    for (int i = 0; i < 2; i++)
        if (ball->c[i] - camera->hi[i] * ball->t > ball->radius * camera->hi_norm[i] ||
            camera->lo[i] * ball->t - ball->c[i] > ball->radius * camera->lo_norm[i])
            return false;
    return true;
}

/* The pixels whose centres lie between; false: none. */
static bool pixel_range(double lo, double hi, double size, int16_t *first, int16_t *last)
{
    lo = ceil(lo - 0.5 - MARGIN);
    hi = floor(hi - 0.5 + MARGIN);
    lo = lo > 0 ? lo : 0;
    hi = hi < size - 1 ? hi : size - 1;
    if (!(lo <= hi))
        return false;
    *first = (int16_t)lo;
    *last = (int16_t)hi;
    return true;
}

enum verdict { DROPPED, SEEN, DEMOTED };

/*
 * In the plane of an axis and forward the ball is a disc around (c, t); its tangents from the eye
 * have the slopes (c t -+ r sqrt(c^2 + q)) / q, q = t^2 - r^2.
 */
static enum verdict look_at(const struct csg_cull *cull, const struct camera *camera,
                            const struct ball *ball, struct csg_candidate *out)
{
    const double r = ball->radius, t = ball->t;
    double reach[2] = {r, r}, middle[2] = {ball->c[0], ball->c[1]};
    if (!cull->screen->orthographic) {
        const double q = t * t - r * r, near = CSG_BALL_NEAR * r;
        if (t < -r)
            return DROPPED;
        if (!(t > CSG_BALL_FRONT * r) ||
            ball->c[0] * ball->c[0] + ball->c[1] * ball->c[1] + t * t < near * near)
            return crosses_picture(camera, ball) ? DEMOTED : DROPPED;
        for (int i = 0; i < 2; i++) {
            reach[i] = r * sqrt(ball->c[i] * ball->c[i] + q) / q;
            middle[i] = ball->c[i] * t / q;
        }
    }
    for (int i = 0; i < 2; i++) {
        const double x = middle[i] * camera->scale[i] - camera->shift[i];
        const double w = reach[i] * camera->scale[i];
        if (!pixel_range(x - w, x + w, camera->size[i], &out->lo[i], &out->hi[i]))
            return DROPPED;
    }
    const double range[2] = {t - r, t + r};
    if (!cull->all_in_float &&
        !csg_precision_suffices(cull->screen, range, (double)cull->crowd->need[out->member]))
        return DEMOTED;
    out->key = csg_occlusion_near(cull->screen, t - r);
    return SEEN;
}

/* A solid that is no ball covers less. */
static bool shrink(const struct csg_cull *cull, struct csg_candidate *candidate)
{
    const struct csg_shape *shape =
        &cull->scene->leaves[cull->crowd->leaf[candidate->member]].shape;
    const struct csg_rect rect = csg_screen_rect(cull->screen, &shape->frame, &shape->bounds);
    const double size[2] = {cull->screen->width, cull->screen->height};
    for (int i = 0; i < 2; i++) {
        int16_t lo, hi;
        if (!pixel_range(rect.lo[i], rect.hi[i], size[i], &lo, &hi))
            return false;
        candidate->lo[i] = lo > candidate->lo[i] ? lo : candidate->lo[i];
        candidate->hi[i] = hi < candidate->hi[i] ? hi : candidate->hi[i];
        if (candidate->lo[i] > candidate->hi[i])
            return false;
    }
    return true;
}

static void look_at_block(void *user, size_t task)
{
    struct csg_cull *cull = user;
    const struct csg_crowd *crowd = cull->crowd;
    const struct camera camera = camera_of(cull->screen);
    struct csg_crowd_block *block = &cull->blocks.data[task];
    const bool balls = crowd->classes[block->class].ball;
    block->num = 0;
    for (uint32_t i = block->begin; i < block->end; i++) {
        const struct csg_vec3 c =
            csg_sub(csg_vec3(crowd->x[i], crowd->y[i], crowd->z[i]), camera.origin);
        const struct ball ball = {{csg_dot(c, camera.axis[0]), csg_dot(c, camera.axis[1])},
                                  csg_dot(c, camera.forward),
                                  crowd->radius[i]};
        struct csg_candidate *candidate = &cull->candidates[block->begin + block->num];
        candidate->member = i;
        const enum verdict verdict = look_at(cull, &camera, &ball, candidate);
        cull->demoted[i] = verdict == DEMOTED;
        block->num += verdict == SEEN && (balls || shrink(cull, candidate));
    }
}

static void hide_block(void *user, size_t task)
{
    struct csg_cull *cull = user;
    struct csg_crowd_block *block = &cull->blocks.data[task];
    struct csg_candidate *candidates = cull->candidates + block->begin;
    uint32_t num = 0;
    for (uint32_t i = 0; i < block->num; i++)
        if (csg_occlusion_shows(cull, &candidates[i]))
            candidates[num++] = candidates[i];
    block->num = num;
}

static bool plan_blocks(struct csg_cull *cull)
{
    cull->blocks.num = 0;
    for (uint32_t i = 0; i < cull->crowd->num_classes; i++) {
        const struct csg_crowd_class *class = &cull->crowd->classes[i];
        for (size_t begin = class->begin; begin < class->end; begin += CSG_CROWD_BLOCK) {
            const size_t end = begin + CSG_CROWD_BLOCK;
            const struct csg_crowd_block block = {
                i, (uint32_t)begin, (uint32_t)(end < class->end ? end : class->end), 0};
            if (!csg_array_push(&cull->blocks, block))
                return false;
        }
    }
    return true;
}

/* What suffices for the finest member over all depths suffices for each over its own. */
static bool are_all_in_float(const struct csg_cull *cull)
{
    double range[2];
    csg_depth_range(cull->screen, &cull->scene->box, range);
    return range[1] > range[0] &&
           csg_precision_suffices(cull->screen, range, (double)cull->crowd->least_need);
}

bool csg_cull_run(struct csg_cull *cull)
{
    const size_t num = cull->crowd->num;
    cull->candidates = malloc((num + 1) * sizeof *cull->candidates);
    cull->demoted = malloc(num + 1);
    if (!cull->candidates || !cull->demoted || !plan_blocks(cull))
        return false;
    cull->all_in_float = are_all_in_float(cull);
    csg_parallel(cull->blocks.num, look_at_block, cull);
    if (!csg_occlusion_draw(cull))
        return false;
    if (cull->keys)
        csg_parallel(cull->blocks.num, hide_block, cull);
    return true;
}

void csg_cull_finish(struct csg_cull *cull)
{
    free(cull->blocks.data);
    free(cull->candidates);
    free(cull->demoted);
    free(cull->keys);
    free(cull->occluders);
}
