/* SPDX-License-Identifier: MIT */
#include "pack/choice.h"

#include "cells/bunch.h"
#include "cells/store.h"
#include "pack/walk.h"
#include "tile/tile.h"

/* Smaller objects are drawn in tiles whatever they are. */
#define MIN_CELL_LEAVES 200

/* Solids a pixel is tested against in tiles, from which on cells are faster: in bunches, in rows of
 * solids, and in nested trees, which need a stack. */
#define MAX_TESTS_BUNCHED 9.5
#define MAX_TESTS_ROW 6.0
#define MAX_TESTS_NESTED 13.0

/* ... times this where the cells, boxes along the axes, lie askew to the solid that is cut: a plate
 * that is turned shares most of its cells with what is beside it. */
#define ASKEW 3.0
#define ACROSS 0.995 /* of a normal along an axis: 6 degrees off */

/* Shares of that: few, so that cells are certainly no faster, and many: they certainly are. */
#define FEW_TESTS 0.7
#define MANY_TESTS 3.0

static bool is_nested(const struct csg_terms *terms, const struct csg_object *object)
{
    const struct csg_node *nodes = terms->scene->trees[object->layer].data;
    for (uint32_t i = object->begin + 1; i < object->end; i++)
        if (nodes[i].op != CSG_LEAF)
            return true;
    return false;
}

/* Whether the first solid that is not subtracted has planes that are not across an axis. */
static bool is_askew(const struct csgcast_scene *scene, const struct csg_object *object)
{
    const struct csg_leaf *minuend = csg_object_minuend(scene, object);
    const size_t num = minuend ? minuend->shape.num_planes : 0;
    for (size_t i = 0; i < num; i++) {
        const struct csg_vec3 n = minuend->shape.planes[i].normal;
        const double most = fmax(fabs(n.x), fmax(fabs(n.y), fabs(n.z)));
        if (most < ACROSS)
            return true;
    }
    return false;
}

/* What cells would spare this object in this frame, in tests; 0: nothing. false: out of memory. */
static bool find_spared(const struct csg_terms *terms, const struct csg_object *object,
                        const struct csg_rect *rect, struct csg_draw *draw, double *spared)
{
    bool quadrics;
    const bool bunched = csg_bunches_can_hold(terms->scene, object, &quadrics);
    draw->nested = is_nested(terms, object);
    const double askew = is_askew(terms->scene, object) ? ASKEW : 1;
    const double most = askew * (bunched        ? MAX_TESTS_BUNCHED
                                 : draw->nested ? MAX_TESTS_NESTED
                                                : MAX_TESTS_ROW);
    const double area = (rect->hi[0] - rect->lo[0]) * (rect->hi[1] - rect->lo[1]);
    double tests;
    *spared = 0;
    if (terms->views.num)
        return true;
    draw->may_walk = true;
    draw->bunched = bunched;
    if (csg_cells_recall(terms->scene, draw->object, area, spared))
        return true;
    if (!csg_tile_sample(terms, object, rect, draw, FEW_TESTS * most, MANY_TESTS * most, &tests))
        return false;
    *spared = fmax(tests - most, 0) * area;
    csg_cells_remember(terms->scene, draw->object, area, *spared);
    return true;
}

/* The leaves that are in no stack: cells know no stacks, and take many times as long for them. */
static size_t count_loose(const struct csg_terms *terms)
{
    size_t num = terms->leaves.num - terms->stacks.list.num;
    for (size_t i = 0; i < terms->stacks.rings.num; i++)
        num -= terms->stacks.rings.data[i].inner != CSG_NO_LEAF ? 2 : 1;
    return num;
}

bool csg_cells_choose(const struct csg_terms *terms, const struct csg_object *object,
                      const struct csg_rect *rect, struct csg_draw *draw,
                      const struct csg_cells **cells)
{
    const enum csg_cells_use use = terms->params->cells;
    double spared = INFINITY;
    *cells = NULL;
    const bool is_small = use == CSG_CELLS_WHERE_BETTER && count_loose(terms) < MIN_CELL_LEAVES;
    if (use == CSG_CELLS_NEVER || is_small || draw->object == CSG_WHOLE_LAYER || draw->around_eye ||
        draw->precise || !csg_walk_can_see(&terms->frame->screen, &object->box))
        return true;
    if (use == CSG_CELLS_WHERE_BETTER && !find_spared(terms, object, rect, draw, &spared))
        return false;
    if (spared == 0)
        return true;
    *cells = csg_cells_of(terms->scene, draw->object, spared, terms->params->num_threads);
    if (*cells && !csg_walk_has_room(terms->frame, *cells))
        *cells = NULL;
    return true;
}
