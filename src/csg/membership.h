/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_MEMBERSHIP_H
#define CSG_CSG_MEMBERSHIP_H

#include "csg/object.h"

/* Whether a point of world space is in the object, by its leaves' own inequalities. Out of memory
 * counts as inside, which only makes drawing slower. */
bool csg_object_contains(const struct csgcast_scene *scene, const struct csg_object *object,
                         struct csg_vec3 point);

#endif
