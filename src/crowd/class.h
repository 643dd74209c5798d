/* SPDX-License-Identifier: MIT */
#ifndef CSG_CROWD_CLASS_H
#define CSG_CROWD_CLASS_H

/* Which objects may be members of a crowd, and of which class. */

#include "crowd/crowd.h"
#include "csg/object.h"

/* The key of what cannot be a member; those of classes are below CSG_CROWD_MAX_CLASSES. */
enum { CSG_CROWD_NO_CLASS = 0xff };

/* The only solid of an object; NULL where there are several, or it is a complement. */
const struct csg_node *csg_crowd_only_node(const struct csgcast_scene *scene,
                                           const struct csg_object *object);

/* The key of the class that a scene's object belongs to. *need: what csg_precision_need says of a
 * member. */
uint8_t csg_crowd_key(const struct csgcast_scene *scene, const struct csg_object *object,
                      float *need);

/* A class as its key says, without members. */
struct csg_crowd_class csg_crowd_class_of(uint32_t key);

/* csg_outline_of a leaf, with the quadric that it is drawn with. */
enum csg_outline csg_crowd_measure(const struct csgcast_scene *scene, uint32_t leaf,
                                   struct csg_outline_ball *ball, double numbers[CSG_OUTLINE_MAX]);

#endif
