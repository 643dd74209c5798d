/* SPDX-License-Identifier: MIT */
#include "tile/flat.h"

#include "common/wide.h"
#include "tile/front.h"

#define LANES CSG_TILE_LANES

/* The keys that all solids have in common. */
PART void find_common(const struct csg_tree *tree, const struct csg_leaf_ranges *ranges,
                      struct csg_ranges *common)
{
    for (int i = 0; i < LANES; i++) {
        common->lo[i] = -(double)CSG_KEY_MAX;
        common->hi[i] = INFINITY;
    }
    for (size_t j = 1; j < tree->num; j++) {
        const struct csg_leaf_ranges *leaf = &ranges[j];
        for (int i = 0; i < LANES && !tree->data[j].negated; i++) {
            common->lo[i] = csg_larger(common->lo[i], leaf->entry.lo[i]);
            common->hi[i] = csg_smaller(common->hi[i], leaf->exit.hi[i]);
        }
    }
}

/* The first keys from those on at which the solid is certainly met by all rays. */
PART void jump_into(const struct csg_leaf_ranges *leaf, double *keys)
{
    for (int i = 0; i < LANES; i++) {
        const double begin = keys[i] > leaf->entry.hi[i] ? keys[i] : csg_behind(leaf->entry.hi[i]);
        const double last = leaf->entry.hi[i] < leaf->exit.lo[i] ? leaf->exit.lo[i] : -INFINITY;
        keys[i] = begin < last ? begin : INFINITY;
    }
}

/* ... by none. */
PART void jump_out_of(const struct csg_leaf_ranges *leaf, double *keys)
{
    for (int i = 0; i < LANES; i++) {
        const double out = keys[i] > leaf->exit.hi[i] ? keys[i] : csg_behind(leaf->exit.hi[i]);
        keys[i] = keys[i] < leaf->entry.lo[i] ? keys[i] : out;
    }
}

/* Whether keys before far are still to be tried. */
PART bool may_jump(const double *last, const double *keys, double far)
{
    bool any = false;
    for (int i = 0; i < LANES; i++)
        any |= last[i] < keys[i] && keys[i] < far;
    return any;
}

/* As csg_front_find: the keys behind which nothing shows. */
PART void find_fronts(const struct csg_tree *tree, const struct csg_leaf_ranges *ranges, double far,
                      double *fronts, double *opaque)
{
    double keys[LANES], last[LANES];
    for (int i = 0; i < LANES; i++)
        keys[i] = -(double)CSG_KEY_MAX;
    int left = CSG_FRONT_JUMPS;
    do {
        for (int i = 0; i < LANES; i++)
            last[i] = keys[i];
        for (size_t j = 1; j < tree->num; j++)
            if (tree->data[j].negated)
                jump_out_of(&ranges[j], keys);
            else
                jump_into(&ranges[j], keys);
    } while (--left > 0 && may_jump(last, keys, far));
    for (int i = 0; i < LANES; i++) {
        const double found = keys[i] < far ? keys[i] : far;
        opaque[i] = last[i] == keys[i] && keys[i] < far;
        fronts[i] = opaque[i] != 0 ? found : far;
    }
}

/* As leaves of other trees are judged, see fold.c: one that is nothing ends before it begins, as one
 * does that is everything, for which *covers is more than common->hi. */
PART void judge(const struct csg_ranges *common, struct csg_leaf_ranges *leaf, double *covers)
{
    for (int i = 0; i < LANES; i++) {
        const double lo = common->lo[i], hi = common->hi[i];
        const double begin = csg_larger(leaf->entry.lo[i], lo);
        const double end = csg_smaller(leaf->exit.hi[i], hi);
        const double solid = leaf->entry.hi[i] < lo ? leaf->exit.lo[i] : -INFINITY;
        leaf->entry.lo[i] = solid > hi ? INFINITY : begin;
        leaf->exit.hi[i] = begin <= end ? end : -INFINITY;
        covers[i] = begin <= end ? solid : -INFINITY;
    }
}

/* Nothing is left where it is nothing. */
PART void judge_solid(const struct csg_ranges *common, struct csg_leaf_ranges *leaf, double *empty)
{
    double covers[LANES];
    judge(common, leaf, covers);
    for (int i = 0; i < LANES; i++)
        empty[i] = leaf->exit.hi[i] < common->lo[i] ? 1 : empty[i];
}

/* ... where what is taken away is everything. */
PART void judge_complement(const struct csg_ranges *common, struct csg_leaf_ranges *leaf,
                           double *empty)
{
    double covers[LANES];
    judge(common, leaf, covers);
    for (int i = 0; i < LANES; i++)
        empty[i] = covers[i] > common->hi[i] ? 1 : empty[i];
}

WIDE void judge_all(const struct csg_tree *tree, struct csg_leaf_ranges *ranges, double far,
                    bool has_front, struct csg_flat *flat)
{
    struct csg_ranges common;
    double fronts[LANES];
    for (int i = 0; i < LANES; i++) {
        flat->opaque[i] = flat->empty[i] = 0;
        fronts[i] = far;
    }
    find_common(tree, ranges, &common);
    if (has_front)
        find_fronts(tree, ranges, far, fronts, flat->opaque);
    for (int i = 0; i < LANES; i++)
        common.hi[i] = csg_smaller(common.hi[i], fronts[i]);
    for (size_t j = 1; j < tree->num; j++)
        if (tree->data[j].negated)
            judge_complement(&common, &ranges[j], flat->empty);
        else
            judge_solid(&common, &ranges[j], flat->empty);
}

void csg_flat_judge(const struct csg_tree *tree, struct csg_leaf_ranges *ranges, double far,
                    bool has_front, struct csg_flat *flat)
{
    judge_all(tree, ranges, far, has_front, flat);
}
