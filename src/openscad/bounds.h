/* SPDX-License-Identifier: MIT */
#ifndef CSG_OPENSCAD_BOUNDS_H
#define CSG_OPENSCAD_BOUNDS_H

#include "common/file.h"
#include "common/process.h"

/* What a run of openscad may take. */
struct csg_process_bounds csg_openscad_bounds(const struct csgcast_scene_params *params);

/* Room for what csg_openscad_describe_end writes. */
enum { CSG_OPENSCAD_END_SIZE = 192 };

/* How a run has ended that was no success, behind the program's name: "was killed by signal 9", or
 * which of the bounds was met, with what raises it. */
void csg_openscad_describe_end(const struct csg_process *process,
                               const struct csg_process_bounds *bounds,
                               char text[CSG_OPENSCAD_END_SIZE]);

#endif
