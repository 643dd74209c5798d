/* SPDX-License-Identifier: MIT */
#include "nodes/walk.h"
#include "plane/extrude.h"

#include <stdlib.h>
#include <string.h>

#include "csg/part.h"
#include "nodes/compounds.h"
#include "nodes/origin.h"
#include "nodes/repeats.h"
#include "nodes/transforms.h"

/* A node that changed the space of what is below it. */
struct frame {
    uint32_t end; /* of its subtree */
    struct csg_space space;
};

struct walk {
    struct csg_walk base;
    struct csg_builder *builder;
    CSG_ARRAY(struct frame) frames; /* the first is around all nodes */
    uint32_t compound_end;          /* of the last compound's subtree */
};

/* ---- solids ------------------------------------------------------------------------------- */

void csg_leaf_set_color(struct csg_leaf *leaf, const float color[4])
{
    memcpy(leaf->color, color, sizeof leaf->color);
    for (int i = 0; i < 3; i++)
        if (!(leaf->color[i] >= 0))
            leaf->color[i] = -1;
    if (!(leaf->color[3] >= 0))
        leaf->color[3] = 1;
}

static bool add_leaf(struct walk *walk, const struct csg_leaf *leaf)
{
    struct csgcast_scene *scene = walk->builder->scene;
    if (scene->num_leaves == scene->leaves_capacity &&
        !csg_array_grow((void **)&scene->leaves, &scene->leaves_capacity, scene->num_leaves, 1,
                        sizeof *scene->leaves))
        return csg_log_memory(&walk->builder->report->log);
    scene->leaves[scene->num_leaves++] = *leaf;
    return true;
}

/* ---- where leaves come from, for edits ------------------------------------------------------ */

static bool keep_origin(struct walk *walk, const struct csg_shape *own,
                        const struct csg_space *space)
{
    struct csg_origins *origins = walk->builder->origins;
    return !origins || csg_origins_add(origins, own, space) ||
           csg_log_memory(&walk->builder->report->log);
}

/* The leaves from first on are all of one node. */
static void finish_origins(struct walk *walk, uint32_t node, uint32_t first)
{
    struct csg_origins *origins = walk->builder->origins;
    const uint32_t num = origins ? (uint32_t)origins->num - first : 0;
    for (uint32_t i = first; i < first + num; i++) {
        origins->data[i].first = first;
        origins->data[i].num = num;
        origins->data[i].node = node;
        origins->data[i].is_compound = csg_is_compound(&walk->builder->meanings[node]);
        origins->data[i].is_inside = node < walk->compound_end;
    }
}

/* ---- single solids ------------------------------------------------------------------------- */

/* Places a node's own shape, with its origin. false: nothing is left of it. failed: out of
 * memory. */
static bool place(struct walk *walk, const struct csg_space *space, struct csg_shape *shape,
                  bool *failed)
{
    struct csg_origins *origins = walk->builder->origins;
    *failed = !keep_origin(walk, shape, space);
    if (*failed)
        return false;
    if (csg_space_place(space, shape))
        return true;
    if (origins)
        csg_shape_finish(&origins->data[--origins->num].shape);
    return false;
}

/* Empty solids and malformed ones get no leaf. */
static bool read_solid(struct walk *walk, uint32_t node, const struct csg_space *space)
{
    const struct csg_parsed_node *parsed = csg_walk_node(&walk->base, node);
    const enum csg_kind kind = walk->builder->meanings[node].kind;
    const struct csg_solid_ops *ops = csg_solids[kind];
    struct csg_args args;
    struct csg_leaf leaf = {
        .kind = kind, .line = parsed->place.line, .column = parsed->place.column};
    leaf.shape.frame = csg_map_identity;
    if (!csg_walk_args(&walk->base, node, ops->name, ops->parameters, &args))
        return false;
    const enum csg_read_result result = ops->read(&args, &leaf.shape);
    bool failed = false;
    if (result == CSG_READ_OK && place(walk, space, &leaf.shape, &failed)) {
        const uint32_t index = (uint32_t)walk->builder->scene->num_leaves;
        csg_leaf_set_color(&leaf, space->color);
        walk->builder->meanings[node].leaf = index;
        if (add_leaf(walk, &leaf)) {
            finish_origins(walk, node, index);
            return true;
        }
        failed = true;
    }
    csg_shape_finish(&leaf.shape);
    if (failed)
        return false;
    walk->builder->scene->info.num_dropped += result != CSG_READ_ERROR;
    return true;
}

/* ---- compounds ---------------------------------------------------------------------------- */

/* The shapes that are left in world space become leaves; index[shape] gets their numbers. */
static bool add_shapes(struct walk *walk, uint32_t node, const struct csg_space *space,
                       struct csg_part *part, uint32_t *index)
{
    const struct csg_parsed_node *parsed = csg_walk_node(&walk->base, node);
    for (size_t i = 0; i < part->shapes.num; i++) {
        struct csg_leaf leaf = {.shape = part->shapes.data[i],
                                .kind = (enum csg_kind)walk->builder->meanings[node].kind,
                                .line = parsed->place.line,
                                .column = parsed->place.column};
        bool failed;
        index[i] = CSG_NO_LEAF;
        const bool is_placed = place(walk, space, &leaf.shape, &failed);
        part->shapes.data[i] = leaf.shape;
        if (failed)
            return false;
        if (!is_placed)
            continue;
        csg_leaf_set_color(&leaf, space->color);
        index[i] = (uint32_t)walk->builder->scene->num_leaves;
        if (!add_leaf(walk, &leaf))
            return false;
        part->shapes.data[i].planes = NULL; /* the leaf has them now */
        part->shapes.data[i].surface = NULL;
    }
    return true;
}

/* Appends the part's tree to the builder's. A shape that nothing is left of is an empty union. */
static bool add_tree(struct walk *walk, uint32_t node, const struct csg_part *part,
                     const uint32_t *index)
{
    struct csg_tree *parts = &walk->builder->parts;
    const uint32_t first = (uint32_t)parts->num;
    for (size_t i = 0; i < part->tree.num; i++) {
        struct csg_node copy = part->tree.data[i];
        copy.end += first;
        if (copy.op == CSG_LEAF && index[copy.leaf] != CSG_NO_LEAF) {
            copy.leaf = index[copy.leaf];
            walk->builder->scene->leaves[copy.leaf].is_hole = copy.negated;
        } else if (copy.op == CSG_LEAF) {
            copy = (struct csg_node){.op = copy.negated ? CSG_AND : CSG_OR, .end = copy.end};
        }
        if (!csg_array_push(parts, copy))
            return csg_log_memory(&walk->builder->report->log);
    }
    walk->builder->meanings[node].leaf = part->tree.num ? first : CSG_NO_LEAF;
    return true;
}

static bool is_along_axes(const struct csg_map *map)
{
    for (int i = 0; i < 3; i++)
        if ((map->m[i][0] != 0) + (map->m[i][1] != 0) + (map->m[i][2] != 0) > 1)
            return false;
    return true;
}

/* OpenSCAD's viewall frames a node's box in the node's own space: each shape gets all of it. */
static void frame_together(struct csg_part *part)
{
    struct csg_box box = csg_box_empty;
    for (size_t i = 0; i < part->tree.num; i++) {
        const struct csg_node *node = &part->tree.data[i];
        if (node->op != CSG_LEAF || node->negated)
            continue;
        const struct csg_shape *shape = &part->shapes.data[node->leaf];
        const struct csg_box own = csg_box_map(&shape->frame, &shape->written);
        box = csg_box_union(&box, &own);
    }
    for (size_t i = 0; i < part->shapes.num && csg_box_is_finite(&box); i++) {
        struct csg_shape *shape = &part->shapes.data[i];
        struct csg_map inverse;
        if (is_along_axes(&shape->frame) && csg_map_invert(&shape->frame, &inverse))
            shape->written = csg_box_map(&inverse, &box);
    }
}

static bool add_part(struct walk *walk, uint32_t node, const struct csg_space *space,
                     struct csg_part *part)
{
    uint32_t *index = malloc((part->shapes.num + 1) * sizeof *index);
    if (!index)
        return csg_log_memory(&walk->builder->report->log);
    const uint32_t first = (uint32_t)walk->builder->scene->num_leaves;
    frame_together(part);
    const bool done =
        add_shapes(walk, node, space, part, index) && add_tree(walk, node, part, index);
    finish_origins(walk, node, first);
    free(index);
    return done;
}

static bool is_marked(const struct walk *walk, uint32_t node)
{
    return csg_walk_node(&walk->base, node)->modifiers &
           (CSG_MODIFIER_BACKGROUND | CSG_MODIFIER_HIGHLIGHT);
}

static bool read_compound(struct walk *walk, uint32_t node, const struct csg_space *space)
{
    const struct csg_node_ops *ops = csg_walk_ops(&walk->base, node);
    const bool is_slab = walk->builder->meanings[node].is_slab;
    struct csg_part part = {0};
    struct csg_args args;
    walk->base.is_see_through =
        space->is_marked || is_marked(walk, node) || (space->color[3] >= 0 && space->color[3] < 1);
    bool done = is_slab ? csg_walk_args(&walk->base, node, ops->name, ops->parameters, &args) &&
                              csg_compound_slab(&walk->base, node, &args, space->in_boolean, &part)
                        : csg_repeats_read(&walk->base, node, ops, space->in_boolean, &part);
    if (done && part.is_too_large)
        csg_walk_unsupported(
            &walk->base, node,
            "%s: it takes more than %d convex solids, or its numbers are too large", ops->name,
            CSG_PART_MAX_SHAPES);
    else if (done)
        done = add_part(walk, node, space, &part);
    csg_part_finish(&part);
    if (csg_walk_node(&walk->base, node)->end > walk->compound_end)
        walk->compound_end = csg_walk_node(&walk->base, node)->end;
    return done;
}

/* ---- the walk ----------------------------------------------------------------------------- */

/* A node with children. Only those that change the space get a frame. */
static bool enter(struct walk *walk, uint32_t node)
{
    const struct csg_parsed_node *parsed = csg_walk_node(&walk->base, node);
    const struct csg_node_ops *ops = csg_walk_ops(&walk->base, node);
    struct frame frame = walk->frames.data[walk->frames.num - 1];
    const bool was_in_boolean = frame.space.in_boolean, was_marked = frame.space.is_marked;
    struct csg_args args;
    if (!csg_walk_args(&walk->base, node, ops->name, ops->parameters, &args))
        return false;
    if (ops->enter)
        ops->enter(&args, &frame.space);
    frame.end = parsed->end;
    frame.space.in_boolean = was_in_boolean || csg_walk_is_boolean(&walk->base, node);
    frame.space.is_marked |= is_marked(walk, node);
    const bool has_changed = ops->enter || frame.space.in_boolean != was_in_boolean ||
                             frame.space.is_marked != was_marked;
    if (has_changed && frame.end > node + 1 && !csg_array_push(&walk->frames, frame))
        return csg_log_memory(&walk->builder->report->log);
    return true;
}

static bool visit(struct walk *walk, uint32_t node)
{
    const struct csg_meaning *meaning = &walk->builder->meanings[node];
    const bool is_malformed = csg_walk_node(&walk->base, node)->malformed;
    while (walk->frames.data[walk->frames.num - 1].end <= node)
        walk->frames.num--;
    if (is_malformed || meaning->is_misplaced)
        return true;
    if (meaning->is_idle)
        return !csg_has_children(meaning) || enter(walk, node);
    if (meaning->role == CSG_ROLE_SOLID)
        return read_solid(walk, node, &walk->frames.data[walk->frames.num - 1].space);
    if (csg_is_compound(meaning))
        return read_compound(walk, node, &walk->frames.data[walk->frames.num - 1].space);
    return !csg_has_children(meaning) || enter(walk, node);
}

static bool is_off(const struct csg_builder *builder, uint32_t node)
{
    return (builder->document->nodes.data[node].modifiers & CSG_MODIFIER_DISABLE) != 0;
}

/* What comes behind a node whose children do not count, or the first of those. */
static uint32_t next_node(const struct csg_builder *builder, uint32_t node)
{
    const bool descend = !is_off(builder, node) && csg_has_leaves(&builder->meanings[node]);
    return descend ? node + 1 : builder->document->nodes.data[node].end;
}

/* Whether the walk to a node has nothing to do here: what is around that node is entered. */
static bool is_passed_by(const struct csg_builder *builder, uint32_t node, uint32_t first)
{
    return node < first && (builder->document->nodes.data[node].end <= first ||
                            next_node(builder, node) > node + 1);
}

bool csg_build_leaves_in(struct csg_builder *builder, uint32_t begin, uint32_t end)
{
    const struct csg_parsed_node *nodes = builder->document->nodes.data;
    struct frame around = {UINT32_MAX, builder->space ? *builder->space : csg_space_world};
    around.space.is_crowded |= builder->num_extrusions >= CSG_EXTRUDE_CROWD;
    struct walk walk = {.base = {.builder = builder}, .builder = builder};
    bool done = csg_array_push(&walk.frames, around) || csg_log_memory(&builder->report->log);
    for (uint32_t i = builder->begin; done && i < end;) {
        if (is_passed_by(builder, i, begin)) {
            i = nodes[i].end;
            continue;
        }
        done = is_off(builder, i) || visit(&walk, i);
        i = next_node(builder, i);
    }
    if (builder->origins)
        builder->origins->are_placed |= walk.base.was_placed;
    csg_arguments_finish(&walk.base.arguments);
    free(walk.frames.data);
    return done;
}

void csg_build_renumber(struct csg_builder *builder, uint32_t begin, uint32_t end, uint32_t gap)
{
    const struct csg_parsed_node *nodes = builder->document->nodes.data;
    for (uint32_t i = builder->begin; i < end;) {
        struct csg_meaning *meaning = &builder->meanings[i];
        if (is_passed_by(builder, i, begin)) {
            i = nodes[i].end;
            continue;
        }
        if (i >= begin && !is_off(builder, i) && meaning->role == CSG_ROLE_SOLID &&
            meaning->leaf != CSG_NO_LEAF)
            meaning->leaf -= gap;
        i = next_node(builder, i);
    }
}
