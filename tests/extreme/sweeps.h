/* SPDX-License-Identifier: MIT */
#ifndef EXTREME_SWEEPS_H
#define EXTREME_SWEEPS_H

/* Families of scenes with one parameter that goes where float32 breaks ray casters. */

#include "shot.h"

struct sweep {
    const char *name;
    const char *parameter;
    const double *values;
    int num_values;
    int num_shots; /* different ones per value; more are repeated with other random numbers */
    bool contacts; /* solids that touch */
    void (*make)(struct shot *shot, struct dice *dice, double value, int index);
};

extern const struct sweep sweeps[];
extern const int num_sweeps;

#endif
