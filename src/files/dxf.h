/* SPDX-License-Identifier: MIT */
#ifndef CSG_FILES_DXF_H
#define CSG_FILES_DXF_H

/*
 * Drawings in DXF, read as OpenSCAD 2021.01 reads them (dxfdata.cc): LINE, LWPOLYLINE (straight),
 * CIRCLE, ARC, ELLIPSE and INSERT become lines on a grid of 2^-10, which are joined to contours.
 */

#include "common/file.h"
#include "plane/drawing.h"
#include "solids/facets.h"

struct csg_dxf_params {
    struct csg_facets facets; /* of circles, arcs and ellipses */
    const char *layer;        /* the only one that counts; empty: all */
    double origin[2];         /* in the file, becomes [0, 0] */
    double scale;             /* above 0 */
};

/* Takes what is wrong with the file, which is left out; line counts from 1. */
struct csg_dxf_warnings {
    void *user;
    void (*add)(void *user, size_t line, const char *text);
};

enum csg_dxf_result {
    CSG_DXF_DONE,
    CSG_DXF_TOO_LARGE, /* more than CSG_DXF_MAX_LINES lines */
    CSG_DXF_NO_MEMORY,
};

/* Blocks that insert each other can stand for any number of lines. */
#define CSG_DXF_MAX_LINES 5000000

/* Adds the contours to the drawing's last figure. */
enum csg_dxf_result csg_dxf_read(const struct csg_bytes *bytes, const struct csg_dxf_params *params,
                                 const struct csg_dxf_warnings *warnings,
                                 struct csg_drawing *drawing);

#endif
