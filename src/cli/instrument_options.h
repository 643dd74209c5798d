/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_INSTRUMENT_OPTIONS_H
#define CSG_CLI_INSTRUMENT_OPTIONS_H

/* The options of `csgcast compare` and `report`. */

#include "options.h"

extern const struct csg_compare_options csg_compare_defaults;

csg_option_set_fn csg_set_mesh, csg_set_side_by_side, csg_set_difference, csg_set_sagitta,
    csg_set_max_wrong, csg_set_min_iou, csg_set_max_depth, csg_set_max_depth_p99,
    csg_set_max_normal_p99, csg_set_limit, /* of both */
    csg_set_wasm;                          /* of report */

#endif
