/* SPDX-License-Identifier: MIT */
#ifndef CSG_OPENSCAD_VIEWPOINT_H
#define CSG_OPENSCAD_VIEWPOINT_H

/*
 * The camera that a .scad file asks for by assigning $vpt, $vpr, $vpd and $vpf (OpenSCAD 2021.01,
 * Camera::updateView). A .csg has no variables, so openscad is made to echo them.
 */

#include "openscad/openscad.h"

/* For -D: the echo. */
extern const char csg_viewpoint_define[];

/* Whether openscad says that the file asks for a camera. */
bool csg_viewpoint_is_asked(const struct csg_bytes *messages);

/*
 * Takes what the echoes printed, and the warning that goes with it, out of openscad's messages, to
 * flattened->cameras. source: the .scad's text, to tell what is assigned from what openscad has by
 * default; empty where no camera is asked for. false: out of memory.
 */
bool csg_viewpoint_take(struct csg_flattened *flattened, struct csg_bytes *messages,
                        const struct csg_bytes *source);

#endif
