/* SPDX-License-Identifier: MIT */
#ifndef CSG_REPORT_RASTER_H
#define CSG_REPORT_RASTER_H

/*
 * Draws a mesh with OpenGL as a viewer would: one vertex buffer, flat normals, a depth buffer; the
 * same outputs as csgcast's, read back in the same way. What a finished mesh costs a frame.
 */

#include "compare/soup.h"
#include "csgcast/csgcast.h"

struct csg_raster;

/* NULL, with a message, where there is no such context. */
struct csg_raster *csg_raster_create(enum csgcast_backend backend, const struct csg_log *log);
void csg_raster_destroy(struct csg_raster *raster);

/* A mesh in a vertex buffer of the raster. */
struct csg_raster_mesh {
    unsigned buffer, array;
    size_t num_triangles;
    struct csg_vec3 center;
    double radius;
};

bool csg_raster_upload(struct csg_raster *raster, const struct csg_soup *soup,
                       struct csg_raster_mesh *mesh);
void csg_raster_delete(struct csg_raster *raster, struct csg_raster_mesh *mesh);

/* Fills image's z and normal. The eye must be outside of the mesh's sphere. */
bool csg_raster_draw(struct csg_raster *raster, const struct csg_raster_mesh *mesh,
                     const struct csgcast_frustum *frustum, int width, int height,
                     const struct csgcast_image *image);

#endif
