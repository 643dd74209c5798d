/* SPDX-License-Identifier: MIT */
#ifndef CSG_FILES_SVG_H
#define CSG_FILES_SVG_H

/*
 * Drawings in SVG, read as OpenSCAD 2021.01 reads them (libsvg): path, rect, circle, ellipse, line,
 * polyline and polygon in svg and g, with their transforms; each becomes a polygon, an open one the
 * outline of its stroke. Fills, styles other than strokes', use, clip paths and texts do not count.
 */

#include "clip/module.h"
#include "common/file.h"
#include "plane/drawing.h"
#include "xml/module.h"

struct csg_svg_params {
    double dpi;  /* of lengths without a unit */
    bool center; /* the box of all corners about [0, 0]; else the page's lower left corner there */
    const struct csg_xml_module *xml;
    const struct csg_clip_module *clip;
};

enum csg_svg_result {
    CSG_SVG_DONE,
    CSG_SVG_MALFORMED, /* error tells what and where; nothing was added */
    CSG_SVG_ENTITY,    /* likewise: its text has one that it defines itself */
    CSG_SVG_FOREIGN,   /* numbers that are not read here; nothing was added */
    CSG_SVG_NO_MEMORY,
};

/* Adds a figure for each shape. Together they are the drawing, in mm, y upwards. */
enum csg_svg_result csg_svg_read(const struct csg_bytes *bytes, const struct csg_svg_params *params,
                                 struct csg_drawing *drawing, struct csg_xml_error *error);

#endif
