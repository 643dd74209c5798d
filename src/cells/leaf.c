/* SPDX-License-Identifier: MIT */
#include "cells/leaf.h"

#include <stdlib.h>

#include "carrier/carrier.h"
#include "carrier/side.h"

/* Rounding of the double arithmetic below, relative to its terms. */
#define NOISE 1e-12

static void set_leaf(const struct csgcast_scene *scene, uint32_t leaf, struct csg_cell_leaf *own)
{
    const struct csg_shape *shape = &scene->leaves[leaf].shape;
    *own = (struct csg_cell_leaf){.box = scene->leaves[leaf].box,
                                  .is_box = csg_side_is_box(scene, leaf)};
    if (!shape->has_quadric || shape->num_planes)
        return;
    const struct csg_face face = scene->carriers->quadric_faces[leaf];
    struct csg_vec3 center;
    double radius;
    if (face.flipped || !csg_quadric_ball(csg_carrier_quadric(scene, scene->carriers, face.carrier),
                                          &center, &radius))
        return;
    const struct csg_vec3 reach = csg_vec3(radius, radius, radius);
    own->box = (struct csg_box){csg_sub(center, reach), csg_add(center, reach)};
    own->radius = radius;
}

struct csg_cell_leaf *csg_cell_leaves_create(const struct csgcast_scene *scene,
                                             const struct csg_object *object)
{
    const struct csg_node *nodes = scene->trees[object->layer].data;
    struct csg_cell_leaf *leaves = malloc((scene->num_leaves + 1) * sizeof *leaves);
    for (uint32_t i = object->begin; i < object->end && leaves; i++)
        if (nodes[i].op == CSG_LEAF)
            set_leaf(scene, nodes[i].leaf, &leaves[nodes[i].leaf]);
    return leaves;
}

/* How far the box's nearest and furthest points are from the ball's center, squared, and a little
 * nearer and further. */
static void find_reach(const struct csg_cell_leaf *ball, const struct csg_box *box, double reach[2])
{
    double near = 0, far = 0;
    for (int i = 0; i < 3; i++) {
        const double lo = csg_vec3_component(box->lo, i), hi = csg_vec3_component(box->hi, i);
        const double center =
            0.5 * (csg_vec3_component(ball->box.lo, i) + csg_vec3_component(ball->box.hi, i));
        const double off = fabs(center - 0.5 * (lo + hi)), half = 0.5 * (hi - lo);
        const double noise = NOISE * (fabs(center) + off + half);
        const double least = csg_most(off - half - noise, 0), most = off + half + noise;
        near += least * least;
        far += most * most;
    }
    reach[0] = near * (1 - NOISE);
    reach[1] = far * (1 + NOISE);
}

uint8_t csg_cell_leaf_side(const struct csgcast_scene *scene, const struct csg_cell_leaf *leaves,
                           uint32_t leaf, const struct csg_box *box)
{
    const struct csg_cell_leaf *own = &leaves[leaf];
    const uint8_t by_box = csg_side_of_box(&own->box, box);
    double reach[2];
    if (own->is_box || by_box == CSG_NOTHING)
        return by_box;
    if (own->radius == 0)
        return csg_side_of_leaf(scene, leaf, false, box);
    find_reach(own, box, reach);
    const double square = own->radius * own->radius;
    return reach[0] > square ? CSG_NOTHING : reach[1] < square ? CSG_EVERYTHING : CSG_VARIES;
}

bool csg_cell_leaf_quadric_varies(const struct csgcast_scene *scene,
                                  const struct csg_cell_leaf *leaves, uint32_t leaf,
                                  const struct csg_box *box)
{
    double reach[2];
    if (leaves[leaf].radius == 0)
        return csg_side_quadric_varies(scene, leaf, box);
    find_reach(&leaves[leaf], box, reach);
    return reach[1] >= leaves[leaf].radius * leaves[leaf].radius;
}
