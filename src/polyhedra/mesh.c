/* SPDX-License-Identifier: MIT */
#include "polyhedra/mesh.h"

#include <stdlib.h>

#include "common/hash.h"
#include "polyhedra/cut.h"

/* Points closer than this share of the largest coordinate are one. */
#define SAME_POINT 1e-12

/* Faces are plane when their corners are off by less than this share of the largest coordinate. */
#define PLANE 1e-9

#define PI 3.14159265358979323846264338327950288

void csg_mesh_finish(struct csg_mesh *mesh)
{
    free(mesh->points.data);
    free(mesh->corners.data);
    free(mesh->faces.data);
    *mesh = (struct csg_mesh){0};
}

bool csg_mesh_add_point(struct csg_mesh *mesh, struct csg_vec3 p)
{
    mesh->size = fmax(mesh->size, csg_vec3_largest(p));
    return csg_array_push(&mesh->points, p);
}

bool csg_mesh_close_face(struct csg_mesh *mesh)
{
    const uint32_t begin = mesh->faces.num ? mesh->faces.data[mesh->faces.num - 1].end : 0;
    const struct csg_mesh_face face = {begin, (uint32_t)mesh->corners.num};
    if (face.end - face.begin >= 3)
        return csg_array_push(&mesh->faces, face);
    mesh->corners.num = begin;
    return true;
}

static struct csg_vec3 corner(const struct csg_mesh *mesh, uint32_t i)
{
    return mesh->points.data[mesh->corners.data[i]];
}

/* Newell's normal: twice the area vector. */
bool csg_mesh_plane(const struct csg_mesh *mesh, const struct csg_mesh_face *face,
                    struct csg_plane *plane)
{
    const uint32_t num = face->end - face->begin;
    const struct csg_vec3 origin = corner(mesh, face->begin);
    struct csg_vec3 normal = {0, 0, 0}, center = {0, 0, 0};
    double longest = 0;
    for (uint32_t i = 0; i < num; i++) {
        const struct csg_vec3 a = csg_sub(corner(mesh, face->begin + i), origin);
        const struct csg_vec3 b = csg_sub(corner(mesh, face->begin + (i + 1) % num), origin);
        normal = csg_add(normal, csg_cross(a, b));
        center = csg_add(center, a);
        longest = fmax(longest, csg_length(a));
    }
    center = csg_add(origin, csg_scale(1.0 / num, center));
    if (!(csg_length(normal) > SAME_POINT * longest * fmax(longest, mesh->size)))
        return false;
    plane->normal = csg_normalize(normal);
    plane->offset = csg_dot(plane->normal, center);
    return true;
}

/* ---- cleaning ----------------------------------------------------------------------------- */

/* Points met so far, by the cell of a grid that they are in; linear probing. */
struct places {
    const struct csg_vec3 *points;
    uint32_t *slots; /* points; UINT32_MAX where there is none */
    size_t mask;
    double near, cell;
};

static size_t slot_of(const struct places *places, const double cell[3])
{
    uint64_t hash = 0;
    for (int i = 0; i < 3; i++)
        hash = csg_hash_number(hash, (uint64_t)(int64_t)cell[i]);
    return (size_t)hash & places->mask;
}

/* A point of the cell near p; *slot is where the search ended. */
static uint32_t find_in_cell(const struct places *places, struct csg_vec3 p, const double cell[3],
                             size_t *slot)
{
    for (*slot = slot_of(places, cell); places->slots[*slot] != UINT32_MAX;
         *slot = (*slot + 1) & places->mask) {
        const uint32_t point = places->slots[*slot];
        if (csg_length(csg_sub(places->points[point], p)) <= places->near)
            return point;
    }
    return UINT32_MAX;
}

/* The first point near p, or p's own number, which is then kept. Near points may be in the next
 * cell where p is close to its walls. */
static uint32_t find_place(struct places *places, uint32_t i)
{
    const struct csg_vec3 p = places->points[i];
    const double near = places->near, size = places->cell;
    const double own[3] = {floor(p.x / size), floor(p.y / size), floor(p.z / size)};
    size_t slot;
    for (int corner = 0; corner < 8; corner++) {
        const double x = p.x + (corner & 1 ? near : -near), y = p.y + (corner & 2 ? near : -near);
        const double z = p.z + (corner & 4 ? near : -near);
        const double cell[3] = {floor(x / size), floor(y / size), floor(z / size)};
        const bool is_own = cell[0] == own[0] && cell[1] == own[1] && cell[2] == own[2];
        if (is_own && corner > 0)
            continue;
        const uint32_t found = find_in_cell(places, p, cell, &slot);
        if (found != UINT32_MAX)
            return found;
    }
    const uint32_t found = find_in_cell(places, p, own, &slot);
    if (found == UINT32_MAX)
        places->slots[slot] = i;
    return found == UINT32_MAX ? i : found;
}

static bool join_points(struct csg_mesh *mesh)
{
    const size_t num = mesh->points.num;
    struct places places = {.points = mesh->points.data, .near = SAME_POINT * mesh->size};
    size_t room = 16;
    while (room < 2 * num)
        room *= 2;
    places.mask = room - 1;
    places.cell = places.near > 0 ? 8 * places.near : 1;
    places.slots = malloc(room * sizeof *places.slots);
    uint32_t *to = malloc((num + 1) * sizeof *to);
    const bool ok = places.slots && to;
    for (size_t i = 0; i < room && ok; i++)
        places.slots[i] = UINT32_MAX;
    for (size_t i = 0; i < num && ok; i++)
        to[i] = find_place(&places, (uint32_t)i);
    for (size_t i = 0; i < mesh->corners.num && ok; i++)
        mesh->corners.data[i] = to[mesh->corners.data[i]];
    free(places.slots);
    free(to);
    return ok;
}

static bool is_plane(const struct csg_mesh *mesh, const struct csg_mesh_face *face)
{
    struct csg_plane plane;
    const double near = PLANE * mesh->size + 2 * mesh->rounding;
    bool plane_is = csg_mesh_plane(mesh, face, &plane);
    for (uint32_t i = face->begin; i < face->end && plane_is; i++)
        plane_is = fabs(csg_dot(plane.normal, corner(mesh, i)) - plane.offset) <= near;
    return plane_is;
}

static bool add_corners(struct csg_mesh *mesh, const uint32_t *corners, uint32_t num)
{
    for (uint32_t i = 0; i < num; i++)
        if (corners[i] != corners[(i + 1) % num] && !csg_array_push(&mesh->corners, corners[i]))
            return false;
    return csg_mesh_close_face(mesh);
}

static bool add_triangles(struct csg_mesh *mesh, struct csg_cutter *cutter, const uint32_t *corners,
                          uint32_t num)
{
    bool ok = csg_cutter_cut(cutter, mesh->points.data, corners, num);
    for (size_t i = 0; i < cutter->num_triangles && ok; i++) {
        const uint32_t *cut = cutter->triangles[i];
        const uint32_t triangle[3] = {corners[cut[0]], corners[cut[1]], corners[cut[2]]};
        ok = add_corners(mesh, triangle, 3);
    }
    return ok;
}

bool csg_mesh_is_bent(const struct csg_mesh *mesh)
{
    for (size_t i = 0; i < mesh->faces.num; i++) {
        const struct csg_mesh_face *face = &mesh->faces.data[i];
        if (face->end - face->begin > 3 && !is_plane(mesh, face))
            return true;
    }
    return false;
}

/* OpenSCAD numbers points as it meets them in the faces. NULL: out of memory. */
static uint32_t *number_points(const struct csg_mesh *mesh, bool reversed)
{
    uint32_t *numbers = malloc((mesh->points.num + 1) * sizeof *numbers), num = 0;
    for (size_t i = 0; i < mesh->points.num && numbers; i++)
        numbers[i] = UINT32_MAX;
    for (size_t i = 0; i < mesh->faces.num && numbers; i++) {
        const struct csg_mesh_face *face = &mesh->faces.data[i];
        for (uint32_t j = face->begin; j < face->end; j++) {
            const uint32_t k = reversed ? face->begin + face->end - 1 - j : j;
            if (numbers[mesh->corners.data[k]] == UINT32_MAX)
                numbers[mesh->corners.data[k]] = num++;
        }
    }
    return numbers;
}

bool csg_mesh_clean(struct csg_mesh *mesh, const struct csg_cut_space *space)
{
    struct csg_mesh clean = {
        .size = mesh->size, .rounding = mesh->rounding, .is_simple = mesh->is_simple};
    uint32_t *numbers = NULL;
    bool ok =
        join_points(mesh) && (numbers = number_points(mesh, csg_cut_space_is_reversed(space)));
    struct csg_cutter cutter = {.space = space, .numbers = numbers};
    clean.points.data = mesh->points.data;
    clean.points.num = mesh->points.num;
    clean.points.capacity = mesh->points.capacity;
    for (size_t i = 0; i < mesh->faces.num && ok; i++) {
        const struct csg_mesh_face *face = &mesh->faces.data[i];
        const uint32_t *corners = &mesh->corners.data[face->begin];
        const uint32_t num = face->end - face->begin;
        ok = num == 3 || is_plane(mesh, face) ? add_corners(&clean, corners, num)
                                              : add_triangles(&clean, &cutter, corners, num);
    }
    clean.num_guessed = cutter.num_guessed;
    csg_cutter_finish(&cutter);
    free(numbers);
    free(mesh->corners.data);
    free(mesh->faces.data);
    *mesh = clean;
    return ok;
}

/* ---- volume and winding ------------------------------------------------------------------- */

double csg_mesh_volume(const struct csg_mesh *mesh)
{
    double sum = 0;
    for (size_t i = 0; i < mesh->faces.num; i++) {
        const struct csg_mesh_face *face = &mesh->faces.data[i];
        const struct csg_vec3 origin = corner(mesh, mesh->faces.data[0].begin);
        const struct csg_vec3 a = csg_sub(corner(mesh, face->begin), origin);
        for (uint32_t j = face->begin + 1; j + 1 < face->end; j++)
            sum += csg_dot(a, csg_cross(csg_sub(corner(mesh, j), origin),
                                        csg_sub(corner(mesh, j + 1), origin)));
    }
    return sum / 6;
}

/* Twice the tangent's angle is the solid angle of the triangle (Van Oosterom and Strackee 1983). */
static double solid_angle(struct csg_vec3 a, struct csg_vec3 b, struct csg_vec3 c)
{
    const double x = csg_length(a), y = csg_length(b), z = csg_length(c);
    const double numerator = csg_dot(a, csg_cross(b, c));
    const double denominator =
        x * y * z + csg_dot(a, b) * z + csg_dot(b, c) * x + csg_dot(c, a) * y;
    return 2 * atan2(numerator, denominator);
}

double csg_mesh_winding(const struct csg_mesh *mesh, struct csg_vec3 p)
{
    double sum = 0;
    for (size_t i = 0; i < mesh->faces.num; i++) {
        const struct csg_mesh_face *face = &mesh->faces.data[i];
        const struct csg_vec3 a = csg_sub(corner(mesh, face->begin), p);
        for (uint32_t j = face->begin + 1; j + 1 < face->end; j++)
            sum += solid_angle(a, csg_sub(corner(mesh, j), p), csg_sub(corner(mesh, j + 1), p));
    }
    return sum / (4 * PI);
}
