/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_INSTRUMENT_OPTIONS_H
#define CSG_CLI_INSTRUMENT_OPTIONS_H

/* The options of `csgcast compare` and `report`; each function is the set of a struct csg_option.
 */

#include "options.h"

extern const struct csg_compare_options csg_compare_defaults;

const char *csg_set_mesh(struct csg_cli_options *options, const char *value);
const char *csg_set_side_by_side(struct csg_cli_options *options, const char *value);
const char *csg_set_difference(struct csg_cli_options *options, const char *value);
const char *csg_set_sagitta(struct csg_cli_options *options, const char *value);
const char *csg_set_max_wrong(struct csg_cli_options *options, const char *value);
const char *csg_set_min_iou(struct csg_cli_options *options, const char *value);
const char *csg_set_max_depth(struct csg_cli_options *options, const char *value);
const char *csg_set_max_depth_p99(struct csg_cli_options *options, const char *value);
const char *csg_set_max_normal_p99(struct csg_cli_options *options, const char *value);

/* Of both. */
const char *csg_set_limit(struct csg_cli_options *options, const char *value);
/* Of `csgcast report`. */
const char *csg_set_wasm(struct csg_cli_options *options, const char *value);

#endif
