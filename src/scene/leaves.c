/* SPDX-License-Identifier: MIT */
#include "scene/build.h"

#include <stdlib.h>
#include <string.h>

#include "scene/transforms.h"

/* A node that changed the space of what is below it. */
struct frame {
    uint32_t end; /* of its subtree */
    struct csg_space space;
};

struct walk {
    struct csg_builder *builder;
    struct csg_arguments arguments;
    CSG_ARRAY(struct frame) frames; /* the first is the world */
};

static const struct csg_parsed_node *parsed_of(const struct walk *walk, uint32_t node)
{
    return &walk->builder->document->nodes.data[node];
}

/* ---- arguments ---------------------------------------------------------------------------- */

static bool is_parameter(const char *parameters, const char *name)
{
    const size_t length = strlen(name);
    for (const char *word = parameters ? parameters : ""; *word;) {
        const size_t word_length = strcspn(word, " ");
        if (word_length == length && memcmp(word, name, length) == 0)
            return true;
        word += word_length;
        word += strspn(word, " ");
    }
    return false;
}

/* A misspelt name would silently mean the default. $fn and its like may stand anywhere. */
static void warn_of_strange_names(const struct csg_args *args)
{
    for (size_t i = 0; i < args->num; i++) {
        const struct csg_arg *arg = &args->args[i];
        if (arg->name && arg->name[0] != '$' && strcmp(arg->name, "convexity") != 0 &&
            !is_parameter(args->parameters, arg->name))
            csg_log_warning(args->log, CSGCAST_MESSAGE_SCENE,
                            "%s:%u:%u: %s has no parameter '%.40s'; it has: %s", args->file,
                            (unsigned)arg->value.line, (unsigned)arg->value.column, args->node,
                            arg->name, args->parameters ? args->parameters : "none");
    }
}

/* false when memory is out. */
static bool read_args(struct walk *walk, uint32_t node, const char *name, const char *parameters,
                      struct csg_args *args)
{
    const struct csg_builder *builder = walk->builder;
    const struct csg_parsed_node *parsed = parsed_of(walk, node);
    if (!csg_document_arguments(builder->document, node, &walk->arguments, builder->report))
        return false;
    *args = (struct csg_args){.args = walk->arguments.args.data,
                              .num = walk->arguments.args.num,
                              .parameters = parameters,
                              .facets = builder->facets,
                              .log = &builder->report->log,
                              .file = builder->report->file,
                              .line = parsed->place.line,
                              .column = parsed->place.column,
                              .node = name};
    warn_of_strange_names(args);
    return true;
}

/* ---- solids ------------------------------------------------------------------------------- */

static bool is_finite_vector(struct csg_vec3 v)
{
    return isfinite(v.x) && isfinite(v.y) && isfinite(v.z);
}

/* Maps near the limits of double take a shape beyond them. */
static bool is_finite_shape(const struct csg_shape *shape)
{
    bool finite = true;
    for (size_t i = 0; i < shape->num_planes; i++)
        finite &= is_finite_vector(shape->planes[i].normal) && isfinite(shape->planes[i].offset);
    for (int i = 0; shape->has_quadric && i < 3; i++)
        for (int j = 0; j < 4; j++)
            finite &= isfinite(shape->quadric.to_canon.m[i][j]) != 0;
    return finite;
}

/* OpenSCAD knows a colour of which components are unset; here it is set or not. */
static void set_color(struct csg_leaf *leaf, const struct csg_space *space)
{
    memcpy(leaf->color, space->color, sizeof leaf->color);
    if (!(leaf->color[0] >= 0 && leaf->color[1] >= 0 && leaf->color[2] >= 0))
        leaf->color[0] = leaf->color[1] = leaf->color[2] = -1;
    if (!(leaf->color[3] >= 0))
        leaf->color[3] = 1;
}

/* Into world space. false when nothing is left of it there. */
static bool place_shape(struct csg_shape *shape, const struct csg_space *space)
{
    const bool has_written = csg_box_is_finite(&shape->written);
    const struct csg_box *box = has_written ? &shape->written : &shape->bounds;
    shape->rounding = shape->rounding * csg_space_stretch(space) + csg_space_rounding(space, box);
    return !space->is_empty && csg_shape_map(shape, &space->map) && is_finite_shape(shape);
}

static bool add_leaf(struct walk *walk, uint32_t node, const struct csg_leaf *leaf)
{
    struct csgcast_scene *scene = walk->builder->scene;
    if (scene->num_leaves == scene->leaves_capacity &&
        !csg_array_grow((void **)&scene->leaves, &scene->leaves_capacity, scene->num_leaves, 1,
                        sizeof *scene->leaves))
        return csg_log_memory(&walk->builder->report->log);
    walk->builder->meanings[node].leaf = (uint32_t)scene->num_leaves;
    scene->leaves[scene->num_leaves++] = *leaf;
    return true;
}

/* Empty solids and malformed ones get no leaf. */
static bool read_solid(struct walk *walk, uint32_t node, const struct csg_space *space)
{
    const struct csg_parsed_node *parsed = parsed_of(walk, node);
    const enum csg_kind kind = walk->builder->meanings[node].kind;
    const struct csg_solid_ops *ops = csg_solids[kind];
    struct csg_args args;
    struct csg_leaf leaf = {
        .kind = kind, .line = parsed->place.line, .column = parsed->place.column};
    leaf.shape.frame = csg_map_identity;
    if (!read_args(walk, node, ops->name, ops->parameters, &args))
        return false;
    const enum csg_read_result result = ops->read(&args, &leaf.shape);
    if (result == CSG_READ_OK && place_shape(&leaf.shape, space)) {
        set_color(&leaf, space);
        if (add_leaf(walk, node, &leaf))
            return true;
        csg_shape_finish(&leaf.shape);
        return false;
    }
    csg_shape_finish(&leaf.shape);
    walk->builder->scene->info.num_dropped += result != CSG_READ_ERROR;
    return true;
}

/* ---- the walk ----------------------------------------------------------------------------- */

/* A difference or intersection that has something to do. */
static bool is_boolean(const struct walk *walk, uint32_t node)
{
    const struct csg_parsed_node *nodes = walk->builder->document->nodes.data;
    int num_operands = 0;
    if (walk->builder->meanings[node].role == CSG_ROLE_UNION)
        return false;
    for (uint32_t i = node + 1; i < nodes[node].end && num_operands < 2; i = nodes[i].end)
        num_operands += !csg_is_left_out(&nodes[i]);
    return num_operands == 2;
}

/* A node with children. Only those that change the space get a frame. */
static bool enter(struct walk *walk, uint32_t node)
{
    const struct csg_parsed_node *parsed = parsed_of(walk, node);
    const struct csg_node_ops *ops =
        csg_node_find(walk->builder->document->text + parsed->at, parsed->name_length);
    struct frame frame = walk->frames.data[walk->frames.num - 1];
    const bool was_in_boolean = frame.space.in_boolean;
    struct csg_args args;
    if (!read_args(walk, node, ops->name, ops->parameters, &args))
        return false;
    if (ops->enter)
        ops->enter(&args, &frame.space);
    frame.end = parsed->end;
    frame.space.in_boolean = was_in_boolean || is_boolean(walk, node);
    const bool has_changed = ops->enter || frame.space.in_boolean != was_in_boolean;
    if (has_changed && frame.end > node + 1 && !csg_array_push(&walk->frames, frame))
        return csg_log_memory(&walk->builder->report->log);
    return true;
}

static bool visit(struct walk *walk, uint32_t node)
{
    const struct csg_meaning *meaning = &walk->builder->meanings[node];
    const bool is_malformed = parsed_of(walk, node)->malformed;
    while (walk->frames.data[walk->frames.num - 1].end <= node)
        walk->frames.num--;
    if (is_malformed)
        return true;
    if (meaning->role == CSG_ROLE_SOLID)
        return read_solid(walk, node, &walk->frames.data[walk->frames.num - 1].space);
    return !csg_has_children(meaning) || enter(walk, node);
}

bool csg_build_leaves(struct csg_builder *builder)
{
    const struct csg_parsed_node *nodes = builder->document->nodes.data;
    const struct frame world = {UINT32_MAX, csg_space_world};
    struct walk walk = {.builder = builder};
    bool done = csg_array_push(&walk.frames, world) || csg_log_memory(&builder->report->log);
    for (uint32_t i = builder->begin; done && i < builder->end;) {
        const bool is_off = (nodes[i].modifiers & CSG_MODIFIER_DISABLE) != 0;
        done = is_off || visit(&walk, i);
        i = is_off || !csg_has_children(&builder->meanings[i]) ? nodes[i].end : i + 1;
    }
    csg_arguments_finish(&walk.arguments);
    free(walk.frames.data);
    return done;
}
