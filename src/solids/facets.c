/* SPDX-License-Identifier: MIT */
#include "solids/facets.h"

#include <limits.h>
#include <math.h>

/* OpenSCAD 2021.01's constants (primitives.cc, grid.h). */
#define SMALLEST_STEP 0.01              /* of $fa in degrees and of $fs in scene units */
#define SMALLEST_RADIUS (1.0 / 1048576) /* GRID_FINE: smaller circles have three fragments */

/* --facets=auto: up to so many fragments are meant as a polygon, beyond them as a circle. */
#define LARGEST_POLYGON 12

/* More digits than M_PI and M_SQRT1_2, which C11 does not have. */
#define PI 3.14159265358979323846264338327950288
#define SQRT_1_2 0.70710678118654752440084436210484904
#define SQRT_3_4 0.86602540378443864676372317075293618

struct csg_facets csg_args_facets(const struct csg_args *args)
{
    return (struct csg_facets){.fn = csg_args_number(args, "$fn", 0, NULL),
                               .fa = csg_args_number(args, "$fa", 12, NULL),
                               .fs = csg_args_number(args, "$fs", 2, NULL)};
}

struct csg_facets csg_args_round_facets(const struct csg_args *args)
{
    struct csg_facets facets = csg_args_facets(args);
    if (facets.fa < SMALLEST_STEP)
        facets.fa = SMALLEST_STEP;
    if (facets.fs < SMALLEST_STEP)
        facets.fs = SMALLEST_STEP;
    return facets;
}

/* A number of fragments beyond int is as good as the largest int: nobody can draw either. */
static int to_count(double number)
{
    return number < INT_MAX ? (int)number : INT_MAX;
}

int csg_facets_count(const struct csg_facets *facets, double radius)
{
    if (radius < SMALLEST_RADIUS || !isfinite(facets->fn))
        return 3;
    if (facets->fn > 0)
        return to_count(facets->fn >= 3 ? facets->fn : 3);
    return to_count(ceil(fmax(fmin(360 / facets->fa, radius * 2 * PI / facets->fs), 5)));
}

/* radius (1 - cos(pi / num)), without the difference. */
double csg_facets_sagitta(double num, double radius)
{
    const double s = sin(0.5 * 3.14159265358979323846 / fmax(num, 1));
    return 2 * radius * s * s;
}

bool csg_facets_wanted(const struct csg_args *args, const struct csg_facets *facets)
{
    if (args->facets == CSGCAST_FACETS_AUTO)
        return facets->fn > 0 && facets->fn < LARGEST_POLYGON + 1;
    return args->facets == CSGCAST_FACETS_AS_WRITTEN;
}

static double radians(double degrees)
{
    return degrees * (PI / 180);
}

/* Sine and cosine of 0 to 90 degrees. Beyond 45 each is the other of the complement, which is exact
 * there: so sin(x) == cos(90 - x) bit by bit. */
static double sin_quadrant(double degrees)
{
    if (degrees == 30)
        return 0.5;
    if (degrees == 45)
        return SQRT_1_2;
    if (degrees == 60)
        return SQRT_3_4;
    return degrees < 45 ? sin(radians(degrees)) : cos(radians(90 - degrees));
}

static double cos_quadrant(double degrees)
{
    if (degrees == 60)
        return 0.5;
    if (degrees == 45)
        return SQRT_1_2;
    if (degrees == 30)
        return SQRT_3_4;
    return degrees > 45 ? sin(radians(90 - degrees)) : cos(radians(degrees));
}

/* 0 <= result < 360 for every finite argument; nan stays. */
static double wrap(double degrees)
{
    if (degrees >= 0 && degrees < 360)
        return degrees;
    if (degrees < 0 && degrees >= -360)
        return degrees + 360 < 360 ? degrees + 360 : 0;
    return degrees - 360 * floor(degrees / 360);
}

double csg_sin_degrees(double degrees)
{
    const double turn = wrap(degrees);
    const double half = turn >= 180 ? turn - 180 : turn;
    const double sine = sin_quadrant(half > 90 ? 180 - half : half);
    return turn >= 180 ? -sine : sine;
}

double csg_cos_degrees(double degrees)
{
    const double turn = wrap(degrees);
    const double half = turn >= 180 ? turn - 180 : turn;
    const double cosine = cos_quadrant(half > 90 ? 180 - half : half);
    return (turn >= 180) != (half > 90) ? -cosine : cosine;
}
