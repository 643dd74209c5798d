/* SPDX-License-Identifier: MIT */
#ifndef TESTS_OPENSCAD_CASTER_H
#define TESTS_OPENSCAD_CASTER_H

/*
 * Casts rays at a mesh. Embree's tree finds the triangles whose boxes a ray meets; hit, distance
 * and normal are then computed in double from the vertices as OpenSCAD wrote them.
 */

#include "mesh.h"

struct ray {
    struct csg_vec3 org, dir; /* dir needs no unit length; t counts in its multiples */
    double tnear;             /* hits before it do not count; may be -infinity */
};

struct hit {
    bool found;
    double t;
    struct csg_vec3 normal; /* unit, out of the solid */
};

struct caster;

/* Copies what it needs of the mesh. NULL, with a message, when Embree fails. */
struct caster *caster_create(const struct mesh *mesh);
void caster_destroy(struct caster *caster);

struct hit caster_trace(struct caster *caster, const struct ray *ray);

#endif
