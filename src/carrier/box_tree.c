/* SPDX-License-Identifier: MIT */
#include "carrier/box_tree.h"

#include <stdlib.h>

#include "common/array.h"

/* Boxes in one of the level above; bits of a place along one axis. */
enum { FAN = 8, PLACE_BITS = 21 };

struct sorted {
    uint64_t place;
    uint32_t item;
};

/* The bits of a number, each with two zeros behind it. */
static uint64_t spread(uint64_t x)
{
    x = (x | x << 32) & UINT64_C(0x1f00000000ffff);
    x = (x | x << 16) & UINT64_C(0x1f0000ff0000ff);
    x = (x | x << 8) & UINT64_C(0x100f00f00f00f00f);
    x = (x | x << 4) & UINT64_C(0x10c30c30c30c30c3);
    return (x | x << 2) & UINT64_C(0x1249249249249249);
}

static uint64_t place_along(double x, double lo, double hi)
{
    const double most = (1 << PLACE_BITS) - 1, share = (x - lo) / (hi - lo) * most;
    return share >= most ? (uint64_t)most : share > 0 ? (uint64_t)share : 0;
}

/* Boxes without an end are anywhere. */
static uint64_t place_of(const struct csg_box *box, const struct csg_box *all)
{
    const struct csg_vec3 middle = csg_add(csg_scale(0.5, box->lo), csg_scale(0.5, box->hi));
    return spread(place_along(middle.x, all->lo.x, all->hi.x)) |
           spread(place_along(middle.y, all->lo.y, all->hi.y)) << 1 |
           spread(place_along(middle.z, all->lo.z, all->hi.z)) << 2;
}

static int compare(const void *a, const void *b)
{
    const struct sorted *x = a, *y = b;
    if (x->place != y->place)
        return x->place < y->place ? -1 : 1;
    return x->item < y->item ? -1 : x->item > y->item;
}

static size_t sort(const struct csg_box *boxes, size_t num, struct sorted *sorted)
{
    struct csg_box all = csg_box_empty;
    size_t num_sorted = 0;
    for (size_t i = 0; i < num; i++)
        if (csg_box_is_finite(&boxes[i]))
            all = csg_box_union(&all, &boxes[i]);
    for (size_t i = 0; i < num; i++)
        if (!csg_box_is_empty(&boxes[i]))
            sorted[num_sorted++] = (struct sorted){place_of(&boxes[i], &all), (uint32_t)i};
    if (num_sorted)
        qsort(sorted, num_sorted, sizeof *sorted, compare);
    return num_sorted;
}

/* Boxes of all levels over so many. */
static size_t count(size_t num)
{
    size_t sum = num;
    while (num > 1) {
        num = (num + FAN - 1) / FAN;
        sum += num;
    }
    return sum;
}

static void fill_levels(struct csg_box_tree *tree, size_t num)
{
    size_t below = 0, at = num;
    for (tree->num_levels = 1; num > 1; tree->num_levels++) {
        const size_t end = below + num;
        tree->begins[tree->num_levels] = at;
        for (size_t i = below; i < end; i++) {
            struct csg_box *box = &tree->boxes[at + (i - below) / FAN];
            *box = csg_box_union((i - below) % FAN ? box : &csg_box_empty, &tree->boxes[i]);
        }
        num = (num + FAN - 1) / FAN;
        below = at;
        at += num;
    }
}

bool csg_box_tree_init(struct csg_box_tree *tree, const struct csg_box *boxes, size_t num)
{
    struct sorted *sorted = malloc((num + 1) * sizeof *sorted);
    const size_t num_sorted = sorted ? sort(boxes, num, sorted) : 0;
    tree->boxes = malloc((count(num_sorted) + 1) * sizeof *tree->boxes);
    tree->items = malloc((num_sorted + 1) * sizeof *tree->items);
    const bool ok = sorted && tree->boxes && tree->items;
    for (size_t i = 0; i < num_sorted && ok; i++) {
        tree->items[i] = sorted[i].item;
        tree->boxes[i] = boxes[sorted[i].item];
    }
    tree->begins[1] = num_sorted;
    if (ok && num_sorted)
        fill_levels(tree, num_sorted);
    free(sorted);
    return ok;
}

void csg_box_tree_finish(struct csg_box_tree *tree)
{
    free(tree->boxes);
    free(tree->items);
    *tree = (struct csg_box_tree){0};
}

static bool overlaps(const struct csg_box *box, const void *what)
{
    return csg_box_overlaps(box, what);
}

/* The end of a level, in boxes. */
static size_t end_of(const struct csg_box_tree *tree, int level)
{
    return level + 1 < tree->num_levels ? tree->begins[level + 1] : tree->begins[level] + 1;
}

bool csg_box_tree_visit(const struct csg_box_tree *tree, csg_box_test_fn *meets, const void *what,
                        struct csg_box_tree_list *items)
{
    struct {
        size_t box;
        int level;
    } open[FAN * 24];
    int num = 0;
    if (tree->num_levels > 0) {
        open[num].level = tree->num_levels - 1;
        open[num++].box = tree->begins[tree->num_levels - 1];
    }
    while (num > 0) {
        const size_t box = open[--num].box;
        const int level = open[num].level;
        if (!meets(&tree->boxes[box], what))
            continue;
        if (level == 0) {
            if (!csg_array_push(items, tree->items[box]))
                return false;
            continue;
        }
        const size_t first = tree->begins[level - 1] + FAN * (box - tree->begins[level]);
        for (size_t i = first; i < first + FAN && i < end_of(tree, level - 1); i++) {
            open[num].level = level - 1;
            open[num++].box = i;
        }
    }
    return true;
}

bool csg_box_tree_find(const struct csg_box_tree *tree, const struct csg_box *around,
                       struct csg_box_tree_list *items)
{
    return csg_box_tree_visit(tree, overlaps, around, items);
}
