/* SPDX-License-Identifier: MIT */
#ifndef CSG_PLANE_DRAWING_H
#define CSG_PLANE_DRAWING_H

/*
 * A drawing: what lies below a linear_extrude or rotate_extrude. A Boolean tree over figures, kept
 * as it was written: discs stay discs. Nodes lie in pre-order, like those of a csg_tree.
 */

#include <stdint.h>

#include "common/array.h"
#include "common/linear.h"

struct csg_vec2 {
    double x, y;
};

enum csg_draw_op {
    CSG_DRAW_UNION,
    CSG_DRAW_DIFFERENCE, /* the first child without the others */
    CSG_DRAW_INTERSECTION,
    CSG_DRAW_FIGURE,
};

struct csg_draw_node {
    uint8_t op;      /* enum csg_draw_op */
    uint32_t figure; /* FIGURE: its index */
    uint32_t end;    /* one past the last node of this subtree */
};

struct csg_contour {
    uint32_t begin, end; /* of its points; closed, in either direction */
};

/* The points that an odd number of its contours go round, or by_winding those that they go round
 * more often counterclockwise than clockwise. */
struct csg_figure {
    uint32_t begin, end; /* of its contours */
    bool is_disc;        /* meant is the ellipse disc; the contour has OpenSCAD's facets */
    bool is_join;        /* a disc over facets of another figure, which stand for it */
    bool facetted;       /* the contour stands for an ellipse */
    bool by_winding;     /* no disc */
    bool is_outline;     /* its contours do not cross and have the inside to their left */
    struct csg_map disc; /* from the unit circle about the z axis; z stays */
    double rounding;     /* see struct csg_shape */
};

/* Zero-initialise it. */
struct csg_drawing {
    CSG_ARRAY(struct csg_draw_node) nodes;
    CSG_ARRAY(struct csg_figure) figures;
    CSG_ARRAY(struct csg_contour) contours;
    CSG_ARRAY(struct csg_vec2) points;
};

void csg_drawing_finish(struct csg_drawing *drawing);

/* Appends a node that is no figure; its end is set by csg_drawing_close. false: out of memory. */
bool csg_drawing_open(struct csg_drawing *drawing, enum csg_draw_op op);
static inline void csg_drawing_close(struct csg_drawing *drawing, uint32_t node)
{
    drawing->nodes.data[node].end = (uint32_t)drawing->nodes.num;
}

/* Appends a figure without contours, and its node. The functions below fill the last figure. */
bool csg_drawing_add_figure(struct csg_drawing *drawing, double rounding);
bool csg_drawing_add_contour(struct csg_drawing *drawing);
bool csg_drawing_add_point(struct csg_drawing *drawing, double x, double y);

/* Appends a figure, but for its contours, which are those of the first figure of another drawing:
 * an outline. false: out of memory. */
bool csg_drawing_append_figure(struct csg_drawing *drawing, const struct csg_drawing *from,
                               const struct csg_figure *figure);

/* Takes the nodes from that one on away again. Their figures stay, unused. */
static inline void csg_drawing_cut(struct csg_drawing *drawing, uint32_t node)
{
    drawing->nodes.num = node;
}

/* Takes the last subtree, at node, away with its figures: those from its first one on. */
void csg_drawing_drop(struct csg_drawing *drawing, uint32_t node);

/* The node that all of the subtree at node is: the only child of only children. */
uint32_t csg_drawing_only(const struct csg_drawing *drawing, uint32_t node);

/* The largest rounding of the figures in nodes [begin, end). */
double csg_drawing_rounding(const struct csg_drawing *drawing, uint32_t begin, uint32_t end);

/* Whether some figure in nodes [begin, end) stands for circles. */
bool csg_drawing_is_facetted(const struct csg_drawing *drawing, uint32_t begin, uint32_t end);

/* Whether the figure is a circle's disc; radius gets its. */
bool csg_figure_is_round(const struct csg_figure *figure, double *radius);

/* Maps the figures in nodes [begin, end), each once; the map leaves z alone. rounding grows by
 * stretch. false: out of memory. */
bool csg_drawing_map(struct csg_drawing *drawing, uint32_t begin, uint32_t end,
                     const struct csg_map *map, double stretch);

/* Twice the area of a contour: positive where it runs counterclockwise. */
double csg_contour_twice_area(const struct csg_drawing *drawing, const struct csg_contour *contour);

/* Bounds a figure; z is 0. */
struct csg_box csg_figure_written(const struct csg_drawing *drawing,
                                  const struct csg_figure *figure);

#endif
