/* SPDX-License-Identifier: MIT */
#include "nodes/clip.h"

#include <stdlib.h>

#include "clip/module.h"
#include "common/module.h"
#include "solids/facets.h"

bool csg_clip_is_wanted(struct csg_walk *walk)
{
    return walk->builder->clip.is_wanted && csg_clip_is_there(walk);
}

bool csg_clip_is_there(struct csg_walk *walk)
{
    struct csg_clip_state *state = &walk->builder->clip;
    if (state->was_opened)
        return state->module != NULL;
    state->was_opened = true;
    state->module =
        csg_module_symbol("csgcast-clip.so", "CSGCAST_CLIP_MODULE", CSG_CLIP_MODULE_NAME);
    return state->module != NULL;
}

struct paths {
    CSG_ARRAY(struct csg_clip_path) list;
    uint32_t num_operands;
};

static bool add_figure(const struct csg_drawing *drawing, uint32_t node, struct paths *paths)
{
    const struct csg_figure *figure = &drawing->figures.data[drawing->nodes.data[node].figure];
    bool ok = true;
    for (uint32_t i = figure->begin; i < figure->end && ok; i++) {
        const struct csg_contour *contour = &drawing->contours.data[i];
        if (contour->end == contour->begin)
            continue;
        const struct csg_clip_path path = {&drawing->points.data[contour->begin].x,
                                           contour->end - contour->begin, paths->num_operands, node,
                                           figure->is_outline};
        ok = csg_array_push(&paths->list, path);
    }
    return ok;
}

/* A figure by itself is one operand. */
static bool collect(const struct csg_drawing *drawing, uint32_t node, struct paths *paths)
{
    const struct csg_draw_node *nodes = drawing->nodes.data;
    const bool is_figure = nodes[node].op == CSG_DRAW_FIGURE;
    bool ok = true;
    for (uint32_t i = is_figure ? node : node + 1; i < nodes[node].end && ok; i = nodes[i].end) {
        for (uint32_t k = i; k < nodes[i].end && ok; k++)
            if (nodes[k].op == CSG_DRAW_FIGURE)
                ok = add_figure(drawing, k, paths);
        paths->num_operands++;
    }
    return ok;
}

static enum csg_clip_op op_of(uint8_t op)
{
    if (op == CSG_DRAW_FIGURE)
        return CSG_CLIP_CLEAN;
    if (op == CSG_DRAW_DIFFERENCE)
        return CSG_CLIP_DIFFERENCE;
    return op == CSG_DRAW_INTERSECTION ? CSG_CLIP_INTERSECTION : CSG_CLIP_UNION;
}

static bool begin_contour(void *user)
{
    return csg_drawing_add_contour(user);
}

static bool add_point(void *user, double x, double y)
{
    return csg_drawing_add_point(user, x, y);
}

/* The first figure of result, which clip has filled, takes the place of the subtree at node. */
static bool replace(struct csg_drawing *drawing, uint32_t node, const struct csg_drawing *result)
{
    const uint32_t end = drawing->nodes.data[node].end;
    const struct csg_figure figure = {
        .disc = csg_map_identity,
        .rounding = csg_drawing_rounding(drawing, node, end),
        .facetted = csg_drawing_is_facetted(drawing, node, end),
    };
    csg_drawing_cut(drawing, node);
    return csg_drawing_append_figure(drawing, result, &figure);
}

static bool combine(struct csg_walk *walk, struct csg_drawing *drawing, uint32_t node,
                    const struct paths *paths, struct csg_drawing *result)
{
    const struct csg_clip_sink sink = {result, begin_contour, add_point};
    const enum csg_clip_result done = walk->builder->clip.module->combine(
        op_of(drawing->nodes.data[node].op), paths->num_operands, paths->list.data, paths->list.num,
        &sink);
    if (done != CSG_CLIP_DONE)
        return done == CSG_CLIP_TOO_LARGE; /* it stays as it is */
    return replace(drawing, node, result);
}

bool csg_clip_evaluate(struct csg_walk *walk, struct csg_drawing *drawing, uint32_t node)
{
    struct paths paths = {0};
    struct csg_drawing result = {0};
    const bool ok = collect(drawing, node, &paths) && csg_drawing_add_figure(&result, 0) &&
                    combine(walk, drawing, node, &paths, &result);
    free(paths.list.data);
    csg_drawing_finish(&result);
    return ok || csg_walk_no_memory(walk);
}

/* As OpenSCAD finds it (visit(OffsetNode) in its GeometryEvaluator.cc): to the last bit, which
 * decides whether an arc of a half of a segment more gets one. */
static double arc_tolerance(const struct csg_offset *offset)
{
    return fabs(offset->distance) * (1 - csg_cos_degrees(180.0 / offset->num));
}

static bool move(struct csg_walk *walk, struct csg_drawing *drawing, uint32_t node,
                 const struct paths *paths, const struct csg_offset *offset,
                 struct csg_drawing *result, bool *taken)
{
    static const enum csg_clip_join joins[] = {[CSG_JOIN_ROUND] = CSG_CLIP_JOIN_ROUND,
                                               [CSG_JOIN_MITER] = CSG_CLIP_JOIN_MITER,
                                               [CSG_JOIN_SQUARE] = CSG_CLIP_JOIN_BEVEL};
    const struct csg_clip_sink sink = {result, begin_contour, add_point};
    const struct csg_clip_offset how = {offset->distance, joins[offset->join],
                                        arc_tolerance(offset)};
    const enum csg_clip_result done =
        walk->builder->clip.module->offset(&how, paths->list.data, paths->list.num, &sink);
    *taken = done == CSG_CLIP_DONE;
    return *taken ? replace(drawing, node, result) : done == CSG_CLIP_TOO_LARGE;
}

bool csg_clip_offset(struct csg_walk *walk, struct csg_drawing *drawing, uint32_t node,
                     const struct csg_offset *offset, bool *taken)
{
    struct paths paths = {0};
    struct csg_drawing result = {0};
    uint32_t num = 0;
    for (uint32_t i = node; i < drawing->nodes.data[node].end; i++)
        num += drawing->nodes.data[i].op == CSG_DRAW_FIGURE;
    *taken = false;
    const bool ok = (num <= 1 || csg_clip_evaluate(walk, drawing, node)) &&
                    ((collect(drawing, node, &paths) && csg_drawing_add_figure(&result, 0) &&
                      move(walk, drawing, node, &paths, offset, &result, taken)) ||
                     csg_walk_no_memory(walk));
    free(paths.list.data);
    csg_drawing_finish(&result);
    return ok;
}
