/* SPDX-License-Identifier: MIT */
#ifndef EXTREME_CROWDS_H
#define EXTREME_CROWDS_H

/* Many solids on one ray and deep trees: what is seen is known from the construction. */

#include <stdbool.h>

#include <csgcast/csgcast.h>

/* full: 10^4 solids on a ray also where each of them must be passed. Prints a row for each. */
bool crowds_check(struct csgcast_renderer *renderer, bool full, bool csv);

#endif
