/* SPDX-License-Identifier: MIT */
#include "cells/split.h"

#include <stdlib.h>

/* Leaves at whose ends cuts are tried: the largest, which leave the largest cells empty, and some
 * of all the others. */
#define NUM_LARGEST 8
#define NUM_OTHERS 8
/* So many leaves tell how many are on either side of a place, by every k-th of them. */
#define MAX_COUNTED 512

#define MAX_PLACES (2 * (NUM_LARGEST + NUM_OTHERS) + 1)

/* So many solids are worth a cut even where their boxes promise nothing. */
#define MANY_LEAVES 8

/* Boxes are not halved below this size, in margins. */
#define SMALLEST 32

/* What a cut costs a ray, in literals. */
#define COST_OF_CUT 0.5

/* The share of a box that a hole has to take. */
#define CARVED_SHARE 0.02

struct places {
    double at[MAX_PLACES];
    size_t num;
    size_t begun[MAX_PLACES + 1], ended[MAX_PLACES + 1]; /* leaves between two places */
};

struct csg_box csg_split_box(const struct csg_box *box, const struct csg_split *split, bool upper)
{
    struct csg_box part = *box;
    struct csg_vec3 *end = upper ? &part.lo : &part.hi;
    *(split->axis == 0 ? &end->x : split->axis == 1 ? &end->y : &end->z) = split->at;
    return part;
}

static bool collect(struct csg_splitter *splitter, const struct csg_box *box,
                    const struct csg_tree *tree)
{
    splitter->inside.num = 0;
    if (!csg_array_reserve(&splitter->inside, tree->num))
        return false;
    for (size_t i = 0; i < tree->num; i++) {
        const struct csg_node *node = &tree->data[i];
        if (node->op == CSG_LEAF)
            splitter->inside.data[splitter->inside.num++] = (struct csg_split_leaf){
                csg_box_intersection(box, &splitter->leaves[node->leaf].box), node->negated,
                splitter->leaves[node->leaf].is_box};
    }
    return true;
}

/* They stay in order. */
static void add_place(struct places *places, double at)
{
    size_t i = places->num++;
    for (; i > 0 && places->at[i - 1] > at; i--)
        places->at[i] = places->at[i - 1];
    places->at[i] = at;
}

/* Places of the largest boxes, by area, the first of equal ones first. */
static size_t find_largest(const struct csg_splitter *splitter, size_t largest[NUM_LARGEST])
{
    double areas[NUM_LARGEST];
    size_t num = 0;
    for (size_t i = 0; i < splitter->inside.num; i++) {
        const double own = csg_box_half_area(&splitter->inside.data[i].box);
        if (num == NUM_LARGEST && own <= areas[num - 1])
            continue;
        size_t at = num < NUM_LARGEST ? num++ : num - 1;
        for (; at > 0 && areas[at - 1] < own; at--) {
            areas[at] = areas[at - 1];
            largest[at] = largest[at - 1];
        }
        areas[at] = own;
        largest[at] = i;
    }
    return num;
}

/* Beside the end on the side where nothing is left: that cell is then empty. */
static void add_ends(const struct csg_splitter *splitter, const struct csg_box *box,
                     const struct csg_split_leaf *leaf, int axis, struct places *places)
{
    const double off = (leaf->negated ? 2 : -2) * splitter->margin;
    const double lo = csg_vec3_component(box->lo, axis) + 4 * splitter->margin;
    const double hi = csg_vec3_component(box->hi, axis) - 4 * splitter->margin;
    const double ends[2] = {csg_vec3_component(leaf->box.lo, axis) + off,
                            csg_vec3_component(leaf->box.hi, axis) - off};
    for (int i = 0; i < 2; i++)
        if (ends[i] > lo && ends[i] < hi)
            add_place(places, ends[i]);
}

static void find_places(const struct csg_splitter *splitter, const struct csg_box *box,
                        const size_t *largest, size_t num_largest, int axis, struct places *places)
{
    const size_t num = splitter->inside.num;
    const size_t step = num > NUM_OTHERS ? num / NUM_OTHERS : 1;
    places->num = 0;
    for (size_t i = 0; i < num_largest; i++)
        add_ends(splitter, box, &splitter->inside.data[largest[i]], axis, places);
    for (size_t i = 0; i < NUM_OTHERS && i * step < num; i++)
        add_ends(splitter, box, &splitter->inside.data[i * step], axis, places);
    const double lo = csg_vec3_component(box->lo, axis), hi = csg_vec3_component(box->hi, axis);
    if (hi - lo > SMALLEST * splitter->margin)
        add_place(places, 0.5 * (lo + hi));
}

/* How many places are below key. Which way each step goes is not foreseen, so none branches. */
static size_t places_below(const struct places *places, double key)
{
    size_t begin = 0, num = places->num;
    for (; num > 1; num -= num / 2)
        begin += num / 2 * (places->at[begin + num / 2 - 1] < key);
    return begin + (num == 1 && places->at[begin] < key);
}

static void count_leaves(const struct csg_splitter *splitter, size_t step, int axis,
                         struct places *places)
{
    for (size_t i = 0; i <= places->num; i++)
        places->begun[i] = places->ended[i] = 0;
    for (size_t i = 0; i < splitter->inside.num; i += step) {
        const struct csg_box *leaf = &splitter->inside.data[i].box;
        const double margin = splitter->margin;
        places->begun[places_below(places, csg_vec3_component(leaf->lo, axis) - margin)] += step;
        places->ended[places_below(places, csg_vec3_component(leaf->hi, axis) + margin)] += step;
    }
}

static void choose(const struct csg_box *box, int axis, const struct places *places, size_t num,
                   struct csg_split *best)
{
    size_t below = 0, above = num;
    for (size_t i = 0; i < places->num; i++) {
        below += places->begun[i];
        above -= places->ended[i];
        struct csg_split split = {axis, places->at[i], 0};
        const struct csg_box lower = csg_split_box(box, &split, false);
        const struct csg_box upper = csg_split_box(box, &split, true);
        split.cost = COST_OF_CUT + ((double)below * csg_box_half_area(&lower) +
                                    (double)above * csg_box_half_area(&upper)) /
                                       csg_box_half_area(box);
        if (split.cost < best->cost)
            *best = split;
    }
}

static double volume(const struct csg_box *box)
{
    const struct csg_vec3 d = csg_sub(box->hi, box->lo);
    return d.x * d.y * d.z;
}

/* A cut along the largest hole that takes a good part of the box away: of several such cuts one
 * leaves an empty cell, which the heuristic does not foresee. */
static bool find_carving(const struct csg_splitter *splitter, const struct csg_box *box,
                         struct csg_split *split)
{
    const struct csg_split_leaf *best = NULL;
    double most = CARVED_SHARE * volume(box);
    for (size_t i = 0; i < splitter->inside.num; i++) {
        const struct csg_split_leaf *leaf = &splitter->inside.data[i];
        if (leaf->negated && leaf->is_box && volume(&leaf->box) > most) {
            most = volume(&leaf->box);
            best = leaf;
        }
    }
    double share = 0;
    for (int axis = 0; axis < 3 && best; axis++) {
        struct places places = {.num = 0};
        const double lo = csg_vec3_component(box->lo, axis), hi = csg_vec3_component(box->hi, axis);
        add_ends(splitter, box, best, axis, &places);
        for (size_t i = 0; i < places.num; i++) {
            const double off = fmin(places.at[i] - lo, hi - places.at[i]) / (hi - lo);
            if (off > share) {
                share = off;
                *split = (struct csg_split){axis, places.at[i], 0};
            }
        }
    }
    return share > 0;
}

/* In the middle of the longest side: of solids askew, whose boxes say little, either half may miss
 * many. */
static void halve(const struct csg_splitter *splitter, const struct csg_box *box,
                  struct csg_split *split)
{
    const struct csg_vec3 d = csg_sub(box->hi, box->lo);
    const int axis = d.x >= d.y && d.x >= d.z ? 0 : d.y >= d.z ? 1 : 2;
    const double lo = csg_vec3_component(box->lo, axis), hi = csg_vec3_component(box->hi, axis);
    if (hi - lo > SMALLEST * splitter->margin)
        *split = (struct csg_split){axis, 0.5 * (lo + hi), 0};
}

bool csg_split_find(struct csg_splitter *splitter, const struct csg_box *box,
                    const struct csg_tree *tree, struct csg_split *split)
{
    size_t largest[NUM_LARGEST];
    if (!collect(splitter, box, tree))
        return false;
    const size_t num = splitter->inside.num;
    *split = (struct csg_split){.axis = -1, .cost = (double)num};
    if (find_carving(splitter, box, split))
        return true;
    const size_t step = 1 + num / MAX_COUNTED, num_counted = (num + step - 1) / step * step;
    const size_t num_largest = find_largest(splitter, largest);
    for (int axis = 0; axis < 3; axis++) {
        struct places places;
        find_places(splitter, box, largest, num_largest, axis, &places);
        count_leaves(splitter, step, axis, &places);
        choose(box, axis, &places, num_counted, split);
    }
    if (split->axis < 0 && num > MANY_LEAVES)
        halve(splitter, box, split);
    return split->axis >= 0;
}
