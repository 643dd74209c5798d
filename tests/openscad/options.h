/* SPDX-License-Identifier: MIT */
#ifndef TESTS_OPENSCAD_OPTIONS_H
#define TESTS_OPENSCAD_OPTIONS_H

#include "csgcast/csgcast.h"

/* The referee's command line; referee.c has its usage. */
struct options {
    const char *name;  /* of the case, in messages and file names */
    const char *scene; /* .csg or .scad */
    char **meshes;     /* num_meshes ASCII STL files; more than one for --converge only */
    int num_meshes;
    enum csgcast_facets facets;
    enum csgcast_backend backend;
    struct csgcast_view view; /* its camera is used when has_camera */
    bool has_camera;
    unsigned views, seed; /* random views: seed, seed + 1, ... */
    bool converge, render;
    double sagitta;         /* scene units; for --converge that of the first mesh */
    double depth;           /* relative error of z that is allowed */
    double depth_of_radius; /* above 0: the allowed error is this part of the scene's radius */
    double normal;          /* degrees, of 99.9 % of the pixels; as-written only */
    double edge;            /* part of the edge pixels that may mismatch */
    double thin;            /* part of all hits that may be thin */
    unsigned long off;      /* mismatches off the edges that are allowed */
};

/* false, with a message, for a malformed command line. */
bool options_parse(int argc, char **argv, struct options *options);

#endif
