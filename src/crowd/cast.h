/* SPDX-License-Identifier: MIT */
#ifndef CSG_CROWD_CAST_H
#define CSG_CROWD_CAST_H

/*
 * What shaders/passes/single.frag.glsl finds, by the CPU and from the same terms, between bounds:
 * each number is off by its rounding at most, there or here.
 */

#include "crowd/crowd.h"
#include "pack/screen.h"

/* Pixels of a row that are cast at once. */
#define CSG_CAST_LANES 8

struct csg_cast {
    const float *quadric; /* three texels; NULL: none */
    const float *planes;  /* one texel each */
    uint32_t num_planes;
    float noise;         /* of keys, whatever the member: the depth buffer's steps */
    float quadric_noise; /* of the middle of its crossings, and of the root */
    float conic_noise;
    float plane_noise[CSG_CROWD_MAX_PLANES];
};

/* Which of a member's crossings is meant. */
enum csg_cast_side { CSG_CAST_FRONT, CSG_CAST_REAR };

/* A range of offsets from the reference pixel. */
struct csg_cast_rect {
    float lo[2], hi[2];
};

/* From csg_member_terms, for pixels in rect. false: not of the kind that can be cast here, which is
 * what lies between its quadric's crossings. */
bool csg_cast_init(struct csg_cast *cast, bool has_quadric, uint32_t num_planes, const float *terms,
                   const struct csg_cast_rect *rect, float noise);

/* Bounds of where a ray enters and leaves: where it may miss, entry_hi is not less than exit_lo,
 * and where it certainly does, entry_lo is more than exit_hi. */
struct csg_spans {
    float entry_lo[CSG_CAST_LANES], entry_hi[CSG_CAST_LANES];
    float exit_lo[CSG_CAST_LANES], exit_hi[CSG_CAST_LANES];
};

/* Of CSG_CAST_LANES pixels of a row, at (dx + i, dy). */
void csg_cast_spans(const struct csg_cast *cast, float dx, float dy, struct csg_spans *spans);

/*
 * What follows is about num pixels of a row, at most CSG_CAST_LANES, at d = (dx + i, dy) for
 * i = 0 .. num - 1. keys[i] is what is known to hide what is behind it; CSG_CAST_LANES of them can
 * be read.
 */

/* Notes what the member's side certainly hides. Whether that is more than before. */
bool csg_cast_draw(const struct csg_cast *cast, enum csg_cast_side side, float dx, float dy,
                   int num, float *keys);

#define CSG_SEVERAL (UINT32_MAX - 1) /* in place of a member */

/* What a row of pixels knows of those that may show there, see crowd/owners.h. */
struct csg_contest {
    float *keys;   /* what hides what is behind it */
    float *least;  /* nothing of those that may show is nearer; infinite where nobody may */
    uint32_t *who; /* the only one, or CSG_SEVERAL */
};

/* Pixels, as bits. */
struct csg_contested {
    unsigned shows;       /* the member may show there, */
    unsigned with_others; /* ... and so may some of those before it */
};

/* As csg_cast_draw of the near side, and enters who where the member may show: in place of those
 * that it certainly hides, or else as one of several. */
struct csg_contested csg_cast_contend(const struct csg_cast *cast, float dx, float dy, int num,
                                      uint32_t who, const struct csg_contest *contest);

/* The pixels, as bits, at which that side may show. */
unsigned csg_cast_shows(const struct csg_cast *cast, enum csg_cast_side side, float dx, float dy,
                        int num, const float *keys);

/* Whether something with this key would show at any. */
bool csg_cast_any_behind(float key, int num, const float *keys);

/* Keys that grow by slope per pixel and are 0 at one offset. */
struct csg_tilt {
    float slope[2], at[2];
};

/* Nothing of that side, less tilt, is nearer in the rectangle; CSG_KEY_MAX: there is nothing. */
float csg_cast_near(const struct csg_cast *cast, enum csg_cast_side side,
                    const struct csg_cast_rect *rect, const struct csg_tilt *tilt);

#endif
