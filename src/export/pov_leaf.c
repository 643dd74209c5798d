/* SPDX-License-Identifier: MIT */

/*
 * Leaves as POV-Ray's primitives. Sphere, box, cylinder and cone are recognised by their surfaces,
 * whatever node they come from, and written in world space where their map is a similarity; others
 * are mapped by a matrix, and what is none of these is an intersection of planes and a quadric.
 */

#include "export/pov.h"

#define SAME 1e-9 /* relative: directions and lengths that differ by less are meant to be equal */

/* Bounds are larger than the solid by this share of it. */
#define BOUND_ROOM 1e-2

/* POV-Ray takes time in the square of the planes of an intersection; more become a mesh of the
 * same polygons. */
#define MAX_PLANES 64

static void write_vector_line(struct csg_text *text, const char *head, struct csg_vec3 v,
                              const char *tail)
{
    char vector[CSG_TEXT_VECTOR];
    csg_text_line(text, "%s%s%s", head, csg_text_vector(vector, v), tail);
}

/* POV-Ray lists the images of x, y and z and the offset. */
static void write_matrix(struct csg_text *text, const struct csg_map *map)
{
    csg_text_line(text, "matrix <");
    for (int i = 0; i < 4; i++) {
        char x[CSG_TEXT_NUMBER], y[CSG_TEXT_NUMBER], z[CSG_TEXT_NUMBER];
        const struct csg_vec3 v = csg_map_column(map, i);
        csg_text_line(text, "  %s, %s, %s%s", csg_text_number(x, v.x), csg_text_number(y, v.y),
                      csg_text_number(z, v.z), i < 3 ? "," : ">");
    }
}

static void finish(struct csg_text *text, const char *tail)
{
    if (*tail)
        csg_text_line(text, "%s", tail);
    csg_text_close(text);
}

/* Whether the first num axes of the map have one length and stand upright on each other. */
static bool is_round(const struct csg_map *map, int num)
{
    const double length = csg_length(csg_map_column(map, 0));
    for (int i = 0; i < 3; i++) {
        const struct csg_vec3 axis = csg_map_column(map, i);
        const double size = csg_length(axis);
        if (i < num && !(fabs(size - length) <= SAME * length))
            return false;
        for (int j = 0; j < i; j++)
            if (!(fabs(csg_dot(axis, csg_map_column(map, j))) <=
                  SAME * size * csg_length(csg_map_column(map, j))))
                return false;
    }
    return true;
}

/* Whether it is x^2 + y^2 + z z^2 + constant. */
static bool has_diagonal(const struct csg_quadric *quadric, double z, double constant)
{
    const int8_t *diag = quadric->diag;
    return diag[0] == 1 && diag[1] == 1 && diag[2] == z && diag[3] == constant &&
           quadric->linear == 0;
}

/* ---- spheres -------------------------------------------------------------------------------- */

static bool write_sphere(struct csg_text *text, const struct csg_shape *shape,
                         const struct csg_map *from_canon, const char *tail)
{
    char center[CSG_TEXT_VECTOR], radius[CSG_TEXT_NUMBER];
    if (shape->num_planes || !has_diagonal(&shape->quadric, 1, -1))
        return false;
    csg_text_open(text, "sphere");
    if (is_round(from_canon, 3)) {
        csg_text_line(text, "%s, %s", csg_text_vector(center, csg_map_column(from_canon, 3)),
                      csg_text_number(radius, csg_length(csg_map_column(from_canon, 0))));
    } else {
        csg_text_line(text, "0, 1");
        write_matrix(text, from_canon);
    }
    finish(text, tail);
    return true;
}

/* ---- cylinders and cones -------------------------------------------------------------------- */

/* The canonical z between two planes that are upright on the canonical axis. */
static bool find_ends(const struct csg_shape *shape, const struct csg_map *from_canon, double *lo,
                      double *hi)
{
    *lo = -INFINITY;
    *hi = INFINITY;
    for (size_t i = 0; i < shape->num_planes; i++) {
        const struct csg_plane *plane = &shape->planes[i];
        const struct csg_vec3 normal = csg_map_transposed(from_canon, plane->normal);
        const double offset = plane->offset - csg_dot(plane->normal, csg_map_column(from_canon, 3));
        const double reach =
            csg_length(csg_map_column(from_canon, 0)) + csg_length(csg_map_column(from_canon, 1));
        if (!(hypot(normal.x, normal.y) <= SAME * reach))
            return false;
        if (normal.z > 0)
            *hi = fmin(*hi, offset / normal.z);
        else
            *lo = fmax(*lo, offset / normal.z);
    }
    return isfinite(*lo) && isfinite(*hi) && *lo < *hi;
}

static void write_round_ends(struct csg_text *text, const struct csg_map *map, bool is_cone,
                             double lo, double hi)
{
    char a[CSG_TEXT_VECTOR], b[CSG_TEXT_VECTOR], r[CSG_TEXT_NUMBER], s[CSG_TEXT_NUMBER];
    const double radius = csg_length(csg_map_column(map, 0));
    csg_text_vector(a, csg_map_point(map, csg_vec3(0, 0, lo)));
    csg_text_vector(b, csg_map_point(map, csg_vec3(0, 0, hi)));
    if (is_cone)
        csg_text_line(text, "%s, %s, %s, %s", a, csg_text_number(r, radius * fabs(lo)), b,
                      csg_text_number(s, radius * fabs(hi)));
    else
        csg_text_line(text, "%s, %s, %s", a, b, csg_text_number(r, radius));
}

/* The canonical solid is moved so that its lower end is at the origin: the apex of a slender cone
 * is far away, and the matrix would have to undo that. */
static void write_mapped_ends(struct csg_text *text, const struct csg_map *map, bool is_cone,
                              double lo, double hi)
{
    char h[CSG_TEXT_NUMBER], r[CSG_TEXT_NUMBER], s[CSG_TEXT_NUMBER];
    struct csg_map moved = *map;
    const struct csg_vec3 end = csg_map_point(map, csg_vec3(0, 0, lo));
    moved.m[0][3] = end.x;
    moved.m[1][3] = end.y;
    moved.m[2][3] = end.z;
    csg_text_number(h, hi - lo);
    if (is_cone)
        csg_text_line(text, "0, %s, z * %s, %s", csg_text_number(r, fabs(lo)), h,
                      csg_text_number(s, fabs(hi)));
    else
        csg_text_line(text, "0, z * %s, 1", h);
    write_matrix(text, &moved);
}

static bool write_cylinder(struct csg_text *text, const struct csg_shape *shape,
                           const struct csg_map *from_canon, const char *tail)
{
    const bool is_cone = has_diagonal(&shape->quadric, -1, 0) && shape->sheet != 0;
    double lo, hi;
    if ((!is_cone && !has_diagonal(&shape->quadric, 0, -1)) ||
        !find_ends(shape, from_canon, &lo, &hi))
        return false;
    if (is_cone && shape->sheet * (shape->sheet > 0 ? lo : hi) < 0)
        return false; /* cut by the apex and not by its plane */
    csg_text_open(text, is_cone ? "cone" : "cylinder");
    (is_round(from_canon, 2) ? write_round_ends : write_mapped_ends)(text, from_canon, is_cone, lo,
                                                                     hi);
    finish(text, tail);
    return true;
}

/* ---- boxes ---------------------------------------------------------------------------------- */

/* to_box maps the shape to [-1, 1]^3. false: its planes are not three pairs. */
static bool find_box(const struct csg_shape *shape, struct csg_map *to_box)
{
    bool used[6] = {false};
    int row = 0;
    if (shape->has_quadric || shape->num_planes != 6)
        return false;
    for (size_t i = 0; i < 6; i++) {
        const struct csg_plane *plane = &shape->planes[i];
        for (size_t j = i + 1; j < 6 && !used[i]; j++) {
            const struct csg_plane *other = &shape->planes[j];
            if (used[j] || csg_length(csg_add(plane->normal, other->normal)) > SAME || row == 3)
                continue;
            const double half = 0.5 * (plane->offset + other->offset);
            const double center = 0.5 * (plane->offset - other->offset);
            to_box->m[row][0] = plane->normal.x / half;
            to_box->m[row][1] = plane->normal.y / half;
            to_box->m[row][2] = plane->normal.z / half;
            to_box->m[row++][3] = -center / half;
            used[i] = used[j] = true;
        }
    }
    return row == 3;
}

static bool is_upright(const struct csg_map *map)
{
    for (int i = 0; i < 3; i++) {
        const struct csg_vec3 v = csg_map_column(map, i);
        if ((v.x != 0) + (v.y != 0) + (v.z != 0) != 1)
            return false;
    }
    return true;
}

static bool write_box(struct csg_text *text, const struct csg_shape *shape, const char *tail)
{
    char lo[CSG_TEXT_VECTOR], hi[CSG_TEXT_VECTOR];
    struct csg_map to_box, from_box;
    if (!find_box(shape, &to_box) || !csg_map_invert(&to_box, &from_box))
        return false;
    csg_text_open(text, "box");
    if (is_upright(&from_box)) {
        const struct csg_box unit = {{-1, -1, -1}, {1, 1, 1}};
        const struct csg_box box = csg_box_map(&from_box, &unit);
        csg_text_line(text, "%s, %s", csg_text_vector(lo, box.lo), csg_text_vector(hi, box.hi));
    } else {
        csg_text_line(text, "-1, 1");
        write_matrix(text, &from_box);
    }
    finish(text, tail);
    return true;
}

/* ---- everything else ------------------------------------------------------------------------ */

/* Coefficients of x^2, y^2, z^2, xy, xz, yz, x, y, z, 1 of the quadric in world space. */
static void expand_quadric(const struct csg_quadric *quadric, double c[10])
{
    const double *const rows[3] = {quadric->to_canon.m[0], quadric->to_canon.m[1],
                                   quadric->to_canon.m[2]};
    double q[4][4] = {{0}};
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            for (int k = 0; k < 3; k++)
                q[i][j] += quadric->diag[k] * rows[k][i] * rows[k][j];
    for (int i = 0; i < 4; i++) {
        q[i][3] += quadric->linear * rows[2][i];
        q[3][i] += quadric->linear * rows[2][i];
    }
    q[3][3] += quadric->diag[3];
    const double all[10] = {q[0][0],     q[1][1],     q[2][2],     2 * q[0][1], 2 * q[0][2],
                            2 * q[1][2], 2 * q[0][3], 2 * q[1][3], 2 * q[2][3], q[3][3]};
    for (int i = 0; i < 10; i++)
        c[i] = all[i];
}

static void write_coefficients(struct csg_text *text, const double c[10])
{
    char last[CSG_TEXT_NUMBER];
    csg_text_open(text, "quadric");
    for (int i = 0; i < 9; i += 3)
        write_vector_line(text, "", csg_vec3(c[i], c[i + 1], c[i + 2]), ",");
    csg_text_line(text, "%s", csg_text_number(last, c[9]));
}

static void write_plane(struct csg_text *text, const struct csg_plane *plane)
{
    char normal[CSG_TEXT_VECTOR], offset[CSG_TEXT_NUMBER];
    csg_text_line(text, "plane { %s, %s }", csg_text_vector(normal, plane->normal),
                  csg_text_number(offset, plane->offset));
}

/* Where the map cannot be inverted, the coefficients in world space are as good as any. */
static void write_quadric(struct csg_text *text, const struct csg_shape *shape)
{
    const struct csg_quadric *quadric = &shape->quadric;
    const struct csg_vec3 z = csg_map_row(&quadric->to_canon, 2);
    struct csg_map from_canon;
    double c[10] = {quadric->diag[0],    quadric->diag[1], quadric->diag[2], 0, 0, 0, 0, 0,
                    2 * quadric->linear, quadric->diag[3]};
    const bool is_mapped = csg_map_invert(&quadric->to_canon, &from_canon);
    if (!is_mapped)
        expand_quadric(quadric, c);
    write_coefficients(text, c);
    if (is_mapped)
        write_matrix(text, &from_canon);
    csg_text_close(text);
    if (shape->sheet && csg_length(z) > 0) {
        const double scale = -shape->sheet / csg_length(z);
        const struct csg_plane half = {csg_scale(scale, z), -scale * quadric->to_canon.m[2][3]};
        write_plane(text, &half);
    }
}

static void write_bound(struct csg_text *text, const struct csg_leaf *leaf)
{
    char lo[CSG_TEXT_VECTOR], hi[CSG_TEXT_VECTOR];
    const struct csg_box box = leaf->box;
    if (csg_box_is_empty(&box) || !csg_box_is_finite(&box))
        return;
    const struct csg_vec3 room = csg_scale(BOUND_ROOM, csg_sub(box.hi, box.lo));
    csg_text_line(text, "bounded_by { box { %s, %s } }", csg_text_vector(lo, csg_sub(box.lo, room)),
                  csg_text_vector(hi, csg_add(box.hi, room)));
}

static void write_surfaces(struct csg_text *text, const struct csg_leaf *leaf, const char *tail)
{
    const struct csg_shape *shape = &leaf->shape;
    csg_text_open(text, "intersection");
    if (shape->has_quadric)
        write_quadric(text, shape);
    for (size_t i = 0; i < shape->num_planes; i++)
        write_plane(text, &shape->planes[i]);
    /* POV-Ray wants two operands, and all space has no surface: this plane is never reached. */
    for (size_t i = shape->num_planes + (shape->has_quadric ? 1 : 0); i < 2; i++)
        csg_text_line(text, "plane { z, 1e30 }");
    write_bound(text, leaf);
    finish(text, tail);
}

bool csg_pov_leaf(struct csg_text *text, const struct csg_leaf *leaf, const char *tail)
{
    const struct csg_shape *shape = &leaf->shape;
    const struct csg_box box = leaf->box;
    struct csg_map from_canon;
    if (shape->surface)
        return csg_pov_triangles(text, shape, tail), true;
    if (shape->has_quadric && csg_map_invert(&shape->quadric.to_canon, &from_canon) &&
        (write_sphere(text, shape, &from_canon, tail) ||
         write_cylinder(text, shape, &from_canon, tail)))
        return true;
    if (write_box(text, shape, tail))
        return true;
    if (!shape->has_quadric && shape->num_planes > MAX_PLANES && csg_box_is_finite(&box))
        return csg_pov_polygons(text, shape, tail);
    write_surfaces(text, leaf, tail);
    return true;
}
