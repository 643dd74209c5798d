/* SPDX-License-Identifier: MIT */

/* The rectangles of an object that wait: how they are cut, and the memory of their trees. */

#include <stdlib.h>
#include <string.h>

#include "tile/tile.h"
#include "tile/tiler.h"

/* An empty one. */
static struct csg_tree take_tree(struct csg_tiler *tiler)
{
    struct csg_tree tree = {0};
    if (tiler->spare.num)
        tree = tiler->spare.data[--tiler->spare.num];
    tree.num = 0;
    return tree;
}

/* The caller frees the copy, also when memory is out. */
static bool copy_tree(struct csg_tiler *tiler, const struct csg_tree *tree, struct csg_tree *copy)
{
    *copy = take_tree(tiler);
    if (!csg_array_reserve(copy, tree->num))
        return false;
    memcpy(copy->data, tree->data, tree->num * sizeof *tree->data);
    copy->num = tree->num;
    return true;
}

void csg_task_drop(struct csg_tiler *tiler, struct csg_tile_task *task)
{
    if (task->tree.data && !csg_array_push(&tiler->spare, task->tree))
        free(task->tree.data);
    free(task->bands.data);
}

/* Where to cut between lo and hi: at the multiple of the largest power of two tiles, *step pixels,
 * so that tiles are squares where they can be. Drivers draw blocks of pixels, and a tile that lies
 * across them has more of them than it need have. lo: there is no edge to cut at. */
static int edge_between(int lo, int hi, int tile, int *step)
{
    int edge = lo;
    *step = 0;
    for (int next = tile; (lo / next + 1) * next < hi; next *= 2) {
        edge = (lo / next + 1) * next;
        *step = next;
    }
    return edge;
}

/* What task is to keep of itself: the part below edge on an axis, or the one above. */
static void keep_part(struct csg_tile_task *task, int axis, int edge, bool upper)
{
    if (upper)
        task->lo[axis] = edge;
    else
        task->hi[axis] = edge;
}

bool csg_task_copy(struct csg_tiler *tiler, const struct csg_tile_task *whole,
                   struct csg_tile_task *part)
{
    part->bands = (struct csg_band_list){0};
    if (copy_tree(tiler, &whole->tree, &part->tree) &&
        csg_band_list_copy(&whole->bands, &part->bands))
        return true;
    csg_task_drop(tiler, part);
    return false;
}

int csg_task_cut(const struct csg_tiler *tiler, const struct csg_tile_task *task,
                 struct csg_tile_task parts[CSG_TILE_LANES])
{
    int edges[2], steps[2], num = 1;
    for (int i = 0; i < 2; i++) {
        const int size = task->hi[i] - task->lo[i];
        const int tile = size > csg_tile_size(tiler) ? csg_tile_size(tiler) : 1;
        edges[i] = edge_between(task->lo[i], task->hi[i], tile, &steps[i]);
    }
    const bool cuts[2] = {steps[0] >= steps[1], steps[1] >= steps[0]};
    const size_t num_leaves = csg_tree_count_leaves(&task->tree);
    for (int i = 0; i < 2; i++)
        num *= cuts[i] ? 2 : 1;
    for (int i = 0; i < num; i++) {
        parts[i] = *task;
        parts[i].before[0] = num_leaves;
        parts[i].before[1] = num == 4 ? num_leaves : task->before[0];
        if (cuts[0])
            keep_part(&parts[i], 0, edges[0], i & 1);
        if (cuts[1])
            keep_part(&parts[i], 1, edges[1], cuts[0] ? i >> 1 : i);
    }
    return num;
}

/* What is seen of the object, counted from 0. Tiles leave spare leaves out, which
 * are nowhere: a record would keep none of their planes, and one without planes is everywhere. */
static bool object_tree(struct csg_tiler *tiler, struct csg_tree *tree)
{
    const struct csg_stacks *stacks = &tiler->terms->stacks;
    const struct csg_seen *seen = &tiler->terms->seen;
    bool ok = true;
    if (stacks->list.num) {
        ok = copy_tree(tiler, &stacks->tree, tree);
    } else {
        *tree = take_tree(tiler);
        ok = csg_tree_append(tree, seen->nodes, seen->begin, seen->end);
    }
    for (size_t i = 0; i < tree->num && ok; i++)
        tree->data[i].spare = false;
    return ok;
}

bool csg_task_start(struct csg_tiler *tiler, struct csg_tile_task *task)
{
    if (!object_tree(tiler, &task->tree) || !csg_band_list_fill(&task->bands, tiler->terms)) {
        csg_task_drop(tiler, task);
        return false;
    }
    task->flat = csg_tiler_is_flat(&task->tree);
    return true;
}
