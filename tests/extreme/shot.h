/* SPDX-License-Identifier: MIT */
#ifndef EXTREME_SHOT_H
#define EXTREME_SHOT_H

/* One scene, what it is by construction, and one view of it. */

#include "ideal/judge.h"
#include "ideal/kinds.h"

struct shot {
    struct text text;
    struct ideal_scene ideal; /* in world space; no solids where only the reference knows */
    struct csgcast_view view;
    double extent; /* of the whole scene; ideal.size is that of its finest part */
};

/* Solids as they are made: kind, half width and depth, and a map. */
struct part {
    enum kind kind;
    double size, height;
    struct map map;
};

extern const struct map map_identity;
struct map map_scale(double x, double y, double z);
struct map map_move(double x, double y, double z);
struct map map_turn(struct dice *dice); /* any rotation */

/* Appends the solid's text and its construction. */
void shot_part(struct shot *shot, const struct part *part);
/* The same for a quadric xx x^2 + yy y^2 + zz z^2 + 2 iz z + constant <= 0. */
void shot_quadric(struct shot *shot, const double terms[5], const struct map *map);

/* rule: postfix over the solids, in order (ideal.h). */
void shot_begin(struct shot *shot, double size);
void shot_end(struct shot *shot, const char *rule);

/* The eye at distance from target, in the direction away; reach: half of what the picture holds. */
void shot_look(struct shot *shot, struct ideal_vec target, struct ideal_vec away, double distance,
               double reach, bool orthographic);
struct ideal_vec random_direction(struct dice *dice);

#endif
