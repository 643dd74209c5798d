/* SPDX-License-Identifier: MIT */
#ifndef CSG_FILES_SVG_PATH_H
#define CSG_FILES_SVG_PATH_H

/* The paths that a shape of SVG becomes, in its own space. */

#include "files/svg.h"

/* Zero-initialise it, but for clip and pen. */
struct csg_svg_paths {
    CSG_ARRAY(struct csg_vec2) points;
    CSG_ARRAY(size_t) begins; /* of each path in points; the last one is open to more */
    const struct csg_clip_module *clip;
    struct csg_clip_pen pen;    /* of open paths */
    enum csg_svg_result result; /* the first that went wrong */
};

void csg_svg_paths_finish(struct csg_svg_paths *paths);

static inline void csg_svg_fail(struct csg_svg_paths *paths, enum csg_svg_result result)
{
    if (paths->result == CSG_SVG_DONE)
        paths->result = result;
}

/* One past the last point of that path. */
static inline size_t csg_svg_path_end(const struct csg_svg_paths *paths, size_t i)
{
    return i + 1 < paths->begins.num ? paths->begins.data[i + 1] : paths->points.num;
}

void csg_svg_begin_path(struct csg_svg_paths *paths);
void csg_svg_add_point(struct csg_svg_paths *paths, double x, double y);

/* Replaces the last path by the outlines of its stroke. */
void csg_svg_stroke_path(struct csg_svg_paths *paths);

/* Adds what is in the d of a path. */
void csg_svg_add_data(struct csg_svg_paths *paths, const char *d);

#endif
