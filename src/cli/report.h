/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_REPORT_H
#define CSG_CLI_REPORT_H

/* What `csgcast report` measures, and how it is told. */

#include "common/array.h"
#include "common/log.h"
#include "options.h"
#include "report/errors.h"

#include <stdio.h>

/* The page, its pictures and its data are files of this name with something behind it. */
#define CSG_REPORT_NAME "error-against-time"

enum csg_series {
    CSG_SERIES_VARIANT,   /* csgcast, by the variant's name */
    CSG_SERIES_REFERENCE, /* csgcast's reference in C */
    CSG_SERIES_CGAL,      /* meshes, by $fn */
    CSG_SERIES_MANIFOLD,
};

struct csg_report_times {
    double median, min, max; /* ms */
    int num;                 /* 0: not measured */
};

/* One way to draw one scene. */
struct csg_report_item {
    const char *scene; /* the file's name without folder and extension; lives with the report */
    char name[48];     /* of the variant, or "CGAL $fn=8" */
    enum csg_series series;
    int fn; /* of a mesh */
    size_t num_triangles;
    double prepare_ms; /* loading the scene with openscad, or making the mesh */
    double first_ms;   /* context, programs, buffers and the first frame */
    struct csg_report_times frame;
    struct csg_picture_errors errors; /* depth as a share of the scene's radius */
    char note[96];                    /* why there are no figures; empty: there are */
};

/* One variant at one value of one sweep. */
struct csg_sweep_item {
    const char *sweep, *variant;
    double value;
    struct csg_picture_errors errors; /* depth relative to the distance */
};

struct csg_report {
    const struct csg_cli_options *options;
    const char *folder;
    char renderer[256], processor[128], openscad[64], date[32];
    double load[2]; /* processes that wanted a processor, at the beginning and at the end */
    long num_processors;
    bool has_wasm, has_gnuplot;
    int size[2];
    CSG_ARRAY(char *) scenes; /* names, owned */
    CSG_ARRAY(struct csg_report_item) items;
    CSG_ARRAY(struct csg_sweep_item) sweeps;
    size_t sweep_rays; /* of each item of the sweeps */
};

/* "report: ..." on standard error, unless quiet. */
void csg_report_progress(const struct csg_report *report, const char *format, ...) CSG_PRINTF(2, 3);

/* The variants that are measured, NULL behind the last: those of these names that there are. */
const char *csg_report_variant(size_t index);

/* false: nothing could be measured, with a message. */
bool csg_report_measure_scene(struct csg_report *report, const char *path);
bool csg_report_measure_sweeps(struct csg_report *report);

/* The sweeps' names, what their values are, and a sentence on what they show; NULL past the last.
 */
struct csg_sweep_text {
    const char *name, *parameter, *about;
};
const struct csg_sweep_text *csg_report_sweep(size_t index);

/* The files of the report's folder. */
void csg_report_print_page(const struct csg_report *report, FILE *file);
void csg_report_print_csv(const struct csg_report *report, FILE *file);
void csg_report_print_sweeps_csv(const struct csg_report *report, FILE *file);
void csg_report_print_json(const struct csg_report *report, FILE *file);

/* PNG pictures by gnuplot. false, with a message. */
bool csg_report_plot(const struct csg_report *report);

#endif
