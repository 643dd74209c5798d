/* SPDX-License-Identifier: MIT */
#include "pack/apart.h"

#include <stdlib.h>

#include "polyhedra/hull.h"

/* Solids of more planes would take longer to tell apart than microseconds. */
enum { MAX_PLANES = 12 };

/* So far may a corner be on the wrong side of a plane, of the size of the coordinates: more than
 * rounding makes of it, and less than a picture shows. */
#define ROUNDING 1e-9

static const struct csg_shape *lone_shape(const struct csgcast_scene *scene,
                                          const struct csg_object *object)
{
    const struct csg_node *node = &scene->trees[object->layer].data[object->begin];
    if (object->end - object->begin != 1 || node->op != CSG_LEAF || node->negated)
        return NULL;
    const struct csg_shape *shape = &scene->leaves[node->leaf].shape;
    const bool is_known = shape->num_planes > 0 && shape->num_planes <= MAX_PLANES &&
                          !shape->has_quadric && csg_box_is_finite(&shape->bounds);
    return is_known ? shape : NULL;
}

static bool is_beyond(const struct csg_plane *plane, const struct csg_points *corners, double near)
{
    for (size_t i = 0; i < corners->points.num; i++)
        if (!(csg_dot(plane->normal, corners->points.data[i]) - plane->offset >= -near))
            return false;
    return corners->points.num > 0;
}

/* Whether all of b is beyond one of a's planes, but for what is nearer to it than near. */
static bool has_beyond(const struct csg_shape *a, const struct csg_shape *b, double near)
{
    struct csg_points corners = {{0}};
    bool found = false;
    if (csg_shape_corners(b, &corners) == CSG_HULL_DONE)
        for (size_t i = 0; i < a->num_planes && !found; i++)
            found = is_beyond(&a->planes[i], &corners, near);
    free(corners.points.data);
    return found;
}

bool csg_objects_are_apart(const struct csgcast_scene *scene, const struct csg_object *a,
                           const struct csg_object *b)
{
    const struct csg_shape *of_a = lone_shape(scene, a), *of_b = lone_shape(scene, b);
    const struct csg_box both = csg_box_union(&a->box, &b->box);
    const double near = ROUNDING * fmax(csg_vec3_largest(both.lo), csg_vec3_largest(both.hi));
    return of_a && of_b && (has_beyond(of_a, of_b, near) || has_beyond(of_b, of_a, near));
}
