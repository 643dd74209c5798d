/* SPDX-License-Identifier: MIT */
#include "polyhedra/hull.h"

#include <stdio.h>
#include <stdlib.h>

#include "mesh/surface.h"

#ifdef CSGCAST_QHULL

#include <libqhull_r/libqhull_r.h>

/* Called for each facet: its unit normal points outwards, dot(normal, x) + offset = 0 on it. */
typedef bool facet_fn(void *user, qhT *qh, const facetT *facet);

static bool visit_facets(qhT *qh, facet_fn *fn, void *user)
{
    const facetT *facet;
    FORALLfacets
    {
        if (!fn(user, qh, facet))
            return false;
    }
    return true;
}

static struct csg_vec3 normal_of(const facetT *facet)
{
    return csg_vec3(facet->normal[0], facet->normal[1], facet->normal[2]);
}

/* Qhull takes any number for a coordinate, but only these are safe. */
#define MAX_COORDINATE 1e100

static bool is_valid(const struct csg_points *points)
{
    bool valid = true;
    for (size_t i = 0; i < points->points.num; i++) {
        const struct csg_vec3 p = points->points.data[i];
        valid &=
            fabs(p.x) < MAX_COORDINATE && fabs(p.y) < MAX_COORDINATE && fabs(p.z) < MAX_COORDINATE;
    }
    return valid;
}

/* Qhull wants its own copy of the points and a file for its complaints, which nobody reads: what it
 * refuses is flat. */
static enum csg_hull_result run(const struct csg_points *points, facet_fn *fn, void *user)
{
    static char options[] = "qhull Pp";
    const size_t num = points->points.num;
    enum csg_hull_result result = CSG_HULL_NO_MEMORY;
    char *complaints = NULL;
    size_t complaints_size = 0;
    if (num < 4 || !is_valid(points))
        return CSG_HULL_FLAT;
    coordT *coordinates = malloc(3 * num * sizeof *coordinates);
    qhT *qh = calloc(1, sizeof *qh);
    FILE *file = open_memstream(&complaints, &complaints_size);
    for (size_t i = 0; i < num && coordinates; i++) {
        coordinates[3 * i] = points->points.data[i].x;
        coordinates[3 * i + 1] = points->points.data[i].y;
        coordinates[3 * i + 2] = points->points.data[i].z;
    }
    if (coordinates && qh && file) {
        int current, total;
        qh_zero(qh, file);
        const int error = qh_new_qhull(qh, 3, (int)num, coordinates, False, options, file, file);
        if (error)
            result = error == qh_ERRmem ? CSG_HULL_NO_MEMORY : CSG_HULL_FLAT;
        else
            result = visit_facets(qh, fn, user) ? CSG_HULL_DONE : CSG_HULL_NO_MEMORY;
        qh_freeqhull(qh, !qh_ALL);
        qh_memfreeshort(qh, &current, &total);
    }
    if (file)
        fclose(file);
    free(complaints);
    free(coordinates);
    free(qh);
    return result;
}

struct hull {
    struct csg_shape *shape;
    struct csg_vec3 center;
};

/* Relative to the middle of the points. Qhull has merged the facets that lie on one plane. */
static bool add_facet(void *user, qhT *qh, const facetT *facet)
{
    const struct hull *hull = user;
    const struct csg_vec3 normal = normal_of(facet);
    (void)qh;
    return csg_shape_add_plane(hull->shape, normal, -facet->offset + csg_dot(normal, hull->center));
}

enum csg_hull_result csg_hull_fill(struct csg_shape *shape, const struct csg_points *points)
{
    struct csg_points moved = {0};
    struct csg_box box = csg_box_empty;
    enum csg_hull_result result = CSG_HULL_DONE;
    for (size_t i = 0; i < points->points.num; i++)
        csg_box_extend(&box, points->points.data[i]);
    const struct csg_vec3 center = csg_box_middle(&box);
    struct hull hull = {shape, center};
    for (size_t i = 0; i < points->points.num && result == CSG_HULL_DONE; i++)
        if (!csg_array_push(&moved.points, csg_sub(points->points.data[i], center)))
            result = CSG_HULL_NO_MEMORY;
    if (result == CSG_HULL_DONE)
        result = run(&moved, add_facet, &hull);
    free(moved.points.data);
    shape->convex = true;
    shape->bounds = shape->written = box;
    return result;
}

struct visit {
    CSG_ARRAY(size_t) corners;
    csg_hull_face_fn *fn;
    void *user;
};

static bool visit_face(void *user, qhT *qh, const facetT *facet)
{
    struct visit *visit = user;
    vertexT *vertex, **vertexp;
    visit->corners.num = 0;
    FOREACHvertex_(facet->vertices)
    {
        if (!csg_array_push(&visit->corners, (size_t)qh_pointid(qh, vertex->point)))
            return false;
    }
    return visit->fn(visit->user, visit->corners.data, visit->corners.num);
}

enum csg_hull_result csg_hull_visit(const struct csg_points *points, csg_hull_face_fn *fn,
                                    void *user)
{
    struct visit visit = {.fn = fn, .user = user};
    const enum csg_hull_result result = run(points, visit_face, &visit);
    free(visit.corners.data);
    return result;
}

/* ---- corners ------------------------------------------------------------------------------ */

struct dual {
    struct csg_vec3 center, scale; /* lengths along each axis are in units of these */
    struct csg_points *corners;    /* of the shape, */
    struct csg_points *faces;      /* or of each of its planes */
};

static struct csg_vec3 scaled(const struct dual *dual, struct csg_vec3 v)
{
    return csg_vec3(dual->scale.x * v.x, dual->scale.y * v.y, dual->scale.z * v.z);
}

/* A facet n.q = -offset of the dual points is the corner center - n / offset. */
static struct csg_vec3 corner_of(const struct dual *dual, const facetT *facet)
{
    return csg_sub(dual->center, scaled(dual, csg_scale(1 / facet->offset, normal_of(facet))));
}

static bool add_corner(void *user, qhT *qh, const facetT *facet)
{
    const struct dual *dual = user;
    (void)qh;
    return csg_array_push(&dual->corners->points, corner_of(dual, facet));
}

/* The facet's corners are the planes that meet at this one. */
static bool add_to_faces(void *user, qhT *qh, const facetT *facet)
{
    const struct dual *dual = user;
    const struct csg_vec3 corner = corner_of(dual, facet);
    vertexT *vertex, **vertexp;
    FOREACHvertex_(facet->vertices)
    {
        if (!csg_array_push(&dual->faces[qh_pointid(qh, vertex->point)].points, corner))
            return false;
    }
    return true;
}

static double positive(double x)
{
    return x > 0 ? x : 1;
}

/* Planes n.x = d, seen from a point inside, are dual to the points n / d, and their hull's facets
 * to the corners. Of a thin solid these points lie very far apart, but not of one that is scaled to
 * be as long along each axis. */
static enum csg_hull_result run_dual(const struct csg_shape *shape, facet_fn *fn, struct dual *dual)
{
    const struct csg_vec3 middle = csg_box_middle(&shape->bounds);
    const struct csg_box box = csg_box_map(&shape->frame, &shape->bounds);
    const struct csg_vec3 size = csg_sub(box.hi, box.lo);
    struct csg_points normals = {0};
    enum csg_hull_result result = CSG_HULL_DONE;
    dual->center = csg_map_point(&shape->frame, middle);
    dual->scale = csg_vec3(positive(size.x), positive(size.y), positive(size.z));
    for (size_t i = 0; i < shape->num_planes && result == CSG_HULL_DONE; i++) {
        const struct csg_plane *plane = &shape->planes[i];
        const double d = plane->offset - csg_dot(plane->normal, dual->center);
        if (!(d > 0))
            result = CSG_HULL_FLAT; /* the middle is not inside */
        else if (!csg_array_push(&normals.points, csg_scale(1 / d, scaled(dual, plane->normal))))
            result = CSG_HULL_NO_MEMORY;
    }
    if (result == CSG_HULL_DONE)
        result = run(&normals, fn, dual);
    free(normals.points.data);
    return result;
}

static enum csg_hull_result dual_corners(const struct csg_shape *shape, struct csg_points *points)
{
    return run_dual(shape, add_corner, &(struct dual){.corners = points});
}

static enum csg_hull_result dual_faces(const struct csg_shape *shape, struct csg_points *faces)
{
    return run_dual(shape, add_to_faces, &(struct dual){.faces = faces});
}

#else

enum csg_hull_result csg_hull_fill(struct csg_shape *shape, const struct csg_points *points)
{
    (void)shape;
    (void)points;
    return CSG_HULL_MISSING;
}

enum csg_hull_result csg_hull_visit(const struct csg_points *points, csg_hull_face_fn *fn,
                                    void *user)
{
    (void)points;
    (void)fn;
    (void)user;
    return CSG_HULL_MISSING;
}

static enum csg_hull_result dual_corners(const struct csg_shape *shape, struct csg_points *points)
{
    (void)shape;
    (void)points;
    return CSG_HULL_FLAT;
}

static enum csg_hull_result dual_faces(const struct csg_shape *shape, struct csg_points *faces)
{
    (void)shape;
    (void)faces;
    return CSG_HULL_FLAT;
}

#endif

static int compare_x(const void *a, const void *b)
{
    const struct csg_vec3 *p = a, *q = b;
    return p->x < q->x ? -1 : p->x > q->x;
}

void csg_corners_sort(struct csg_vec3 *corners, size_t num)
{
    if (num > 0)
        qsort(corners, num, sizeof *corners, compare_x);
}

bool csg_corners_have(const struct csg_vec3 *corners, size_t num, struct csg_vec3 p, double near)
{
    for (size_t i = num; i > 0 && p.x - corners[i - 1].x <= near; i--)
        if (csg_length(csg_sub(corners[i - 1], p)) <= near)
            return true;
    return false;
}

/* What counts as one place: some bits more than clipping loses. */
static double near_of(const struct csg_shape *shape)
{
    const struct csg_box box = csg_box_map(&shape->frame, &shape->bounds);
    return 1e-12 * (csg_length(box.lo) + csg_length(box.hi));
}

/* Each of a cell's corners is in three faces or more. */
static void keep_once(struct csg_points *points, size_t begin, double near)
{
    struct csg_vec3 *corners = points->points.data + begin;
    const size_t num = points->points.num - begin;
    size_t kept = 0;
    csg_corners_sort(corners, num);
    for (size_t i = 0; i < num; i++)
        if (!csg_corners_have(corners, kept, corners[i], near))
            corners[kept++] = corners[i];
    points->points.num = begin + kept;
}

static enum csg_hull_result cut_corners(const struct csg_shape *shape, struct csg_points *points)
{
    const size_t begin = points->points.num;
    struct csg_cell cell = {0};
    bool ok = csg_cell_from_shape(&cell, shape);
    for (size_t i = 0; i < cell.faces.num && ok; i++)
        for (size_t j = 0; j < cell.faces.data[i].points.num && ok; j++)
            ok = csg_array_push(&points->points, cell.faces.data[i].points.data[j]);
    csg_cell_finish(&cell);
    if (ok && points->points.num > begin)
        keep_once(points, begin, near_of(shape));
    return ok ? CSG_HULL_DONE : CSG_HULL_NO_MEMORY;
}

static enum csg_hull_result surface_points(const struct csg_shape *shape, struct csg_points *points)
{
    bool ok = true;
    for (size_t i = 0; i < shape->surface->points.num && ok; i++)
        ok = csg_array_push(&points->points,
                            csg_map_point(&shape->frame, shape->surface->points.data[i]));
    return ok ? CSG_HULL_DONE : CSG_HULL_NO_MEMORY;
}

enum csg_hull_result csg_shape_corners(const struct csg_shape *shape, struct csg_points *points)
{
    if (shape->surface)
        return surface_points(shape, points);
    if (shape->num_planes > CSG_HULL_MAX_CUT_PLANES) {
        const enum csg_hull_result result = dual_corners(shape, points);
        if (result != CSG_HULL_FLAT)
            return result;
    }
    return cut_corners(shape, points);
}

/* A plane that has none of the corners has no face. */
static bool add_faces(const struct csg_shape *shape, const struct csg_points *faces,
                      struct csg_cell *cell)
{
    const double near = near_of(shape);
    bool ok = true;
    for (size_t i = 0; i < shape->num_planes && ok; i++)
        ok = csg_cell_add_face(cell, &shape->planes[i], faces[i].points.data, faces[i].points.num,
                               near);
    return ok;
}

enum csg_hull_result csg_shape_cell(const struct csg_shape *shape, struct csg_cell *cell)
{
    const bool is_large = shape->num_planes > CSG_HULL_MAX_CUT_PLANES;
    struct csg_points *faces = is_large ? calloc(shape->num_planes, sizeof *faces) : NULL;
    enum csg_hull_result result = faces      ? dual_faces(shape, faces)
                                  : is_large ? CSG_HULL_NO_MEMORY
                                             : CSG_HULL_FLAT;
    if (result == CSG_HULL_DONE && !add_faces(shape, faces, cell))
        result = CSG_HULL_NO_MEMORY;
    for (size_t i = 0; i < shape->num_planes && faces; i++)
        free(faces[i].points.data);
    free(faces);
    if (result == CSG_HULL_FLAT)
        result = csg_cell_from_shape(cell, shape) ? CSG_HULL_DONE : CSG_HULL_NO_MEMORY;
    return result;
}
