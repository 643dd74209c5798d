/* SPDX-License-Identifier: MIT */
#ifndef TESTS_OPENSCAD_CAMERA_H
#define TESTS_OPENSCAD_CAMERA_H

/*
 * OpenSCAD 2021.01's camera, written a second time from its sources and checked against its PNGs by
 * picture.sh: the referee does not take csgcast's word for where the rays go.
 */

#include "compare/mesh_view.h"

/* box: what viewall and autocenter look at. */
struct csgcast_frustum camera_frustum(const struct csgcast_view *view, const struct csg_box *box);

/* Reads OpenSCAD's --camera value, 6 or 7 numbers. */
bool camera_parse(const char *text, struct csgcast_camera *camera);

/* A view of the box from a random side, perspective for even numbers, orthographic for odd ones. */
struct csgcast_camera camera_random(unsigned number, const struct csg_box *box);

#endif
