/* SPDX-License-Identifier: MIT */
#include "nodes/build.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "nodes/handoff.h"
#include "nodes/import.h"

/* Characters of a name that a message quotes. */
enum { shown_length = 40 };

static const char *name_of(const struct csg_builder *builder, uint32_t node)
{
    return builder->document->text + builder->document->nodes.data[node].at;
}

/* The first ! in the order of the text wins, as in OpenSCAD; the others only get a warning. */
static void select_root(struct csg_builder *builder)
{
    const struct csg_parsed_node *nodes = builder->document->nodes.data;
    const uint32_t num = (uint32_t)builder->document->nodes.num;
    bool found = false;
    builder->begin = 0;
    builder->end = num;
    for (uint32_t i = 0; i < num;) {
        if (nodes[i].modifiers & CSG_MODIFIER_DISABLE) {
            i = nodes[i].end;
            continue;
        }
        if (nodes[i].modifiers & CSG_MODIFIER_ROOT && found) {
            csg_report_warning(builder->report, CSGCAST_MESSAGE_SCENE, nodes[i].place,
                               "a second '!'; only the first one in the text counts");
        } else if (nodes[i].modifiers & CSG_MODIFIER_ROOT) {
            builder->begin = i;
            builder->end = nodes[i].end;
            found = true;
        }
        i++;
    }
}

static void report_unknown(struct csg_builder *builder, uint32_t node)
{
    const struct csg_parsed_node *parsed = &builder->document->nodes.data[node];
    const bool too_long = parsed->name_length > shown_length;
    const char *nearest = csg_node_suggest(name_of(builder, node), parsed->name_length);
    char hint[64] = "";
    if (builder->skip_unsupported)
        snprintf(hint, sizeof hint, "; left out with all that is in it");
    else if (nearest)
        snprintf(hint, sizeof hint, "; did you mean '%s'?", nearest);
    csg_report_print(builder->report,
                     builder->skip_unsupported ? CSGCAST_LOG_WARNING : CSGCAST_LOG_ERROR,
                     CSGCAST_MESSAGE_UNSUPPORTED, parsed->place, "unknown node '%.*s%s'%s",
                     (int)(too_long ? shown_length : parsed->name_length), name_of(builder, node),
                     too_long ? "..." : "", hint);
}

static struct csg_meaning meaning_of(const struct csg_builder *builder, uint32_t node)
{
    const size_t length = builder->document->nodes.data[node].name_length;
    const char *name = name_of(builder, node);
    const struct csg_node_ops *ops = csg_node_find(name, length);
    const struct csg_handed_off *handed_off =
        builder->handoff ? csg_handoff_find(builder->handoff, node) : NULL;
    struct csg_meaning meaning = {.role = CSG_ROLE_UNKNOWN, .leaf = CSG_NO_LEAF};
    if (handed_off)
        ops = csg_handoff_ops(handed_off->dimension);
    meaning.is_handed_off = handed_off != NULL;
    if (ops) {
        meaning.role = (uint8_t)ops->role;
        meaning.kind = (uint8_t)ops->kind;
        meaning.dimension = ops->dimension;
        meaning.is_whole = ops->is_whole;
        meaning.shows_marks = ops->shows_marks;
    } else {
        meaning.kind = (uint8_t)csg_solid_find(name, length);
        meaning.role = meaning.kind < CSG_NUM_KINDS ? CSG_ROLE_SOLID : CSG_ROLE_UNKNOWN;
        meaning.dimension = 3;
    }
    return meaning;
}

/* A drawing, a mesh, or something that only OpenSCAD may know: the ending of the file tells. */
static void classify_import(const struct csg_builder *builder, uint32_t node,
                            struct csg_meaning *meaning)
{
    struct csg_arguments arguments = {0};
    meaning->dimension = 3;
    if (!builder->document->nodes.data[node].malformed &&
        csg_document_arguments(builder->document, node, &arguments, builder->report)) {
        const struct csg_args args = {
            .args = arguments.args.data, .num = arguments.args.num, .parameters = "file"};
        const char *name = csg_import_name(&args);
        meaning->dimension = csg_import_is_drawing(name) ? 2 : 3;
        if (csg_import_is_mesh(name))
            meaning->role = CSG_ROLE_COMPOUND;
        else if (csg_import_is_drawing(name))
            meaning->role = CSG_ROLE_FIGURE;
    }
    csg_arguments_finish(&arguments);
}

/* Returns the node to go on with: the next in the text, or the one behind this subtree. */
static uint32_t assign_meaning(struct csg_builder *builder, uint32_t node)
{
    const struct csg_parsed_node *parsed = &builder->document->nodes.data[node];
    struct csg_meaning *meaning = &builder->meanings[node];
    *meaning = meaning_of(builder, node);
    if (meaning->role == CSG_ROLE_UNSUPPORTED && meaning->dimension == 0 &&
        parsed->name_length == 6 && memcmp(name_of(builder, node), "import", 6) == 0)
        classify_import(builder, node, meaning);
    if (meaning->role == CSG_ROLE_UNKNOWN) {
        report_unknown(builder, node);
        return builder->skip_unsupported ? parsed->end : node + 1;
    }
    if (meaning->is_handed_off)
        return parsed->end;
    if (meaning->role == CSG_ROLE_SOLID && parsed->end > node + 1) {
        csg_report_warning(builder->report, CSGCAST_MESSAGE_SCENE, parsed[1].place,
                           "%s is a solid and has no children; they are left out",
                           csg_solids[meaning->kind]->name);
        return parsed->end;
    }
    return node + 1;
}

bool csg_build_meanings(struct csg_builder *builder)
{
    const struct csg_parsed_node *nodes = builder->document->nodes.data;
    select_root(builder);
    builder->meanings = calloc(builder->document->nodes.num + 1, sizeof *builder->meanings);
    if (!builder->meanings)
        return csg_log_memory(&builder->report->log);
    for (uint32_t i = builder->begin; i < builder->end;)
        i = nodes[i].modifiers & CSG_MODIFIER_DISABLE ? nodes[i].end : assign_meaning(builder, i);
    return true;
}
