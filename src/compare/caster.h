/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMPARE_CASTER_H
#define CSG_COMPARE_CASTER_H

/*
 * Casts rays at a mesh. Embree's tree finds the triangles whose boxes a ray meets; hit, distance
 * and normal are then computed in double from the vertices as the file has them.
 */

#include "compare/soup.h"

struct csg_mesh_ray {
    struct csg_vec3 org, dir; /* dir needs no unit length; t counts in its multiples */
    double tnear;             /* hits before it do not count; may be -infinity */
};

struct csg_mesh_hit {
    bool found;
    double t;
    struct csg_vec3 normal; /* unit, out of the solid */
    double skin;            /* where two faces lie upon each other before it; infinite: nowhere */
};

/* Belongs to one thread at a time. */
struct csg_caster {
    struct csg_mesh_hit (*trace)(struct csg_caster *caster, const struct csg_mesh_ray *ray);
    void (*destroy)(struct csg_caster *caster);
    bool failed; /* memory ran out in some trace */
};

/* Copies what it needs of the soup. NULL, with a message, when Embree fails. */
struct csg_caster *csg_caster_create(const struct csg_soup *soup, const struct csg_log *log);

/* NULL is fine. */
static inline void csg_caster_destroy(struct csg_caster *caster)
{
    if (caster)
        caster->destroy(caster);
}

static inline struct csg_mesh_hit csg_caster_trace(struct csg_caster *caster,
                                                   const struct csg_mesh_ray *ray)
{
    return caster->trace(caster, ray);
}

#endif
