/* SPDX-License-Identifier: MIT */
#include "polyhedra/evaluate.h"

#include <stdlib.h>

#include "polyhedra/cell.h"
#include "polyhedra/join.h"
#include "polyhedra/mesh.h"

/* Give up when a Boolean is in so many pieces. */
enum { max_cells = 50000 };

/* From so many sets on it is tried whether there are fewer without overlaps. */
enum { many_sets = 1000 };

struct cells {
    CSG_ARRAY(struct csg_cell) list;
};

/* A Boolean node at work. */
struct frame {
    uint32_t end;
    bool is_and;
    struct cells in;  /* what its next child, of an intersection, or each child is cut out of */
    struct cells out; /* union: what the children have made */
    CSG_ARRAY(struct csg_node) leaves; /* union: the children so far that are leaves */
};

struct evaluator {
    const struct csg_part *part;
    CSG_ARRAY(struct frame) frames;
    size_t num_cells;
    double near;
    bool apart; /* the leaves of a union do not overlap */
};

/* ---- lists of cells ----------------------------------------------------------------------- */

static void finish_cells(struct cells *cells)
{
    for (size_t i = 0; i < cells->list.num; i++)
        csg_cell_finish(&cells->list.data[i]);
    free(cells->list.data);
    *cells = (struct cells){0};
}

/* Takes the cell over. */
static bool push_cell(struct cells *cells, struct csg_cell *cell)
{
    if (cell->faces.num >= 4 && csg_array_push(&cells->list, *cell))
        return true;
    const bool is_empty = cell->faces.num < 4;
    csg_cell_finish(cell);
    return is_empty;
}

/* A plane far beyond it copies a cell. */
static bool copy_cell(const struct csg_cell *cell, struct csg_cell *copy)
{
    const struct csg_box box = csg_cell_box(cell);
    const double far = box.hi.x + (box.hi.x - box.lo.x) + 1;
    struct csg_cell rest = {0};
    const bool ok = csg_cell_split(cell, &(struct csg_plane){{1, 0, 0}, far}, 0, copy, &rest);
    csg_cell_finish(&rest);
    return ok;
}

static bool copy_cells(const struct cells *from, struct cells *to)
{
    bool ok = true;
    for (size_t i = 0; i < from->list.num && ok; i++) {
        struct csg_cell copy = {0};
        ok = copy_cell(&from->list.data[i], &copy);
        ok = push_cell(to, &copy) && ok;
    }
    return ok;
}

static bool move_cells(struct cells *from, struct cells *to)
{
    bool ok = true;
    for (size_t i = 0; i < from->list.num; i++)
        ok = push_cell(to, &from->list.data[i]) && ok;
    from->list.num = 0;
    finish_cells(from);
    return ok;
}

/* ---- a leaf ------------------------------------------------------------------------------- */

/* Whether all of the cell is beyond one of the shape's planes. Cutting along the planes before that
 * one would only make pieces. */
static bool is_beyond(const struct csg_cell *cell, const struct csg_shape *shape, double near)
{
    for (size_t i = 0; i < shape->num_planes; i++) {
        double lo, hi;
        csg_cell_range(cell, &shape->planes[i], &lo, &hi);
        if (lo >= -near)
            return true;
    }
    return false;
}

static bool misses(const struct csg_cell *cell, const struct csg_shape *shape, double near)
{
    const struct csg_box a = csg_cell_box(cell), b = csg_box_map(&shape->frame, &shape->bounds);
    const struct csg_box common = csg_box_intersection(&a, &b);
    return csg_box_is_empty(&common) || is_beyond(cell, shape, near);
}

/* What of the cell is in the shape, or, where that is asked for, the pieces that are not: beyond
 * its first plane, then within that and beyond the second, and so on. */
static bool cut_cell(struct evaluator *evaluator, struct csg_cell *cell,
                     const struct csg_shape *shape, bool negated, struct cells *out)
{
    bool ok = true;
    if (misses(cell, shape, evaluator->near)) {
        if (negated)
            return push_cell(out, cell);
        csg_cell_finish(cell);
        return true;
    }
    for (size_t i = 0; i < shape->num_planes && ok && cell->faces.num > 0; i++) {
        double lo, hi;
        csg_cell_range(cell, &shape->planes[i], &lo, &hi);
        if (hi <= evaluator->near)
            continue;
        struct csg_cell below = {0}, above = {0};
        if (lo < -evaluator->near) {
            ok = csg_cell_split(cell, &shape->planes[i], evaluator->near, &below, &above);
            csg_cell_finish(cell);
        } else {
            above = *cell;
            *cell = (struct csg_cell){0};
        }
        *cell = below;
        evaluator->num_cells++;
        if (negated)
            ok = push_cell(out, &above) && ok;
        else
            csg_cell_finish(&above);
    }
    if (!negated)
        return push_cell(out, cell) && ok;
    csg_cell_finish(cell);
    return ok;
}

/* What of the shape is in the cell: for a shape of many planes, since each cut takes the time of
 * all faces that there are by then. */
static bool cut_shape(struct evaluator *evaluator, struct csg_cell *cell,
                      const struct csg_shape *shape, struct cells *out)
{
    struct csg_cell cut = {0};
    bool ok = csg_shape_cell(shape, &cut) != CSG_HULL_NO_MEMORY;
    for (size_t i = 0; i < cell->faces.num && ok; i++)
        ok = csg_cell_clip(&cut, &cell->faces.data[i].plane, evaluator->near);
    csg_cell_finish(cell);
    evaluator->num_cells++;
    return push_cell(out, &cut) && ok;
}

static bool cut_cells(struct evaluator *evaluator, struct cells *in, const struct csg_node *leaf,
                      struct cells *out)
{
    const struct csg_shape *shape = &evaluator->part->shapes.data[leaf->leaf];
    bool ok = true;
    for (size_t i = 0; i < in->list.num; i++) {
        struct csg_cell *cell = &in->list.data[i];
        if (!leaf->negated && shape->num_planes > CSG_HULL_MAX_CUT_PLANES &&
            shape->num_planes > cell->faces.num)
            ok = cut_shape(evaluator, cell, shape, out) && ok;
        else
            ok = cut_cell(evaluator, cell, shape, leaf->negated, out) && ok;
    }
    in->list.num = 0;
    finish_cells(in);
    return ok;
}

/* ---- the tree ----------------------------------------------------------------------------- */

/* What a child works on: an intersection hands its cells from child to child. */
static bool take_input(struct frame *frame, struct cells *in)
{
    if (!frame->is_and)
        return copy_cells(&frame->in, in);
    *in = frame->in;
    frame->in = (struct cells){0};
    return true;
}

static bool give_output(struct frame *frame, struct cells *out)
{
    return move_cells(out, frame->is_and ? &frame->in : &frame->out);
}

static void finish_frame(struct frame *frame)
{
    finish_cells(&frame->in);
    finish_cells(&frame->out);
    free(frame->leaves.data);
}

static bool close_frame(struct evaluator *evaluator)
{
    struct frame frame = evaluator->frames.data[--evaluator->frames.num];
    struct frame *parent = &evaluator->frames.data[evaluator->frames.num - 1];
    const bool ok = give_output(parent, frame.is_and ? &frame.in : &frame.out);
    finish_frame(&frame);
    return ok;
}

/* Takes from cells what the union's leaves before have, the last ones first, for along a path it is
 * those that have most of it. */
static bool take_apart(struct evaluator *evaluator, const struct frame *frame, struct cells *cells)
{
    bool ok = true;
    for (size_t i = frame->leaves.num; i > 0 && cells->list.num > 0 && ok; i--) {
        struct csg_node other = frame->leaves.data[i - 1];
        struct cells left = {0};
        other.negated = !other.negated;
        ok = cut_cells(evaluator, cells, &other, &left);
        *cells = left;
    }
    return ok;
}

static bool visit_leaf(struct evaluator *evaluator, struct frame *frame,
                       const struct csg_node *leaf, struct cells *in)
{
    const bool is_cut = evaluator->apart && !frame->is_and;
    struct cells out = {0};
    const bool ok = cut_cells(evaluator, in, leaf, &out) &&
                    (!is_cut || (take_apart(evaluator, frame, &out) &&
                                 csg_array_push(&frame->leaves, *leaf))) &&
                    give_output(frame, &out);
    finish_cells(&out);
    return ok;
}

static bool visit(struct evaluator *evaluator, const struct csg_node *node)
{
    struct frame *top = &evaluator->frames.data[evaluator->frames.num - 1];
    struct cells in = {0};
    if (node->op == CSG_LEAF && evaluator->part->shapes.data[node->leaf].surface)
        return true;
    bool ok = take_input(top, &in);
    if (node->op == CSG_LEAF) {
        ok = ok && visit_leaf(evaluator, top, node, &in);
    } else {
        const struct frame frame = {.end = node->end, .is_and = node->op == CSG_AND, .in = in};
        if (ok && csg_array_push(&evaluator->frames, frame))
            return true;
        ok = false;
    }
    finish_cells(&in);
    return ok;
}

/* Everything is cut out of one cell around all shapes. */
static bool start(struct evaluator *evaluator)
{
    const struct csg_part *part = evaluator->part;
    struct csg_box box = csg_part_box(part);
    struct csg_cell cell = {0};
    if (csg_box_is_empty(&box))
        box = (struct csg_box){{0, 0, 0}, {1, 1, 1}};
    const struct csg_vec3 size = csg_sub(box.hi, box.lo);
    evaluator->near = 1e-11 * (csg_length(box.lo) + csg_length(box.hi));
    box.lo = csg_sub(box.lo, size);
    box.hi = csg_add(box.hi, size);
    struct frame root = {.end = UINT32_MAX};
    if (csg_cell_from_box(&cell, &box) && push_cell(&root.in, &cell) &&
        csg_array_push(&evaluator->frames, root))
        return true;
    csg_cell_finish(&cell);
    finish_cells(&root.in);
    return false;
}

static enum csg_hull_result evaluate_cells(const struct csg_part *part, bool apart,
                                           struct csg_clusters *clusters)
{
    struct evaluator evaluator = {.part = part, .apart = apart};
    bool ok = start(&evaluator);
    for (size_t i = 0; i < part->tree.num && ok && evaluator.num_cells < max_cells; i++) {
        while (ok && evaluator.frames.data[evaluator.frames.num - 1].end <= i)
            ok = close_frame(&evaluator);
        ok = ok && visit(&evaluator, &part->tree.data[i]);
    }
    while (ok && evaluator.frames.num > 1)
        ok = close_frame(&evaluator);
    struct cells *sets = &evaluator.frames.data[0].out;
    ok = ok && csg_cells_join(sets->list.data, sets->list.num, evaluator.near);
    for (size_t i = 0; ok && i < sets->list.num; i++)
        if (sets->list.data[i].faces.num > 0)
            ok = csg_clusters_add_cell(clusters, &sets->list.data[i], evaluator.near);
    for (size_t i = 0; i < evaluator.frames.num; i++)
        finish_frame(&evaluator.frames.data[i]);
    free(evaluator.frames.data);
    if (!ok)
        return CSG_HULL_NO_MEMORY;
    return evaluator.num_cells < max_cells ? CSG_HULL_DONE : CSG_HULL_FLAT;
}

/* Where the solids of a union overlap much, as along a path, what they have in common with another
 * solid is the same many times. Without overlaps that is cut into more cells, and joined to fewer
 * sets, but into more of both where there are few overlaps. */
static enum csg_hull_result evaluate_tree(const struct csg_part *part,
                                          struct csg_clusters *clusters)
{
    struct csg_clusters sets[2] = {{.ends = {0}}};
    enum csg_hull_result results[2] = {evaluate_cells(part, false, &sets[0]), CSG_HULL_FLAT};
    if (results[0] != CSG_HULL_NO_MEMORY &&
        (results[0] != CSG_HULL_DONE || sets[0].ends.num >= many_sets))
        results[1] = evaluate_cells(part, true, &sets[1]);
    const bool apart = results[1] == CSG_HULL_DONE &&
                       (results[0] != CSG_HULL_DONE || sets[1].ends.num < sets[0].ends.num);
    enum csg_hull_result result = results[apart];
    if (result == CSG_HULL_DONE && !csg_clusters_append(clusters, &sets[apart]))
        result = CSG_HULL_NO_MEMORY;
    csg_clusters_finish(&sets[0]);
    csg_clusters_finish(&sets[1]);
    return result;
}

static bool is_surface(const struct csg_part *part, size_t leaf)
{
    return part->shapes.data[part->tree.data[leaf].leaf].surface != NULL;
}

/* Surfaces that are operands of unions alone; what is bounded by triangles is not cut here. */
static size_t count_uncut_surfaces(const struct csg_part *part)
{
    size_t num = 0;
    for (size_t i = csg_part_next_uncut(part, 0); i < part->tree.num;
         i = csg_part_next_uncut(part, i + 1))
        num += is_surface(part, i);
    return num;
}

static size_t count_surfaces(const struct csg_part *part)
{
    size_t num = 0;
    for (size_t i = 0; i < part->tree.num; i++)
        num += part->tree.data[i].op == CSG_LEAF && is_surface(part, i);
    return num;
}

/* Each a set, whether it is convex or not. */
static enum csg_hull_result add_uncut(const struct csg_part *part, bool surfaces_only,
                                      struct csg_clusters *clusters)
{
    enum csg_hull_result result = CSG_HULL_DONE;
    for (size_t i = csg_part_next_uncut(part, 0); i < part->tree.num && result == CSG_HULL_DONE;
         i = csg_part_next_uncut(part, i + 1)) {
        const size_t before = clusters->corners.points.num;
        if (surfaces_only && !is_surface(part, i))
            continue;
        result = csg_shape_corners(&part->shapes.data[part->tree.data[i].leaf], &clusters->corners);
        if (result == CSG_HULL_DONE && clusters->corners.points.num > before &&
            !csg_array_push(&clusters->ends, clusters->corners.points.num))
            result = CSG_HULL_NO_MEMORY;
    }
    return result;
}

enum csg_hull_result csg_part_evaluate(const struct csg_part *part, bool points_only,
                                       struct csg_clusters *clusters)
{
    const bool is_union = csg_part_is_union(part);
    if (count_surfaces(part) > (points_only ? count_uncut_surfaces(part) : 0))
        return CSG_HULL_FLAT;
    const enum csg_hull_result result = add_uncut(part, !is_union, clusters);
    return is_union || result != CSG_HULL_DONE ? result : evaluate_tree(part, clusters);
}

enum csg_hull_result csg_part_press(struct csg_part *part, const struct csg_map *map)
{
    struct csg_clusters clusters = {0};
    struct csg_mesh mesh = {0};
    struct csg_part pressed = {0};
    struct csg_shape shape;
    enum csg_hull_result result = csg_part_evaluate(part, true, &clusters);
    bool ok = true;
    for (size_t i = 0; i < clusters.corners.points.num && ok; i++)
        ok = csg_mesh_add_point(&mesh, csg_map_point(map, clusters.corners.points.data[i])) &&
             csg_array_push(&mesh.corners, (uint32_t)i);
    ok = ok && csg_part_open(&pressed, false) && csg_mesh_to_points(&mesh, &shape) &&
         csg_part_add(&pressed, &shape, false);
    if (pressed.open.num > 0)
        csg_part_close(&pressed);
    csg_mesh_finish(&mesh);
    csg_clusters_finish(&clusters);
    csg_part_finish(part);
    *part = pressed;
    return ok ? result : CSG_HULL_NO_MEMORY;
}
