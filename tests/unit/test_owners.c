/* SPDX-License-Identifier: MIT */
/*
 * Owners of pixels: at each pixel the sphere that is the nearest in double is its owner, or is
 * drawn by itself in a rectangle that holds the pixel. Small spheres, large ones, and some that
 * coincide or nearly do.
 */
#define DICE_SEED 11

#include <csgcast/csgcast.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "crowd/cull.h"
#include "dice.h"

enum { num_spheres = 3000, size = 200 };

static struct csgcast_scene *random_scene(void)
{
    static char text[num_spheres * 120];
    size_t num = 0;
    double r = 0, x = 0, y = 0, z = 0;
    for (int i = 0; i < num_spheres; i++) {
        if (i % 20 == 9) {
            r *= 1 + 1e-7;         /* the last one, nearly */
        } else if (i % 20 != 19) { /* the last one again */
            r = i % 50 == 0 ? random_between(0.3, 0.6) : random_between(0.02, 0.15);
            x = random_between(-2, 2);
            y = random_between(-2, 2);
            z = random_between(-2, 2);
        }
        num += (size_t)snprintf(text + num, sizeof text - num,
                                "multmatrix([[1,0,0,%.6g],[0,1,0,%.6g],[0,0,1,%.6g],[0,0,0,1]]) "
                                "sphere(r = %.12g);\n",
                                x, y, z, r);
    }
    return csgcast_scene_parse(text, num, NULL);
}

/* From outside, and in parallel. */
static struct csg_frame frame_of(const struct csgcast_scene *scene, bool orthographic)
{
    const double half = orthographic ? 2.4 : 0.4;
    const struct csgcast_frustum frustum = {.eye = {0, -8, 0.3},
                                            .right = {1, 0, 0},
                                            .up = {0, 0, 1},
                                            .forward = {0, 1, 0},
                                            .half_width = half,
                                            .half_height = half,
                                            .orthographic = orthographic};
    struct csg_frame frame = {.at = {size / 2, size / 2}, .num_threads = 2};
    csg_screen_init(&frame.screen, &frustum, size, size, &scene->box, true);
    return frame;
}

/* Of a ball's terms, in double; infinite: missed. */
static double key_of(const float *terms, double dx, double dy)
{
    const double x = (double)terms[4] + (double)terms[5] * dx + (double)terms[6] * dy;
    const double y = (double)terms[8] + (double)terms[5] * dy - (double)terms[6] * dx;
    const double h = (double)terms[7] + (double)terms[11] * y * y - x * x;
    const double m = (double)terms[0] + (double)terms[1] * dx + (double)terms[2] * dy;
    return h < 0 ? INFINITY : m - sqrt(h);
}

struct pixel {
    double key;
    uint32_t member;
};

static void cast_all(struct csg_cull *cull, struct pixel *pixels)
{
    const struct csg_frame *frame = cull->view.frame;
    float terms[12];
    for (int i = 0; i < size * size; i++)
        pixels[i] = (struct pixel){INFINITY, CSG_NOBODY};
    for (uint32_t member = 0; member < cull->view.crowd->num; member++) {
        csg_member_terms(&cull->view, &cull->view.crowd->classes[0], member, terms);
        for (int i = 0; i < size * size; i++) {
            const double key =
                key_of(terms, i % size + 0.5 - frame->at.x, (double)(i / size) + 0.5 - frame->at.y);
            if (key < pixels[i].key)
                pixels[i] = (struct pixel){key, member};
        }
    }
}

/* Whether the member is drawn by itself where that pixel is. */
static bool is_covered(const struct csg_cull *cull, const struct csg_candidate *const *by_member,
                       uint32_t member, int x, int y)
{
    const struct csg_candidate *c = by_member[member];
    return c && c->by_rect && !cull->demoted[member] && c->lo[0] <= x && x <= c->hi[0] &&
           c->lo[1] <= y && y <= c->hi[1];
}

static void check_view(const struct csgcast_scene *scene, bool orthographic)
{
    static struct pixel pixels[size * size];
    static const struct csg_candidate *by_member[num_spheres];
    const struct csg_frame frame = frame_of(scene, orthographic);
    struct csg_cull cull = {.view = {scene, scene->crowd, &frame, true}, .max_owners = size * size};
    size_t num_owned = 0, num_covered = 0;
    CHECK(csg_cull_run(&cull), "no memory");
    CHECK(cull.relief.owners, "no owners");
    memset(by_member, 0, sizeof by_member);
    for (size_t i = 0; i < cull.blocks.num; i++)
        for (uint32_t j = 0; j < cull.blocks.data[i].num; j++) {
            const struct csg_candidate *c = &cull.candidates[cull.blocks.data[i].begin + j];
            by_member[c->member] = c;
        }
    cast_all(&cull, pixels);
    for (int i = 0; i < size * size && cull.relief.owners; i++) {
        const int x = i % size, y = i / size;
        const uint32_t member = pixels[i].member;
        const uint32_t who = cull.owners.who[(size_t)y * cull.owners.stride + (size_t)x];
        if (member == CSG_NOBODY)
            continue;
        const bool owned = who == member && by_member[member] && by_member[member]->owns;
        const bool covered = is_covered(&cull, by_member, member, x, y);
        num_owned += owned;
        num_covered += covered;
        CHECK(owned || covered, "pixel %d %d: not drawn (%u, owner %u)", x, y, (unsigned)member,
              (unsigned)who);
    }
    CHECK(num_owned > size * size / 10, "only %zu pixels are owned", num_owned);
    CHECK(num_covered > size * size / 100, "only %zu pixels are covered", num_covered);
    csg_cull_finish(&cull);
}

int main(void)
{
    struct csgcast_scene *scene = random_scene();
    CHECK(scene && scene->crowd->num == num_spheres, "no crowd");
    if (!num_failed) {
        check_view(scene, false);
        check_view(scene, true);
    }
    csgcast_scene_destroy(scene);
    if (num_failed)
        fprintf(stderr, "%d checks failed\n", num_failed);
    return num_failed != 0;
}
