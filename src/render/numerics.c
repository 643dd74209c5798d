/* SPDX-License-Identifier: MIT */

/* Which objects of a frame are drawn in double, and why, for csgcast info. */

#include <stdio.h>

#include "csg/object.h"
#include "pack/precise.h"
#include "render/renderer.h"

/* Draws of one object follow each other. */
static bool is_first(const struct csg_frame *frame, size_t i)
{
    const struct csg_draw *draw = &frame->draws.data[i];
    return i == 0 || draw[-1].object != draw->object || draw[-1].layer != draw->layer;
}

static void describe(const struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                     const struct csg_draw *draw, char *text, size_t size)
{
    const struct csg_precision precision =
        csg_frame_precision(&renderer->frame, scene, draw->object, draw->layer);
    const struct csg_leaf *leaf = &scene->leaves[precision.leaf];
    char why[128];
    csg_precision_explain(&precision, why, sizeof why);
    if (precision.reason == CSG_REASON_ASKED)
        snprintf(text, size, "all in double: %s\n", why);
    else
        snprintf(text, size, "%s:%u:%u: %s in %s: %s\n", scene->name, (unsigned)leaf->line,
                 (unsigned)leaf->column, csg_kind_name(leaf->kind),
                 renderer->gl->has_double ? "double" : "double on the CPU", why);
}

void csg_numerics_describe(const struct csgcast_renderer *renderer,
                           const struct csgcast_scene *scene, struct csgcast_stats *stats)
{
    const struct csg_frame *frame = &renderer->frame;
    size_t used = 0;
    for (size_t i = 0; i < frame->draws.num; i++) {
        char line[400];
        if (!frame->draws.data[i].precise || !is_first(frame, i))
            continue;
        stats->precise_objects++;
        describe(renderer, scene, &frame->draws.data[i], line, sizeof line);
        const int length =
            snprintf(stats->numerics + used, sizeof stats->numerics - used, "%s", line);
        if (used + (size_t)length >= sizeof stats->numerics)
            stats->numerics[used] = 0; /* whole lines only */
        else
            used += (size_t)length;
    }
}
