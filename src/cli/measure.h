/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_MEASURE_H
#define CSG_CLI_MEASURE_H

/* Timing one scene. */

#include "options.h"

struct csg_spread {
    double median, min, max;
};

/* No pointers: it goes through a pipe. */
struct csg_measurement {
    int width, height;          /* pixels */
    int num_frames;             /* after the first image */
    size_t num_leaves;
    char renderer[256];
    double load_ms;             /* the scene file */
    double first_image_ms;      /* load, context, programs and the first frame */
    struct csg_spread frame_ms; /* later frames, with their edits */
    struct csg_spread work_ms;  /* of them: processor time, all cores together */
    struct csg_spread cpu_ms;   /* of them: preparing in double precision */
    struct csg_spread edit_ms;  /* of them: csgcast_scene_edit */
    double compile_ms;          /* all programs */
    size_t first_programs;      /* compiled for the first image */
    struct csgcast_stats stats; /* of the last frame */
    size_t peak_rss;            /* bytes, of the process that measured */
};

/* false after a message. */
bool csg_measure(const struct csg_cli_options *options, const char *input,
                 struct csg_measurement *result);

#endif
