/* SPDX-License-Identifier: MIT */
/*
 * OpenSCAD does not mix two and three dimensions: among the children of a node the first one
 * decides and those that differ are dropped with a warning. Its preview shows all of the outermost
 * union, figures as slabs, though; so it is here where a figure comes first: no mesh is made of
 * that.
 */
#include "nodes/walk.h"

static bool is_off(const struct csg_builder *builder, uint32_t node)
{
    return (builder->document->nodes.data[node].modifiers &
            (CSG_MODIFIER_DISABLE | CSG_MODIFIER_BACKGROUND)) != 0;
}

/* Roles that say nothing themselves take the dimension of the first child that has one. Counts the
 * solids whose first child is a drawing. */
static void find_dimensions(struct csg_builder *builder)
{
    const struct csg_parsed_node *nodes = builder->document->nodes.data;
    for (uint32_t i = builder->end; i-- > builder->begin;) {
        struct csg_meaning *meaning = &builder->meanings[i];
        for (uint32_t child = i + 1; child < nodes[i].end && meaning->dimension == 0;
             child = nodes[child].end)
            if (!is_off(builder, child))
                meaning->dimension = builder->meanings[child].dimension;
        builder->num_extrusions += meaning->dimension == 3 && i + 1 < nodes[i].end &&
                                   builder->meanings[i + 1].dimension == 2;
    }
}

/* A drawing that no extrusion is around: maps, colours and Booleans act on slabs as on solids. */
static void make_slabs(struct csg_builder *builder, uint32_t root)
{
    const struct csg_parsed_node *nodes = builder->document->nodes.data;
    for (uint32_t i = root; i < nodes[root].end;) {
        struct csg_meaning *meaning = &builder->meanings[i];
        csg_make_slab(meaning);
        i = meaning->is_slab || !csg_has_children(meaning) ? nodes[i].end : i + 1;
    }
}

static void check_child(struct csg_builder *builder, uint32_t child, uint8_t wanted)
{
    const struct csg_parsed_node *parsed = &builder->document->nodes.data[child];
    struct csg_meaning *meaning = &builder->meanings[child];
    if (meaning->dimension == 2 && wanted != 2 && parsed->modifiers & CSG_MODIFIER_BACKGROUND) {
        make_slabs(builder, child);
        return;
    }
    if (meaning->dimension == 0 || meaning->dimension == wanted || wanted == 0)
        return;
    meaning->is_misplaced = true;
    if (is_off(builder, child) || meaning->role == CSG_ROLE_UNKNOWN)
        return;
    csg_report_warning(builder->report, CSGCAST_MESSAGE_SCENE, parsed->place,
                       wanted == 3 ? "%.*s is two-dimensional among solids; it is left out"
                                   : "%.*s is a solid in a two-dimensional drawing; it is left out",
                       (int)parsed->name_length, builder->document->text + parsed->at);
}

/* What the children of a node must be. */
static uint8_t wanted_below(const struct csg_builder *builder, uint32_t node)
{
    const struct csg_parsed_node *parsed = &builder->document->nodes.data[node];
    const struct csg_meaning *meaning = &builder->meanings[node];
    const struct csg_node_ops *ops =
        csg_node_find(builder->document->text + parsed->at, parsed->name_length);
    return ops && ops->wants ? ops->wants : meaning->dimension;
}

static void check_nodes(struct csg_builder *builder)
{
    const struct csg_parsed_node *nodes = builder->document->nodes.data;
    for (uint32_t i = builder->begin; i < builder->end;) {
        const struct csg_meaning *meaning = &builder->meanings[i];
        if (meaning->is_misplaced || nodes[i].modifiers & CSG_MODIFIER_DISABLE ||
            meaning->is_handed_off || meaning->role == CSG_ROLE_UNKNOWN ||
            meaning->role == CSG_ROLE_UNSUPPORTED || nodes[i].end == i + 1) {
            i = nodes[i].end;
            continue;
        }
        const uint8_t wanted = wanted_below(builder, i);
        for (uint32_t child = i + 1; child < nodes[i].end; child = nodes[child].end)
            check_child(builder, child, wanted);
        i++;
    }
}

static void check_roots(struct csg_builder *builder)
{
    const struct csg_parsed_node *nodes = builder->document->nodes.data;
    uint8_t first = 0;
    for (uint32_t i = builder->begin; i < builder->end && first == 0; i = nodes[i].end)
        first = is_off(builder, i) ? 0 : builder->meanings[i].dimension;
    for (uint32_t i = builder->begin; i < builder->end; i = nodes[i].end) {
        const struct csg_meaning *meaning = &builder->meanings[i];
        if (meaning->dimension != 2 || nodes[i].modifiers & CSG_MODIFIER_DISABLE ||
            meaning->role == CSG_ROLE_UNSUPPORTED)
            continue;
        if (first == 3)
            check_child(builder, i, 3);
        else
            make_slabs(builder, i);
    }
}

bool csg_build_dimensions(struct csg_builder *builder)
{
    find_dimensions(builder);
    check_roots(builder);
    check_nodes(builder);
    return true;
}
