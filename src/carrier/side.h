/* SPDX-License-Identifier: MIT */
#ifndef CSG_CARRIER_SIDE_H
#define CSG_CARRIER_SIDE_H

/* How boxes lie to leaves and to their faces: conservative, in double. */

#include "carrier/carrier.h"

/* Whether the leaf is a box along the axes. */
bool csg_side_is_box(const struct csgcast_scene *scene, uint32_t leaf);

/* What is known of the leaf's set in the box: CSG_VARIES where that is not certain. */
uint8_t csg_side_of_leaf(const struct csgcast_scene *scene, uint32_t leaf, bool is_box,
                         const struct csg_box *box);

/* The same of a set that is all of a box. */
static inline uint8_t csg_side_of_box(const struct csg_box *of, const struct csg_box *box)
{
    if (of->hi.x < box->lo.x || box->hi.x < of->lo.x || of->hi.y < box->lo.y ||
        box->hi.y < of->lo.y || of->hi.z < box->lo.z || box->hi.z < of->lo.z)
        return CSG_NOTHING;
    const bool holds = of->lo.x < box->lo.x && box->hi.x < of->hi.x && of->lo.y < box->lo.y &&
                       box->hi.y < of->hi.y && of->lo.z < box->lo.z && box->hi.z < of->hi.z;
    return holds ? CSG_EVERYTHING : CSG_VARIES;
}

/* Whether a plane or the quadric of the leaf may pass through the box; else the box is inside. The
 * leaf itself meets it. */
bool csg_side_plane_varies(const struct csgcast_scene *scene, struct csg_face face,
                           const struct csg_box *box);
bool csg_side_quadric_varies(const struct csgcast_scene *scene, uint32_t leaf,
                             const struct csg_box *box);

#endif
