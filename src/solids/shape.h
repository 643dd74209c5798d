/* SPDX-License-Identifier: MIT */
#ifndef CSG_SOLIDS_SHAPE_H
#define CSG_SOLIDS_SHAPE_H

/*
 * What every kind of solid becomes: the points that satisfy some plane inequalities and at most
 * one quadric inequality. A ray meets each of these surfaces ("carriers") in closed form, so the
 * renderer knows nothing else about a kind.
 */

#include <stddef.h>
#include <stdint.h>

#include "common/linear.h"

/* Inside: dot(normal, x) <= offset. normal has unit length and points out of the solid. */
struct csg_plane {
    struct csg_vec3 normal;
    double offset;
};

/* To the last bit. */
static inline bool csg_plane_is_same(const struct csg_plane *a, const struct csg_plane *b)
{
    return a->normal.x == b->normal.x && a->normal.y == b->normal.y && a->normal.z == b->normal.z &&
           a->offset == b->offset;
}

/*
 * Inside: f(p) <= 0 with p = to_canon(x) and the normal form (Sigg et al. 2006, eq. 1, with a
 * linear term for the paraboloids)
 *     f(p) = diag[0] p.x^2 + diag[1] p.y^2 + diag[2] p.z^2 + 2 linear p.z + diag[3].
 * diag entries are -1, 0 or 1. linear is 0 but for paraboloids and the parabolic cylinder, where it
 * is -0.5 or 0.5 and diag[2] = diag[3] = 0: p.x^2 + p.y^2 = p.z is diag {1, 1, 0, 0}, linear -0.5.
 */
struct csg_quadric {
    int8_t diag[4];
    float linear;
    struct csg_map to_canon;
};

struct csg_surface;

/* Either planes and a quadric, or a surface of triangles and neither. */
struct csg_shape {
    struct csg_surface *surface; /* NULL: bounded by planes and a quadric. Shared with copies, in
                                  * the space of `bounds`: see mesh/surface.h */
    struct csg_plane *planes;    /* owned, malloc'ed; NULL when there are none */
    uint32_t num_planes;
    bool has_quadric;
    bool facetted; /* OpenSCAD's facets instead of the true quadric */
    /* The set is convex: a line meets it in one interval. Always true without a quadric. With one,
     * f must have at most one negative eigenvalue (as a 4x4 form), and a solid on one sheet of a
     * double cone or two-sheeted hyperboloid says which: sheet = sign of canonical p.z there. */
    bool convex;
    int8_t sheet; /* -1, 0 (there is only one), 1 */
    struct csg_quadric quadric;
    struct csg_box bounds;  /* of the solid, in the space of `frame`; infinite if unbounded */
    struct csg_map frame;   /* from the space of `bounds` to the space of the shape */
    struct csg_box written; /* box of OpenSCAD's vertices in the same space (frames the camera);
                             * equal to bounds where OpenSCAD has no such solid */
    /* How far the surface may lie off because numbers in the file were rounded to six digits. */
    double rounding;
    /* How far OpenSCAD's facets may be off the surface; 0 where there are none of them. */
    double sagitta;
    /* Of a frustum that a turned profile is made of (csg/stack.h): its radii at bounds.lo.z and
     * bounds.hi.z, its axis being z and its planes those two. Others: 0, 0. */
    double radii[2];
};

void csg_shape_finish(struct csg_shape *shape);

/* Makes copy, whatever it was, a shape of its own. false: out of memory. */
bool csg_shape_copy(struct csg_shape *copy, const struct csg_shape *shape);

/*
 * Replaces shape by its image under map. false, with shape untouched, where map is singular.
 * Mirrored and sheared maps are fine.
 */
bool csg_shape_map(struct csg_shape *shape, const struct csg_map *map);

/* Replaces the plane by its image under the map that inverse undoes. */
void csg_plane_map(struct csg_plane *plane, const struct csg_map *inverse);

/* Whether its planes come in pairs that face opposite ways: no ray that starts outside can enter by
 * more than half of them. */
bool csg_shape_is_paired(const struct csg_shape *shape);

/* Appends the plane normal.x <= offset; normal need not be a unit vector. false: out of memory. */
bool csg_shape_add_plane(struct csg_shape *shape, struct csg_vec3 normal, double offset);

/* f at a point of the shape's space, and the gradient of f there (in the shape's space). */
double csg_quadric_value(const struct csg_quadric *quadric, struct csg_vec3 p);
struct csg_vec3 csg_quadric_gradient(const struct csg_quadric *quadric, struct csg_vec3 p);

/* Whether the quadric is a sphere to the noise of double arithmetic; then its center and radius. */
bool csg_quadric_ball(const struct csg_quadric *quadric, struct csg_vec3 *center, double *radius);

/* Point membership, closed: the rule that tests check crossings against. */
bool csg_shape_contains(const struct csg_shape *shape, struct csg_vec3 p);

#endif
