/* SPDX-License-Identifier: MIT */
#include "polyhedra/cell.h"

#include <stdlib.h>

void csg_polygon_finish(struct csg_polygon *polygon)
{
    free(polygon->points.data);
    *polygon = (struct csg_polygon){0};
}

static double distance(const struct csg_plane *plane, struct csg_vec3 p)
{
    return csg_dot(plane->normal, p) - plane->offset;
}

void csg_polygon_range(const struct csg_polygon *polygon, const struct csg_plane *plane, double *lo,
                       double *hi)
{
    for (size_t i = 0; i < polygon->points.num; i++) {
        const double d = distance(plane, polygon->points.data[i]);
        *lo = fmin(*lo, d);
        *hi = fmax(*hi, d);
    }
}

static struct csg_vec3 between(struct csg_vec3 a, double da, struct csg_vec3 b, double db)
{
    return csg_add(a, csg_scale(da / (da - db), csg_sub(b, a)));
}

static bool push(struct csg_polygon *polygon, struct csg_vec3 p)
{
    return csg_array_push(&polygon->points, p);
}

bool csg_polygon_split(const struct csg_polygon *polygon, const struct csg_plane *plane,
                       double near, struct csg_polygon *below, struct csg_polygon *above)
{
    double lo = INFINITY, hi = -INFINITY;
    bool ok = true;
    csg_polygon_range(polygon, plane, &lo, &hi);
    below->plane = above->plane = polygon->plane;
    const bool has_below = lo<-near, has_above = hi> near;
    for (size_t i = 0; i < polygon->points.num && ok; i++) {
        const struct csg_vec3 a = polygon->points.data[i];
        const struct csg_vec3 b = polygon->points.data[(i + 1) % polygon->points.num];
        const double da = distance(plane, a), db = distance(plane, b);
        if (has_below && (da <= near || !has_above))
            ok = push(below, a);
        if (ok && has_above && (da >= -near || !has_below))
            ok = push(above, a);
        if (has_below && has_above && ((da < -near && db > near) || (da > near && db < -near))) {
            const struct csg_vec3 p = between(a, da, b, db);
            ok = ok && push(below, p) && push(above, p);
        }
    }
    return ok;
}

/* ---- cells -------------------------------------------------------------------------------- */

void csg_cell_finish(struct csg_cell *cell)
{
    for (size_t i = 0; i < cell->faces.num; i++)
        csg_polygon_finish(&cell->faces.data[i]);
    free(cell->faces.data);
    *cell = (struct csg_cell){0};
}

bool csg_cell_from_box(struct csg_cell *cell, const struct csg_box *box)
{
    /* Corners as csg_box_corner counts them, counter-clockwise from outside. */
    static const int corners[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                      {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    const double lo[3] = {box->lo.x, box->lo.y, box->lo.z};
    const double hi[3] = {box->hi.x, box->hi.y, box->hi.z};
    for (int i = 0; i < 6; i++) {
        struct csg_polygon polygon = {0};
        const double sign = i % 2 ? 1 : -1;
        const int axis = i / 2;
        polygon.plane.normal =
            csg_vec3(axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0);
        polygon.plane.offset = i % 2 ? hi[axis] : -lo[axis];
        bool ok = true;
        for (int j = 0; j < 4 && ok; j++)
            ok = push(&polygon, csg_box_corner(box, corners[i][j]));
        if (!ok || !csg_array_push(&cell->faces, polygon)) {
            csg_polygon_finish(&polygon);
            return false;
        }
    }
    return true;
}

void csg_cell_range(const struct csg_cell *cell, const struct csg_plane *plane, double *lo,
                    double *hi)
{
    *lo = INFINITY;
    *hi = -INFINITY;
    for (size_t i = 0; i < cell->faces.num; i++)
        csg_polygon_range(&cell->faces.data[i], plane, lo, hi);
}

static bool keep(struct csg_cell *cell, struct csg_polygon *polygon)
{
    if (polygon->points.num >= 3 && csg_array_push(&cell->faces, *polygon))
        return true;
    const bool is_flat = polygon->points.num < 3;
    csg_polygon_finish(polygon);
    return is_flat;
}

struct cap_point {
    double angle;
    struct csg_vec3 p;
};

static int compare_cap(const void *a, const void *b)
{
    const struct cap_point *x = a, *y = b;
    return x->angle < y->angle ? -1 : x->angle > y->angle;
}

struct cap {
    CSG_ARRAY(struct cap_point) points;
};

/* Where the faces of a side touch the plane. */
static bool collect_cap(const struct csg_cell *side, const struct csg_plane *plane, double near,
                        struct cap *cap)
{
    for (size_t i = 0; i < side->faces.num; i++)
        for (size_t j = 0; j < side->faces.data[i].points.num; j++) {
            const struct csg_vec3 p = side->faces.data[i].points.data[j];
            if (fabs(distance(plane, p)) <= near &&
                !csg_array_push(&cap->points, ((struct cap_point){0, p})))
                return false;
        }
    return true;
}

/* In the order of their angles about the middle, seen against the plane's normal. */
static void sort_cap(struct cap *cap, const struct csg_plane *plane)
{
    struct csg_vec3 center = {0, 0, 0};
    const struct csg_vec3 n = plane->normal;
    const struct csg_vec3 other = fabs(n.x) < 0.6 ? csg_vec3(1, 0, 0) : csg_vec3(0, 1, 0);
    const struct csg_vec3 u = csg_normalize(csg_cross(n, other)), v = csg_cross(n, u);
    for (size_t i = 0; i < cap->points.num; i++)
        center = csg_add(center, csg_scale(1.0 / (double)cap->points.num, cap->points.data[i].p));
    for (size_t i = 0; i < cap->points.num; i++) {
        const struct csg_vec3 d = csg_sub(cap->points.data[i].p, center);
        cap->points.data[i].angle = atan2(csg_dot(d, v), csg_dot(d, u));
    }
    if (cap->points.num)
        qsort(cap->points.data, cap->points.num, sizeof *cap->points.data, compare_cap);
}

/* Each corner of a cap comes from two faces: once is enough. */
static bool add_cap(struct csg_cell *cell, const struct cap *cap, struct csg_plane plane, bool flip,
                    double near)
{
    struct csg_polygon polygon = {.plane = plane};
    bool ok = true;
    if (flip)
        polygon.plane = (struct csg_plane){csg_scale(-1, plane.normal), -plane.offset};
    for (size_t i = 0; i < cap->points.num && ok; i++) {
        const size_t k = flip ? cap->points.num - 1 - i : i;
        const struct csg_vec3 p = cap->points.data[k].p;
        const size_t num = polygon.points.num;
        if (num == 0 || (csg_length(csg_sub(p, polygon.points.data[num - 1])) > 2 * near &&
                         csg_length(csg_sub(p, polygon.points.data[0])) > 2 * near))
            ok = push(&polygon, p);
    }
    if (!ok)
        csg_polygon_finish(&polygon);
    return ok && keep(cell, &polygon);
}

bool csg_cell_split(const struct csg_cell *cell, const struct csg_plane *plane, double near,
                    struct csg_cell *below, struct csg_cell *above)
{
    struct cap cap = {0};
    bool ok = true;
    for (size_t i = 0; i < cell->faces.num && ok; i++) {
        struct csg_polygon low = {0}, high = {0};
        ok = csg_polygon_split(&cell->faces.data[i], plane, near, &low, &high);
        const bool kept = keep(below, &low);
        ok = keep(above, &high) && kept && ok;
    }
    ok = ok && collect_cap(below, plane, near, &cap);
    if (ok) {
        sort_cap(&cap, plane);
        ok = add_cap(below, &cap, *plane, false, near) && add_cap(above, &cap, *plane, true, near);
    }
    free(cap.points.data);
    return ok;
}

bool csg_cell_add_face(struct csg_cell *cell, const struct csg_plane *plane,
                       const struct csg_vec3 *points, size_t num, double near)
{
    struct cap cap = {0};
    bool ok = true;
    for (size_t i = 0; i < num && ok; i++)
        ok = csg_array_push(&cap.points, ((struct cap_point){0, points[i]}));
    if (ok) {
        sort_cap(&cap, plane);
        ok = add_cap(cell, &cap, *plane, false, near);
    }
    free(cap.points.data);
    return ok;
}

static void drop_face(struct csg_cell *cell, size_t i)
{
    csg_polygon_finish(&cell->faces.data[i]);
    cell->faces.data[i] = cell->faces.data[--cell->faces.num];
}

static bool collect_polygon(const struct csg_polygon *polygon, struct cap *cap)
{
    bool ok = true;
    for (size_t i = 0; i < polygon->points.num && ok; i++)
        ok = csg_array_push(&cap->points, ((struct cap_point){0, polygon->points.data[i]}));
    return ok;
}

/* The cell's face on that plane, which looks to the same side; the number of faces: none. */
static size_t find_face(const struct csg_cell *cell, const struct csg_plane *plane, double near)
{
    size_t i = 0;
    for (; i < cell->faces.num; i++) {
        const struct csg_polygon *face = &cell->faces.data[i];
        double lo = INFINITY, hi = -INFINITY;
        csg_polygon_range(face, plane, &lo, &hi);
        if (csg_dot(face->plane.normal, plane->normal) > 0 && lo >= -near && hi <= near)
            break;
    }
    return i;
}

/* Takes the polygon over: it becomes a face, or a part of the one on its plane. */
static bool add_face(struct csg_cell *cell, struct csg_polygon *polygon, double near)
{
    const size_t same = find_face(cell, &polygon->plane, near);
    struct cap cap = {0};
    if (same == cell->faces.num)
        return keep(cell, polygon);
    bool ok = collect_polygon(&cell->faces.data[same], &cap) && collect_polygon(polygon, &cap);
    if (ok) {
        sort_cap(&cap, &polygon->plane);
        drop_face(cell, same);
        ok = add_cap(cell, &cap, polygon->plane, false, near);
    }
    free(cap.points.data);
    csg_polygon_finish(polygon);
    return ok;
}

bool csg_cell_join(struct csg_cell *a, size_t i, struct csg_cell *b, size_t j, double near)
{
    bool ok = true;
    drop_face(a, i);
    drop_face(b, j);
    for (size_t k = 0; k < b->faces.num; k++)
        ok = add_face(a, &b->faces.data[k], near) && ok;
    b->faces.num = 0;
    csg_cell_finish(b);
    return ok;
}

bool csg_cell_clip(struct csg_cell *cell, const struct csg_plane *plane, double near)
{
    struct csg_cell below = {0}, above = {0};
    double lo, hi;
    csg_cell_range(cell, plane, &lo, &hi);
    if (hi <= near)
        return true;
    const bool ok = lo >= -near || csg_cell_split(cell, plane, near, &below, &above);
    csg_cell_finish(cell);
    csg_cell_finish(&above);
    *cell = below;
    return ok;
}

struct csg_vec3 csg_cell_center(const struct csg_cell *cell)
{
    struct csg_vec3 sum = {0, 0, 0};
    size_t num = 0;
    for (size_t i = 0; i < cell->faces.num; i++)
        for (size_t j = 0; j < cell->faces.data[i].points.num; j++, num++)
            sum = csg_add(sum, cell->faces.data[i].points.data[j]);
    return csg_scale(1.0 / (double)(num ? num : 1), sum);
}

struct csg_box csg_cell_box(const struct csg_cell *cell)
{
    struct csg_box box = csg_box_empty;
    for (size_t i = 0; i < cell->faces.num; i++)
        for (size_t j = 0; j < cell->faces.data[i].points.num; j++)
            csg_box_extend(&box, cell->faces.data[i].points.data[j]);
    return box;
}

bool csg_cell_from_shape(struct csg_cell *cell, const struct csg_shape *shape)
{
    struct csg_box box = csg_box_map(&shape->frame, &shape->bounds);
    const struct csg_vec3 size = csg_sub(box.hi, box.lo);
    const double near = 1e-12 * (csg_length(box.lo) + csg_length(box.hi));
    box.lo = csg_sub(box.lo, csg_scale(0.5, size));
    box.hi = csg_add(box.hi, csg_scale(0.5, size));
    bool ok = csg_cell_from_box(cell, &box);
    for (size_t i = 0; i < shape->num_planes && ok; i++)
        ok = csg_cell_clip(cell, &shape->planes[i], near);
    return ok;
}
