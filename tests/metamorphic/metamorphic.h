/* SPDX-License-Identifier: MIT */
#ifndef METAMORPHIC_H
#define METAMORPHIC_H

/* What all kinds of pairs share. */

#include "ideal/judge.h"
#include "ideal/text.h"

struct run {
    struct csgcast_renderer *renderer;
    enum csgcast_backend backend;
    int size;
    struct picture first, second;
    int failed, num;
};

struct operands {
    char *texts[3];
};

/* Writes the formula with A B C replaced by the operands. */
void put_formula(struct text *text, const char *formula, const struct operands *operands);
struct csgcast_scene *parse(const struct text *text, const char *name);
struct csgcast_view random_view(struct dice *dice, int size);

/* Compares run's pictures, in a square of that many pixels, and counts them; exact: the same
 * numbers are computed. A failure is printed, and the scene is saved. */
bool judge(struct run *run, const char *name, int size, bool exact);
void save(const char *name, const char *which, const struct text *text);

/* Pairs of pictures of one scene: a part of the picture, other tiles, the space along the view axis
 * stretched. */
void check_windows(struct run *run, const struct operands *operands, struct dice *dice,
                   const char *name);

#endif
