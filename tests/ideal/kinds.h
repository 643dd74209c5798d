/* SPDX-License-Identifier: MIT */
#ifndef IDEAL_KINDS_H
#define IDEAL_KINDS_H

/* Every kind of solid as one with a flat face in z = 0: as text, and as it is by construction. */

#include "ideal.h"
#include "text.h"

enum kind {
    KIND_CUBE,
    KIND_SPHERE,
    KIND_CYLINDER,
    KIND_FRUSTUM,
    KIND_CONE,
    KIND_ELLIPSOID,
    KIND_TETRAHEDRON,
    KIND_HALFSPACE,
    KIND_HYPERBOLOID,
    KIND_SHEETS,
    KIND_PARABOLOID,
    KIND_SADDLE,
    KIND_QUADRIC,
    KIND_POLYGON,
    NUM_KINDS
};

extern const char *const kind_names[NUM_KINDS];

/* A row-major affine map, as multmatrix has it. */
struct map {
    double m[3][4];
};

struct flat {
    enum kind kind;
    double size, height; /* half the width, and the depth below z = 0 */
    double x, y, z;      /* moved by this */
    bool up;             /* mirrored: above z = 0 */
    bool alias;          /* written as half-spaces and quadrics, not as its kind */
};

struct style {
    enum text_digits digits;
    const struct map *each; /* the map in front of each solid; NULL: none */
    bool nested;            /* each is a node of its own; else it is multiplied into the solid's */
};

/* The node, with its maps. */
void flat_put(struct text *text, const struct flat *flat, const struct style *style);
/* The same by construction. */
struct ideal_solid flat_ideal(const struct flat *flat);

/* The map that applies b first, then a. */
struct map map_multiply(const struct map *a, const struct map *b);
/* Turns the map's own axes by an angle in radians about its axis 0, 1 or 2. */
void map_turn_by(struct map *map, int axis, double angle);

void map_put(struct text *text, const struct map *map, enum text_digits digits);

#endif
