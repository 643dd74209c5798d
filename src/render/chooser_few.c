/* SPDX-License-Identifier: MIT */

/*
 * A picture alone takes few programs: each takes a driver that knows it from its cache some
 * milliseconds, llvmpipe that has never met it 50 to 150. What draws few pixels is drawn by the
 * loop, which draws everything.
 */

#include <stdlib.h>

#include "render/chooser_parts.h"

/* The loop takes up to 0.2 us longer for a pixel, a program from the cache 2 ms or more. */
#define MIN_PIXELS 3e4

/* Of squares that are drawn as points, for which llvmpipe compiles the vertex stage once more: as
 * rectangles so many take as long as that. */
#define MIN_POINTS 1000

/* The features of a loop that draws the same. */
static int loop_features(const struct csg_way *way)
{
    return CSG_FEATURE_QUADRIC | CSG_FEATURE_GAP | way->features;
}

/* Records of bands depend on whether there are stiff quadrics, see chooser_programs.c. */
static bool can_be_looped(const struct csg_way *way)
{
    return (way->resolver == CSG_RESOLVER_STRAIGHT || way->resolver == CSG_RESOLVER_CHAIN ||
            way->resolver == CSG_RESOLVER_LOOP || way->resolver == CSG_RESOLVER_SURFACE) &&
           !(way->features & (CSG_FEATURE_DOUBLE | CSG_FEATURE_BANDS));
}

static bool is_small(const struct csg_few_way *way)
{
    return way->pixels < MIN_PIXELS && can_be_looped(&way->way);
}

/* The number of the draw's structure, where it has a program of its own; else 0. */
static GLuint structure_of(const struct csg_chooser *chooser, const struct csg_draw *draw,
                           const struct csg_way *way)
{
    if (way->resolver != CSG_RESOLVER_STRAIGHT)
        return 0;
    const struct csg_structure structure = csg_chooser_structure(chooser->request, draw->object);
    const struct csg_known_structure *known =
        csg_structures_find(&chooser->few.structures, &structure, draw->stiff);
    return known ? known->program : 0;
}

static struct csg_few_way *find(const struct csg_chooser *chooser, const struct csg_draw *draw,
                                const struct csg_way *way)
{
    const struct csg_few *few = &chooser->few;
    const GLuint structure = structure_of(chooser, draw, way);
    for (size_t i = 0; i < few->ways.num; i++) {
        struct csg_few_way *other = &few->ways.data[i];
        if (other->way.resolver == way->resolver && other->way.features == way->features &&
            other->way.chain == way->chain && other->structure == structure)
            return other;
    }
    return NULL;
}

/* false: out of memory. */
static bool add_way(struct csg_chooser *chooser, const struct csg_draw *draw,
                    const struct csg_way *way)
{
    struct csg_few *few = &chooser->few;
    struct csg_few_way added = {.way = *way};
    if (way->resolver == CSG_RESOLVER_STRAIGHT && structure_of(chooser, draw, way) == 0) {
        const struct csg_structure structure =
            csg_chooser_structure(chooser->request, draw->object);
        added.structure = (GLuint)few->structures.num + 1;
        csg_structures_add(&few->structures, &structure, draw->stiff, added.structure);
    }
    return csg_array_push(&few->ways, added);
}

static double pixels_of(const struct csg_chooser *chooser, const struct csg_draw *draw)
{
    const float *rect = draw->instance.rect;
    return 0.25 * ((double)rect[2] - (double)rect[0]) * ((double)rect[3] - (double)rect[1]) *
           chooser->request->width * chooser->request->height;
}

/* Structures that there is no room for are drawn by the loop anyway. */
static bool count(struct csg_chooser *chooser, const struct csg_draw *draw)
{
    const struct csg_way way = csg_chooser_way(chooser, draw);
    struct csg_few_way *known = find(chooser, draw, &way);
    const bool has_room = way.resolver != CSG_RESOLVER_STRAIGHT ||
                          chooser->few.structures.num < CSG_MAX_STRAIGHT_PROGRAMS;
    if (!known && !has_room)
        return true;
    if (!known && !add_way(chooser, draw, &way))
        return false;
    known = known ? known : &chooser->few.ways.data[chooser->few.ways.num - 1];
    known->pixels += pixels_of(chooser, draw);
    return true;
}

/* A loop that draws much, and could draw all that is small: -1: there is none. */
static int find_host(const struct csg_few *few, int needed)
{
    for (size_t i = 0; i < few->ways.num; i++) {
        const struct csg_few_way *way = &few->ways.data[i];
        if (way->way.resolver == CSG_RESOLVER_LOOP && !is_small(way) &&
            !(needed & ~way->way.features))
            return way->way.features;
    }
    return -1;
}

/* One small program alone is as good as a loop. */
static int find_loop(const struct csg_few *few)
{
    int needed = 0, num = 0;
    for (size_t i = 0; i < few->ways.num; i++) {
        const struct csg_few_way *way = &few->ways.data[i];
        num += is_small(way);
        needed |= is_small(way) ? loop_features(&way->way) : 0;
    }
    const int host = num > 0 ? find_host(few, needed) : -1;
    return host >= 0 || num < 2 ? host : needed;
}

bool csg_few_find(struct csg_chooser *chooser)
{
    const struct csg_frame *frame = &chooser->renderer->frame;
    size_t num_squares = 0;
    chooser->few.features = -1;
    if (!chooser->request->shared || chooser->request->scene->keeps_structure)
        return true;
    for (size_t i = 0; i < frame->draws.num; i++) {
        num_squares += frame->draws.data[i].instance.side > 0;
        if (!count(chooser, &frame->draws.data[i]))
            return false;
    }
    chooser->few.features = find_loop(&chooser->few);
    chooser->few.no_points = num_squares < MIN_POINTS;
    return true;
}

struct csg_way csg_few_way(const struct csg_chooser *chooser, const struct csg_draw *draw,
                           struct csg_way way)
{
    const struct csg_few_way *known = chooser->few.features >= 0 ? find(chooser, draw, &way) : NULL;
    if (!known || !is_small(known))
        return way;
    return (struct csg_way){CSG_RESOLVER_LOOP, chooser->few.features, -1};
}
