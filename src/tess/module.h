/* SPDX-License-Identifier: MIT */
#ifndef CSG_TESS_MODULE_H
#define CSG_TESS_MODULE_H

/*
 * The border between libcsgcast and csgcast-tess.so, which wraps GLU: a library that only scenes
 * need whose faces are not plane.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct csg_tess_module {
    /*
     * Cuts the polygon, counter-clockwise, into triangles by GLU's sweep along x (Veach 1994), in
     * the order in which it keeps them; triangles has room for num. The result is their number,
     * less than num - 2 where corners lie at one place, 0 where the polygon crosses itself, a
     * coordinate is not finite, or there is no memory.
     */
    size_t (*sweep)(const float (*points)[2], uint32_t num, uint32_t (*triangles)[3]);
};

/* The module's one symbol, a const struct csg_tess_module, named with the version of this border.
 */
#define CSG_TESS_MODULE csg_tess_module_1
#define CSG_TESS_MODULE_NAME "csg_tess_module_1"

#endif
