/* SPDX-License-Identifier: MIT */
#include "nodes/build.h"

#include <stdlib.h>

#include "nodes/origin.h"
#include "nodes/repeats.h"
#include "nodes/text.h"

/* Each # adds its subtree to the highlight layer once more. Nested in differences they could make
 * it quadratic in the size of the scene; beyond this many times its nodes they are left out.
 */
enum { max_highlight_growth = 16 };

/* A Boolean node that is being built. */
struct open {
    uint32_t end;  /* of its subtree, in the document */
    uint32_t node; /* in the tree */
    uint32_t num_operands;
    uint8_t role;
    bool negated;
    bool is_whole;      /* in a render() node, */
    bool whole_negated; /* ... which is complemented, */
    uint32_t whole;     /* ... this one */
};

struct tree_builder {
    const struct csg_builder *builder;
    struct csg_tree *tree;
    CSG_ARRAY(struct open) open;
    enum csg_layer layer; /* that of # is a copy */
    uint32_t whole;       /* the render() node of the last leaf that was in one */
};

static bool push_node(struct tree_builder *build, enum csg_op op, bool negated, uint32_t leaf)
{
    const struct csg_node node = {
        .op = (uint8_t)op, .negated = negated, .leaf = leaf, .end = (uint32_t)build->tree->num + 1};
    return csg_array_push(build->tree, node);
}

static const struct open *innermost(const struct tree_builder *build)
{
    return build->open.num > 0 ? &build->open.data[build->open.num - 1] : NULL;
}

/* Faces that are cut within a render() node are no cut faces. What is under # is in another layer
 * besides. */
static bool note_whole(struct tree_builder *build, uint32_t leaf, bool negated)
{
    struct csgcast_scene *scene = build->builder->scene;
    const struct open *open = innermost(build);
    if (!open || !open->is_whole || build->layer == CSG_LAYER_HIGHLIGHT)
        return true;
    scene->leaves[leaf].is_hole = negated != open->whole_negated;
    if (build->whole != open->whole || scene->wholes.num == 0) {
        const struct csg_whole whole = {leaf, leaf + 1, open->whole_negated};
        build->whole = open->whole;
        return csg_array_push(&scene->wholes, whole);
    }
    scene->wholes.data[scene->wholes.num - 1].end = leaf + 1;
    return true;
}

/* The empty set is an OR of nothing, its complement an AND of nothing. */
static bool push_leaf(struct tree_builder *build, uint32_t leaf, bool negated)
{
    if (leaf != CSG_NO_LEAF)
        return note_whole(build, leaf, negated) && push_node(build, CSG_LEAF, negated, leaf);
    return push_node(build, negated ? CSG_AND : CSG_OR, false, 0);
}

/* Notes where the part of a node comes to stand, for edits. */
static bool note_part(struct tree_builder *build, uint32_t node, bool negated)
{
    struct csg_origins *origins = build->builder->origins;
    const struct csg_part_place place = {node, (uint32_t)build->tree->num, (uint8_t)build->layer,
                                         negated};
    return !origins || csg_array_push(&origins->places, place);
}

/* Copies the tree of a compound: complemented, unions and intersections change places. */
static bool push_part(struct tree_builder *build, uint32_t part, bool negated)
{
    const struct csg_node *nodes = build->builder->parts.data;
    const uint32_t first = (uint32_t)build->tree->num;
    bool done = true;
    for (uint32_t i = part; i < nodes[part].end && done; i++) {
        struct csg_node node = nodes[i];
        node.end = node.end - part + first;
        if (node.op == CSG_LEAF) {
            node.negated = node.negated != negated;
            done = note_whole(build, node.leaf, node.negated);
        } else if (negated) {
            node.op = node.op == CSG_OR ? CSG_AND : CSG_OR;
        }
        done = done && csg_array_push(build->tree, node);
    }
    return done;
}

/* De Morgan: a negated union is an intersection of complements and the other way round. */
static bool open_node(struct tree_builder *build, uint32_t node, bool negated)
{
    const struct csg_meaning *meaning = &build->builder->meanings[node];
    const struct open *around = innermost(build);
    const bool is_inside = around && around->is_whole;
    const struct open open = {.end = build->builder->document->nodes.data[node].end,
                              .node = (uint32_t)build->tree->num,
                              .role = meaning->role,
                              .negated = negated,
                              .is_whole = is_inside || meaning->is_whole,
                              .whole_negated = is_inside ? around->whole_negated : negated,
                              .whole = is_inside ? around->whole : node};
    const bool is_or = (meaning->role == CSG_ROLE_UNION) != negated;
    return push_node(build, is_or ? CSG_OR : CSG_AND, false, 0) &&
           csg_array_push(&build->open, open);
}

/* A difference or intersection of nothing is empty, as a union of nothing is. */
static void close_node(struct tree_builder *build)
{
    const struct open *open = &build->open.data[--build->open.num];
    struct csg_node *node = &build->tree->data[open->node];
    node->end = (uint32_t)build->tree->num;
    if (open->num_operands == 0)
        node->op = open->negated ? CSG_AND : CSG_OR;
}

/* Whether the next operand of the innermost open node is complemented; counts it. */
static bool take_operand(struct tree_builder *build)
{
    if (build->open.num == 0)
        return false;
    struct open *open = &build->open.data[build->open.num - 1];
    const bool is_subtracted = open->role == CSG_ROLE_DIFFERENCE && open->num_operands > 0;
    open->num_operands++;
    return open->negated != is_subtracted;
}

static bool add_subtree(struct tree_builder *build, uint32_t root)
{
    const struct csg_parsed_node *nodes = build->builder->document->nodes.data;
    const uint32_t end = nodes[root].end;
    bool done = true;
    for (uint32_t i = root; done && i < end;) {
        const struct csg_meaning *meaning = &build->builder->meanings[i];
        while (build->open.num > 0 && build->open.data[build->open.num - 1].end <= i)
            close_node(build);
        if (i != root && csg_is_empty_operand(build->builder, i)) {
            done = push_leaf(build, CSG_NO_LEAF, take_operand(build));
            i = nodes[i].end;
        } else if (i != root && csg_is_left_out(build->builder, i)) {
            i = nodes[i].end;
        } else if (csg_has_children(meaning)) {
            done = open_node(build, i, take_operand(build));
            i++;
        } else if (csg_is_compound(meaning) && meaning->leaf != CSG_NO_LEAF) {
            const bool negated = take_operand(build);
            done = note_part(build, i, negated) && push_part(build, meaning->leaf, negated);
            i = nodes[i].end;
        } else {
            done = push_leaf(build, meaning->leaf, take_operand(build));
            i = nodes[i].end;
        }
    }
    while (build->open.num > 0)
        close_node(build);
    return done;
}

/* ---- layers ------------------------------------------------------------------------------- */

static bool is_model_root(const struct csg_builder *builder, uint32_t node)
{
    return !csg_is_left_out(builder, node);
}

static bool is_background(const struct csg_builder *builder, uint32_t node)
{
    return builder->meanings[node].shows_background;
}

static bool is_highlight(const struct csg_builder *builder, uint32_t node)
{
    return builder->meanings[node].shows_highlight;
}

struct layer_rule {
    enum csg_layer layer;
    bool nested; /* looks for roots inside of others and below nodes that are none */
    bool (*is_root)(const struct csg_builder *builder, uint32_t node);
};

static const struct layer_rule layer_rules[CSG_NUM_LAYERS] = {
    {CSG_LAYER_MODEL, false, is_model_root},
    {CSG_LAYER_BACKGROUND, true, is_background},
    {CSG_LAYER_HIGHLIGHT, true, is_highlight},
};

static bool is_too_large(const struct tree_builder *build, const struct csg_parsed_node *node)
{
    const size_t num_nodes = build->builder->document->nodes.num + build->builder->parts.num;
    if (build->tree->num / max_highlight_growth <= num_nodes)
        return false;
    csg_report_warning(build->builder->report, CSGCAST_MESSAGE_SCENE, node->place,
                       "too many '#' inside of each other; the highlights from here on are left "
                       "out");
    return true;
}

/* A layer is the union of the subtrees that its rule picks. */
static bool add_roots(struct tree_builder *build, const struct layer_rule *rule)
{
    const struct csg_builder *builder = build->builder;
    const struct csg_parsed_node *nodes = builder->document->nodes.data;
    bool done = true, is_full = false;
    for (uint32_t i = builder->begin; done && !is_full && i < builder->end;) {
        const bool is_off = (nodes[i].modifiers & CSG_MODIFIER_DISABLE) != 0;
        if (!is_off && rule->is_root(builder, i)) {
            is_full = rule->nested && is_too_large(build, &nodes[i]);
            done = is_full || add_subtree(build, i);
        }
        const bool descend = rule->nested && !is_off && csg_has_leaves(&builder->meanings[i]);
        i = descend ? i + 1 : nodes[i].end;
    }
    return done;
}

static bool build_layer(const struct csg_builder *builder, const struct layer_rule *rule)
{
    struct csg_tree *tree = &builder->scene->trees[rule->layer];
    struct tree_builder build = {
        .builder = builder, .tree = tree, .layer = rule->layer, .whole = UINT32_MAX};
    bool done = push_node(&build, CSG_OR, false, 0) && add_roots(&build, rule);
    free(build.open.data);
    if (!done)
        return csg_log_memory(&builder->report->log);
    tree->data[0].end = (uint32_t)tree->num;
    if (tree->num == 1)
        tree->num = 0; /* nothing: the empty tree */
    return true;
}

bool csg_build(struct csgcast_scene *scene, const struct csg_build_source *source,
               struct csg_handoff *handoff)
{
    const struct csgcast_scene_params *params = source->params;
    struct csg_text_state own_text = {0};
    struct csg_builder builder = {.document = source->document,
                                  .params = params,
                                  .report = source->report,
                                  .scene = scene,
                                  .facets = params->facets,
                                  .text = source->text ? source->text : &own_text,
                                  .clip.is_wanted = params->facets == CSGCAST_FACETS_AS_WRITTEN,
                                  .skip_unsupported = params->skip_unsupported,
                                  .origins = source->origins,
                                  .space = source->space,
                                  .handoff = handoff,
                                  .num_threads = params->num_threads,
                                  .directory = params->directory ? params->directory : "."};
    scene->num_threads = params->num_threads;
    builder.repeats = csg_repeats_create();
    bool done = csg_build_meanings(&builder) && csg_build_dimensions(&builder) &&
                csg_build_marks(&builder) && csg_build_unsupported(&builder) &&
                csg_build_leaves(&builder);
    for (int i = 0; done && i < CSG_NUM_LAYERS; i++)
        done = build_layer(&builder, &layer_rules[i]);
    csg_text_finish(&own_text);
    csg_repeats_destroy(builder.repeats);
    free(builder.meanings);
    free(builder.parts.data);
    return done;
}
