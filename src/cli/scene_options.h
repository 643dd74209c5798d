/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_SCENE_OPTIONS_H
#define CSG_CLI_SCENE_OPTIONS_H

/* How a scene is read; each function is the set of a struct csg_option. */

#include "options.h"

const char *csg_set_define(struct csg_cli_options *options, const char *value);
const char *csg_set_render(struct csg_cli_options *options, const char *value);
const char *csg_set_font(struct csg_cli_options *options, const char *value);
const char *csg_set_parameter_file(struct csg_cli_options *options, const char *value);
const char *csg_set_parameter_set(struct csg_cli_options *options, const char *value);
const char *csg_set_animate(struct csg_cli_options *options, const char *value);
const char *csg_set_facets(struct csg_cli_options *options, const char *value);
const char *csg_set_openscad(struct csg_cli_options *options, const char *value);
const char *csg_set_cache(struct csg_cli_options *options, const char *value);
const char *csg_set_no_cache(struct csg_cli_options *options, const char *value);
const char *csg_set_cache_size(struct csg_cli_options *options, const char *value);

/* Says which of the given options change nothing: those for .scad files where there is none, and
 * half a pair of -p and -P. */
void csg_warn_unheeded(const struct csg_cli_options *options);

#endif
