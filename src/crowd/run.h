/* SPDX-License-Identifier: MIT */
#ifndef CSG_CROWD_RUN_H
#define CSG_CROWD_RUN_H

#include <stdint.h>

#include "common/array.h"

/* Translucent objects come one after the other, as OpenSCAD draws them; more than these together.
 */
#define CSG_MAX_OVERLAYS 64

/*
 * The members of one class that a frame draws. Vertex attributes of an instance, all floats: its
 * rectangle in clip space, three texels of its quadric if any, the texel of each plane with 0
 * (entry) or CSG_KEY_MAX (exit) in place of the face, and, an integer, the place of its normals in
 * the data texture.
 */
struct csg_crowd_run {
    bool ball; /* the terms are csg_screen_ball's */
    bool has_quadric;
    bool owned; /* one instance for all: struct csg_owned_instance */
    uint32_t num_planes;
    size_t first, stride; /* in floats */
    size_t num;           /* instances */
    size_t num_members;   /* that are drawn in no other run */
};

/* Of runs that may be drawn by the same programs. */
static inline uint32_t csg_crowd_run_bit(const struct csg_crowd_run *run)
{
    return UINT32_C(1) << (4 * run->num_planes + 2 * run->has_quadric + run->ball);
}

/*
 * Members of a class where they own pixels (crowd/owners.h): the picture of owners has their
 * numbers. In the data texture their terms follow each other in the order of these, and so do their
 * attribute blocks.
 */
struct csg_owned_instance {
    float rect[4];         /* around such pixels, in clip space */
    int32_t begin, end;    /* numbers */
    int32_t terms, blocks; /* places of the first one's */
    int32_t width;         /* of the picture */
};

struct csg_frame_crowd {
    CSG_ARRAY(float) instances;
    CSG_ARRAY(struct csg_crowd_run) runs;
    CSG_ARRAY(int32_t) owners; /* per pixel the number of its owner, or -1; empty: there are none */
    bool together; /* translucent members were left out as if all overlays are drawn together */
};

#endif
