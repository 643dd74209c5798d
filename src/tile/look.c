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
    return (rect->lo[0] < part->hi[0]) & (rect->hi[0] > part->lo[0]) & (rect->lo[1] < part->hi[1]) &
           (rect->hi[1] > part->lo[1]);
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

/* Whether its ranges are found for all parts at once. */
static bool has_lanes(const struct csg_tiler *tiler, uint32_t leaf)
{
    return !(csg_terms_of(tiler->terms, leaf)->flags & CSG_RECORD_SURFACE);
}

/* Of a surface, in the parts one by one; of another leaf that all of them miss. */
static void look_one_by_one(const struct csg_tiler *tiler, uint32_t leaf, const bool *missed,
                            struct csg_leaf_ranges *ranges)
{
    for (int i = 0; i < CSG_TILE_LANES; i++) {
        const struct csg_leaf_range range =
            missed[i]
                ? csg_leaf_nowhere
                : csg_range_of_surface(csg_terms_view(tiler->terms, leaf), &tiler->parts.tiles[i]);
        ranges->entry.lo[i] = range.entry.lo;
        ranges->entry.hi[i] = range.entry.hi;
        ranges->exit.lo[i] = range.exit.lo;
        ranges->exit.hi[i] = range.exit.hi;
    }
}

/* What the parts' rays meet of a leaf that is no stack. */
static void look_at(const struct csg_tiler *tiler, uint32_t leaf, struct csg_leaf_ranges *ranges)
{
    const struct csg_tile_parts *parts = &tiler->parts;
    const struct csg_rect *rect = rect_of(tiler, leaf);
    bool missed[CSG_TILE_LANES], all = true;
    for (int i = 0; i < CSG_TILE_LANES; i++) {
        missed[i] = i >= parts->num || (rect && !is_in_rect(rect, &parts->rects[i]));
        all &= missed[i];
    }
    if (all || !has_lanes(tiler, leaf)) {
        look_one_by_one(tiler, leaf, missed, ranges);
        return;
    }
    csg_ranges_of_leaf(tiler->terms, csg_terms_of(tiler->terms, leaf), &parts->boxes, ranges);
    for (int i = 0; i < CSG_TILE_LANES; i++) {
        ranges->entry.lo[i] = missed[i] ? INFINITY : ranges->entry.lo[i];
        ranges->exit.hi[i] = missed[i] ? -INFINITY : ranges->exit.hi[i];
    }
}

/* Of a flat tree, what matters in the parts; stacks are not looked at here. */
static void judge_flat(struct csg_tiler *tiler, const struct csg_tree *tree)
{
    const bool has_front = !tiler->draw->around_eye && !tiler->draw->has_rear;
    csg_flat_judge(tree, tiler->parts.ranges.data, tiler->terms->frame->screen.k_far, has_front,
                   &tiler->parts.flat);
}

bool csg_tiler_look(struct csg_tiler *tiler, const struct csg_tile_task *task)
{
    struct csg_tile_parts *parts = &tiler->parts;
    const struct csg_tree *tree = &task->tree;
    parts->ranges.num = 0;
    if (!csg_array_reserve(&parts->ranges, tree->num))
        return false;
    for (int i = 0; i < CSG_TILE_LANES; i++) {
        parts->tiles[i] = box_of(tiler, &parts->rects[i < parts->num ? i : 0]);
        csg_tile_boxes_set(&parts->boxes, i, &parts->tiles[i]);
    }
    for (size_t i = 0; i < tree->num; i++) {
        const struct csg_node *node = &tree->data[i];
        if (node->op == CSG_LEAF && node->leaf < tiler->terms->scene->num_leaves)
            look_at(tiler, node->leaf, &parts->ranges.data[i]);
    }
    if (csg_task_is_judged(tiler, task))
        judge_flat(tiler, tree);
    return true;
}

/* Of the leaf at node i of the tree that was looked at. */
static struct csg_leaf_range leaf_range(const struct csg_tiler *tiler, uint32_t leaf, uint32_t i)
{
    const struct csg_leaf_ranges *ranges = &tiler->parts.ranges.data[i];
    const size_t num_leaves = tiler->terms->scene->num_leaves;
    const int at = tiler->parts.at;
    if (leaf >= num_leaves)
        return tiler->stacks.data[leaf - num_leaves];
    return (struct csg_leaf_range){csg_range_in_lane(&ranges->entry, at),
                                   csg_range_in_lane(&ranges->exit, at)};
}

void csg_tiler_note_leaf(struct csg_tiler *tiler, uint32_t leaf, uint32_t i)
{
    const uint32_t at = tiler->terms->index[leaf];
    tiler->ranges.data[at] = leaf_range(tiler, leaf, i);
    tiler->origins.data[at] = i;
}
