/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLIP_MODULE_H
#define CSG_CLIP_MODULE_H

/*
 * The border between libcsgcast and csgcast-clip.so, which wraps Clipper (Johnson,
 * libpolyclipping), with which OpenSCAD 2021.01 makes the Booleans of drawings, on a grid of 2^-16.
 */

#ifdef __cplusplus
extern "C" {
#else
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#endif

enum csg_clip_op {
    CSG_CLIP_UNION,
    CSG_CLIP_DIFFERENCE,
    CSG_CLIP_INTERSECTION,
    CSG_CLIP_CLEAN, /* of one figure: what an odd number of contours go round becomes an outline */
};

/* A closed contour. Those of one figure together are what an odd number of them go round. */
struct csg_clip_path {
    const double *points; /* x, y, x, y... */
    size_t num;           /* of points */
    uint32_t operand;     /* 0, 1, ... in ascending order */
    uint32_t figure;      /* in ascending order */
    bool is_outline;      /* the figure's contours do not cross and have the inside to their left */
};

/* Takes the result, an outline in that sense. false ends it. */
struct csg_clip_sink {
    void *user;
    bool (*begin_contour)(void *user);
    bool (*add_point)(void *user, double x, double y);
};

enum csg_clip_join { CSG_CLIP_JOIN_MITER, CSG_CLIP_JOIN_ROUND, CSG_CLIP_JOIN_BEVEL };
enum csg_clip_cap { CSG_CLIP_CAP_SQUARE, CSG_CLIP_CAP_ROUND, CSG_CLIP_CAP_BUTT };

struct csg_clip_pen {
    double width;
    enum csg_clip_join join;
    enum csg_clip_cap cap;
};

/* How far an outline is moved, outwards or, negative, inwards. */
struct csg_clip_offset {
    double distance;
    enum csg_clip_join join; /* BEVEL: Clipper's square joins */
    double tolerance;        /* ROUND: how far a segment may be from the arc */
};

enum csg_clip_result {
    CSG_CLIP_DONE,
    CSG_CLIP_TOO_LARGE, /* coordinates beyond Clipper's grid: nothing was made */
    CSG_CLIP_NO_MEMORY, /* or ended by the sink */
};

struct csg_clip_module {
    /* Of num_operands operands, some of which may have no paths. */
    enum csg_clip_result (*combine)(enum csg_clip_op op, uint32_t num_operands,
                                    const struct csg_clip_path *paths, size_t num_paths,
                                    const struct csg_clip_sink *sink);
    /* The paths of all operands are one figure. */
    enum csg_clip_result (*offset)(const struct csg_clip_offset *offset,
                                   const struct csg_clip_path *paths, size_t num_paths,
                                   const struct csg_clip_sink *sink);
    /* The outline of a stroke along points, on a grid of 1/10,000, as OpenSCAD 2021.01 draws SVG's
     * open paths (shape.cc). No points, no outline. */
    enum csg_clip_result (*stroke)(const double *points, size_t num, const struct csg_clip_pen *pen,
                                   const struct csg_clip_sink *sink);
};

/* The module's one symbol, a const struct csg_clip_module, named with the version of this border.
 */
#define CSG_CLIP_MODULE csg_clip_module_3
#define CSG_CLIP_MODULE_NAME "csg_clip_module_3"

#ifdef __cplusplus
}
#endif

#endif
