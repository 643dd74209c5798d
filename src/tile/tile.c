/* SPDX-License-Identifier: MIT */
#include "tile/tile.h"

#include <stdlib.h>
#include <string.h>

#include "pack/surface_record.h"
#include "tile/bands.h"
#include "tile/dominate.h"
#include "tile/front.h"
#include "tile/scan.h"

/* A tile whose part of the tree is this small is not worth cutting further. */
#define SMALL_LEAVES 2

/* Trees of so many nodes are first looked through for leaves that miss the tile. */
#define MIN_SIFTED_NODES 64

/* Tiles with surfaces of triangles have lists of their own in smaller cells, but nothing is drawn
 * where a tile is empty. In pixels. */
#define SURFACE_TILE_SIZE 64

/* A tile that may meet so few bands of stacks is not worth cutting for them. */
#define SMALL_BANDS 4

/* A rectangle that is still to be drawn or cut, with the tree that matters in it. */
struct task {
    int lo[2], hi[2]; /* pixels [lo, hi) */
    struct csg_tree tree;
    struct csg_band_list bands; /* of stacks, that rays may meet */
    size_t before[2];           /* leaves that mattered in twice and in four times the area */
};

/* Where so many leaves are left and a quarter of the area spares less than this share of them, the
 * tile is drawn as it is. */
#define STUBBORN_LEAVES 256
#define STUBBORN_SHARE 0.9

struct tiler {
    struct csg_terms *terms;
    const struct csg_draw *draw;
    CSG_ARRAY(struct task) tasks;
    CSG_ARRAY(struct csg_tree) spare; /* memory of tasks that are done */
    struct csg_tree_room room;
    CSG_ARRAY(struct csg_leaf_range) ranges; /* by leaf of the terms, of the tile at hand */
    CSG_ARRAY(struct csg_range) nodes;       /* keys that a node's set is within */
    CSG_ARRAY(struct csg_range) contexts;    /* keys at which a node matters */
    CSG_ARRAY(uint32_t) members;             /* for csg_dominate */
    CSG_ARRAY(struct csg_leaf_range) stacks;
    CSG_ARRAY(bool) planes;
    CSG_ARRAY(double) keys; /* by node, for csg_front_find */
    struct csg_scan scan;
    size_t max_texels; /* of the frame, from which on tiles are not cut further */
    bool opaque;       /* the tile at hand: the object has certainly begun somewhere in all of it */
};

static struct csg_tile_box tile_box(const struct tiler *tiler, const struct task *task)
{
    const double at[2] = {tiler->terms->frame->at.x, tiler->terms->frame->at.y};
    double center[2], half[2];
    for (int i = 0; i < 2; i++) {
        center[i] = 0.5 * (task->lo[i] + task->hi[i]) - at[i];
        half[i] = 0.5 * (task->hi[i] - task->lo[i]) - 0.5;
    }
    return csg_tile_box(center, half);
}

static struct csg_range node_range(const struct tiler *tiler, const struct csg_tree *tree,
                                   uint32_t i)
{
    const struct csg_node *node = &tree->data[i];
    const bool all = node->op == CSG_AND;
    struct csg_range range = {all ? -INFINITY : INFINITY, all ? INFINITY : -INFINITY};
    for (uint32_t child = i + 1; child < node->end; child = tree->data[child].end) {
        const struct csg_range operand = tiler->nodes.data[child];
        range.lo = all ? csg_larger(range.lo, operand.lo) : csg_smaller(range.lo, operand.lo);
        range.hi = all ? csg_smaller(range.hi, operand.hi) : csg_larger(range.hi, operand.hi);
    }
    return range;
}

static bool is_in_rect(const struct csg_rect *rect, const struct task *task)
{
    return rect->lo[0] < task->hi[0] && rect->hi[0] > task->lo[0] && rect->lo[1] < task->hi[1] &&
           rect->hi[1] > task->lo[1];
}

/* Rays that start inside of solids meet them behind the eye, too. */
static struct csg_leaf_range leaf_range(const struct tiler *tiler, const struct task *task,
                                        const struct csg_tile_box *box, uint32_t leaf)
{
    const size_t num_leaves = tiler->terms->scene->num_leaves;
    if (leaf >= num_leaves)
        return tiler->stacks.data[leaf - num_leaves];
    const struct csg_leaf_terms *terms = csg_terms_of(tiler->terms, leaf);
    if (!tiler->draw->around_eye && !is_in_rect(&terms->rect, task))
        return csg_leaf_nowhere;
    return csg_range_of_leaf(tiler->terms, terms, box);
}

/* Of a leaf of the tree at hand. */
static struct csg_leaf_range *range_of(const struct tiler *tiler, uint32_t leaf)
{
    return &tiler->ranges.data[tiler->terms->index[leaf]];
}

static void fill_ranges(struct tiler *tiler, const struct task *task,
                        const struct csg_tile_box *box)
{
    for (size_t i = task->tree.num; i-- > 0;) {
        const struct csg_node *node = &task->tree.data[i];
        if (node->op != CSG_LEAF) {
            tiler->nodes.data[i] = node_range(tiler, &task->tree, (uint32_t)i);
            continue;
        }
        struct csg_leaf_range *leaf = range_of(tiler, node->leaf);
        *leaf = leaf_range(tiler, task, box, node->leaf);
        tiler->nodes.data[i] = node->negated ? (struct csg_range){-INFINITY, INFINITY}
                                             : (struct csg_range){leaf->entry.lo, leaf->exit.hi};
    }
}

/*
 * A leaf that is nowhere inside where it matters is nothing there; one that covers all of it is
 * everything. The comparison is strict, so the operand that bounds a context is never itself taken
 * for covering it, and crossings that may be equal stay.
 */
static uint8_t judge(const struct csg_leaf_range *leaf, struct csg_range context)
{
    if (leaf->entry.lo > leaf->exit.hi || leaf->exit.hi < context.lo || leaf->entry.lo > context.hi)
        return CSG_NOTHING;
    if (leaf->solid && leaf->entry.hi < context.lo && leaf->exit.lo > context.hi)
        return CSG_EVERYTHING;
    return CSG_VARIES;
}

/* The key behind which nothing shows. */
static double front_of(struct tiler *tiler, const struct csg_tree *tree)
{
    double key = tiler->terms->frame->screen.k_far;
    tiler->opaque = !tiler->draw->around_eye &&
                    csg_front_find(tiler->terms, tree, tiler->ranges.data, tiler->keys.data, &key);
    return key;
}

/* Whether something is known of a leaf. */
static bool judge_leaves(struct tiler *tiler, const struct csg_tree *tree)
{
    bool found = false;
    struct csg_range *contexts = tiler->contexts.data;
    contexts[0] = (struct csg_range){-(double)CSG_KEY_MAX, front_of(tiler, tree)};
    for (uint32_t i = 0; i < tree->num; i++) {
        const struct csg_node *node = &tree->data[i];
        if (node->op == CSG_LEAF) {
            const uint8_t known = judge(range_of(tiler, node->leaf), contexts[i]);
            tiler->terms->known[node->leaf] = known;
            found |= known != CSG_VARIES;
            continue;
        }
        struct csg_range inside = contexts[i];
        if (node->op == CSG_AND) {
            inside.lo = csg_larger(inside.lo, tiler->nodes.data[i].lo);
            inside.hi = csg_smaller(inside.hi, tiler->nodes.data[i].hi);
        }
        for (uint32_t child = i + 1; child < node->end; child = tree->data[child].end)
            contexts[child] = inside;
    }
    return found;
}

static bool reserve(struct tiler *tiler, size_t num)
{
    tiler->nodes.num = tiler->contexts.num = tiler->ranges.num = 0;
    tiler->stacks.num = tiler->members.num = tiler->keys.num = 0;
    return csg_array_reserve(&tiler->stacks, tiler->terms->stacks.list.num) &&
           csg_array_reserve(&tiler->ranges, tiler->terms->leaves.num) &&
           csg_array_reserve(&tiler->nodes, num) && csg_array_reserve(&tiler->contexts, num) &&
           csg_array_reserve(&tiler->keys, num) && csg_array_reserve(&tiler->members, 2 * num);
}

static size_t count_leaves(const struct csg_tree *tree)
{
    size_t num = 0;
    for (size_t i = 0; i < tree->num; i++)
        num += tree->data[i].op == CSG_LEAF;
    return num;
}

static bool copy_tree(struct tiler *tiler, const struct csg_tree *tree, struct csg_tree *copy)
{
    *copy = (struct csg_tree){0};
    if (tiler->spare.num)
        *copy = tiler->spare.data[--tiler->spare.num];
    copy->num = 0;
    if (!csg_array_reserve(copy, tree->num)) {
        free(copy->data);
        return false;
    }
    memcpy(copy->data, tree->data, tree->num * sizeof *tree->data);
    copy->num = tree->num;
    return true;
}

/* The memory of a tree that is not needed any more, for the next one. */
static void drop_tree(struct tiler *tiler, struct csg_tree *tree)
{
    if (tree->data && !csg_array_push(&tiler->spare, *tree))
        free(tree->data);
}

static int tile_size(const struct tiler *tiler)
{
    const int size = tiler->terms->params->tile_size;
    return size ? size : CSG_TILE_SIZE;
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
static void keep_part(struct task *task, int axis, int edge, bool upper)
{
    if (upper)
        task->lo[axis] = edge;
    else
        task->hi[axis] = edge;
}

/* Waits for its turn with a copy of the task's tree. */
static bool add_task(struct tiler *tiler, const struct task *task)
{
    struct task copy = *task;
    copy.bands = (struct csg_band_list){0};
    if (copy_tree(tiler, &task->tree, &copy.tree) &&
        csg_band_list_copy(&task->bands, &copy.bands) && csg_array_push(&tiler->tasks, copy))
        return true;
    free(copy.tree.data);
    free(copy.bands.data);
    return false;
}

/* Cuts into two or four, across the axes that have an edge of the larger step. */
static bool cut(struct tiler *tiler, struct task *task, size_t num_leaves)
{
    int edges[2], steps[2], parts = 1;
    for (int i = 0; i < 2; i++) {
        const int size = task->hi[i] - task->lo[i];
        const int tile = size > tile_size(tiler) ? tile_size(tiler) : 1;
        edges[i] = edge_between(task->lo[i], task->hi[i], tile, &steps[i]);
    }
    const bool cuts[2] = {steps[0] >= steps[1], steps[1] >= steps[0]};
    task->before[1] = cuts[0] && cuts[1] ? num_leaves : task->before[0];
    task->before[0] = num_leaves;
    for (int i = 0; i < 2; i++)
        parts *= cuts[i] ? 2 : 1;
    for (int part = 0; part < parts; part++) {
        struct task some = *task;
        if (cuts[0])
            keep_part(&some, 0, edges[0], part & 1);
        if (cuts[1])
            keep_part(&some, 1, edges[1], cuts[0] ? part >> 1 : part);
        if (!add_task(tiler, &some))
            return false;
    }
    return true;
}

static bool add_record(struct tiler *tiler, size_t i, const struct task *task,
                       const struct csg_tile_box *box)
{
    const struct csg_step *step = &tiler->scan.program.data[i];
    if (step->flags & CSG_RECORD_BOUND)
        return csg_terms_add_bound(tiler->terms, tiler->scan.bounds.data[i]);
    if (step->flags & CSG_RECORD_POP)
        return csg_terms_add_record(tiler->terms, step, NULL);
    if (step->flags & CSG_RECORD_BANDS)
        return csg_band_list_put(&task->bands, tiler->terms, step, box);
    if (step->flags & CSG_RECORD_SURFACE)
        return csg_surface_add_record(tiler->terms, step, task->lo, task->hi);
    const struct csg_leaf_terms *leaf = csg_terms_of(tiler->terms, step->leaf);
    struct csg_record_filter filter = {NULL, false};
    tiler->planes.num = 0;
    if (!csg_array_reserve(&tiler->planes, leaf->num_entries + leaf->num_exits + 1))
        return false;
    filter.quadric = csg_range_filter(tiler->terms, leaf, range_of(tiler, step->leaf), box,
                                      tiler->planes.data);
    filter.planes = tiler->planes.data;
    return csg_terms_add_record(tiler->terms, step, &filter);
}

static bool is_surface_alone(const struct tiler *tiler)
{
    const struct csg_step *step = tiler->scan.program.data;
    return tiler->scan.program.num == 1 && step->flags & CSG_RECORD_SURFACE &&
           !(step->flags & (CSG_RECORD_NEGATED | CSG_RECORD_BANDS)) &&
           csg_terms_view(tiler->terms, step->leaf)->turns == 0;
}

static bool emit(struct tiler *tiler, const struct task *task)
{
    struct csg_frame *frame = tiler->terms->frame;
    const struct csg_tile_box box = tile_box(tiler, task);
    struct csg_draw draw = *tiler->draw;
    if (!csg_scan_fill(&tiler->scan, tiler->terms, &task->tree, tiler->ranges.data,
                       !draw.around_eye))
        return false;
    draw.instance.records[0] = (int32_t)(frame->texels.num / 4);
    for (size_t i = 0; i < tiler->scan.program.num; i++) {
        const uint32_t flags = tiler->scan.program.data[i].flags;
        draw.bands |= (flags & CSG_RECORD_BANDS) != 0;
        draw.surface |= (flags & (CSG_RECORD_SURFACE | CSG_RECORD_BANDS)) == CSG_RECORD_SURFACE;
        if (!add_record(tiler, i, task, &box))
            return false;
    }
    draw.surface_alone = is_surface_alone(tiler);
    draw.instance.records[1] = (int32_t)(frame->texels.num / 4);
    const struct csg_rect rect = {{task->lo[0], task->lo[1]}, {task->hi[0], task->hi[1]}};
    csg_draw_set_rect(&draw, &frame->screen, &rect);
    csg_frame_count(frame, &rect, count_leaves(&task->tree) + task->bands.num);
    *(tiler->opaque ? &frame->tiles_opaque : &frame->tiles_mixed) += 1;
    return draw.instance.records[0] == draw.instance.records[1] ||
           csg_array_push(&frame->draws, draw);
}

static bool is_worth_cutting(const struct tiler *tiler, const struct task *task, size_t num_leaves)
{
    const int tile = tile_size(tiler);
    const bool smallest = task->hi[0] - task->lo[0] <= tile && task->hi[1] - task->lo[1] <= tile;
    const bool stubborn = num_leaves > STUBBORN_LEAVES && task->before[1] > 0 &&
                          (double)num_leaves > STUBBORN_SHARE * (double)task->before[1];
    const bool small_enough =
        tiler->terms->views.num == 0 || (task->hi[0] - task->lo[0] <= SURFACE_TILE_SIZE &&
                                         task->hi[1] - task->lo[1] <= SURFACE_TILE_SIZE);
    if (!small_enough)
        return true;
    const bool many = task->bands.num > SMALL_BANDS || (!stubborn && num_leaves > SMALL_LEAVES);
    return !smallest && many && tiler->terms->frame->texels.num / 4 < tiler->max_texels;
}

/* Leaves out what the tile misses by its rectangle: what is left of a large tree is asked more. */
static bool sift(struct tiler *tiler, struct task *task)
{
    const size_t num_leaves = tiler->terms->scene->num_leaves;
    if (task->tree.num < MIN_SIFTED_NODES || tiler->draw->around_eye)
        return true;
    for (size_t i = 0; i < task->tree.num; i++) {
        const uint32_t leaf = task->tree.data[i].leaf;
        if (task->tree.data[i].op != CSG_LEAF)
            continue;
        const bool missed =
            leaf < num_leaves && !is_in_rect(&csg_terms_of(tiler->terms, leaf)->rect, task);
        tiler->terms->known[leaf] = missed ? CSG_NOTHING : CSG_VARIES;
    }
    return csg_tree_simplify_in(&tiler->room, &task->tree, tiler->terms->known);
}

static bool run(struct tiler *tiler, struct task *task)
{
    if (!sift(tiler, task) || !reserve(tiler, task->tree.num))
        return false;
    if (task->tree.num == 0) {
        tiler->terms->frame->tiles_empty++;
        return true;
    }
    const struct csg_tile_box box = tile_box(tiler, task);
    csg_band_list_narrow(&task->bands, tiler->terms, &box, tiler->stacks.data);
    fill_ranges(tiler, task, &box);
    bool found = judge_leaves(tiler, &task->tree);
    found |= csg_dominate(tiler->terms, &task->tree, tiler->ranges.data, &box, tiler->members.data);
    if (found && !csg_tree_simplify_in(&tiler->room, &task->tree, tiler->terms->known))
        return false;
    if (task->tree.num == 0) {
        tiler->terms->frame->tiles_empty++;
        return true;
    }
    const size_t num_leaves = count_leaves(&task->tree);
    if (!is_worth_cutting(tiler, task, num_leaves))
        return emit(tiler, task);
    return cut(tiler, task, num_leaves);
}

/* The object's own part of the layer's tree, counted from 0. */
static bool object_tree(struct tiler *tiler, const struct csg_object *object,
                        struct csg_tree *tree)
{
    const struct csg_stacks *stacks = &tiler->terms->stacks;
    const struct csg_node *nodes = tiler->terms->scene->trees[object->layer].data;
    *tree = (struct csg_tree){0};
    if (stacks->list.num)
        return csg_tree_copy(&stacks->tree, tree);
    return csg_tree_append(tree, nodes, object->begin, object->end);
}

static bool run_all(struct tiler *tiler)
{
    bool ok = true;
    while (tiler->tasks.num) {
        struct task task = tiler->tasks.data[--tiler->tasks.num];
        ok = ok && run(tiler, &task);
        drop_tree(tiler, &task.tree);
        free(task.bands.data);
    }
    return ok;
}

bool csg_tile_area(struct csg_terms *terms, const struct csg_object *object,
                   const struct csg_tile_area *area, const struct csg_draw *draw)
{
    struct tiler tiler = {.terms = terms,
                          .draw = draw,
                          .max_texels = area->max_texels + terms->frame->texels.num / 4};
    struct task whole = {.lo = {area->lo[0], area->lo[1]}, .hi = {area->hi[0], area->hi[1]}};
    bool ok = object_tree(&tiler, object, &whole.tree) &&
              csg_band_list_fill(&whole.bands, terms) && csg_array_push(&tiler.tasks, whole);
    if (!ok) {
        free(whole.tree.data);
        free(whole.bands.data);
    }
    ok = run_all(&tiler) && ok;
    for (size_t i = 0; i < tiler.spare.num; i++)
        free(tiler.spare.data[i].data);
    free(tiler.spare.data);
    csg_tree_room_finish(&tiler.room);
    free(tiler.tasks.data);
    free(tiler.ranges.data);
    free(tiler.members.data);
    free(tiler.nodes.data);
    free(tiler.contexts.data);
    free(tiler.stacks.data);
    free(tiler.planes.data);
    free(tiler.keys.data);
    csg_scan_finish(&tiler.scan);
    return ok;
}
