/* SPDX-License-Identifier: MIT */

/* What rays of tiles meet of each leaf. */

#include "tile/tiler.h"

static struct csg_tile_box box_of(const struct csg_tiler *tiler, const struct csg_rect *tile)
{
    const double at[2] = {tiler->terms->frame->at.x, tiler->terms->frame->at.y};
    double center[2], half[2];
    for (int i = 0; i < 2; i++) {
        center[i] = 0.5 * (tile->lo[i] + tile->hi[i]) - at[i];
        half[i] = 0.5 * (tile->hi[i] - tile->lo[i]) - 0.5;
    }
    return csg_tile_box(center, half);
}

static bool is_in_rect(const struct csg_rect *rect, const struct csg_rect *part)
{
    return rect->lo[0] < part->hi[0] && rect->hi[0] > part->lo[0] && rect->lo[1] < part->hi[1] &&
           rect->hi[1] > part->lo[1];
}

/* Stacks have no rectangle. Rays that start inside of solids meet them behind the eye, too. */
static const struct csg_rect *rect_of(const struct csg_tiler *tiler, uint32_t leaf)
{
    return tiler->draw->around_eye || leaf >= tiler->terms->scene->num_leaves
               ? NULL
               : &csg_terms_of(tiler->terms, leaf)->rect;
}

bool csg_tiler_misses(const struct csg_tiler *tiler, const struct csg_tile_task *task,
                      uint32_t leaf)
{
    const struct csg_rect tile = csg_tile_rect(task);
    const struct csg_rect *rect = rect_of(tiler, leaf);
    return rect && !is_in_rect(rect, &tile);
}

/* The parts that miss it by its rectangle, as bits. */
static uint8_t missing_parts(const struct csg_tiler *tiler, uint32_t leaf)
{
    const struct csg_rect *rect = rect_of(tiler, leaf);
    uint8_t missed = 0;
    for (int i = 0; i < tiler->parts.num && rect; i++)
        missed |= (uint8_t)(!is_in_rect(rect, &tiler->parts.rects[i]) << i);
    return missed;
}

/* Whether its ranges are found for all parts at once. */
static bool has_lanes(const struct csg_tiler *tiler, uint32_t leaf)
{
    return leaf < tiler->terms->scene->num_leaves &&
           !(csg_terms_of(tiler->terms, leaf)->flags & CSG_RECORD_SURFACE);
}

bool csg_tiler_look(struct csg_tiler *tiler, const struct csg_tree *tree)
{
    struct csg_tile_parts *parts = &tiler->parts;
    parts->ranges.num = parts->missed.num = 0;
    if (!csg_array_reserve(&parts->ranges, tree->num) ||
        !csg_array_reserve(&parts->missed, tree->num))
        return false;
    for (int i = 0; i < CSG_TILE_LANES; i++) {
        parts->tiles[i] = box_of(tiler, &parts->rects[i < parts->num ? i : 0]);
        csg_tile_boxes_set(&parts->boxes, i, &parts->tiles[i]);
    }
    for (size_t i = 0; i < tree->num; i++) {
        const uint32_t leaf = tree->data[i].leaf;
        if (tree->data[i].op != CSG_LEAF)
            continue;
        const uint8_t missed = parts->missed.data[i] = missing_parts(tiler, leaf);
        if (missed + 1 != 1 << parts->num && has_lanes(tiler, leaf))
            csg_ranges_of_leaf(tiler->terms, csg_terms_of(tiler->terms, leaf), &parts->boxes,
                               &parts->ranges.data[i]);
    }
    return true;
}

bool csg_tiler_is_missed(const struct csg_tiler *tiler, uint32_t i)
{
    return tiler->parts.missed.data[i] >> tiler->parts.at & 1;
}

/* Of the leaf at node i of the tree that was looked at. */
static struct csg_leaf_range leaf_range(const struct csg_tiler *tiler, uint32_t leaf, uint32_t i)
{
    const struct csg_tile_parts *parts = &tiler->parts;
    const struct csg_leaf_ranges *ranges = &parts->ranges.data[i];
    const size_t num_leaves = tiler->terms->scene->num_leaves;
    if (csg_tiler_is_missed(tiler, i))
        return csg_leaf_nowhere;
    if (leaf >= num_leaves)
        return tiler->stacks.data[leaf - num_leaves];
    if (has_lanes(tiler, leaf))
        return (struct csg_leaf_range){csg_range_in_lane(&ranges->entry, parts->at),
                                       csg_range_in_lane(&ranges->exit, parts->at)};
    return csg_range_of_surface(csg_terms_view(tiler->terms, leaf), csg_tiler_box(tiler));
}

struct csg_leaf_range *csg_tiler_note_leaf(struct csg_tiler *tiler, uint32_t leaf, uint32_t i)
{
    struct csg_leaf_range *range = csg_tiler_range(tiler, leaf);
    *range = leaf_range(tiler, leaf, i);
    tiler->origins.data[tiler->terms->index[leaf]] = i;
    return range;
}
