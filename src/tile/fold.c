/* SPDX-License-Identifier: MIT */

/* What of an object's tree matters in a tile. */

#include "tile/tiler.h"

#include "tile/dominate.h"
#include "tile/front.h"

/* Trees of so many nodes are first looked through for leaves that miss the tile. */
#define MIN_SIFTED_NODES 64

static struct csg_range intersect(struct csg_range a, struct csg_range b)
{
    return (struct csg_range){csg_larger(a.lo, b.lo), csg_smaller(a.hi, b.hi)};
}

static struct csg_range span_both(struct csg_range a, struct csg_range b)
{
    return (struct csg_range){csg_smaller(a.lo, b.lo), csg_larger(a.hi, b.hi)};
}

static const struct csg_range nowhere = {INFINITY, -INFINITY}, anywhere = {-INFINITY, INFINITY};

/* By De Morgan's laws the complement of a union is the intersection of complements. */
static struct csg_node_range node_range(const struct csg_tiler *tiler, const struct csg_tree *tree,
                                        uint32_t i)
{
    const struct csg_node *node = &tree->data[i];
    const bool all = node->op == CSG_AND;
    struct csg_node_range range = {all ? anywhere : nowhere, all ? nowhere : anywhere};
    for (uint32_t child = i + 1; child < node->end; child = tree->data[child].end) {
        const struct csg_node_range *operand = &tiler->nodes.data[child];
        range.set = (all ? intersect : span_both)(range.set, operand->set);
        range.rest = (all ? span_both : intersect)(range.rest, operand->rest);
    }
    return range;
}

static void fill_leaves(struct csg_tiler *tiler, const struct csg_tree *tree)
{
    for (uint32_t i = 0; i < tree->num; i++)
        if (tree->data[i].op == CSG_LEAF)
            csg_tiler_note_leaf(tiler, tree->data[i].leaf, i);
}

static void fill_nodes(struct csg_tiler *tiler, const struct csg_tree *tree)
{
    for (size_t i = tree->num; i-- > 0;) {
        const struct csg_node *node = &tree->data[i];
        if (node->op != CSG_LEAF) {
            tiler->nodes.data[i] = node_range(tiler, tree, (uint32_t)i);
            continue;
        }
        const struct csg_leaf_range *leaf = csg_tiler_range(tiler, node->leaf);
        const struct csg_range own = {leaf->entry.lo, leaf->exit.hi};
        tiler->nodes.data[i] = node->negated ? (struct csg_node_range){anywhere, own}
                                             : (struct csg_node_range){own, anywhere};
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
    if (csg_is_solid(leaf) && leaf->entry.hi < context.lo && leaf->exit.lo > context.hi)
        return CSG_EVERYTHING;
    return CSG_VARIES;
}

/* Beyond its context a leaf may be anything: faces there do not matter (csg_range_filter). */
static void narrow(struct csg_leaf_range *leaf, struct csg_range context)
{
    leaf->entry.lo = csg_larger(leaf->entry.lo, context.lo);
    leaf->exit.hi = csg_smaller(leaf->exit.hi, context.hi);
}

/* The key behind which nothing shows. */
static double front_of(struct csg_tiler *tiler, const struct csg_tree *tree)
{
    double key = tiler->terms->frame->screen.k_far;
    tiler->opaque = !tiler->draw->around_eye && !tiler->draw->has_rear &&
                    csg_front_find(tiler->terms, tree, tiler->ranges.data, tiler->keys.data, &key);
    return key;
}

/* What is known by leaf is meant for each place where the leaf stands: parts of distributed objects
 * have what cuts them in common, and a layer drawn as one object has them all. */
static bool has_repeats(const struct csg_tiler *tiler)
{
    return tiler->draw->object == CSG_WHOLE_LAYER && tiler->terms->scene->is_distributed;
}

/* No verdict of a leaf. */
#define NOT_JUDGED 0xff

static void forget_leaves(struct csg_tiler *tiler, const struct csg_tree *tree)
{
    for (size_t i = 0; i < tree->num; i++)
        if (tree->data[i].op == CSG_LEAF)
            tiler->terms->known[tree->data[i].leaf] = NOT_JUDGED;
}

/* Judges a leaf that may stand elsewhere, too: what holds at one of the places only is not known,
 * and its range is not narrowed to one of them. */
static uint8_t judge_repeated(struct csg_tiler *tiler, uint32_t leaf, struct csg_range context)
{
    uint8_t *known = &tiler->terms->known[leaf];
    const uint8_t here = judge(csg_tiler_range(tiler, leaf), context);
    *known = *known == NOT_JUDGED || *known == here ? here : CSG_VARIES;
    return *known;
}

static uint8_t judge_single(struct csg_tiler *tiler, uint32_t leaf, struct csg_range context)
{
    struct csg_leaf_range *range = csg_tiler_range(tiler, leaf);
    tiler->terms->known[leaf] = judge(range, context);
    narrow(range, context);
    return tiler->terms->known[leaf];
}

/* Whether something may be known of a leaf. */
static bool judge_leaves(struct csg_tiler *tiler, const struct csg_tree *tree)
{
    const bool repeats = has_repeats(tiler);
    bool found = false;
    struct csg_range *contexts = tiler->contexts.data;
    contexts[0] = (struct csg_range){-(double)CSG_KEY_MAX, front_of(tiler, tree)};
    if (repeats)
        forget_leaves(tiler, tree);
    for (uint32_t i = 0; i < tree->num; i++) {
        const struct csg_node *node = &tree->data[i];
        if (node->op == CSG_LEAF) {
            const uint8_t known = repeats ? judge_repeated(tiler, node->leaf, contexts[i])
                                          : judge_single(tiler, node->leaf, contexts[i]);
            found |= known != CSG_VARIES;
            continue;
        }
        const struct csg_node_range *range = &tiler->nodes.data[i];
        const struct csg_range inside =
            intersect(contexts[i], node->op == CSG_AND ? range->set : range->rest);
        for (uint32_t child = i + 1; child < node->end; child = tree->data[child].end)
            contexts[child] = inside;
    }
    return found;
}

static bool reserve(struct csg_tiler *tiler, size_t num)
{
    tiler->nodes.num = tiler->contexts.num = tiler->ranges.num = tiler->origins.num = 0;
    tiler->stacks.num = tiler->members.num = tiler->keys.num = 0;
    return csg_array_reserve(&tiler->stacks, tiler->terms->stacks.list.num) &&
           csg_array_reserve(&tiler->ranges, tiler->terms->leaves.num) &&
           csg_array_reserve(&tiler->origins, tiler->terms->leaves.num) &&
           csg_array_reserve(&tiler->nodes, num) && csg_array_reserve(&tiler->contexts, num) &&
           csg_array_reserve(&tiler->keys, num) && csg_array_reserve(&tiler->members, 2 * num);
}

/* Leaves out what the tile misses by its rectangle: what is left of a large tree is asked more. */
static bool sift(struct csg_tiler *tiler, struct csg_tile_task *task)
{
    if (task->tree.num < MIN_SIFTED_NODES || tiler->draw->around_eye)
        return true;
    for (size_t i = 0; i < task->tree.num; i++) {
        const uint32_t leaf = task->tree.data[i].leaf;
        if (task->tree.data[i].op == CSG_LEAF)
            tiler->terms->known[leaf] =
                csg_tiler_misses(tiler, task, leaf) ? CSG_NOTHING : CSG_VARIES;
    }
    return csg_tree_simplify_in(&tiler->room, &task->tree, tiler->terms->known);
}

/* Leaves out what does not matter in the tile. false: out of memory. */
static bool fold(struct csg_tiler *tiler, struct csg_tile_task *task)
{
    fill_nodes(tiler, &task->tree);
    bool found = judge_leaves(tiler, &task->tree);
    found |= !has_repeats(tiler) && csg_dominate(tiler->terms, &task->tree, tiler->ranges.data,
                                                 csg_tiler_box(tiler), tiler->members.data);
    if (found && !csg_tree_simplify_in(&tiler->room, &task->tree, tiler->terms->known))
        return false;
    task->flat = csg_tiler_is_flat(&task->tree);
    return true;
}

/* ---- flat trees: leaves are left out in place ----------------------------------------------- */

bool csg_tiler_is_flat(const struct csg_tree *tree)
{
    if (tree->num == 0 || tree->data[0].op != CSG_AND)
        return false;
    for (uint32_t i = 1; i < tree->num; i++)
        if (tree->data[i].op != CSG_LEAF || tree->data[i].spare)
            return false;
    return true;
}

/* Leaves out the leaf at place i of the tree where known says so: else it becomes the one at place
 * *num, which is counted. false: nothing is left of the intersection. */
static bool keep_flat(struct csg_tree *tree, uint32_t i, uint8_t known, uint32_t *num)
{
    const struct csg_node node = tree->data[i];
    if (known != CSG_VARIES)
        return (known == CSG_NOTHING) == node.negated;
    tree->data[*num] = node;
    tree->data[*num].end = *num + 1;
    (*num)++;
    return true;
}

/* Ends the tree behind the first num nodes. */
static void end_flat(struct csg_tree *tree, uint32_t num)
{
    tree->num = num;
    tree->data[0].end = num;
}

/* The same as sift, for a flat tree. */
static void sift_flat(const struct csg_tiler *tiler, struct csg_tile_task *task)
{
    struct csg_tree *tree = &task->tree;
    uint32_t num = 1;
    bool any = true;
    for (uint32_t i = 1; i < tree->num && any; i++) {
        const bool missed = csg_tiler_misses(tiler, task, tree->data[i].leaf);
        any = keep_flat(tree, i, missed ? CSG_NOTHING : CSG_VARIES, &num);
    }
    end_flat(tree, any ? num : 0);
}

/* Leaves what matters in the part at hand of a flat tree that was judged. */
static void take_part(struct csg_tiler *tiler, struct csg_tree *tree)
{
    const struct csg_leaf_ranges *ranges = tiler->parts.ranges.data;
    const int at = tiler->parts.at;
    uint32_t num = 1;
    for (uint32_t i = 1; i < tree->num; i++) {
        const struct csg_node node = tree->data[i];
        if (!(ranges[i].entry.lo[at] <= ranges[i].exit.hi[at]))
            continue;
        csg_tiler_note_leaf(tiler, node.leaf, i);
        tiler->terms->known[node.leaf] = CSG_VARIES;
        tree->data[num] = node;
        tree->data[num].end = num + 1;
        num++;
    }
    end_flat(tree, num);
    tiler->opaque = tiler->parts.flat.opaque[at] != 0;
}

/* The same as fold, for a flat tree. */
static void fold_flat(struct csg_tiler *tiler, struct csg_tile_task *task)
{
    struct csg_tree *tree = &task->tree;
    const bool any = tiler->parts.flat.empty[tiler->parts.at] == 0; /* is left */
    if (any)
        take_part(tiler, tree);
    if (any && csg_dominate(tiler->terms, tree, tiler->ranges.data, csg_tiler_box(tiler),
                            tiler->members.data)) {
        uint32_t num = 1;
        for (uint32_t i = 1; i < tree->num; i++)
            keep_flat(tree, i, tiler->terms->known[tree->data[i].leaf], &num);
        end_flat(tree, num);
    }
    if (tree->num == 2)
        tree->data[0] = tree->data[1];
    if (tree->num == 2 || !any)
        end_flat(tree, any ? 1 : 0);
    task->flat = tree->num > 1;
}

bool csg_tiler_sift(struct csg_tiler *tiler, struct csg_tile_task *task)
{
    if (!task->flat)
        return sift(tiler, task);
    sift_flat(tiler, task);
    return true;
}

bool csg_tiler_fold(struct csg_tiler *tiler, struct csg_tile_task *task)
{
    if (task->tree.num == 0)
        return true;
    if (!reserve(tiler, task->tree.num))
        return false;
    csg_band_list_narrow(&task->bands, tiler->terms, csg_tiler_box(tiler), tiler->stacks.data);
    if (csg_task_is_judged(tiler, task)) {
        fold_flat(tiler, task);
        return true;
    }
    fill_leaves(tiler, &task->tree);
    return sift(tiler, task) && (task->tree.num == 0 || fold(tiler, task));
}
