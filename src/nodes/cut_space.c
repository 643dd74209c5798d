/* SPDX-License-Identifier: MIT */
#include "nodes/cut_space.h"

#include "nodes/compounds.h"
#include "nodes/figures.h"

/* Siblings, and the node around them. */
struct siblings {
    uint32_t begin, end;
    bool counts_empty; /* difference and intersection meet empty operands as well */
    bool in_sum;       /* operands of minkowski */
};

static bool has_solid(const struct csg_walk *walk, uint32_t node)
{
    const struct csg_builder *builder = walk->builder;
    const uint32_t end = csg_walk_node(walk, node)->end;
    for (uint32_t i = node; i < end;) {
        const struct csg_meaning *meaning = &builder->meanings[i];
        if (csg_is_left_out(builder, i))
            i = csg_walk_node(walk, i)->end;
        else if (meaning->role == CSG_ROLE_SOLID || csg_is_compound(meaning))
            return true;
        else
            i++;
    }
    return false;
}

static bool has_several(const struct csg_walk *walk, const struct siblings *siblings)
{
    int num = 0;
    for (uint32_t i = siblings->begin; i < siblings->end && num < 2;
         i = csg_walk_node(walk, i)->end)
        num += !csg_is_left_out(walk->builder, i) && (siblings->counts_empty || has_solid(walk, i));
    return num == 2;
}

static void enter_resize(const struct csg_walk *walk, uint32_t node, struct csg_space *space)
{
    for (const struct csg_resized *resized = walk->resized; resized; resized = resized->outer)
        if (resized->node == node)
            space->map = csg_map_multiply(&space->map, &resized->map);
}

/* What a node around the polyhedron does to its points. */
static bool enter(struct csg_walk *walk, uint32_t node, struct csg_space *space)
{
    const struct csg_builder *builder = walk->builder;
    const struct csg_node_ops *ops = csg_walk_ops(walk, node);
    if (!ops || !ops->enter || csg_walk_node(walk, node)->malformed)
        return true;
    if (!csg_document_arguments(builder->document, node, &walk->arguments, builder->report))
        return false;
    const struct csg_args args = {.args = walk->arguments.args.data,
                                  .num = walk->arguments.args.num,
                                  .parameters = ops->parameters,
                                  .log = &csg_log_silent,
                                  .node = ops->name};
    ops->enter(&args, space);
    return true;
}

static bool is_resize(const struct csg_walk *walk, uint32_t node)
{
    const struct csg_node_ops *ops = csg_walk_ops(walk, node);
    return ops && ops->compound == csg_compound_resize;
}

static bool is_sum(const struct csg_walk *walk, uint32_t node)
{
    const struct csg_node_ops *ops = csg_walk_ops(walk, node);
    return ops && ops->compound == csg_compound_minkowski;
}

/* A section is one of CGAL's, also where there is only one solid. */
static bool enter_projection(struct csg_walk *walk, uint32_t node, struct csg_cut_space *to)
{
    const struct csg_node_ops *ops = csg_walk_ops(walk, node);
    struct csg_args args;
    if (!ops || ops->figure != csg_figure_projection)
        return true;
    if (!csg_walk_args(walk, node, ops->name, ops->parameters, &args))
        return false;
    to->on_grid |= csg_args_bool(&args, "cut");
    return true;
}

bool csg_cut_space_find(struct csg_walk *walk, uint32_t node, struct csg_cut_space *to)
{
    struct siblings siblings = {walk->builder->begin, walk->builder->end, false, false};
    struct csg_space space = csg_space_world;
    while (siblings.begin <= node) {
        uint32_t around = siblings.begin;
        while (csg_walk_node(walk, around)->end <= node)
            around = csg_walk_node(walk, around)->end;
        if (has_several(walk, &siblings)) {
            space.map = csg_map_identity;
            to->on_grid = true;
            to->in_sum = siblings.in_sum;
        }
        if (around == node)
            break;
        if (is_resize(walk, around)) {
            enter_resize(walk, around, &space);
        } else if (!csg_has_children(&walk->builder->meanings[around])) {
            if (!enter_projection(walk, around, to))
                return false;
            space.map = csg_map_identity;
        } else if (!enter(walk, around, &space)) {
            return false;
        }
        const uint8_t role = walk->builder->meanings[around].role;
        siblings = (struct siblings){around + 1, csg_walk_node(walk, around)->end,
                                     role == CSG_ROLE_DIFFERENCE || role == CSG_ROLE_INTERSECTION,
                                     is_sum(walk, around)};
    }
    to->map = space.is_empty ? csg_map_identity : space.map; /* nothing will be seen of it */
    return true;
}
