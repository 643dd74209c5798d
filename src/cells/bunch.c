/* SPDX-License-Identifier: MIT */
#include "cells/bunch.h"

#include <stdlib.h>
#include <string.h>

#include "carrier/side.h"
#include "common/layout.glsl"

enum { MAX_PLANES = CSG_BUNCH_MANY_PLANES, NUM_LITERALS = CSG_BUNCH_LITERALS };
enum { NUM_QUADRICS = CSG_BUNCH_QUADRICS };

/* A bunch that is being filled. */
struct bunch {
    uint64_t planes[MAX_PLANES], quadrics[NUM_QUADRICS];
    uint32_t plane_places[MAX_PLANES], quadric_places[NUM_QUADRICS];
    uint32_t masks[NUM_LITERALS];
    int32_t leaves[NUM_LITERALS];
    size_t num_planes, num_quadrics, num_literals;
};

static size_t max_planes(bool quadrics)
{
    return quadrics ? CSG_BUNCH_FEW_PLANES : CSG_BUNCH_MANY_PLANES;
}

bool csg_bunches_can_hold(const struct csgcast_scene *scene, const struct csg_object *object,
                          bool *quadrics)
{
    const struct csg_node *nodes = scene->trees[object->layer].data;
    size_t most_planes = 0;
    *quadrics = false;
    for (uint32_t i = object->begin; i < object->end; i++) {
        if (nodes[i].op != CSG_LEAF) {
            if (i > object->begin || nodes[i].op != CSG_AND)
                return false;
            continue;
        }
        const struct csg_shape *shape = &scene->leaves[nodes[i].leaf].shape;
        if (shape->has_quadric && !shape->convex)
            return false;
        *quadrics |= shape->has_quadric;
        most_planes = shape->num_planes > most_planes ? shape->num_planes : most_planes;
    }
    return most_planes <= max_planes(*quadrics);
}

/* The bit of a surface among those at hand, which it joins: equal terms count once. */
static size_t find_surface(uint64_t surface, uint32_t place, uint64_t *surfaces, uint32_t *places,
                           size_t *num, size_t max)
{
    for (size_t i = 0; i < *num && i < max; i++)
        if (surfaces[i] == surface)
            return i;
    if (*num < max) {
        surfaces[*num] = surface;
        places[*num] = place;
    }
    return (*num)++;
}

static uint64_t plane_of(struct csg_face face)
{
    return 2 * (uint64_t)face.carrier + face.flipped;
}

/* Of a double cone or a hyperboloid either sheet has terms of its own. */
static uint64_t quadric_of(const struct csg_carriers *carriers, uint32_t leaf)
{
    return 4 * plane_of(carriers->quadric_faces[leaf]) + (uint64_t)(carriers->sheets[leaf] + 1);
}

/* false: the bunch has no room for it. */
static bool put_literal(const struct csg_bunches *bunches, const struct csg_bunch_literal *literal,
                        const struct csg_box *box, struct bunch *bunch)
{
    const struct csgcast_scene *scene = bunches->scene;
    const struct csg_carriers *carriers = scene->carriers;
    const uint32_t begin = carriers->face_begin[literal->leaf];
    const uint32_t num = carriers->face_begin[literal->leaf + 1] - begin;
    const uint32_t place = bunches->places[literal->leaf];
    const size_t max = max_planes(bunches->quadrics);
    if (bunch->num_literals == NUM_LITERALS)
        return false;
    const size_t num_planes = bunch->num_planes, num_quadrics = bunch->num_quadrics;
    uint32_t mask = literal->negated ? CSG_BUNCH_NEGATED : 0;
    for (uint32_t i = 0; i < num; i++)
        if (csg_side_plane_varies(scene, carriers->faces[begin + i], box)) {
            const size_t bit =
                find_surface(plane_of(carriers->faces[begin + i]), place + 1 + i, bunch->planes,
                             bunch->plane_places, &bunch->num_planes, max);
            mask |= 1u << bit;
        }
    if (scene->leaves[literal->leaf].shape.has_quadric &&
        csg_cell_leaf_quadric_varies(scene, bunches->leaves, literal->leaf, box)) {
        const size_t bit =
            find_surface(quadric_of(carriers, literal->leaf), place + 1 + num, bunch->quadrics,
                         bunch->quadric_places, &bunch->num_quadrics, NUM_QUADRICS);
        mask |= 1u << (CSG_BUNCH_FEW_PLANES + bit);
    }
    if (bunch->num_planes > max || bunch->num_quadrics > NUM_QUADRICS) {
        bunch->num_planes = num_planes;
        bunch->num_quadrics = num_quadrics;
        return false;
    }
    bunch->masks[bunch->num_literals] = mask;
    bunch->leaves[bunch->num_literals++] =
        literal->negated ? -(int32_t)(place + 1) : (int32_t)(place + 1);
    return true;
}

/* Places where there is nothing repeat the first one; literals that are not there always hold. */
static bool put_bunch(struct csg_bunches *bunches, const struct bunch *bunch)
{
    const size_t num_planes = max_planes(bunches->quadrics);
    const size_t num_quadrics = bunches->quadrics ? NUM_QUADRICS : 0;
    const size_t num = num_planes + num_quadrics + 2 * (size_t)NUM_LITERALS;
    if (!csg_array_reserve(&bunches->texels, num))
        return false;
    float *to = bunches->texels.data + bunches->texels.num;
    memset(to, 0, num * sizeof *to);
    for (size_t i = 0; i < num_planes && bunch->num_planes; i++)
        to[i] = (float)bunch->plane_places[i < bunch->num_planes ? i : 0];
    for (size_t i = 0; i < num_quadrics && bunch->num_quadrics; i++)
        to[num_planes + i] = (float)bunch->quadric_places[i < bunch->num_quadrics ? i : 0];
    to += num_planes + num_quadrics;
    for (size_t i = 0; i < bunch->num_literals; i++) {
        to[i] = (float)bunch->masks[i];
        to[NUM_LITERALS + i] = (float)bunch->leaves[i];
    }
    bunches->texels.num += num;
    return true;
}

/* In the order in which one of them is chosen where several change at once: those that are not
 * subtracted, then those that are, as in the file. */
static int compare_literals(const void *a, const void *b)
{
    const struct csg_bunch_literal *x = a, *y = b;
    if (x->negated != y->negated)
        return x->negated ? 1 : -1;
    return x->leaf < y->leaf ? -1 : x->leaf > y->leaf;
}

static bool sort_literals(struct csg_bunches *bunches, const struct csg_tree *tree)
{
    struct csg_bunch_literal last = {0};
    bool sorted = true;
    bunches->literals.num = 0;
    for (size_t i = 0; i < tree->num; i++) {
        const struct csg_bunch_literal own = {tree->data[i].leaf, tree->data[i].negated};
        if (tree->data[i].op != CSG_LEAF)
            continue;
        if (!csg_array_push(&bunches->literals, own))
            return false;
        sorted &= compare_literals(&last, &own) <= 0;
        last = own;
    }
    if (!sorted)
        qsort(bunches->literals.data, bunches->literals.num, sizeof *bunches->literals.data,
              compare_literals);
    return true;
}

bool csg_bunches_add(struct csg_bunches *bunches, const struct csg_tree *tree,
                     const struct csg_box *box)
{
    struct bunch bunch = {.num_planes = 0};
    if (tree->num == 0)
        return true;
    if (!sort_literals(bunches, tree))
        return false;
    for (size_t i = 0; i < bunches->literals.num; i++) {
        if (put_literal(bunches, &bunches->literals.data[i], box, &bunch))
            continue;
        if (!put_bunch(bunches, &bunch))
            return false;
        bunch = (struct bunch){.num_planes = 0};
        put_literal(bunches, &bunches->literals.data[i], box, &bunch); /* one always has room */
    }
    return put_bunch(bunches, &bunch);
}
