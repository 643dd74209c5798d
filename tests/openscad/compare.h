/* SPDX-License-Identifier: MIT */
#ifndef TESTS_OPENSCAD_COMPARE_H
#define TESTS_OPENSCAD_COMPARE_H

/*
 * One view of a mesh against csgcast's picture of the same view.
 *
 * A pixel is an edge pixel where the mesh's picture is discontinuous within one pixel: hit beside
 * miss, or two depths that the two surfaces' planes do not bridge. Edge pixels may differ. So may a
 * pixel where csgcast shows what the mesh shows a fiftieth of a pixel aside: there an edge passes
 * so close to the pixel's centre that float and double need not agree ("thin").
 */

#include "camera.h"

#include <stdint.h>

struct reference {
    struct caster *caster;
    struct csgcast_frustum frustum;
    int width, height;
    struct hit *hits; /* width * height, row 0 on top */
    uint8_t *edges;   /* 1 at edge pixels, and up to the margin around them */
};

/* Traces the mesh at the pixels' centres. false, with a message, when memory is out. */
bool reference_init(struct reference *reference, struct caster *caster,
                    const struct csgcast_frustum *frustum, int width, int height);
void reference_finish(struct reference *reference);

/*
 * Marks the edge pixels. sagitta: how far the true surface may be from the mesh; what it spans on
 * the screen widens the edges.
 */
void reference_mark_edges(struct reference *reference, double sagitta);

/* Whether one surface, bent or not, may join the two hits. */
bool reference_joins(const struct hit *a, const struct ray *ray_a, const struct hit *b,
                     const struct ray *ray_b);

enum verdict {
    VERDICT_SAME,
    VERDICT_EDGE,  /* hit against miss, on an edge pixel */
    VERDICT_THIN,  /* explained by an edge within a fiftieth of a pixel */
    VERDICT_OFF,   /* hit against miss anywhere else */
    VERDICT_DEPTH, /* both hit, too far apart */
};

struct tolerance {
    double depth;    /* of z, relative */
    double absolute; /* of z, scene units; above 0 it replaces depth */
    double rounding; /* scene units along the normal: what six digits in a .csg do to a surface */
    double sagitta;  /* scene units along the normal; 0: as written */
};

struct comparison {
    size_t num_hits, num_edges;             /* of the reference */
    size_t num_edge_mismatches, num_thin;   /* allowed */
    size_t num_off, num_depth;              /* not allowed */
    size_t num_compared;                    /* hit by both, off the edges */
    double max_depth, p999_depth;           /* (z - z_ref) / z_ref */
    double max_normal, p999_normal;         /* degrees, to the next of the 3x3 pixels around */
    double max_error;                       /* |z - z_ref| off the edges, scene units */
    double max_offset, rms_offset;          /* |z - z_ref| * |n . dir|, scene units */
    uint8_t *verdicts;                      /* width * height of enum verdict; the caller frees */
};

/* image: csgcast's z and normal. false, with a message, when memory is out. */
bool compare(const struct reference *reference, const struct csgcast_image *image,
             const struct tolerance *tolerance, struct comparison *result);

#endif
