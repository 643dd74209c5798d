/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_SCENE_OPTIONS_H
#define CSG_CLI_SCENE_OPTIONS_H

/* How a scene is read. */

#include "options.h"

csg_option_set_fn csg_set_define, csg_set_render, csg_set_font, csg_set_parameter_file,
    csg_set_parameter_set, csg_set_animate, csg_set_facets, csg_set_openscad, csg_set_cache,
    csg_set_no_cache, csg_set_cache_size, csg_set_openscad_memory, csg_set_openscad_time;

/* Says which of the given options change nothing: those for .scad files where there is none, and
 * half a pair of -p and -P. */
void csg_warn_unheeded(const struct csg_cli_options *options);

#endif
