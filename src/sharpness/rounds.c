/* SPDX-License-Identifier: MIT */
#include "sharpness/rounds.h"

#include <stdlib.h>

#include "carrier/carrier.h"
#include "sharpness/wall.h"
#include "solids/sample.h"

/* Quadrics with boxes that differ by less than this share nearly coincide. */
#define NEAR_BOXES 1e-3

/* Points of a quadric's surface that show how far it is from another. */
#define NUM_SAMPLES 24

static double box_difference(const struct csg_box *a, const struct csg_box *b)
{
    const struct csg_vec3 lo = csg_sub(a->lo, b->lo), hi = csg_sub(a->hi, b->hi);
    return fmax(csg_vec3_largest(lo), csg_vec3_largest(hi));
}

/* Largest distance of b's surface from the carrier, to first order, by samples. */
static double deviation(const struct csg_quadric *carrier, const struct csg_shape *b)
{
    struct csg_vec3 points[NUM_SAMPLES];
    const size_t num = csg_shape_sample(b, points, NUM_SAMPLES);
    double largest = num ? 0 : INFINITY;
    for (size_t i = 0; i < num; i++) {
        const double slope = csg_length(csg_quadric_gradient(carrier, points[i]));
        largest = fmax(largest, fabs(csg_quadric_value(carrier, points[i])) / slope);
    }
    return largest;
}

/* Quadrics nearly coincide where the solids' boxes do, and the surfaces all over. */
static void note_quadrics(struct csg_sharpness *sharp, const struct csgcast_scene *scene,
                          const struct csg_round *a, const struct csg_round *b)
{
    const struct csg_box box = scene->leaves[a->leaf].box;
    const struct csg_box other = scene->leaves[b->leaf].box;
    const double near = NEAR_BOXES * csg_length(csg_sub(box.hi, box.lo));
    if (!csg_box_is_finite(&box) || !csg_box_is_finite(&other) ||
        !(box_difference(&box, &other) < near))
        return;
    const double apart = deviation(csg_carrier_quadric(scene, scene->carriers, a->carrier),
                                   &scene->leaves[b->leaf].shape);
    if (apart < near)
        csg_sharpness_note(sharp, CSG_FINE_GAP, apart, b->leaf);
}

/* Rings of one profile, whose walls are known. */
static bool is_one_profile(const struct csgcast_scene *scene, const uint8_t *marks, uint32_t a,
                           uint32_t b)
{
    const struct csg_leaf *x = &scene->leaves[a], *y = &scene->leaves[b];
    return marks[a] & marks[b] & CSG_WALL_RING && x->line == y->line && x->column == y->column;
}

/* In many objects all of them are taken away, and there is nothing to compare. */
static bool are_on_one_side(const struct csg_rounds *rounds)
{
    for (size_t i = 1; i < rounds->all.num; i++)
        if (rounds->all.data[i].turned != rounds->all.data[0].turned)
            return false;
    return true;
}

bool csg_rounds_sort(struct csg_rounds *rounds)
{
    rounds->keys.list.num = 0;
    if (are_on_one_side(rounds))
        return true;
    for (uint32_t i = 0; i < rounds->all.num; i++) {
        const struct csg_key key = {csg_key_of(rounds->all.data[i].place), i};
        if (!csg_array_push(&rounds->keys.list, key))
            return false;
    }
    return csg_keys_sort(&rounds->keys);
}

/* A quadric and those behind it in the order. */
static void note_neighbours(const struct csg_rounds *rounds, const struct csgcast_scene *scene,
                            const uint8_t *marks, size_t i, double near,
                            struct csg_sharpness *sharp)
{
    const struct csg_key *keys = rounds->keys.list.data;
    const struct csg_round *own = &rounds->all.data[keys[i].index];
    for (size_t j = i + 1; j < rounds->all.num && j < i + CSG_FINE_NEIGHBOURS; j++) {
        const struct csg_round *other = &rounds->all.data[keys[j].index];
        if (!(other->place - own->place < near))
            return;
        if (own->carrier != other->carrier && own->turned != other->turned &&
            !is_one_profile(scene, marks, own->leaf, other->leaf))
            note_quadrics(sharp, scene, own, other);
    }
}

void csg_rounds_note(const struct csg_rounds *rounds, const struct csgcast_scene *scene,
                     size_t begin, size_t end, const uint8_t *marks, double radius,
                     struct csg_sharpness *sharp)
{
    for (size_t i = begin; i < end; i++)
        note_neighbours(rounds, scene, marks, i, NEAR_BOXES * radius, sharp);
}

void csg_rounds_finish(struct csg_rounds *rounds)
{
    free(rounds->all.data);
    free(rounds->keys.list.data);
    free(rounds->keys.room.data);
}
