/* SPDX-License-Identifier: MIT */
#ifndef CSG_PACK_SINGLES_H
#define CSG_PACK_SINGLES_H

/* The solids of a frame that are drawn by themselves, counted by kind: what is known of waste. */

#include "csg/scene.h"

struct csg_singles {
    bool is_wanted;
    bool *is_drawn; /* by leaf */
    size_t num[CSG_NUM_LEAF_KINDS];
    size_t proxy_pixels[CSG_NUM_LEAF_KINDS]; /* of their rectangles */
};

/* Counts anew; where it is not wanted csg_singles_note does nothing. false: out of memory. */
bool csg_singles_start(struct csg_singles *singles, const struct csgcast_scene *scene, bool wanted);
void csg_singles_finish(struct csg_singles *singles);

/* A leaf that is drawn by itself, in a rectangle of so many pixels. */
void csg_singles_note(struct csg_singles *singles, const struct csgcast_scene *scene, uint32_t leaf,
                      size_t num_pixels);

/* One more pixel of a leaf that was noted. */
void csg_singles_add_pixel(struct csg_singles *singles, const struct csgcast_scene *scene,
                           uint32_t leaf);

/* Fills single_kinds of stats; ids: num_pixels leaf numbers of the picture, -1 for none. */
void csg_singles_count(const struct csg_singles *singles, const struct csgcast_scene *scene,
                       const float *ids, size_t num_pixels, struct csgcast_stats *stats);

#endif
