/* SPDX-License-Identifier: MIT */
#include "nodes/transforms.h"

#include <string.h>

#include "nodes/colors.h"
#include "solids/facets.h"

/* A map as written: its entries, and how far each may be off. */
struct written_map {
    struct csg_map map;
    double error[3][4];
};

static bool is_finite(const struct csg_map *map)
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            if (!isfinite(map->m[i][j]))
                return false;
    return true;
}

static void warn(const struct csg_args *args, const char *text)
{
    csg_log_warning(args->log, CSGCAST_MESSAGE_SCENE, "%s:%u:%u: %s: %s", args->file,
                    (unsigned)args->line, (unsigned)args->column, args->node, text);
}

/*
 * With M the space's map, E its error, T and dT those of the node:
 *     |(M + E)(T + dT) - M T| <= |M| dT + E |T|   to first order, entry by entry,
 * where the last row of the matrices is 0 0 0 1 and has no error.
 */
static void compose_error(struct csg_space *space, const struct written_map *by)
{
    double error[3][4];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++) {
            error[i][j] = j == 3 ? space->error[i][3] : 0;
            for (int k = 0; k < 3; k++)
                error[i][j] += fabs(space->map.m[i][k]) * by->error[k][j] +
                               space->error[i][k] * fabs(by->map.m[k][j]);
        }
    memcpy(space->error, error, sizeof error);
}

static bool compose(const struct csg_args *args, struct csg_space *space,
                    const struct written_map *by)
{
    if (space->in_boolean)
        compose_error(space, by);
    space->map = csg_map_multiply(&space->map, &by->map);
    if (!space->is_empty && !is_finite(&space->map)) {
        warn(args, "the matrix is not finite (nan or inf); what is in it is left out");
        space->is_empty = true;
    }
    return true;
}

static const struct written_map identity = {
    .map = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}},
};

/* Entry [row][column] of m; OpenSCAD keeps the identity's where there is no number. */
static const struct csg_value *entry_of(const struct csg_value *m, size_t row, size_t column)
{
    if (row >= m->num || m->items[row].type != CSG_VALUE_VECTOR || column >= m->items[row].num)
        return NULL;
    const struct csg_value *entry = &m->items[row].items[column];
    return entry->type == CSG_VALUE_NUMBER ? entry : NULL;
}

/* Of the fourth row only the last number counts, as a divisor: the geometry stays affine. */
bool csg_enter_multmatrix(const struct csg_args *args, struct csg_space *space)
{
    const struct csg_value *m = csg_args_find(args, "m");
    struct written_map by = identity;
    if (!m)
        return true;
    if (m->type != CSG_VALUE_VECTOR) {
        csg_args_error(args, "m must be a matrix, [[a, b, c, x], [d, e, f, y], [g, h, i, z], "
                             "[0, 0, 0, 1]]");
        return false;
    }
    const struct csg_value *corner = entry_of(m, 3, 3);
    const double divisor = corner ? corner->number : 1;
    for (size_t i = 0; i < 3; i++)
        for (size_t j = 0; j < 4; j++) {
            const struct csg_value *entry = entry_of(m, i, j);
            by.map.m[i][j] = (entry ? entry->number : by.map.m[i][j]) / divisor;
            by.error[i][j] = entry ? (double)entry->rounding / fabs(divisor) : 0;
        }
    return compose(args, space, &by);
}

/* Two or three numbers; the third is by default rest. */
static bool read_vector(const struct csg_args *args, const struct csg_value *value, double rest,
                        double numbers[3], double rounding[3])
{
    const size_t num = value && value->type == CSG_VALUE_VECTOR ? value->num : 0;
    numbers[2] = rest;
    rounding[2] = 0;
    bool valid = num == 2 || num == 3;
    for (size_t i = 0; valid && i < num; i++) {
        numbers[i] = value->items[i].number;
        rounding[i] = (double)value->items[i].rounding;
        valid = value->items[i].type == CSG_VALUE_NUMBER;
    }
    if (!valid)
        csg_args_error(args, "v must be a vector of three numbers, [x, y, z]");
    return valid;
}

bool csg_enter_translate(const struct csg_args *args, struct csg_space *space)
{
    double by[3], rounding[3];
    struct written_map written = identity;
    if (!read_vector(args, csg_args_find(args, "v"), 0, by, rounding))
        return false;
    if (!isfinite(by[0]) || !isfinite(by[1]) || !isfinite(by[2])) {
        warn(args, "v is not finite (nan or inf); nothing is moved, as in OpenSCAD");
        return true;
    }
    for (int i = 0; i < 3; i++) {
        written.map.m[i][3] = by[i];
        written.error[i][3] = rounding[i];
    }
    return compose(args, space, &written);
}

bool csg_enter_scale(const struct csg_args *args, struct csg_space *space)
{
    const struct csg_value *v = csg_args_find(args, "v");
    double by[3] = {1, 1, 1}, rounding[3] = {0};
    struct written_map written = identity;
    if (v && v->type == CSG_VALUE_NUMBER)
        by[0] = by[1] = by[2] = v->number;
    else if (!read_vector(args, v, 1, by, rounding))
        return false;
    for (int i = 0; i < 3; i++) {
        written.map.m[i][i] = by[i];
        written.error[i][i] = v->type == CSG_VALUE_NUMBER ? (double)v->rounding : rounding[i];
    }
    return compose(args, space, &written);
}

/* Reflection in the plane through the origin with normal v: 1 - 2 v v^T / v.v. */
bool csg_enter_mirror(const struct csg_args *args, struct csg_space *space)
{
    const struct csg_value *v = csg_args_find(args, "v");
    double numbers[3] = {1, 0, 0}, rounding[3];
    struct written_map written = identity;
    if (v && !read_vector(args, v, 0, numbers, rounding))
        return false;
    const struct csg_vec3 unit = csg_normalize(csg_vec3_of(numbers));
    const double n[3] = {unit.x, unit.y, unit.z};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            written.map.m[i][j] -= 2 * n[i] * n[j];
    return compose(args, space, &written);
}

/* Rodrigues' rotation by degrees about the unit vector n. */
static struct csg_map rotation_about(struct csg_vec3 n, double degrees)
{
    const double c = csg_cos_degrees(degrees), s = csg_sin_degrees(degrees), r = 1 - c;
    return (struct csg_map){{
        {c + r * n.x * n.x, r * n.x * n.y - s * n.z, r * n.x * n.z + s * n.y, 0},
        {r * n.y * n.x + s * n.z, c + r * n.y * n.y, r * n.y * n.z - s * n.x, 0},
        {r * n.z * n.x - s * n.y, r * n.z * n.y + s * n.x, c + r * n.z * n.z, 0},
    }};
}

/* About x, then y, then z. Missing angles are 0. */
static bool rotation_by_angles(const struct csg_args *args, const struct csg_value *angles,
                               struct csg_map *map)
{
    static const struct csg_vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    *map = csg_map_identity;
    if (angles->num > 3)
        return csg_args_error(args, "a must be an angle or [x, y, z], in degrees"), false;
    for (size_t i = 0; i < angles->num; i++) {
        if (angles->items[i].type != CSG_VALUE_NUMBER)
            return csg_args_error(args, "the angles must be numbers, in degrees"), false;
        const struct csg_map next = rotation_about(axes[i], angles->items[i].number);
        *map = csg_map_multiply(&next, map);
    }
    return true;
}

bool csg_enter_rotate(const struct csg_args *args, struct csg_space *space)
{
    const struct csg_value *a = csg_args_find(args, "a"), *v = csg_args_find(args, "v");
    double axis[3] = {0, 0, 1}, rounding[3];
    struct written_map written = identity;
    if (!a)
        return true;
    if (a->type == CSG_VALUE_VECTOR) {
        if (!rotation_by_angles(args, a, &written.map))
            return false;
    } else if (a->type != CSG_VALUE_NUMBER) {
        csg_args_error(args, "a must be an angle or [x, y, z], in degrees");
        return false;
    } else {
        if (v && !read_vector(args, v, 0, axis, rounding))
            return false;
        const struct csg_vec3 unit = csg_normalize(csg_vec3_of(axis));
        if (csg_length(unit) > 0)
            written.map = rotation_about(unit, a->number);
    }
    return compose(args, space, &written);
}

bool csg_enter_color(const struct csg_args *args, struct csg_space *space)
{
    float color[4];
    if (!csg_color_read(args, color))
        return false;
    if (!space->has_color) {
        memcpy(space->color, color, sizeof color);
        space->has_color = color[0] >= 0 && color[1] >= 0 && color[2] >= 0 && color[3] >= 0;
    }
    return true;
}

bool csg_enter_render(const struct csg_args *args, struct csg_space *space)
{
    (void)args;
    space->has_color = true;
    return true;
}

double csg_space_rounding(const struct csg_space *space, const struct csg_box *box)
{
    double largest = 0;
    /* Of an unbounded solid at least the move is known. */
    const bool finite = csg_box_is_finite(box);
    for (int corner = 0; corner < (finite ? 8 : 1); corner++) {
        const struct csg_vec3 c = finite ? csg_box_corner(box, corner) : csg_vec3(0, 0, 0);
        double squares = 0;
        for (int i = 0; i < 3; i++) {
            const double *e = space->error[i];
            const double off = e[0] * fabs(c.x) + e[1] * fabs(c.y) + e[2] * fabs(c.z) + e[3];
            squares += off * off;
        }
        largest = fmax(largest, sqrt(squares));
    }
    return largest;
}

/* The spectral norm is at most the Frobenius norm and at most sqrt(norm1 * norm-infinity). */
double csg_space_stretch(const struct csg_space *space)
{
    double rows = 0, columns = 0, squares = 0;
    for (int i = 0; i < 3; i++) {
        const double(*m)[4] = space->map.m;
        rows = fmax(rows, fabs(m[i][0]) + fabs(m[i][1]) + fabs(m[i][2]));
        columns = fmax(columns, fabs(m[0][i]) + fabs(m[1][i]) + fabs(m[2][i]));
        squares += m[i][0] * m[i][0] + m[i][1] * m[i][1] + m[i][2] * m[i][2];
    }
    return fmin(sqrt(squares), sqrt(rows * columns));
}
