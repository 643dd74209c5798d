/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMPARE_MESH_VIEW_H
#define CSG_COMPARE_MESH_VIEW_H

/*
 * What a mesh shows in one view, ray by ray, in double.
 *
 * A pixel is an edge pixel where that is discontinuous within one pixel: hit beside miss, or two
 * depths that the two surfaces' planes do not bridge.
 */

#include "compare/caster.h"
#include "csgcast/csgcast.h"

#include <stdint.h>

struct csg_mesh_view {
    struct csg_caster *caster;
    struct csgcast_frustum frustum;
    int width, height;
    struct csg_mesh_hit *hits; /* width * height, row 0 on top; t is distance along the view axis */
    uint8_t *edges;            /* 1 at edge pixels, and up to the margin around them */
};

/* The ray through the point (x, y) of the picture, pixels from the left and top; t is depth. */
struct csg_mesh_ray csg_frustum_ray(const struct csgcast_frustum *frustum, int width, int height,
                                    double x, double y);

/* Traces the mesh at the pixels' centres. view: finished by the caller. false: out of memory. */
bool csg_mesh_view_init(struct csg_mesh_view *view, struct csg_caster *caster,
                        const struct csgcast_frustum *frustum, int width, int height);
void csg_mesh_view_finish(struct csg_mesh_view *view);

/*
 * Marks the edge pixels. sagitta: how far the true surface may be from the mesh; what it spans on
 * the screen widens the edges. false: out of memory.
 */
bool csg_mesh_view_mark_edges(struct csg_mesh_view *view, double sagitta);

/* Whether one surface, bent or not, may join the two hits. */
bool csg_mesh_view_joins(const struct csg_mesh_hit *a, const struct csg_mesh_ray *ray_a,
                         const struct csg_mesh_hit *b, const struct csg_mesh_ray *ray_b);

#endif
