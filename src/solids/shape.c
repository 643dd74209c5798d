/* SPDX-License-Identifier: MIT */
#include "solids/shape.h"

#include <stdlib.h>
#include <string.h>

#include "mesh/surface.h"

/* How far a sphere's map may be from a uniform scaling and a rotation, relative. */
#define BALL_NOISE 1e-12

void csg_shape_finish(struct csg_shape *shape)
{
    free(shape->planes);
    csg_surface_destroy(shape->surface);
    shape->surface = NULL;
    shape->planes = NULL;
    shape->num_planes = 0;
}

/* There is room for 1, 2, 4, 6, 8, 12, 16, 24 ... planes, the first of these that is enough. */
static size_t room_for(size_t num)
{
    size_t power = 1;
    while (2 * power <= num)
        power *= 2;
    const size_t step = power > 2 ? power / 2 : power;
    return (num + step - 1) / step * step;
}

bool csg_shape_copy(struct csg_shape *copy, const struct csg_shape *shape)
{
    *copy = *shape;
    copy->planes = NULL;
    copy->surface = NULL;
    if (shape->surface)
        copy->surface = csg_surface_share(shape->surface);
    if (!shape->num_planes)
        return true;
    copy->planes = malloc(room_for(shape->num_planes) * sizeof *copy->planes);
    if (copy->planes)
        memcpy(copy->planes, shape->planes, shape->num_planes * sizeof *copy->planes);
    return copy->planes != NULL;
}

/* n.x <= d with x = inverse(y) is transpose(L) n . y <= d - n . offset, L and offset of inverse. */
void csg_plane_map(struct csg_plane *plane, const struct csg_map *inverse)
{
    const struct csg_vec3 normal = csg_map_transposed(inverse, plane->normal);
    const struct csg_vec3 shift = csg_map_column(inverse, 3);
    const double length = csg_length(normal);
    *plane = (struct csg_plane){csg_scale(1 / length, normal),
                                (plane->offset - csg_dot(plane->normal, shift)) / length};
}

bool csg_shape_map(struct csg_shape *shape, const struct csg_map *map)
{
    struct csg_map inverse, ignored;
    const struct csg_map frame = csg_map_multiply(map, &shape->frame);
    if (!csg_map_invert(map, &inverse) || (shape->surface && !csg_map_invert(&frame, &ignored)))
        return false;
    for (size_t i = 0; i < shape->num_planes; i++)
        csg_plane_map(&shape->planes[i], &inverse);
    if (shape->has_quadric)
        shape->quadric.to_canon = csg_map_multiply(&shape->quadric.to_canon, &inverse);
    shape->frame = frame;
    shape->sagitta *= csg_map_stretch(map);
    return true;
}

/* Of unit normals that are exactly opposite, as rounding leaves them. */
#define OPPOSITE 1e-12 /* of their cosine: 1.4e-6 of an angle */

/* As many face its way as face the opposite one. */
static bool is_balanced(const struct csg_shape *shape, size_t plane)
{
    int balance = 0;
    for (size_t i = 0; i < shape->num_planes; i++) {
        const double along = csg_dot(shape->planes[i].normal, shape->planes[plane].normal);
        balance += along > 1 - OPPOSITE ? 1 : along < OPPOSITE - 1 ? -1 : 0;
    }
    return balance == 0;
}

bool csg_shape_is_paired(const struct csg_shape *shape)
{
    for (size_t i = 0; i < shape->num_planes; i++)
        if (!is_balanced(shape, i))
            return false;
    return true;
}

static bool make_room(struct csg_shape *shape)
{
    const size_t room = room_for(shape->num_planes + 1);
    if (room == room_for(shape->num_planes))
        return true;
    struct csg_plane *planes = realloc(shape->planes, room * sizeof *planes);
    if (planes)
        shape->planes = planes;
    return planes != NULL;
}

/* Divided by the largest component first, so that no square overflows or underflows. */
bool csg_shape_add_plane(struct csg_shape *shape, struct csg_vec3 normal, double offset)
{
    if (!make_room(shape))
        return false;
    const double size = csg_vec3_largest(normal);
    const struct csg_vec3 n = csg_vec3(normal.x / size, normal.y / size, normal.z / size);
    const double length = csg_length(n);
    shape->planes[shape->num_planes++] = (struct csg_plane){
        csg_vec3(n.x / length, n.y / length, n.z / length), offset / size / length};
    return true;
}

double csg_quadric_value(const struct csg_quadric *quadric, struct csg_vec3 x)
{
    const struct csg_vec3 p = csg_map_point(&quadric->to_canon, x);
    const int8_t *diag = quadric->diag;
    return diag[0] * p.x * p.x + diag[1] * p.y * p.y + diag[2] * p.z * p.z +
           2 * quadric->linear * p.z + diag[3];
}

struct csg_vec3 csg_quadric_gradient(const struct csg_quadric *quadric, struct csg_vec3 x)
{
    const struct csg_vec3 p = csg_map_point(&quadric->to_canon, x);
    const struct csg_vec3 canonical =
        csg_vec3(2 * quadric->diag[0] * p.x, 2 * quadric->diag[1] * p.y,
                 2 * quadric->diag[2] * p.z + 2 * quadric->linear);
    return csg_map_transposed(&quadric->to_canon, canonical);
}

bool csg_quadric_ball(const struct csg_quadric *quadric, struct csg_vec3 *center, double *radius)
{
    const double(*m)[4] = quadric->to_canon.m;
    const int8_t *d = quadric->diag;
    const double size = m[0][0] * m[0][0] + m[1][0] * m[1][0] + m[2][0] * m[2][0];
    if (d[0] != 1 || d[1] != 1 || d[2] != 1 || d[3] != -1 || quadric->linear != 0)
        return false;
    for (int i = 0; i < 3; i++)
        for (int j = i; j < 3; j++) {
            const double dot = m[0][i] * m[0][j] + m[1][i] * m[1][j] + m[2][i] * m[2][j];
            if (!(fabs(dot - (i == j ? size : 0)) <= BALL_NOISE * size))
                return false;
        }
    const struct csg_vec3 offset = {m[0][3], m[1][3], m[2][3]};
    *center = csg_scale(-1 / size, csg_map_transposed(&quadric->to_canon, offset));
    *radius = 1 / sqrt(size);
    return true;
}

static bool is_on_sheet(const struct csg_shape *shape, struct csg_vec3 p)
{
    return !shape->convex || shape->sheet * csg_map_point(&shape->quadric.to_canon, p).z >= 0;
}

bool csg_shape_contains(const struct csg_shape *shape, struct csg_vec3 p)
{
    if (shape->surface)
        return csg_surface_winding(shape->surface, &shape->frame, p) != 0;
    for (size_t i = 0; i < shape->num_planes; i++)
        if (!(csg_dot(shape->planes[i].normal, p) <= shape->planes[i].offset))
            return false;
    return !shape->has_quadric ||
           (csg_quadric_value(&shape->quadric, p) <= 0 && is_on_sheet(shape, p));
}
