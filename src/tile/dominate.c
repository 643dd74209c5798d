/* SPDX-License-Identifier: MIT */
#include "tile/dominate.h"

#include <string.h>

/* Operands of a node from which on it is worth looking, and solids that others are compared with.
 */
#define MIN_OPERANDS 12
#define MAX_DOMINATORS 4

/* Planes of one times planes of the other, beyond which they are not compared: in smaller tiles
 * solids of many planes have few of them. */
#define MAX_PLANE_PAIRS 1024

/* How one face lies to another over the tile. */
enum { CROSSES, EQUAL_SOMEWHERE, BEHIND };

/* Of b against a: the difference of two affine terms is one. */
static int compare_planes(const double *a, const double *b, const struct csg_tile_box *tile)
{
    const double dx = b[1] - a[1], dy = b[2] - a[2];
    const double mid = b[0] - a[0] + dx * tile->center[0] + dy * tile->center[1];
    const double least = mid - fabs(dx) * tile->half[0] - fabs(dy) * tile->half[1];
    return least > 0 ? BEHIND : least == 0 ? EQUAL_SOMEWHERE : CROSSES;
}

struct pair {
    const struct csg_terms *terms;
    const struct csg_tile_box *tile;
    struct csg_rect rect; /* of the tile, in pixels */
    const struct csg_leaf_terms *outer, *inner;
    bool touches;
};

/* Whether some plane of inner, of places [begin, end), lies behind the outer one; sign -1: before.
 */
static bool has_plane(struct pair *pair, size_t outer, size_t begin, size_t end, bool before)
{
    const double *a = csg_terms_texel(pair->terms, pair->outer, outer);
    int best = CROSSES;
    for (size_t i = begin; i < end && best != BEHIND; i++) {
        const double *b = csg_terms_texel(pair->terms, pair->inner, i);
        const int order =
            before ? compare_planes(b, a, pair->tile) : compare_planes(a, b, pair->tile);
        best = order > best ? order : best;
    }
    pair->touches |= best == EQUAL_SOMEWHERE;
    return best != CROSSES;
}

/* The quadric of both, if the outer one has any, must be the same: equal carriers have equal terms.
 */
static bool same_quadric(const struct pair *pair)
{
    const struct csg_leaf_terms *outer = pair->outer, *inner = pair->inner;
    if (!(outer->flags & CSG_RECORD_QUADRIC))
        return true;
    return inner->flags & CSG_RECORD_QUADRIC && outer->carrier == inner->carrier &&
           memcmp(csg_terms_texel(pair->terms, outer, outer->num_entries + outer->num_exits),
                  csg_terms_texel(pair->terms, inner, inner->num_entries + inner->num_exits),
                  4 * CSG_QUADRIC_TEXELS * sizeof(double)) == 0;
}

/* Whether what may be seen of inner in the tile lies within what may be of outer: their rectangles
 * tell soonest of most pairs that neither is part of the other. */
static bool has_room(const struct pair *pair)
{
    const struct csg_rect *outer = &pair->outer->rect, *inner = &pair->inner->rect;
    const struct csg_rect *tile = &pair->rect;
    bool has_room = true;
    for (int i = 0; i < 2; i++)
        has_room &= (inner->lo[i] >= outer->lo[i] || outer->lo[i] <= tile->lo[i]) &
                    (inner->hi[i] <= outer->hi[i] || outer->hi[i] >= tile->hi[i]);
    return has_room;
}

/* Whether inner is part of outer everywhere in the tile. Where faces coincide, touches is set. */
static bool is_inside(struct pair *pair)
{
    const struct csg_leaf_terms *outer = pair->outer, *inner = pair->inner;
    const size_t outer_end = outer->num_entries + outer->num_exits;
    const size_t inner_end = inner->num_entries + inner->num_exits;
    pair->touches = outer->flags & CSG_RECORD_QUADRIC;
    if (!has_room(pair) || (outer->flags | inner->flags) & CSG_RECORD_SURFACE ||
        outer->flags & CSG_RECORD_GAP || outer_end * inner_end > MAX_PLANE_PAIRS ||
        !same_quadric(pair))
        return false;
    for (size_t i = 0; i < outer->num_entries; i++)
        if (!has_plane(pair, i, 0, inner->num_entries, false))
            return false;
    for (size_t i = outer->num_entries; i < outer_end; i++)
        if (!has_plane(pair, i, inner->num_entries, inner_end, true))
            return false;
    return true;
}

/* Operands of one node that have the same effect: those of a union, or subtracted ones, of which
 * the largest matters, or the others, of which the smallest does. Leaves of which nothing is known.
 */
struct group {
    uint32_t *leaves;
    size_t num;
    bool largest;
};

/* Of a group's members those that begin first, or last, in this order. */
struct dominators {
    uint32_t leaves[MAX_DOMINATORS];
    double keys[MAX_DOMINATORS];
    size_t num;
};

static void add_dominator(struct dominators *found, uint32_t leaf, double key)
{
    size_t i = found->num;
    if (i == MAX_DOMINATORS && key >= found->keys[i - 1])
        return;
    i = i < MAX_DOMINATORS ? found->num++ : i - 1;
    for (; i > 0 && key < found->keys[i - 1]; i--) {
        found->leaves[i] = found->leaves[i - 1];
        found->keys[i] = found->keys[i - 1];
    }
    found->leaves[i] = leaf;
    found->keys[i] = key;
}

static struct csg_rect rect_of(const struct csg_terms *terms, const struct csg_tile_box *tile)
{
    const double at[2] = {terms->frame->at.x, terms->frame->at.y};
    struct csg_rect rect;
    for (int i = 0; i < 2; i++) {
        rect.lo[i] = at[i] + tile->center[i] - tile->half[i];
        rect.hi[i] = at[i] + tile->center[i] + tile->half[i];
    }
    return rect;
}

static bool dominate_by(const struct csg_terms *terms, const struct csg_tile_box *tile,
                        const struct group *group, uint32_t own)
{
    struct pair pair = {.terms = terms, .tile = tile, .rect = rect_of(terms, tile)};
    bool any = false;
    for (size_t i = 0; i < group->num; i++) {
        const uint32_t leaf = group->leaves[i];
        if (leaf == own || terms->known[leaf] != CSG_VARIES)
            continue;
        pair.outer = csg_terms_of(terms, group->largest ? own : leaf);
        pair.inner = csg_terms_of(terms, group->largest ? leaf : own);
        /* Of faces that coincide the first in the file shows. */
        if (!is_inside(&pair) || (pair.touches && own > leaf))
            continue;
        terms->known[leaf] = group->largest ? CSG_NOTHING : CSG_EVERYTHING;
        any = true;
    }
    return any;
}

static bool dominate_group(const struct csg_terms *terms, const struct csg_leaf_range *ranges,
                           const struct csg_tile_box *tile, const struct group *group)
{
    struct dominators found = {.num = 0};
    bool any = false;
    for (size_t i = 0; i < group->num && group->num > 1; i++) {
        const uint32_t leaf = group->leaves[i];
        const double begin = ranges[terms->index[leaf]].entry.lo;
        add_dominator(&found, leaf, group->largest ? begin : -begin);
    }
    for (size_t i = 0; i < found.num; i++)
        if (terms->known[found.leaves[i]] == CSG_VARIES)
            any |= dominate_by(terms, tile, group, found.leaves[i]);
    return any;
}

static void list_members(const struct csg_terms *terms, const struct csg_tree *tree, uint32_t node,
                         struct group *plain, struct group *negated)
{
    for (uint32_t i = node + 1; i < tree->data[node].end; i = tree->data[i].end) {
        const struct csg_node *member = &tree->data[i];
        struct group *group = member->negated ? negated : plain;
        if (member->op == CSG_LEAF && terms->known[member->leaf] == CSG_VARIES)
            group->leaves[group->num++] = member->leaf;
    }
}

bool csg_dominate(const struct csg_terms *terms, const struct csg_tree *tree,
                  const struct csg_leaf_range *ranges, const struct csg_tile_box *tile,
                  uint32_t *room)
{
    bool any = false;
    for (uint32_t i = 0; i < tree->num && tree->num > MIN_OPERANDS; i++) {
        const struct csg_node *node = &tree->data[i];
        if (node->op == CSG_LEAF || node->end - i <= MIN_OPERANDS)
            continue;
        const bool all = node->op == CSG_AND;
        struct group plain = {room, 0, !all}, negated = {room + tree->num, 0, all};
        list_members(terms, tree, i, &plain, &negated);
        any |= dominate_group(terms, ranges, tile, &plain);
        any |= dominate_group(terms, ranges, tile, &negated);
    }
    return any;
}
