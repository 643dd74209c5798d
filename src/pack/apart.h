/* SPDX-License-Identifier: MIT */
#ifndef CSG_PACK_APART_H
#define CSG_PACK_APART_H

#include "csg/object.h"

/*
 * Whether both objects are one convex solid of few planes, and one of these planes has one of them
 * on either side, to rounding: what they have in a plane that they share does not overlap. false
 * where that is not known.
 */
bool csg_objects_are_apart(const struct csgcast_scene *scene, const struct csg_object *a,
                           const struct csg_object *b);

#endif
