/* SPDX-License-Identifier: MIT */
#include <stdio.h>

#include "nodes/build.h"
#include "nodes/handoff.h"

void csg_unsupported(struct csg_builder *builder, uint32_t node, const char *reason)
{
    const uint8_t dimension = builder->meanings[node].dimension;
    const bool skip = builder->skip_unsupported;
    if (builder->handoff && csg_handoff_want(builder->handoff, node, dimension, reason))
        return;
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
