/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "nodes/build.h"
#include "nodes/handoff.h"

enum { WHY_SIZE = 320 };

/* More fragments or slices than that are no work that openscad ends in sensible time and memory. */
#define MAX_FRAGMENTS 65536.0

static const struct csg_arg *find_absurd(const struct csg_arguments *arguments)
{
    static const char *const names[] = {"$fn", "slices", "segments"};
    for (size_t i = 0; i < arguments->args.num; i++) {
        const struct csg_arg *arg = &arguments->args.data[i];
        for (size_t j = 0; j < sizeof names / sizeof names[0]; j++)
            if (arg->name && strcmp(arg->name, names[j]) == 0 &&
                arg->value.type == CSG_VALUE_NUMBER && arg->value.number > MAX_FRAGMENTS &&
                isfinite(arg->value.number))
                return arg;
    }
    return NULL;
}

/* Whether some number in the subtree keeps openscad from being asked; why, behind the reason. */
static bool is_absurd(struct csg_builder *builder, uint32_t node, const char *reason,
                      char why[WHY_SIZE])
{
    const struct csg_parsed_node *nodes = builder->document->nodes.data;
    struct csg_arguments arguments = {0};
    const struct csg_arg *absurd = NULL;
    for (uint32_t i = node; i < nodes[node].end && !absurd; i++)
        if (csg_document_arguments(builder->document, i, &arguments, builder->report))
            absurd = find_absurd(&arguments);
    if (absurd)
        snprintf(why, WHY_SIZE,
                 "%.160s; openscad is asked for no more than %.0f fragments or slices, and "
                 "%u:%u has %s = %g",
                 reason, MAX_FRAGMENTS, (unsigned)absurd->value.line,
                 (unsigned)absurd->value.column, absurd->name, absurd->value.number);
    csg_arguments_finish(&arguments);
    return absurd != NULL;
}

void csg_unsupported(struct csg_builder *builder, uint32_t node, const char *reason)
{
    const uint8_t dimension = builder->meanings[node].dimension;
    char why[WHY_SIZE];
    if (builder->handoff && is_absurd(builder, node, reason, why))
        csg_refuse(builder, node, why);
    else if (!builder->handoff || !csg_handoff_want(builder->handoff, node, dimension, reason))
        csg_refuse(builder, node, reason);
}

void csg_refuse(struct csg_builder *builder, uint32_t node, const char *reason)
{
    const bool skip = builder->skip_unsupported;
    csg_report_print(
        builder->report, skip ? CSGCAST_LOG_WARNING : CSGCAST_LOG_ERROR,
        CSGCAST_MESSAGE_UNSUPPORTED, builder->document->nodes.data[node].place, "%s; %s", reason,
        skip ? "left out with all that is in it" : "--skip-unsupported draws the rest");
}

/* Nodes that are not done natively, whatever is in them. The outermost one takes all of it along.
 */
bool csg_build_unsupported(struct csg_builder *builder)
{
    const struct csg_parsed_node *nodes = builder->document->nodes.data;
    for (uint32_t i = builder->begin; i < builder->end;) {
        const struct csg_meaning *meaning = &builder->meanings[i];
        const bool is_off = (nodes[i].modifiers & CSG_MODIFIER_DISABLE) != 0;
        if (is_off || meaning->is_misplaced || meaning->is_handed_off) {
            i = nodes[i].end;
        } else if (meaning->role == CSG_ROLE_UNSUPPORTED) {
            char reason[128];
            snprintf(reason, sizeof reason, "%.*s is not supported yet",
                     (int)(nodes[i].name_length < 64 ? nodes[i].name_length : 64),
                     builder->document->text + nodes[i].at);
            csg_unsupported(builder, i, reason);
            i = nodes[i].end;
        } else {
            i++;
        }
    }
    return true;
}
