/* SPDX-License-Identifier: MIT */
#ifndef CSG_PACK_SURFACE_H
#define CSG_PACK_SURFACE_H

/*
 * A surface of triangles as the screen sees it. In pixels and keys all rays are parallel, so what a
 * ray meets is a question of the plane: the triangles whose edges go round its pixel's centre. The
 * hierarchy's boxes become rectangles with ranges of keys, a tile takes from it the triangles that
 * it may meet and writes them as lists by cell of some pixels, edges as the shader asks them
 * (shaders/solids/surface.glsl).
 */

#include "mesh/surface.h"
#include "pack/screen.h"

/* A corner: place in pixels, counted from the frame's reference pixel, and key. Behind the eye the
 * key is nan. By axis, with a margin: the first pixel whose centre is not before the corner, and
 * the last one whose centre is not beyond it. */
struct csg_view_point {
    double x, y, key;
    int32_t first[2], last[2];
};

/* What a node of the hierarchy covers; empty where lo > hi. */
struct csg_view_node {
    double lo[2], hi[2], near, far;
};
extern const struct csg_view_node csg_view_nowhere;
void csg_view_node_extend(struct csg_view_node *node, const struct csg_view_node *by);

/* Pixel coordinates times w, and the distance along the view axis: w, but where rays are parallel.
 */
struct csg_view_place {
    double x, y, t;
};

/* One of these as a function of a point of the surface: step . (point - middle) + start. */
struct csg_view_row {
    struct csg_vec3 step;
    double start;
};

struct csg_surface_view {
    const struct csg_surface *surface;
    uint32_t leaf;
    bool spare;                    /* the leaf counts as nothing */
    double rounding;               /* of the leaf */
    struct csg_map place, inverse; /* of the surface */
    bool is_mirrored;              /* by that place */
    /* What follows is there once it is projected. */
    struct csg_vec3 middle; /* of the surface */
    struct csg_view_row x, y, t;
    bool flat;                     /* rays are parallel */
    struct csg_view_point *points; /* those of nodes that hold pixels */
    struct csg_view_node *nodes;   /* those below no empty one */
    double tnear;                  /* distance along the view axis where triangles are cut off */
    double slack;                  /* of keys: how far carriers may lie off their faces */
    int turns;                     /* of the surface around the eye */
};

void csg_surface_view_init(struct csg_surface_view *view, const struct csg_shape *shape,
                           uint32_t leaf, bool spare);

struct csg_surface_views {
    struct csg_surface_view *data;
    size_t num, capacity;
};
void csg_surface_views_clear(struct csg_surface_views *views);

/* On all cores; before anything below is asked of them. false: out of memory. */
bool csg_surface_views_project(const struct csg_surface_views *views,
                               const struct csg_screen *screen, struct csg_pixel at,
                               int num_threads);

/* Pixel centres of a rectangle, counted from the reference pixel. */
struct csg_view_rect {
    double lo[2], hi[2];
};

/* The keys between which rays of the rectangle meet the surface; false: they miss it. */
bool csg_surface_view_range(const struct csg_surface_view *view, const struct csg_view_rect *rect,
                            double keys[2]);

/* Appends the triangles that a ray of the rectangle may meet. false: out of memory. */
struct csg_view_list {
    uint32_t *data;
    size_t num, capacity;
};
bool csg_surface_view_list(const struct csg_surface_view *view, const struct csg_view_rect *rect,
                           struct csg_view_list *list);

struct csg_view_place csg_view_place_of(const struct csg_surface_view *view, struct csg_vec3 p);

/* What a triangle covers; false: no pixel's centre. */
bool csg_view_triangle(const struct csg_surface_view *view, uint32_t triangle,
                       struct csg_view_node *node);

/* A triangle, cut at tnear, as a polygon of pixels that runs as its corners do; 0 to 4 corners.
 * Corners that two triangles share come out equal to the last bit. */
int csg_surface_view_polygon(const struct csg_surface_view *view, uint32_t triangle,
                             double polygon[4][2]);

#endif
