/* SPDX-License-Identifier: MIT */
#ifndef CSG_SOLIDS_FACETS_H
#define CSG_SOLIDS_FACETS_H

/* OpenSCAD's facets: how many, and whether they are wanted. */

#include "solids/value.h"

/* $fn, $fa, $fs of a node with OpenSCAD's defaults: 0, 12, 2. */
struct csg_facets {
    double fn, fa, fs;
};

struct csg_facets csg_args_facets(const struct csg_args *args);

/* The same for circle, sphere and cylinder, for which it takes $fa and $fs to be at least 0.01. */
struct csg_facets csg_args_round_facets(const struct csg_args *args);

/* Fragments of a circle: Calc::get_fragments_from_r of OpenSCAD 2021.01. At least 3. */
int csg_facets_count(const struct csg_facets *facets, double radius);

/* How far the chords of num fragments are from the circle. */
double csg_facets_sagitta(double num, double radius);

/* Whether --facets makes this node polygonal: AS_WRITTEN, or AUTO and an explicit $fn of 1..12. */
bool csg_facets_wanted(const struct csg_args *args, const struct csg_facets *facets);

/* Sine and cosine of degrees, exact at multiples of 30 and 45 (OpenSCAD's degree_trig.cc). */
double csg_sin_degrees(double degrees);
double csg_cos_degrees(double degrees);

#endif
