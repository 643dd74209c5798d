/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_CARRIER_KEY_H
#define CSG_CSG_CARRIER_KEY_H

/*
 * Keys that a face is looked up by: hashes of cells that it is in, so that different ones may share
 * one. Faces that coincide are in one cell or in neighbours. Planes have two: by their normal to
 * the last bit and their offset, and by the place of both in coarse cells.
 */

#include "csg/directions.h"

/* How far faces that coincide may differ. */
struct csg_carrier_reach {
    double slack;     /* where they are measured */
    double tolerance; /* on the leaf */
    double turn;      /* normals, or more: above 1/64 some are not found */
};

/* Where faces are measured, and the sides of the cells. */
struct csg_carrier_space {
    struct csg_vec3 center;    /* where offsets are measured */
    double radius;             /* of the finite part of the scene */
    struct csg_vec3 probes[3]; /* where quadrics are measured */
    double cell; /* length; coincident faces differ by less than a quarter of it, where measured */
    double fine; /* the same for parallel planes, which differ by as much everywhere */
    double direction;      /* the same for normals, */
    double near_direction; /* ... but by less than this share of it */
};

struct csg_carrier_space csg_carrier_space(struct csg_vec3 center, double radius,
                                           const struct csg_carrier_reach *reach);

/* Of its cell: among planes of one normal, whose number it is; by normal and offset; of a quadric,
 * with its place, more finely than its cell. */
uint64_t csg_parallel_key(const struct csg_carrier_space *space, const struct csg_plane *plane,
                          int64_t number);
uint64_t csg_normal_key(const struct csg_carrier_space *space, const struct csg_plane *plane);
uint64_t csg_quadric_key(const struct csg_carrier_space *space, const struct csg_quadric *quadric,
                         uint16_t place[3]);

/* Of the cells where those are that it may coincide with, and how many they are. */
int csg_parallel_keys(const struct csg_carrier_space *space, const struct csg_plane *plane,
                      uint64_t keys[8]);
int csg_normal_keys(const struct csg_carrier_space *space, const struct csg_plane *plane,
                    uint64_t keys[8]);
int csg_quadric_keys(const struct csg_carrier_space *space, const struct csg_quadric *quadric,
                     uint64_t keys[8], uint16_t place[3]);

/* Whether quadrics at these places, in one cell or in neighbours, may coincide. */
bool csg_is_near_place(const uint16_t a[3], const uint16_t b[3]);

#endif
