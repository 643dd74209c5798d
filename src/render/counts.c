/* SPDX-License-Identifier: MIT */

/* What a picture took, for csgcast_stats. */

#include "render/picture.h"

#include <stdio.h>

static void copy_counts(const struct csg_frame *frame, struct csgcast_stats *stats)
{
    stats->objects_drawn = frame->draws.num;
    stats->proxy_pixels = frame->proxy_pixels;
    stats->solid_tests = frame->solid_tests;
    stats->tiles_empty = frame->tiles_empty;
    stats->tiles_opaque = frame->tiles_opaque;
    stats->tiles_mixed = frame->tiles_mixed;
    stats->tile_ms = frame->tile_ms;
    stats->pack_ms = stats->cpu_ms - frame->tile_ms;
}

static size_t add_variant(char *text, size_t size, size_t used, const char *name, size_t num)
{
    if (num == 0 || used >= size)
        return used;
    return used +
           (size_t)snprintf(text + used, size - used, "%s%s %zu", used ? ", " : "", name, num);
}

/* The resolvers used, and how many objects each drew. */
static void name_variants(const struct csg_picture *picture, char *text, size_t size)
{
    const struct csg_batches *batches = &picture->batches;
    size_t skip = 0;
    if (picture->request->textbook)
        skip = (size_t)snprintf(text, size, CSG_TEXTBOOK_NAME ": ");
    size_t used = add_variant(text + skip, size - skip, 0, "single", batches->drawn_single);
    for (int i = 0; i < CSG_NUM_RESOLVERS; i++)
        used =
            add_variant(text + skip, size - skip, used, csg_resolver_names[i], batches->drawn[i]);
    add_variant(text + skip, size - skip, used, "reference", batches->on_cpu);
}

void csg_picture_count(const struct csg_picture *picture)
{
    struct csgcast_renderer *renderer = picture->renderer;
    struct csgcast_stats *stats = &renderer->stats;
    copy_counts(&renderer->frame, stats);
    csg_numerics_describe(renderer, picture->request->scene, stats);
    stats->objects_drawn += picture->batches.drawn_single;
    name_variants(picture, stats->variants, sizeof stats->variants);
}
