/* SPDX-License-Identifier: MIT */
#include "polyhedra/cut.h"

#include <stdlib.h>
#include <string.h>

#include "common/module.h"
#include "tess/module.h"

void csg_cutter_finish(struct csg_cutter *cutter)
{
    free(cutter->triangles);
    free(cutter->corners);
    free(cutter->projected);
    *cutter = (struct csg_cutter){0};
}

static void open_module(struct csg_cutter *cutter)
{
    cutter->was_opened = true;
    cutter->module =
        csg_module_symbol("csgcast-tess.so", "CSGCAST_TESS_MODULE", CSG_TESS_MODULE_NAME);
}

static bool make_room(struct csg_cutter *cutter, size_t num)
{
    if (num <= cutter->room)
        return true;
    free(cutter->triangles);
    free(cutter->corners);
    free(cutter->projected);
    cutter->triangles = malloc(num * sizeof *cutter->triangles);
    cutter->corners = malloc(num * sizeof *cutter->corners);
    cutter->projected = malloc(num * sizeof *cutter->projected);
    cutter->room = num;
    return cutter->triangles && cutter->corners && cutter->projected;
}

/* ---- projection --------------------------------------------------------------------------- */

static int longest_axis(const float v[3])
{
    const int i = fabsf(v[1]) > fabsf(v[0]) ? 1 : 0;
    return fabsf(v[2]) > fabsf(v[i]) ? 2 : i;
}

static int shortest_axis(const float v[3])
{
    const int i = fabsf(v[1]) < fabsf(v[0]) ? 1 : 0;
    return fabsf(v[2]) < fabsf(v[i]) ? 2 : i;
}

static void subtract(const float a[3], const float b[3], float to[3])
{
    for (int k = 0; k < 3; k++)
        to[k] = a[k] - b[k];
}

/* The corners that are furthest apart along an axis. The first of the face is the last that counts,
 * as in libtess2's list; where several are as far it matters. */
static void find_ends(const float (*corners)[3], uint32_t num, const float **lo, const float **hi)
{
    float longest = -1;
    for (int k = 0; k < 3; k++) {
        const float *least = corners[1], *most = corners[1];
        for (uint32_t i = 2; i <= num; i++) {
            const float *corner = corners[i % num];
            if (corner[k] < least[k])
                least = corner;
            if (corner[k] > most[k])
                most = corner;
        }
        if (most[k] - least[k] > longest) {
            longest = most[k] - least[k];
            *lo = least;
            *hi = most;
        }
    }
}

/* That of the largest triangle over the line between these. */
static void find_normal(const float (*corners)[3], uint32_t num, float normal[3])
{
    const float *lo = corners[0], *hi = corners[0];
    float along[3], largest = 0;
    find_ends(corners, num, &lo, &hi);
    subtract(lo, hi, along);
    for (uint32_t i = 1; i <= num; i++) {
        float to[3];
        subtract(corners[i % num], hi, to);
        const float cross[3] = {along[1] * to[2] - along[2] * to[1],
                                along[2] * to[0] - along[0] * to[2],
                                along[0] * to[1] - along[1] * to[0]};
        const float size = cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2];
        if (size > largest) {
            largest = size;
            memcpy(normal, cross, sizeof cross);
        }
    }
    if (largest > 0)
        return;
    normal[0] = normal[1] = normal[2] = 0;
    normal[shortest_axis(along)] = 1;
}

/* Leaves the axis out, so that the corners run counter-clockwise. */
static void project(struct csg_cutter *cutter, uint32_t num)
{
    float normal[3], area = 0;
    find_normal((const float(*)[3])cutter->corners, num, normal);
    const int axis = longest_axis(normal);
    const float sign = normal[axis] > 0 ? 1 : -1;
    for (uint32_t i = 0; i < num; i++) {
        cutter->projected[i][0] = cutter->corners[i][(axis + 1) % 3];
        cutter->projected[i][1] = sign * cutter->corners[i][(axis + 2) % 3];
    }
    for (uint32_t i = 0; i < num; i++) {
        const float *a = cutter->projected[i], *b = cutter->projected[(i + 1) % num];
        area += (a[0] - b[0]) * (a[1] + b[1]);
    }
    for (uint32_t i = 0; i < num && area < 0; i++)
        cutter->projected[i][1] *= -1;
}

/* ---- cutting ------------------------------------------------------------------------------ */

static float squared_distance(const float a[3], const float b[3])
{
    float to[3];
    subtract(a, b, to);
    return to[0] * to[0] + to[1] * to[1] + to[2] * to[2];
}

static void fan(struct csg_cutter *cutter, uint32_t first, uint32_t num)
{
    cutter->num_triangles = num - 2;
    for (uint32_t i = 0; i + 2 < num; i++) {
        cutter->triangles[i][0] = first;
        cutter->triangles[i][1] = (first + i + 1) % num;
        cutter->triangles[i][2] = (first + i + 2) % num;
    }
}

static void guess(struct csg_cutter *cutter, uint32_t num)
{
    const float(*p)[3] = (const float(*)[3])cutter->corners;
    const bool is_other = num == 4 && squared_distance(p[3], p[1]) < squared_distance(p[2], p[0]);
    cutter->num_guessed++;
    fan(cutter, is_other, num);
}

/* The diagonal leaves out the corner that is cut off. */
static void cut_crossed(struct csg_cutter *cutter, const uint32_t *face, bool reversed)
{
    uint32_t numbers[4];
    for (int i = 0; i < 4; i++)
        numbers[i] = cutter->numbers[face[reversed ? 3 - i : i]];
    fan(cutter, csg_crossed_corner(numbers) % 2 == 0, 4);
}

/* Where two of four corners are projected to one place the sweep leaves one triangle out. */
static void add_missing(struct csg_cutter *cutter)
{
    const uint32_t *found = cutter->triangles[0];
    const uint32_t missing = 6 - found[0] - found[1] - found[2];
    cutter->triangles[1][0] = (missing + 3) % 4;
    cutter->triangles[1][1] = missing;
    cutter->triangles[1][2] = (missing + 1) % 4;
    cutter->num_triangles = 2;
}

/* A map that mirrors turns faces over in OpenSCAD, so that they look outwards. */
bool csg_cut_space_is_reversed(const struct csg_cut_space *space)
{
    return space && space->reversed != (csg_map_determinant(&space->map) < 0);
}

/* PolySet::quantizeVertices(). Places nearer than a step to one that was there before are moved to
 * that one; here they are not. */
static double on_grid(double x)
{
    const double steps = 1 << 20;
    return trunc(x * steps) / steps;
}

static void take_corners(struct csg_cutter *cutter, const struct csg_vec3 *points,
                         const uint32_t *face, uint32_t num, bool reversed)
{
    for (uint32_t i = 0; i < num; i++) {
        struct csg_vec3 p = points[face[reversed ? num - 1 - i : i]];
        if (cutter->space)
            p = csg_map_point(&cutter->space->map, p);
        if (cutter->space && cutter->space->on_grid)
            p = csg_vec3(on_grid(p.x), on_grid(p.y), on_grid(p.z));
        cutter->corners[i][0] = (float)p.x;
        cutter->corners[i][1] = (float)p.y;
        cutter->corners[i][2] = (float)p.z;
    }
}

/* Back to the face's own order. */
static void reverse_triangles(struct csg_cutter *cutter, uint32_t num)
{
    for (size_t i = 0; i < cutter->num_triangles; i++) {
        uint32_t *triangle = cutter->triangles[i];
        const uint32_t first = triangle[0];
        triangle[0] = num - 1 - triangle[2];
        triangle[1] = num - 1 - triangle[1];
        triangle[2] = num - 1 - first;
    }
}

bool csg_cutter_cut(struct csg_cutter *cutter, const struct csg_vec3 *points, const uint32_t *face,
                    uint32_t num)
{
    const bool reversed = csg_cut_space_is_reversed(cutter->space);
    bool ok = make_room(cutter, num);
    if (!cutter->was_opened)
        open_module(cutter);
    if (!ok)
        return false;
    take_corners(cutter, points, face, num, reversed);
    project(cutter, num);
    const float(*projected)[2] = (const float(*)[2])cutter->projected;
    cutter->num_triangles =
        cutter->module ? cutter->module->sweep(projected, num, cutter->triangles) : 0;
    if (num == 4 && cutter->num_triangles == 1)
        add_missing(cutter);
    else if (cutter->num_triangles + 2 == num)
        ok = csg_flip_edges(projected, cutter->triangles, cutter->num_triangles);
    else if (num == 4 && cutter->module && cutter->numbers)
        cut_crossed(cutter, face, reversed);
    else
        guess(cutter, num);
    if (reversed)
        reverse_triangles(cutter, num);
    return ok;
}
