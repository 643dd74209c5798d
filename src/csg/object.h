/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_OBJECT_H
#define CSG_CSG_OBJECT_H

/* Objects: the operands of the outermost union. Each is drawn by itself; the depth buffer unites.
 */

#include "csg/scene.h"

struct csg_object {
    uint8_t layer;       /* enum csg_layer */
    uint8_t paint;       /* the layer whose colours it takes: HIGHLIGHT where # is on all of it */
    bool hidden;         /* of the highlight layer, and drawn already as part of such an object */
    uint32_t begin, end; /* nodes of scene->trees[layer] */
    struct csg_box box;  /* of the Boolean result, conservative */
};

struct csg_objects {
    struct csg_object *data;
    size_t num, capacity;
};

/*
 * Splits the simplified trees. An object whose solids, but for subtracted ones, are all under # is
 * painted as a highlight and hides its copies in that layer, as OpenSCAD's preview has it, but
 * where that would be all objects.
 * false: out of memory.
 */
bool csg_objects_split(const struct csgcast_scene *scene, struct csg_objects *objects);

/* The object's first solid that is not subtracted: what its cuts were made in; NULL: none. */
const struct csg_leaf *csg_object_minuend(const struct csgcast_scene *scene,
                                          const struct csg_object *object);

/* Whether the object is one node, such as an extrusion, or in one render(): OpenSCAD's preview has
 * a mesh of it, not a product of solids. */
bool csg_object_is_one_node(const struct csgcast_scene *scene, const struct csg_object *object);

#endif
