/* SPDX-License-Identifier: MIT */
#include "plane/minkowski.h"

#include <stdlib.h>

#include "plane/offset.h"
#include "plane/piece.h"
#include "plane/wrap.h"

/* Convex sets by their corners; a sum of unions is the union of the sums of any two sets. */
struct sets {
    CSG_ARRAY(struct csg_flat_points) list;
};

/* Sums of more sets or corners are refused. */
enum { max_sets = 20000, max_corners = 4000000 };

static void finish(struct sets *sets)
{
    for (size_t i = 0; i < sets->list.num; i++)
        free(sets->list.data[i].list.data);
    free(sets->list.data);
    *sets = (struct sets){0};
}

static size_t count_corners(const struct sets *sets)
{
    size_t num = 0;
    for (size_t i = 0; i < sets->list.num; i++)
        num += sets->list.data[i].list.num;
    return num;
}

/* ---- sums --------------------------------------------------------------------------------- */

/* The set takes the points over. */
static bool add_set(struct sets *sets, struct csg_flat_points *points)
{
    if (csg_flat_points_wrap(points) && csg_array_push(&sets->list, *points))
        return true;
    free(points->list.data);
    return false;
}

static bool add_pieces(struct sets *sets, const struct csg_pieces *pieces)
{
    bool ok = true;
    for (size_t i = 0; i < pieces->pieces.num && ok; i++) {
        const struct csg_piece *piece = &pieces->pieces.data[i];
        struct csg_flat_points points = {0};
        for (uint32_t k = 0; k < piece->num_corners && ok; k++)
            ok = csg_array_push(&points.list, pieces->corners.data[piece->first_corner + k]);
        ok = add_set(sets, &points) && ok;
    }
    return ok;
}

static enum csg_sweep_result cut(struct sets *sets, const struct csg_drawing *drawing,
                                 uint32_t node)
{
    struct csg_pieces pieces = {0};
    enum csg_sweep_result result = csg_pieces_cut(&pieces, drawing, node);
    if (result == CSG_SWEEP_DONE && !add_pieces(sets, &pieces))
        result = CSG_SWEEP_NO_MEMORY;
    csg_pieces_finish(&pieces);
    return result;
}

static bool add_sum(struct sets *sums, const struct csg_flat_points *a,
                    const struct csg_flat_points *b)
{
    struct csg_flat_points points = {0};
    bool ok = true;
    for (size_t i = 0; i < a->list.num && ok; i++)
        for (size_t j = 0; j < b->list.num && ok; j++) {
            const struct csg_vec2 p = a->list.data[i], q = b->list.data[j];
            ok = csg_array_push(&points.list, ((struct csg_vec2){p.x + q.x, p.y + q.y}));
        }
    return add_set(sums, &points) && ok;
}

/* a becomes the sum. */
static enum csg_sweep_result add(struct sets *a, const struct sets *b)
{
    struct sets sums = {0};
    bool ok = true;
    if (a->list.num * b->list.num > max_sets ||
        (double)count_corners(a) * (double)count_corners(b) > max_corners)
        return CSG_SWEEP_TOO_LARGE;
    for (size_t i = 0; i < a->list.num && ok; i++)
        for (size_t j = 0; j < b->list.num && ok; j++)
            ok = add_sum(&sums, &a->list.data[i], &b->list.data[j]);
    finish(a);
    *a = sums;
    return ok ? CSG_SWEEP_DONE : CSG_SWEEP_NO_MEMORY;
}

static enum csg_sweep_result add_children(struct sets *sum, const struct csg_drawing *drawing,
                                          uint32_t node)
{
    const uint32_t end = drawing->nodes.data[node].end;
    enum csg_sweep_result result = CSG_SWEEP_DONE;
    bool has_others = false;
    for (uint32_t child = node + 1; child < end && result == CSG_SWEEP_DONE;
         child = drawing->nodes.data[child].end) {
        struct sets operand = {0};
        result = cut(child == node + 1 ? sum : &operand, drawing, child);
        if (result == CSG_SWEEP_DONE && operand.list.num > 0) {
            has_others = true;
            result = add(sum, &operand);
        }
        finish(&operand);
    }
    if (!has_others)
        finish(sum);
    return result;
}

/* ---- with a disc -------------------------------------------------------------------------- */

/* The disc that is all of the child; NULL where it is anything else. */
static const struct csg_figure *find_disc(const struct csg_drawing *drawing, uint32_t child)
{
    const uint32_t end = drawing->nodes.data[child].end;
    const struct csg_draw_node *last = &drawing->nodes.data[end - 1];
    double radius;
    for (uint32_t i = child; i + 1 < end; i++)
        if (drawing->nodes.data[i].op == CSG_DRAW_FIGURE || drawing->nodes.data[i].end != end)
            return NULL;
    if (last->op != CSG_DRAW_FIGURE ||
        !csg_figure_is_round(&drawing->figures.data[last->figure], &radius))
        return NULL;
    return &drawing->figures.data[last->figure];
}

/* Takes one child of node out of the drawing, whose last subtree node is. */
static void remove_child(struct csg_drawing *drawing, uint32_t node, uint32_t child)
{
    struct csg_draw_node *nodes = drawing->nodes.data;
    const uint32_t end = nodes[child].end, num = end - child;
    for (uint32_t i = end; i < drawing->nodes.num; i++) {
        nodes[i - num] = nodes[i];
        nodes[i - num].end -= num;
    }
    drawing->nodes.num -= num;
    nodes[node].end -= num;
}

/* The sum with a disc is an offset by its radius, moved to its centre. */
static enum csg_sweep_result add_disc(struct csg_drawing *drawing, uint32_t node, uint32_t child,
                                      const struct csg_figure *disc)
{
    const struct csg_contour *contour = &drawing->contours.data[disc->begin];
    struct csg_offset offset = {
        .join = CSG_JOIN_ROUND, .num = (int)(contour->end - contour->begin), .exact = true};
    struct csg_map move = csg_map_identity;
    csg_figure_is_round(disc, &offset.distance);
    move.m[0][3] = disc->disc.m[0][3];
    move.m[1][3] = disc->disc.m[1][3];
    remove_child(drawing, node, child);
    const enum csg_sweep_result result = csg_drawing_offset(drawing, node, &offset);
    if (result != CSG_SWEEP_DONE)
        return result;
    return csg_drawing_map(drawing, node, (uint32_t)drawing->nodes.num, &move, 1)
               ? CSG_SWEEP_DONE
               : CSG_SWEEP_NO_MEMORY;
}

enum csg_sweep_result csg_drawing_minkowski(struct csg_drawing *drawing, uint32_t node)
{
    const uint32_t end = drawing->nodes.data[node].end, first = node + 1;
    const uint32_t second = first < end ? drawing->nodes.data[first].end : end;
    struct sets sum = {0};
    if (second == end)
        return CSG_SWEEP_DONE;
    const bool are_two = drawing->nodes.data[second].end == end;
    if (are_two && find_disc(drawing, second))
        return add_disc(drawing, node, second, find_disc(drawing, second));
    if (are_two && find_disc(drawing, first))
        return add_disc(drawing, node, first, find_disc(drawing, first));
    const double rounding = csg_drawing_rounding(drawing, node, end);
    const bool facetted = csg_drawing_is_facetted(drawing, node, end);
    enum csg_sweep_result result = add_children(&sum, drawing, node);
    csg_drawing_cut(drawing, node);
    bool ok = csg_drawing_open(drawing, CSG_DRAW_UNION);
    for (size_t i = 0; i < sum.list.num && ok && result == CSG_SWEEP_DONE; i++) {
        ok = csg_flat_points_draw(drawing, &sum.list.data[i], rounding);
        if (ok)
            drawing->figures.data[drawing->figures.num - 1].facetted = facetted;
    }
    if (ok)
        csg_drawing_close(drawing, node);
    finish(&sum);
    return ok ? result : CSG_SWEEP_NO_MEMORY;
}
