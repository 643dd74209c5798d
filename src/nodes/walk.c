/* SPDX-License-Identifier: MIT */
#include "nodes/walk.h"

#include <stdlib.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "mesh/surface.h"
#include "nodes/handoff.h"
#include "nodes/transforms.h"
#include "plane/extrude.h"

const struct csg_node_ops *csg_walk_ops(const struct csg_walk *walk, uint32_t node)
{
    const struct csg_parsed_node *parsed = csg_walk_node(walk, node);
    const struct csg_meaning *meaning = &walk->builder->meanings[node];
    if (meaning->is_handed_off)
        return csg_handoff_ops(meaning->dimension);
    return csg_node_find(walk->builder->document->text + parsed->at, parsed->name_length);
}

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
void csg_warn_of_strange_names(const struct csg_args *args)
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

bool csg_walk_args(struct csg_walk *walk, uint32_t node, const char *name, const char *parameters,
                   struct csg_args *args)
{
    const struct csg_builder *builder = walk->builder;
    const struct csg_parsed_node *parsed = csg_walk_node(walk, node);
    const bool is_handed_off = builder->meanings[node].is_handed_off; /* then it has none */
    if (!is_handed_off &&
        !csg_document_arguments(builder->document, node, &walk->arguments, builder->report))
        return false;
    *args = (struct csg_args){.args = walk->arguments.args.data,
                              .num = is_handed_off ? 0 : walk->arguments.args.num,
                              .parameters = parameters,
                              .facets = builder->facets,
                              .log = &builder->report->log,
                              .file = builder->report->file,
                              .line = parsed->place.line,
                              .column = parsed->place.column,
                              .node = name};
    csg_warn_of_strange_names(args);
    return true;
}

/* Leaves the node out, in one of the two ways, for that reason. */
static void leave_out(struct csg_walk *walk, uint32_t node,
                      void (*way)(struct csg_builder *, uint32_t, const char *), const char *format,
                      va_list args)
{
    char small[CSG_LOG_SMALL];
    char *large = csg_log_format(small, format, args);
    way(walk->builder, node, large ? large : small);
    free(large);
}

void csg_walk_unsupported(struct csg_walk *walk, uint32_t node, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    leave_out(walk, node, csg_unsupported, format, args);
    va_end(args);
}

void csg_walk_refuse(struct csg_walk *walk, uint32_t node, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    leave_out(walk, node, csg_refuse, format, args);
    va_end(args);
}

void csg_walk_warning(struct csg_walk *walk, uint32_t node, const char *format, ...)
{
    const struct csg_node_ops *ops = csg_walk_ops(walk, node);
    char small[CSG_LOG_SMALL];
    va_list args;
    va_start(args, format);
    char *large = csg_log_format(small, format, args);
    va_end(args);
    csg_report_warning(walk->builder->report, CSGCAST_MESSAGE_SCENE,
                       csg_walk_node(walk, node)->place, "%s: %s", ops ? ops->name : "node",
                       large ? large : small);
    free(large);
}

/* Maps near the limits of double take a shape beyond them. */
static bool is_finite_shape(const struct csg_shape *shape)
{
    bool finite = !shape->surface || csg_surface_is_finite(shape->surface, &shape->frame);
    for (size_t i = 0; i < shape->num_planes; i++)
        finite &= csg_vec3_is_finite(shape->planes[i].normal) && isfinite(shape->planes[i].offset);
    for (int i = 0; shape->has_quadric && i < 3; i++)
        for (int j = 0; j < 4; j++)
            finite &= isfinite(shape->quadric.to_canon.m[i][j]) != 0;
    return finite;
}

bool csg_space_place(const struct csg_space *space, struct csg_shape *shape)
{
    const bool has_written = csg_box_is_finite(&shape->written);
    const struct csg_box *box = has_written ? &shape->written : &shape->bounds;
    shape->rounding = shape->rounding * csg_space_stretch(space) + csg_space_rounding(space, box);
    return !space->is_empty && csg_shape_map(shape, &space->map) && is_finite_shape(shape);
}

bool csg_walk_is_boolean(const struct csg_walk *walk, uint32_t node)
{
    const struct csg_parsed_node *nodes = walk->builder->document->nodes.data;
    int num_operands = 0;
    if (walk->builder->meanings[node].role == CSG_ROLE_UNION)
        return false;
    for (uint32_t i = node + 1; i < nodes[node].end && num_operands < 2; i = nodes[i].end)
        num_operands += !csg_is_left_out(walk->builder, i);
    return num_operands == 2;
}

size_t csg_walk_max_pieces(const struct csg_walk *walk, bool in_boolean)
{
    if (walk->is_operand)
        return SIZE_MAX;
    const struct csg_builder *builder = walk->builder;
    const bool is_crowded = builder->num_extrusions >= CSG_EXTRUDE_CROWD ||
                            (builder->space && builder->space->is_crowded);
    if (in_boolean && !is_crowded)
        return CSG_EXTRUDE_PIECES;
    return walk->is_see_through && !in_boolean ? CSG_EXTRUDE_BLENDED_PIECES
                                               : CSG_EXTRUDE_ALONE_PIECES;
}
