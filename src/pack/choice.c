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

/* Where solids of nested trees overlap so that tiles are dear, cells take so many times as long to
 * make as elsewhere: it is worth it for several frames only. */
#define NESTED_COST 8.0

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
        const double most = csg_vec3_largest(n);
        if (most < ACROSS)
            return true;
    }
    return false;
}

/* The tests a pixel from which on cells are faster. */
static double find_limit(const struct csg_terms *terms, const struct csg_object *object,
                         const struct csg_draw *draw)
{
    const double askew = is_askew(terms->scene, object) ? ASKEW : 1;
    return askew * (draw->bunched  ? MAX_TESTS_BUNCHED
                    : draw->nested ? MAX_TESTS_NESTED
                                   : MAX_TESTS_ROW);
}

/* What cells would spare this object in this frame, in tests, as samples of its tiles say; 0:
 * nothing. false: out of memory. */
static bool find_spared(const struct csg_terms *terms, const struct csg_rect *rect,
                        const struct csg_draw *draw, double limit, double *spared)
{
    const double area = csg_rect_area(rect);
    double tests;
    if (csg_cells_recall(terms->scene, draw->object, area, spared))
        return true;
    if (!csg_tile_sample(terms, rect, draw, FEW_TESTS * limit, MANY_TESTS * limit, &tests))
        return false;
    *spared = fmax(tests - limit, 0) * area;
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

/* Whether rays of this frame may walk through cells of the object. */
static bool may_walk(const struct csg_terms *terms, const struct csg_object *object,
                     const struct csg_draw *draw)
{
    return draw->object != CSG_WHOLE_LAYER && !draw->around_eye && !draw->precise &&
           csg_walk_can_see(&terms->frame->screen, &object->box);
}

/* The cells, if there is room for them. */
static const struct csg_cells *ask_for_cells(const struct csg_terms *terms,
                                             const struct csg_draw *draw, double spared)
{
    const struct csg_cells *cells =
        csg_cells_of(terms->scene, draw->object, spared, terms->params->num_threads);
    return cells && csg_walk_has_room(terms->frame, cells) ? cells : NULL;
}

/* ... where they are better than tiles. */
static bool choose(const struct csg_terms *terms, const struct csg_object *object,
                   const struct csg_rect *rect, struct csg_draw *draw,
                   const struct csg_cells **cells, size_t *max_tests)
{
    bool quadrics;
    double spared;
    draw->may_walk = true;
    draw->nested = is_nested(terms, object);
    draw->bunched = csg_bunches_can_hold(terms->scene, object, &quadrics);
    const double limit = find_limit(terms, object, draw);
    if (!find_spared(terms, rect, draw, limit, &spared))
        return false;
    if (spared > 0)
        *cells = ask_for_cells(terms, draw, spared);
    else if (!terms->seen.is_part && csg_cells_can_hold(terms->scene, object))
        *max_tests =
            (size_t)(limit * csg_rect_area(rect) +
                     (draw->nested ? NESTED_COST : 1) * csg_cells_cost(terms->scene, object));
    return true;
}

bool csg_cells_choose(const struct csg_terms *terms, const struct csg_object *object,
                      const struct csg_rect *rect, struct csg_draw *draw,
                      const struct csg_cells **cells, size_t *max_tests)
{
    const enum csg_cells_use use = terms->params->cells;
    *cells = NULL;
    *max_tests = SIZE_MAX;
    if (use == CSG_CELLS_NEVER || !may_walk(terms, object, draw))
        return true;
    if (use == CSG_CELLS_ALWAYS)
        *cells = ask_for_cells(terms, draw, INFINITY);
    else if (terms->views.num == 0 && count_loose(terms) >= MIN_CELL_LEAVES)
        return choose(terms, object, rect, draw, cells, max_tests);
    return true;
}

void csg_cells_learn(const struct csg_terms *terms, const struct csg_rect *rect,
                     const struct csg_draw *draw, size_t tests)
{
    const double area = csg_rect_area(rect);
    if (!draw->may_walk)
        return;
    const double limit = find_limit(terms, &terms->scene->objects->data[draw->object], draw);
    if ((double)tests > MANY_TESTS * limit * area)
        csg_cells_remember(terms->scene, draw->object, area, (double)tests - limit * area);
}

const struct csg_cells *csg_cells_instead(const struct csg_terms *terms,
                                          const struct csg_object *object,
                                          const struct csg_draw *draw)
{
    return ask_for_cells(terms, draw, csg_cells_cost(terms->scene, object));
}
