/* SPDX-License-Identifier: MIT */
#ifndef COINCIDENCE_RELATIONS_H
#define COINCIDENCE_RELATIONS_H

/* Pairs of solids whose faces coincide, and what they make by construction. */

#include "ideal/kinds.h"

enum relation {
    RELATION_FLUSH,   /* a - b, b's face in a's: a blind hole */
    RELATION_THROUGH, /* a - b, b between both ends of a slab cut from a */
    RELATION_ABUT,    /* a + b, b on top of a */
    RELATION_GROW,    /* a + a mirrored: the ends of two equal solids meet */
    RELATION_PLUG,    /* (a - b) + b */
    RELATION_PARTS,   /* (a - b) + (a * b): a */
    RELATION_INNER,   /* a - (a - b): a * b */
    RELATION_UNDO,    /* (a + b) - b */
    RELATION_ABSORB,  /* (a + b) * a: a */
    RELATION_EQUAL,   /* a - a: nothing */
    RELATION_TWICE,   /* a + a, a * a: a */
    RELATION_SKIN,    /* a - b, b deeper by 1e-4 of a: a skin is left */
    NUM_RELATIONS
};

extern const char *const relation_names[NUM_RELATIONS];

enum placement {
    PLACE_REST,      /* as made */
    PLACE_OUTER,     /* turned and moved by one matrix around the Boolean */
    PLACE_EACH,      /* by a matrix at every solid, multiplied into the solid's own */
    PLACE_FAR,       /* as OUTER or EACH, 1e5 radii from the origin */
    PLACE_SIX_OUTER, /* as OUTER, EACH; six digits */
    PLACE_SIX_NESTED,
    PLACE_SIX_EACH,
    NUM_PLACEMENTS
};

extern const char *const placement_names[NUM_PLACEMENTS];

struct pair {
    struct text text;
    struct ideal_scene ideal;
    bool six;
    struct ideal_vec target; /* in the solids' space: a point of the face in question */
};

/* Relations of one solid do not look at b. */
bool relation_has_b(enum relation relation);

void pair_make(struct pair *pair, struct dice *dice, enum relation relation, enum kind a,
               enum kind b, enum placement placement);

#endif
