/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_COMPARE_H
#define CSG_CLI_COMPARE_H

/* What `csgcast compare` finds out, and how it is told. */

#include "compare/compare.h"
#include "options.h"

#include <stdio.h>

#define CSG_COMPARE_MAX_VIEWS 4

struct csg_compared_view {
    const char *label;
    struct csg_mesh_view mesh;    /* the mesh's hits */
    float *z, *normal, *id;       /* csgcast's, with the facets asked for */
    struct csg_comparison result; /* of these */
    size_t num_wrong;             /* pixels that neither edges nor facets explain */
    uint8_t *wrong;               /* 1 at these, width * height */
    double facets;                /* largest distance of OpenSCAD's facets from the exact surface */
};

/* All views together. */
struct csg_compared_total {
    double iou;
    size_t num_hits, num_missing, num_extra, num_wrong, num_compared;
    double wrong;  /* share of the mesh's pixels */
    double facets; /* as in a view */
    /* Means of all pixels; quantiles and maxima of the worst view. */
    struct csg_errors depth, relative, offset, normal;
};

struct csg_compared {
    const struct csg_cli_options *options;
    const char *mesh_name; /* the file, or the program that made it */
    size_t num_triangles;
    double mesh_seconds; /* 0: given */
    double radius;       /* of the mesh, scene units */
    double sagitta;      /* the bound: how far OpenSCAD's facets may be from what is drawn */
    bool by_facets;      /* wrong is judged with OpenSCAD's facets, else by --sagitta */
    int num_views;
    struct csg_compared_view views[CSG_COMPARE_MAX_VIEWS];
    struct csg_compared_total total;
};

/* Fills total from the views. */
void csg_compared_sum_up(struct csg_compared *compared);

/* The point of the mesh that pixel (x, y) of the view shows. */
struct csg_vec3 csg_compared_position(const struct csg_compared_view *view, int x, int y);

/* One threshold and what it is held against. */
struct csg_threshold {
    const char *option, *unit;
    double limit, value; /* limit infinite or, for a minimum, 0: not judged */
    bool is_minimum;
};

#define CSG_NUM_THRESHOLDS 5
void csg_compare_thresholds(const struct csg_compared *compared,
                            struct csg_threshold thresholds[CSG_NUM_THRESHOLDS]);
bool csg_threshold_is_judged(const struct csg_threshold *threshold);
bool csg_threshold_holds(const struct csg_threshold *threshold);

void csg_compare_print(const struct csg_compared *compared);
void csg_compare_print_json(const struct csg_compared *compared);

/* Which pictures a sheet has beside each other, a row a view. */
enum csg_sheet {
    CSG_SHEET_SIDE_BY_SIDE = 1, /* csgcast, mesh */
    CSG_SHEET_DIFFERENCE = 2,
};

/* false, with a message. */
bool csg_compare_write_sheet(const struct csg_compared *compared, unsigned sheet, const char *path);

#endif
