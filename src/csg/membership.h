/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_MEMBERSHIP_H
#define CSG_CSG_MEMBERSHIP_H

#include "csg/object.h"

/* Whether a point of world space is in the object, by its leaves' own inequalities. Out of memory
 * counts as inside, which only makes drawing slower. */
bool csg_object_contains(const struct csgcast_scene *scene, const struct csg_object *object,
                         struct csg_vec3 point);

/* The same for a ball about the point, by samples: some ray from there may start inside. */
bool csg_object_is_near(const struct csgcast_scene *scene, const struct csg_object *object,
                        struct csg_vec3 point, double distance);

/*
 * Where rays from the eye start, as a distance along the view axis: surfaces nearer than that are
 * the eye's own. An eye exactly on a face then sees what its rays go through: the face's solid from
 * inside on one side, the outside on the other, whatever the rounding of its height over the face.
 */
double csg_eye_near(const struct csgcast_scene *scene, struct csg_vec3 eye);

/* Whether the eye is on a triangle of a surface, or hardly off it: what is around the eye then is
 * different for each ray. */
bool csg_eye_is_on_surface(const struct csgcast_scene *scene, struct csg_vec3 eye);

#endif
