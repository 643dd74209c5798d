/* SPDX-License-Identifier: MIT */
#include "nodes/parts.h"

#include <stdlib.h>

#include "common/parallel.h"
#include "nodes/repeats.h"
#include "polyhedra/evaluate.h"

/* A node whose children are being read. */
struct frame {
    uint32_t end;
    uint8_t role;
    bool negated;
    uint32_t num_operands;
    struct csg_space space;
};

struct reader {
    struct csg_walk *walk;
    struct csg_part *part;
    bool exact; /* quadrics are welcome */
    CSG_ARRAY(struct frame) frames;
};

static struct frame *top_of(struct reader *reader)
{
    return &reader->frames.data[reader->frames.num - 1];
}

/* Whether the next operand of the innermost open node is complemented; counts it. */
static bool take_operand(struct reader *reader)
{
    struct frame *top = top_of(reader);
    const bool is_subtracted = top->role == CSG_ROLE_DIFFERENCE && top->num_operands > 0;
    top->num_operands++;
    return top->negated != is_subtracted;
}

static bool add_empty(struct reader *reader, bool negated)
{
    if (!csg_part_open(reader->part, negated))
        return csg_walk_no_memory(reader->walk);
    csg_part_close(reader->part);
    return true;
}

/* An intersection without operands is empty. */
static void close_frame(struct reader *reader)
{
    const struct frame *top = top_of(reader);
    struct csg_part *part = reader->part;
    struct csg_node *node = &part->tree.data[part->open.data[part->open.num - 1]];
    if (top->num_operands == 0)
        node->op = top->negated ? CSG_AND : CSG_OR;
    csg_part_close(part);
    reader->frames.num--;
}

/* Whether a difference or intersection is open. */
static bool is_cut(const struct reader *reader)
{
    for (size_t i = 0; i < reader->frames.num; i++)
        if (reader->frames.data[i].role != CSG_ROLE_UNION)
            return true;
    return false;
}

/* The children that have something to say. */
static int count_operands(const struct csg_walk *walk, uint32_t node)
{
    int num = 0;
    for (uint32_t i = node + 1; i < csg_walk_node(walk, node)->end; i = csg_walk_node(walk, i)->end)
        num += !csg_is_left_out(walk->builder, i);
    return num;
}

static bool is_singular(const struct csg_space *space)
{
    struct csg_map inverse;
    return !space->is_empty && !csg_map_invert(&space->map, &inverse);
}

/* Into the innermost open node's space. Where that leaves no volume of the part it leaves points,
 * if it is points that matter. */
static bool place(struct reader *reader, struct csg_part *part)
{
    const struct csg_space *space = &top_of(reader)->space;
    bool is_placed = !space->is_empty;
    if (!is_singular(space)) {
        for (size_t i = 0; i < part->shapes.num && is_placed; i++)
            is_placed = csg_space_place(space, &part->shapes.data[i]);
        return is_placed;
    }
    reader->part->has_flat = true;
    if (!reader->walk->points_only || is_cut(reader))
        return false;
    return csg_part_press(part, &space->map) == CSG_HULL_DONE;
}

static bool open_frame(struct reader *reader, uint32_t node)
{
    const struct csg_node_ops *ops = csg_walk_ops(reader->walk, node);
    const bool negated = take_operand(reader);
    struct frame frame = *top_of(reader);
    struct csg_args args;
    frame.end = csg_walk_node(reader->walk, node)->end;
    frame.role = reader->walk->builder->meanings[node].role;
    frame.negated = negated;
    frame.num_operands = 0;
    frame.space.in_boolean |= csg_walk_is_boolean(reader->walk, node);
    if (!csg_walk_args(reader->walk, node, ops->name, ops->parameters, &args))
        return false;
    if (ops->enter)
        ops->enter(&args, &frame.space);
    /* OpenSCAD flattens solids, but not a union of several. */
    frame.space.is_empty |= is_singular(&frame.space) && count_operands(reader->walk, node) > 1;
    const bool is_union = frame.role == CSG_ROLE_UNION;
    return (csg_part_open(reader->part, is_union == negated) &&
            csg_array_push(&reader->frames, frame)) ||
           csg_walk_no_memory(reader->walk);
}

static bool add_part(struct reader *reader, struct csg_part *part, bool negated)
{
    if (part->tree.num > 0 && place(reader, part))
        return csg_part_append(reader->part, part, negated) || csg_walk_no_memory(reader->walk);
    csg_part_finish(part);
    return add_empty(reader, negated);
}

static bool add_solid(struct reader *reader, struct csg_shape *shape, bool negated)
{
    const struct csg_space *space = &top_of(reader)->space;
    struct csg_part part = {0};
    if (!is_singular(space) && csg_space_place(space, shape))
        return csg_part_add(reader->part, shape, negated) || csg_walk_no_memory(reader->walk);
    if (csg_part_open(&part, false) && csg_part_add(&part, shape, false)) {
        csg_part_close(&part);
        return add_part(reader, &part, negated);
    }
    csg_part_finish(&part);
    return csg_walk_no_memory(reader->walk);
}

/* Faces of so many corners take hulls the square of their number in time. */
static bool refuse_solid(struct reader *reader, uint32_t node, const struct csg_args *args)
{
    const double num = csg_args_number(args, "$fn", 0, NULL);
    const bool is_refused = isfinite(num) && num > CSG_OPERAND_MAX_FRAGMENTS;
    if (is_refused)
        csg_walk_refuse(reader->walk, node,
                        "%s: $fn = %g is more than the %d that solids in a hull, minkowski, resize "
                        "or projection may have",
                        args->node, num, CSG_OPERAND_MAX_FRAGMENTS);
    return is_refused;
}

static bool read_solid(struct reader *reader, uint32_t node)
{
    const struct csg_solid_ops *ops = csg_solids[reader->walk->builder->meanings[node].kind];
    const bool negated = take_operand(reader);
    struct csg_shape shape = {.frame = csg_map_identity};
    struct csg_args args;
    if (!csg_walk_args(reader->walk, node, ops->name, ops->parameters, &args))
        return false;
    const enum csg_read_result result = ops->read(&args, &shape);
    const bool is_bounded =
        csg_box_is_finite(&shape.bounds) && (!shape.has_quadric || reader->exact);
    const bool is_refused =
        result == CSG_READ_OK && shape.facetted && refuse_solid(reader, node, &args);
    if (result == CSG_READ_OK && is_bounded && !is_refused)
        return add_solid(reader, &shape, negated);
    if (result == CSG_READ_OK && !is_refused && csg_space_place(&top_of(reader)->space, &shape))
        csg_walk_unsupported(reader->walk, node,
                             "%s inside of hull or minkowski is not supported yet", ops->name);
    csg_shape_finish(&shape);
    return add_empty(reader, negated);
}

/* A compound to be read. */
struct inner {
    struct csg_walk *walk;
    uint32_t node;
    bool in_boolean;
    struct csg_part part;
    bool ok;
};

static void read_inner(void *user, size_t task)
{
    struct inner *inner = user;
    const struct csg_node_ops *ops = csg_walk_ops(inner->walk, inner->node);
    (void)task;
    inner->ok = csg_repeats_read(inner->walk, inner->node, ops, inner->in_boolean, &inner->part);
}

static bool read_compound(struct reader *reader, uint32_t node)
{
    struct csg_walk *walk = reader->walk;
    const bool negated = take_operand(reader), points_only = walk->points_only;
    struct inner inner = {
        .walk = walk, .node = node, .in_boolean = top_of(reader)->space.in_boolean};
    walk->points_only = points_only && !is_cut(reader);
    if (++walk->depth % CSG_PARTS_LEVELS_A_STACK != 0)
        read_inner(&inner, 0);
    else if (!csg_call_on_new_stack(read_inner, &inner))
        csg_walk_no_memory(reader->walk);
    walk->depth--;
    walk->points_only = points_only;
    if (inner.ok)
        return add_part(reader, &inner.part, negated);
    csg_part_finish(&inner.part);
    return false;
}

static bool visit(struct reader *reader, uint32_t node, uint32_t *next)
{
    const struct csg_parsed_node *parsed = csg_walk_node(reader->walk, node);
    const struct csg_meaning *meaning = &reader->walk->builder->meanings[node];
    *next = parsed->end;
    const bool is_flat = csg_is_empty_operand(reader->walk->builder, node);
    if (!is_flat && csg_is_left_out(reader->walk->builder, node))
        return true;
    if (is_flat || parsed->malformed)
        return add_empty(reader, take_operand(reader));
    if (meaning->role == CSG_ROLE_SOLID)
        return read_solid(reader, node);
    if (meaning->role == CSG_ROLE_COMPOUND)
        return read_compound(reader, node);
    if (!csg_has_children(meaning))
        return add_empty(reader, take_operand(reader));
    *next = node + 1;
    return open_frame(reader, node);
}

static bool read_nodes(struct reader *reader, uint32_t begin, uint32_t end)
{
    bool ok = true;
    for (uint32_t i = begin; ok && i < end && !reader->part->is_too_large;) {
        while (top_of(reader)->end <= i)
            close_frame(reader);
        ok = visit(reader, i, &i);
    }
    while (reader->frames.num > 0)
        close_frame(reader);
    return ok;
}

bool csg_part_read(struct csg_walk *walk, uint32_t begin, uint32_t end, bool in_boolean,
                   enum csg_part_wanted wanted, struct csg_part *part)
{
    struct csg_builder *builder = walk->builder;
    const bool exact = wanted == CSG_WANT_EXACT ||
                       (wanted == CSG_WANT_AROUND && builder->facets != CSGCAST_FACETS_AS_WRITTEN);
    struct reader reader = {.walk = walk, .part = part, .exact = exact};
    struct frame root = {.end = end, .role = CSG_ROLE_UNION, .space = csg_space_world};
    const enum csgcast_facets facets = builder->facets;
    root.space.in_boolean = in_boolean;
    if (!reader.exact)
        builder->facets = CSGCAST_FACETS_AS_WRITTEN;
    const bool outer_points_only = walk->points_only, outer_is_operand = walk->is_operand;
    walk->points_only = wanted == CSG_WANT_POINTS;
    walk->is_operand |= wanted != CSG_WANT_AROUND;
    const bool ok = csg_part_open(part, false) && csg_array_push(&reader.frames, root)
                        ? read_nodes(&reader, begin, end)
                        : csg_walk_no_memory(reader.walk);
    walk->points_only = outer_points_only;
    walk->is_operand = outer_is_operand;
    builder->facets = facets;
    free(reader.frames.data);
    return ok;
}
