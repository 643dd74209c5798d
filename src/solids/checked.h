/* SPDX-License-Identifier: MIT */
#ifndef CSG_SOLIDS_CHECKED_H
#define CSG_SOLIDS_CHECKED_H

/*
 * Arguments of the kinds that OpenSCAD lacks. Where OpenSCAD would quietly take a default or draw
 * nothing, these say what is wrong. Each function leaves its result alone when the argument is
 * absent, and returns false, with a message, when it is there and wrong. rounding gets the
 * argument's rounding added (struct csg_value).
 */

#include "common/linear.h"
#include "solids/value.h"

/* A finite number. */
bool csg_checked_number(const struct csg_args *args, const char *name, double *number,
                        double *rounding);

/* A finite number above 0. */
bool csg_checked_positive(const struct csg_args *args, const char *name, double *number,
                          double *rounding);

/* num numbers above 0, or one that stands for all. */
bool csg_checked_lengths(const struct csg_args *args, const char *name, size_t num, double *lengths,
                         double *rounding);

/* num (at most 3) finite numbers. */
bool csg_checked_vector(const struct csg_args *args, const char *name, size_t num, double *numbers,
                        double *rounding);

#endif
