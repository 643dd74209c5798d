/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_STATS_H
#define CSG_CLI_STATS_H

/* What a frame cost, printed. */

#include "json.h"

#include <csgcast/csgcast.h>

#include <stdio.h>

/* One line a number. */
void csg_cli_print_stats(FILE *file, const char *renderer, const struct csgcast_stats *stats);

/* What is drawn in double, and why: the numerics of stats. */
void csg_cli_print_numerics(FILE *file, const struct csgcast_stats *stats);

/* The numbers as members of the object that is open. */
void csg_cli_print_stats_json(struct csg_json *json, const struct csgcast_stats *stats);

#endif
