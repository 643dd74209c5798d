/* SPDX-License-Identifier: MIT */
#ifndef CSG_CARRIER_KEY_H
#define CSG_CARRIER_KEY_H

/*
 * Keys that a face is looked up by: hashes of cells that it is in, so that different ones may share
 * one. Faces that coincide are in one cell or in neighbours. Planes have one by their normal to the
 * last bit and their offset, and some by the place of both in coarse cells: a face of a large leaf
 * can coincide only with planes that it nearly agrees with, a sliver's with many more, so that
 * there are cells of several widths.
 */

#include "carrier/directions.h"

/* How far faces that coincide may differ. */
struct csg_carrier_reach {
    double slack;     /* of quadrics, where they are measured */
    double tolerance; /* on the leaf */
};

/* How far planes that coincide with a face of a leaf may differ from it. */
struct csg_carrier_spread {
    double slack; /* where they are measured */
    double turn;  /* normals, or more: above 1/64 some are not found */
};

/* Each eight times as wide as the next, between the widest that is of use and the least turn that
 * numbers tell: the widths that planes may be looked for in. */
#define CSG_MAX_WIDTHS 12

/* Of that number is the width for faces that have this spread; 0 is the widest. */
int csg_carrier_width(const struct csg_carrier_spread *spread);

/* The sides of coarse cells, for planes that differ by that spread at most. */
struct csg_carrier_cells {
    struct csg_carrier_spread spread;
    double offset;         /* length; of offsets that differ by less than a quarter of it */
    double direction;      /* the same for normals, */
    double near_direction; /* ... but by less than this share of it */
};

static inline bool csg_carrier_has_spread(const struct csg_carrier_cells *cells,
                                          const struct csg_carrier_spread *spread)
{
    return spread->turn <= cells->spread.turn && spread->slack <= cells->spread.slack;
}

/* Where faces are measured, and the sides of the cells. */
struct csg_carrier_space {
    struct csg_vec3 center;    /* where offsets are measured */
    double radius;             /* of the finite part of the scene */
    struct csg_vec3 probes[3]; /* where quadrics are measured */
    double cell; /* of quadrics; those that coincide differ by less than a quarter of it */
    double fine; /* the same for parallel planes, which differ by as much everywhere */
    struct csg_carrier_cells widths[CSG_MAX_WIDTHS]; /* those in use, the widest first */
    int num_widths;
};

/* spreads: by width; of those not in use turn is 0. */
struct csg_carrier_space csg_carrier_space(struct csg_vec3 center, double radius,
                                           const struct csg_carrier_reach *reach,
                                           const struct csg_carrier_spread spreads[CSG_MAX_WIDTHS]);

/* The narrowest of the space's widths in which all are found that may coincide with a face of that
 * spread; where there is none, the widest. */
int csg_carrier_narrowest(const struct csg_carrier_space *space,
                          const struct csg_carrier_spread *spread);

/* Of its cell: among planes of one normal, whose number it is; by normal and offset, of a width; of
 * a quadric, with its place, more finely than its cell. */
uint64_t csg_parallel_key(const struct csg_carrier_space *space, const struct csg_plane *plane,
                          int64_t number);
uint64_t csg_normal_key(const struct csg_carrier_space *space, int width,
                        const struct csg_plane *plane);
uint64_t csg_quadric_key(const struct csg_carrier_space *space, const struct csg_quadric *quadric,
                         uint16_t place[3]);

/* Of the cells where those are that it may coincide with, its own first, and how many they are. */
int csg_parallel_keys(const struct csg_carrier_space *space, const struct csg_plane *plane,
                      uint64_t keys[8]);
int csg_normal_keys(const struct csg_carrier_space *space, int width, const struct csg_plane *plane,
                    uint64_t keys[8]);
int csg_quadric_keys(const struct csg_carrier_space *space, const struct csg_quadric *quadric,
                     uint64_t keys[8], uint16_t place[3]);

/* Whether quadrics at these places, in one cell or in neighbours, may coincide. */
bool csg_is_near_place(const uint16_t a[3], const uint16_t b[3]);

#endif
