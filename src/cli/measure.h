/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_MEASURE_H
#define CSG_CLI_MEASURE_H

/* Timing one scene. */

#include "options.h"

struct csg_spread {
    double median, min, max;
};

/* ms of one frame, or the medians of several. */
struct csg_frame_times {
    double frame;                               /* with its edit */
    double work;                                /* of it: processor time, all cores together */
    double edit;                                /* of it: csgcast_scene_edit */
    double cpu;                                 /* of it: preparing in double precision */
    double csg, tile, pack, upload, draw, read; /* stages, as in csgcast_stats */
};

/* No pointers: it goes through a pipe. */
struct csg_measurement {
    int width, height; /* pixels */
    int num_frames;    /* after the first image */
    size_t num_leaves;
    char renderer[256];
    double load_ms;                 /* the scene file */
    double first_image_ms;          /* load, context, programs and the first frame */
    struct csg_frame_times first;   /* of that frame: the stages */
    size_t first_programs;          /* compiled for it */
    struct csg_spread frame_ms;     /* later frames, with their edits */
    struct csg_frame_times medians; /* of them */
    double compile_ms;              /* all programs */
    struct csgcast_stats stats;     /* of the last frame */
    size_t peak_rss;                /* bytes, of the process that measured */
};

/* false after a message. */
bool csg_measure(const struct csg_cli_options *options, const char *input,
                 struct csg_measurement *result);

#endif
