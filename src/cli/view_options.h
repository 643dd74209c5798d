/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_VIEW_OPTIONS_H
#define CSG_CLI_VIEW_OPTIONS_H

/* How a scene is looked at and by what it is drawn; each function is the set of a struct
 * csg_option. */

#include "options.h"

const char *csg_set_imgsize(struct csg_cli_options *options, const char *value);
const char *csg_set_camera(struct csg_cli_options *options, const char *value);
const char *csg_set_projection(struct csg_cli_options *options, const char *value);
const char *csg_set_fov(struct csg_cli_options *options, const char *value);
const char *csg_set_colorscheme(struct csg_cli_options *options, const char *value);
const char *csg_set_cut_color(struct csg_cli_options *options, const char *value);
const char *csg_set_backend(struct csg_cli_options *options, const char *value);
const char *csg_set_threads(struct csg_cli_options *options, const char *value);
const char *csg_set_variant(struct csg_cli_options *options, const char *value);

#endif
