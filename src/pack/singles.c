/* SPDX-License-Identifier: MIT */
#include "pack/singles.h"

#include <assert.h>
#include <stdlib.h>

static_assert(CSG_NUM_LEAF_KINDS <= CSGCAST_MAX_KINDS, "single_kinds has no room for each kind");

void csg_singles_finish(struct csg_singles *singles)
{
    free(singles->is_drawn);
    *singles = (struct csg_singles){0};
}

bool csg_singles_start(struct csg_singles *singles, const struct csgcast_scene *scene, bool wanted)
{
    csg_singles_finish(singles);
    singles->is_wanted = wanted;
    if (wanted)
        singles->is_drawn = calloc(scene->num_leaves + 1, sizeof *singles->is_drawn);
    return !wanted || singles->is_drawn;
}

void csg_singles_note(struct csg_singles *singles, const struct csgcast_scene *scene, uint32_t leaf,
                      size_t num_pixels)
{
    if (!singles->is_wanted)
        return;
    const enum csg_kind kind = scene->leaves[leaf].kind;
    singles->is_drawn[leaf] = true;
    singles->num[kind]++;
    singles->proxy_pixels[kind] += num_pixels;
}

void csg_singles_add_pixel(struct csg_singles *singles, const struct csgcast_scene *scene,
                           uint32_t leaf)
{
    singles->proxy_pixels[scene->leaves[leaf].kind]++;
}

void csg_singles_count(const struct csg_singles *singles, const struct csgcast_scene *scene,
                       const float *ids, size_t num_pixels, struct csgcast_stats *stats)
{
    size_t hits[CSG_NUM_LEAF_KINDS] = {0};
    stats->num_single_kinds = 0;
    if (!singles->is_wanted)
        return;
    for (size_t i = 0; i < num_pixels; i++) {
        const size_t leaf = ids[i] >= 0 ? (size_t)ids[i] : scene->num_leaves;
        if (leaf < scene->num_leaves && singles->is_drawn[leaf])
            hits[scene->leaves[leaf].kind]++;
    }
    for (int kind = 0; kind < CSG_NUM_LEAF_KINDS; kind++)
        if (singles->num[kind])
            stats->single_kinds[stats->num_single_kinds++] =
                (struct csgcast_kind_waste){csg_kind_name((enum csg_kind)kind), singles->num[kind],
                                            singles->proxy_pixels[kind], hits[kind]};
}
