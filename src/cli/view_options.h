/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_VIEW_OPTIONS_H
#define CSG_CLI_VIEW_OPTIONS_H

/* How a scene is looked at and by what it is drawn. */

#include "options.h"

#define CSG_MAX_IMAGE_SIZE 16384 /* pixels; csgcast_view's limit */

csg_option_set_fn csg_set_imgsize, csg_set_antialias, csg_set_camera, csg_set_projection,
    csg_set_fov, csg_set_colorscheme, csg_set_cut_color, csg_set_backend, csg_set_threads,
    csg_set_variant;

#endif
