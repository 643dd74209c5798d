/* SPDX-License-Identifier: MIT */
#include "common/linear.h"

#include <float.h>

const struct csg_map csg_map_identity = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

const struct csg_box csg_box_empty = {{INFINITY, INFINITY, INFINITY},
                                      {-INFINITY, -INFINITY, -INFINITY}};
const struct csg_box csg_box_all = {{-INFINITY, -INFINITY, -INFINITY},
                                    {INFINITY, INFINITY, INFINITY}};

struct csg_map csg_map_scaling(struct csg_vec3 by)
{
    return (struct csg_map){{{by.x, 0, 0, 0}, {0, by.y, 0, 0}, {0, 0, by.z, 0}}};
}

struct csg_map csg_map_multiply(const struct csg_map *a, const struct csg_map *b)
{
    struct csg_map product;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            product.m[i][j] = a->m[i][0] * b->m[0][j] + a->m[i][1] * b->m[1][j] +
                              a->m[i][2] * b->m[2][j] + (j == 3 ? a->m[i][3] : 0);
    return product;
}

double csg_map_determinant(const struct csg_map *map)
{
    return csg_dot(csg_map_column(map, 0),
                   csg_cross(csg_map_column(map, 1), csg_map_column(map, 2)));
}

/* The largest eigenvalue of M M' by Gershgorin's circles. */
double csg_map_stretch(const struct csg_map *map)
{
    double largest = 0;
    for (int i = 0; i < 3; i++) {
        double sum = 0;
        for (int j = 0; j < 3; j++)
            sum += fabs(map->m[i][0] * map->m[j][0] + map->m[i][1] * map->m[j][1] +
                        map->m[i][2] * map->m[j][2]);
        largest = fmax(largest, sum);
    }
    return sqrt(largest);
}

bool csg_map_is_identity(const struct csg_map *map)
{
    bool is_identity = true;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            is_identity &= map->m[i][j] == (i == j ? 1 : 0);
    return is_identity;
}

bool csg_map_invert(const struct csg_map *map, struct csg_map *inverse)
{
    const struct csg_vec3 a = csg_map_column(map, 0), b = csg_map_column(map, 1),
                          c = csg_map_column(map, 2);
    const double det = csg_map_determinant(map);
    /* The determinant of a singular matrix of rounded numbers is rounding noise of the product
     * of its column lengths: below that it carries no information. */
    const double volume = csg_length(a) * csg_length(b) * csg_length(c);
    if (!(fabs(det) > 8 * DBL_EPSILON * volume) || !isfinite(1 / det))
        return false;
    const struct csg_vec3 rows[3] = {csg_scale(1 / det, csg_cross(b, c)),
                                     csg_scale(1 / det, csg_cross(c, a)),
                                     csg_scale(1 / det, csg_cross(a, b))};
    const struct csg_vec3 offset = csg_map_column(map, 3);
    for (int i = 0; i < 3; i++) {
        inverse->m[i][0] = rows[i].x;
        inverse->m[i][1] = rows[i].y;
        inverse->m[i][2] = rows[i].z;
        inverse->m[i][3] = -csg_dot(rows[i], offset);
    }
    return true;
}

struct csg_vec3 csg_map_point(const struct csg_map *map, struct csg_vec3 p)
{
    return csg_add(csg_map_direction(map, p), csg_map_column(map, 3));
}

struct csg_vec3 csg_map_direction(const struct csg_map *map, struct csg_vec3 d)
{
    return csg_vec3(csg_dot(csg_map_row(map, 0), d), csg_dot(csg_map_row(map, 1), d),
                    csg_dot(csg_map_row(map, 2), d));
}

struct csg_vec3 csg_map_transposed(const struct csg_map *map, struct csg_vec3 n)
{
    return csg_vec3(csg_dot(csg_map_column(map, 0), n), csg_dot(csg_map_column(map, 1), n),
                    csg_dot(csg_map_column(map, 2), n));
}

bool csg_box_is_empty(const struct csg_box *box)
{
    return !(box->lo.x <= box->hi.x && box->lo.y <= box->hi.y && box->lo.z <= box->hi.z);
}

bool csg_box_is_finite(const struct csg_box *box)
{
    return isfinite(box->lo.x) && isfinite(box->lo.y) && isfinite(box->lo.z) &&
           isfinite(box->hi.x) && isfinite(box->hi.y) && isfinite(box->hi.z);
}

void csg_box_extend(struct csg_box *box, struct csg_vec3 p)
{
    const struct csg_box point = {p, p};
    *box = csg_box_union(box, &point);
}

struct csg_box csg_box_grown(const struct csg_box *box, double by)
{
    const struct csg_vec3 d = csg_vec3(by, by, by);
    return (struct csg_box){csg_sub(box->lo, d), csg_add(box->hi, d)};
}

struct csg_vec3 csg_box_corner(const struct csg_box *box, int corner)
{
    return csg_vec3(corner & 1 ? box->hi.x : box->lo.x, corner & 2 ? box->hi.y : box->lo.y,
                    corner & 4 ? box->hi.z : box->lo.z);
}

/* An unused infinite direction must not turn into 0 * inf. */
static double product(double factor, double length)
{
    return factor == 0 ? 0 : factor * length;
}

struct csg_box csg_box_map(const struct csg_map *map, const struct csg_box *box)
{
    if (csg_box_is_empty(box))
        return csg_box_empty;
    double lo[3], hi[3];
    for (int i = 0; i < 3; i++) {
        const double *r = map->m[i];
        const double ax = product(r[0], box->lo.x), bx = product(r[0], box->hi.x);
        const double ay = product(r[1], box->lo.y), by = product(r[1], box->hi.y);
        const double az = product(r[2], box->lo.z), bz = product(r[2], box->hi.z);
        lo[i] = csg_least(ax, bx) + csg_least(ay, by) + csg_least(az, bz) + r[3];
        hi[i] = csg_most(ax, bx) + csg_most(ay, by) + csg_most(az, bz) + r[3];
    }
    return (struct csg_box){{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}};
}
