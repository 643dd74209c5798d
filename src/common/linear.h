/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_LINEAR_H
#define CSG_COMMON_LINEAR_H

/* Double-precision vectors, affine maps and boxes. Column vectors, as in OpenSCAD's multmatrix. */

#include <float.h>
#include <math.h>
#include <stdbool.h>

struct csg_vec3 {
    double x, y, z;
};

/* p -> linear * p + offset, rows of a 3x4 matrix. */
struct csg_map {
    double m[3][4];
};

/* Closed box; empty when any lo > hi; unbounded directions are infinite. */
struct csg_box {
    struct csg_vec3 lo, hi;
};

static inline struct csg_vec3 csg_vec3(double x, double y, double z)
{
    return (struct csg_vec3){x, y, z};
}

static inline struct csg_vec3 csg_vec3_of(const double v[3])
{
    return csg_vec3(v[0], v[1], v[2]);
}

/* axis: 0 to 2 */
static inline double csg_vec3_component(struct csg_vec3 a, int axis)
{
    return axis == 0 ? a.x : axis == 1 ? a.y : a.z;
}

/* The size of the largest component. */
static inline double csg_vec3_largest(struct csg_vec3 a)
{
    return fmax(fabs(a.x), fmax(fabs(a.y), fabs(a.z)));
}

static inline bool csg_vec3_is_finite(struct csg_vec3 a)
{
    return isfinite(a.x) && isfinite(a.y) && isfinite(a.z);
}

static inline struct csg_vec3 csg_add(struct csg_vec3 a, struct csg_vec3 b)
{
    return csg_vec3(a.x + b.x, a.y + b.y, a.z + b.z);
}

static inline struct csg_vec3 csg_sub(struct csg_vec3 a, struct csg_vec3 b)
{
    return csg_vec3(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline struct csg_vec3 csg_scale(double s, struct csg_vec3 a)
{
    return csg_vec3(s * a.x, s * a.y, s * a.z);
}

static inline double csg_dot(struct csg_vec3 a, struct csg_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline struct csg_vec3 csg_cross(struct csg_vec3 a, struct csg_vec3 b)
{
    return csg_vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

static inline double csg_length(struct csg_vec3 a)
{
    return sqrt(csg_dot(a, a));
}

/* The zero vector stays zero. */
static inline struct csg_vec3 csg_normalize(struct csg_vec3 a)
{
    const double length = csg_length(a);
    return length > 0 ? csg_scale(1 / length, a) : a;
}

extern const struct csg_map csg_map_identity;

struct csg_map csg_map_scaling(struct csg_vec3 by);

/* i: 0 to 2 */
static inline struct csg_vec3 csg_map_row(const struct csg_map *map, int i)
{
    return csg_vec3(map->m[i][0], map->m[i][1], map->m[i][2]);
}

/* i: 0 to 2, or 3, the offset */
static inline struct csg_vec3 csg_map_column(const struct csg_map *map, int i)
{
    return csg_vec3(map->m[0][i], map->m[1][i], map->m[2][i]);
}

/* The map that applies b first, then a. */
struct csg_map csg_map_multiply(const struct csg_map *a, const struct csg_map *b);

double csg_map_determinant(const struct csg_map *map);

/* At least the factor by which the map lengthens any vector; that of a rotation is 1. */
double csg_map_stretch(const struct csg_map *map);

bool csg_map_is_identity(const struct csg_map *map);

/* false when the linear part is singular to working precision; inverse is then untouched. */
bool csg_map_invert(const struct csg_map *map, struct csg_map *inverse);

struct csg_vec3 csg_map_point(const struct csg_map *map, struct csg_vec3 p);
struct csg_vec3 csg_map_direction(const struct csg_map *map, struct csg_vec3 d);

/* transpose(linear) * n: carries a plane's normal backwards through the map. */
struct csg_vec3 csg_map_transposed(const struct csg_map *map, struct csg_vec3 n);

extern const struct csg_box csg_box_empty;
extern const struct csg_box csg_box_all;

bool csg_box_is_empty(const struct csg_box *box);
bool csg_box_is_finite(const struct csg_box *box);
/* As fmin and fmax, where b may be nan and a is none, but without a call of the C library. */
static inline double csg_least(double a, double b)
{
    return b < a ? b : a;
}

static inline double csg_most(double a, double b)
{
    return b > a ? b : a;
}

static inline struct csg_box csg_box_union(const struct csg_box *a, const struct csg_box *b)
{
    return (struct csg_box){
        {csg_least(a->lo.x, b->lo.x), csg_least(a->lo.y, b->lo.y), csg_least(a->lo.z, b->lo.z)},
        {csg_most(a->hi.x, b->hi.x), csg_most(a->hi.y, b->hi.y), csg_most(a->hi.z, b->hi.z)}};
}

/* Whether two numbers are the same but for the rounding of what they were computed from: within
 * four units of the last place. 0.1 + 0.2 is 0.3. */
static inline bool csg_nearly(double a, double b)
{
    return fabs(a - b) <= 4 * DBL_EPSILON * fmax(fabs(a), fabs(b));
}

static inline struct csg_vec3 csg_box_middle(const struct csg_box *box)
{
    return csg_scale(0.5, csg_add(box->lo, box->hi));
}

void csg_box_extend(struct csg_box *box, struct csg_vec3 p);

static inline struct csg_box csg_box_intersection(const struct csg_box *a, const struct csg_box *b)
{
    return (struct csg_box){
        {csg_most(a->lo.x, b->lo.x), csg_most(a->lo.y, b->lo.y), csg_most(a->lo.z, b->lo.z)},
        {csg_least(a->hi.x, b->hi.x), csg_least(a->hi.y, b->hi.y), csg_least(a->hi.z, b->hi.z)}};
}

/* Whether they have a point in common, if only on their faces. */
static inline bool csg_box_overlaps(const struct csg_box *a, const struct csg_box *b)
{
    return a->lo.x <= b->hi.x && b->lo.x <= a->hi.x && a->lo.y <= b->hi.y && b->lo.y <= a->hi.y &&
           a->lo.z <= b->hi.z && b->lo.z <= a->hi.z;
}

/* The box with all its faces moved outwards by so much. */
struct csg_box csg_box_grown(const struct csg_box *box, double by);

/* Half of its surface; 0 where it is empty. */
static inline double csg_box_half_area(const struct csg_box *box)
{
    const struct csg_vec3 size = csg_sub(box->hi, box->lo);
    return box->lo.x > box->hi.x ? 0 : size.x * size.y + size.y * size.z + size.z * size.x;
}

/* Corner 0..7: bit 0 takes hi.x, bit 1 hi.y, bit 2 hi.z. */
struct csg_vec3 csg_box_corner(const struct csg_box *box, int corner);

/* The box of the mapped box. Infinite where a direction that the map uses is infinite. */
struct csg_box csg_box_map(const struct csg_map *map, const struct csg_box *box);

#endif
