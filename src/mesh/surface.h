/* SPDX-License-Identifier: MIT */
#ifndef CSG_MESH_SURFACE_H
#define CSG_MESH_SURFACE_H

/*
 * The boundary of a solid as triangles, of any number and shape. Inside is where the surface winds
 * around a point, however often and in whichever sense.
 *
 * Nothing here decides whether a ray meets a triangle by the triangle alone. A triangle covers a
 * point of the plane across the ray as often as its directed edges cross a half-line from there,
 * and an edge is asked in the same way by the two triangles that share it. So the sum over a closed
 * surface is zero whatever is rounded: there is no crack at an edge or a vertex, and a face with
 * many corners may be any fan of triangles, also one that folds over itself.
 */

#include <stddef.h>
#include <stdint.h>

#include "common/array.h"
#include "common/linear.h"

struct csg_plane;

struct csg_triangle {
    uint32_t points[3];
    uint32_t plane; /* of the face that it is part of */
};

/* A node of the hierarchy of boxes; in pre-order, the first child follows its parent. */
struct csg_box_node {
    struct csg_box box;
    uint32_t end;        /* one past the last node below */
    uint32_t first, num; /* a leaf's triangles; num is 0 elsewhere */
};

/* Where the triangles of a plane are: centre and radius. */
struct csg_surface_extent {
    struct csg_vec3 center;
    double radius;
};

/* A face lies on the plane of this one of the surface's faces, whose inside may be on the other
 * side. */
struct csg_own_face {
    uint32_t plane;
    bool flipped;
};

/*
 * All copies of a solid have one surface, in a space of its own; each says in its csg_shape.frame
 * where it is, here called place. Nothing is changed once it is made but what csg_surface_build,
 * csg_own_faces_find (carrier/own_faces.h) and csg_surface_closed fill in.
 */
struct csg_surface {
    uint32_t num_sharers; /* shapes beside the first that have it */
    double rounding;      /* of the points, as that of a csg_shape */
    CSG_ARRAY(struct csg_vec3) points;
    CSG_ARRAY(struct csg_triangle) triangles; /* in the order of the hierarchy once it is built */
    CSG_ARRAY(struct csg_plane) planes;       /* unit normals out of the solid */
    CSG_ARRAY(struct csg_box_node) nodes;     /* none until csg_surface_build */
    struct csg_own_face *own;                 /* by plane; NULL until csg_own_faces_find */
    struct csg_surface_extent *extents;       /* likewise */
    size_t num_own;                           /* planes that are their own */
    double size;    /* largest coordinate; infinite where a point or plane is not finite */
    bool is_simple; /* no two faces lie upon each other, not even in part */
    bool open;      /* some edge does not belong to two triangles in opposite directions */
    bool is_filled; /* of its gaps, what can be */
    struct csg_surface *closed; /* see csg_surface_closed; NULL until it is asked for */
};

/* One sharer fewer; the last one destroys it. */
void csg_surface_destroy(struct csg_surface *surface);

/* One sharer more. Returns surface. Not for several threads at a time: only the thread that makes
 * or edits a scene makes and destroys sharers of its surfaces. */
struct csg_surface *csg_surface_share(struct csg_surface *surface);

/* A new surface, or a sharer, that is where place takes this one. NULL: out of memory, or place is
 * singular. */
struct csg_surface *csg_surface_placed(struct csg_surface *surface, const struct csg_map *place);

/* A new one, without what can be built anew. NULL: out of memory. */
struct csg_surface *csg_surface_copy(const struct csg_surface *surface);

/* A sharer of the surface with its gaps filled, but for sheets and for pieces that are mostly gaps;
 * where it is subtracted these would take away all that is seen through them. NULL: out of memory.
 */
struct csg_surface *csg_surface_closed(struct csg_surface *surface);

/* Builds the hierarchy of boxes. false: out of memory. */
bool csg_surface_build(struct csg_surface *surface);

/* Fills in size, of a new surface. */
void csg_surface_measure(struct csg_surface *surface);

/* Whether all points and planes are, where place takes them. */
bool csg_surface_is_finite(struct csg_surface *surface, const struct csg_map *place);

struct csg_box csg_surface_box(const struct csg_surface *surface);

/* The corners of a triangle so that they run counter-clockwise seen from its front; is_mirrored: in
 * a place that mirrors. */
static inline void csg_triangle_corners(const struct csg_triangle *triangle, bool is_mirrored,
                                        uint32_t corners[3])
{
    corners[0] = triangle->points[0];
    corners[1] = triangle->points[is_mirrored ? 2 : 1];
    corners[2] = triangle->points[is_mirrored ? 1 : 2];
}

/* One for each plane; NULL: out of memory. */
struct csg_surface_extent *csg_surface_extents(const struct csg_surface *surface,
                                               const struct csg_map *place);

/* A triangle that a line meets. turns: 1 where the line leaves by its front, from which its corners
 * run counter-clockwise, -1 where it enters there. t is the place along the line of its nearest and
 * farthest corner, in lengths of dir. */
struct csg_meeting {
    uint32_t triangle;
    int turns;
    double tmin, tmax;
};

struct csg_meetings {
    struct csg_meeting *data;
    size_t num, capacity;
};

/* Appends what the line org + t dir meets. Needs the hierarchy. false: out of memory. */
bool csg_surface_meet(const struct csg_surface *surface, const struct csg_map *place,
                      struct csg_vec3 org, struct csg_vec3 dir, struct csg_meetings *meetings);

/* Times that the surface goes round p, 1 inside of a single one; out of memory counts as none. */
int csg_surface_winding(const struct csg_surface *surface, const struct csg_map *place,
                        struct csg_vec3 p);

/* Whether p is on a triangle, or nearer to its plane and its sides than distance. */
bool csg_surface_is_at(const struct csg_surface *surface, const struct csg_map *place,
                       struct csg_vec3 p, double distance);

#endif
