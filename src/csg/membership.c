/* SPDX-License-Identifier: MIT */
#include "csg/membership.h"

#include <stdlib.h>

#include "mesh/surface.h"

/* Share of the coordinates within which the eye is on a surface: double computes heights to 10^-15.
 */
#define NEAR_EYE 1e-11

/* A triangle less than this many times as far from the eye is met before its rays are followed
 * (NEAR_SHARE in pack/surface.c), by some of a wide view's rays. */
#define NEAR_SURFACE 100

bool csg_object_contains(const struct csgcast_scene *scene, const struct csg_object *object,
                         struct csg_vec3 point)
{
    const struct csg_node *nodes = scene->trees[object->layer].data;
    bool *values = malloc((object->end - object->begin) * sizeof *values);
    if (!values)
        return true;
    for (uint32_t i = object->end; i-- > object->begin;) {
        const struct csg_node *node = &nodes[i];
        bool value = node->op == CSG_AND;
        if (node->op == CSG_LEAF)
            value = (!node->spare && csg_shape_contains(&scene->leaves[node->leaf].shape, point)) !=
                    node->negated;
        else
            for (uint32_t child = i + 1; child < node->end; child = nodes[child].end)
                value = node->op == CSG_AND ? value && values[child - object->begin]
                                            : value || values[child - object->begin];
        values[i - object->begin] = value;
    }
    const bool inside = values[0];
    free(values);
    return inside;
}

double csg_eye_near(const struct csgcast_scene *scene, struct csg_vec3 eye)
{
    double size = csg_vec3_largest(eye);
    if (csg_box_is_finite(&scene->box) && !csg_box_is_empty(&scene->box))
        size = fmax(size, fmax(csg_vec3_largest(scene->box.lo), csg_vec3_largest(scene->box.hi)));
    return NEAR_EYE * size;
}

bool csg_eye_is_on_surface(const struct csgcast_scene *scene, struct csg_vec3 eye)
{
    const double distance = NEAR_SURFACE * csg_eye_near(scene, eye);
    for (size_t i = 0; i < scene->num_leaves; i++) {
        const struct csg_shape *shape = &scene->leaves[i].shape;
        if (shape->surface && csg_surface_is_at(shape->surface, &shape->frame, eye, distance))
            return true;
    }
    return false;
}

bool csg_object_is_near(const struct csgcast_scene *scene, const struct csg_object *object,
                        struct csg_vec3 point, double distance)
{
    if (csg_object_contains(scene, object, point))
        return true;
    for (int i = 0; i < 27 && distance > 0; i++) {
        const struct csg_vec3 step = csg_vec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        if (csg_object_contains(scene, object, csg_add(point, csg_scale(distance, step))))
            return true;
    }
    return false;
}
