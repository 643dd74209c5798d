/* SPDX-License-Identifier: MIT */
#include "carrier/overlaps.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "common/parallel.h"
#include "solids/shape.h"

/* Nodes of the hierarchy that one core looks at, at a time. */
enum { CHUNK = 1024 };

/* Pairs that are compared, for each triangle, before all faces are taken for near: they take less
 * time than looking a face up does. Well-formed meshes have 15 to 25. */
enum { MAX_PAIRS = 48 };

struct marks {
    CSG_ARRAY(uint32_t) planes;
    bool is_out_of_memory;
};

struct search {
    const struct csg_surface *surface;
    double tolerance;
    struct marks *marks; /* by chunk */
    atomic_size_t num_pairs;
    size_t max_pairs;
};

/* Whether the planes of two faces are within the tolerance of each other over the smaller face. */
static bool are_near(const struct search *search, uint32_t a, uint32_t b)
{
    const struct csg_surface *surface = search->surface;
    const struct csg_plane *p = &surface->planes.data[a], *q = &surface->planes.data[b];
    const struct csg_surface_extent *of =
        &surface->extents[surface->extents[a].radius < surface->extents[b].radius ? a : b];
    const double s = csg_dot(p->normal, q->normal) < 0 ? -1 : 1;
    const struct csg_vec3 turn = csg_sub(p->normal, csg_scale(s, q->normal));
    const double tolerance = search->tolerance;
    return csg_dot(turn, turn) * of->radius * of->radius <= tolerance * tolerance &&
           fabs(csg_dot(turn, of->center) - (p->offset - s * q->offset)) <= tolerance;
}

/* ---- in the plane ------------------------------------------------------------------------- */

/* A triangle's corners without their coordinate along the normal's largest component. */
static void flatten(const struct csg_surface *surface, const struct csg_triangle *triangle,
                    struct csg_vec3 normal, double flat[3][2])
{
    const double x = fabs(normal.x), y = fabs(normal.y), z = fabs(normal.z);
    for (int i = 0; i < 3; i++) {
        const struct csg_vec3 p = surface->points.data[triangle->points[i]];
        const bool along_x = x >= y && x >= z, along_y = !along_x && y >= z;
        flat[i][0] = along_x ? p.y : p.x;
        flat[i][1] = along_x || along_y ? p.z : p.y;
    }
}

/* Positive where c is to the left of the line from a to b; exactly 0 where it is one of them. */
static double side_of(const double a[2], const double b[2], const double c[2])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* Whether all of b is beyond an edge of a, or upon it. Of a triangle without area nobody can
 * tell. */
static bool is_beyond(double (*a)[2], double (*b)[2])
{
    const double area = side_of(a[0], a[1], a[2]);
    for (int i = 0; i < 3 && area != 0; i++) {
        double *from = a[i], *to = a[(i + 1) % 3];
        if (area < 0) {
            from = a[(i + 1) % 3];
            to = a[i];
        }
        if (side_of(from, to, b[0]) <= 0 && side_of(from, to, b[1]) <= 0 &&
            side_of(from, to, b[2]) <= 0)
            return true;
    }
    return false;
}

static bool overlap(const struct csg_surface *surface, const struct csg_triangle *a,
                    const struct csg_triangle *b)
{
    const struct csg_vec3 normal = surface->planes.data[a->plane].normal;
    double p[3][2], q[3][2];
    flatten(surface, a, normal, p);
    flatten(surface, b, normal, q);
    return !is_beyond(p, q) && !is_beyond(q, p);
}

/* ---- pairs -------------------------------------------------------------------------------- */

static void compare(const struct search *search, uint32_t i, uint32_t j, struct marks *marks)
{
    const struct csg_surface *surface = search->surface;
    const struct csg_triangle *a = &surface->triangles.data[i], *b = &surface->triangles.data[j];
    if (a->plane == b->plane || !are_near(search, a->plane, b->plane) || !overlap(surface, a, b))
        return;
    marks->is_out_of_memory |=
        !csg_array_push(&marks->planes, a->plane) || !csg_array_push(&marks->planes, b->plane);
}

static void compare_within(const struct search *search, const struct csg_box_node *node,
                           struct marks *marks)
{
    for (uint32_t i = node->first; i < node->first + node->num; i++)
        for (uint32_t j = i + 1; j < node->first + node->num; j++)
            compare(search, i, j, marks);
}

static void compare_nodes(const struct search *search, const struct csg_box_node *a,
                          const struct csg_box_node *b, struct marks *marks)
{
    for (uint32_t i = a->first; i < a->first + a->num; i++)
        for (uint32_t j = b->first; j < b->first + b->num; j++)
            compare(search, i, j, marks);
}

/* A leaf of the hierarchy with itself and those behind it. */
static void look_at(struct search *search, uint32_t leaf, struct marks *marks)
{
    const struct csg_box_node *nodes = search->surface->nodes.data;
    const struct csg_box box = csg_box_grown(&nodes[leaf].box, search->tolerance);
    size_t num_pairs = 0;
    compare_within(search, &nodes[leaf], marks);
    for (size_t i = leaf + 1; i < search->surface->nodes.num;) {
        if (!csg_box_overlaps(&nodes[i].box, &box)) {
            i = nodes[i].end;
            continue;
        }
        compare_nodes(search, &nodes[leaf], &nodes[i], marks);
        num_pairs += (size_t)nodes[leaf].num * nodes[i].num;
        i++;
    }
    atomic_fetch_add(&search->num_pairs, num_pairs);
}

static void look_at_chunk(void *user, size_t chunk)
{
    struct search *search = user;
    const size_t num = search->surface->nodes.num;
    for (size_t i = CHUNK * chunk; i < CHUNK * (chunk + 1) && i < num; i++)
        if (search->surface->nodes.data[i].num &&
            atomic_load(&search->num_pairs) <= search->max_pairs)
            look_at(search, (uint32_t)i, &search->marks[chunk]);
}

/* ---- all ---------------------------------------------------------------------------------- */

static bool take_marks(struct search *search, size_t num_chunks, uint8_t *near)
{
    const bool gave_up = search->num_pairs > search->max_pairs;
    bool ok = true;
    memset(near, gave_up, search->surface->planes.num);
    for (size_t i = 0; i < num_chunks; i++) {
        const struct marks *marks = &search->marks[i];
        ok &= !marks->is_out_of_memory;
        for (size_t j = 0; j < marks->planes.num; j++)
            near[marks->planes.data[j]] = 1;
        free(marks->planes.data);
    }
    return ok;
}

bool csg_overlaps_find(const struct csg_surface *surface, double tolerance, int num_threads,
                       uint8_t *near)
{
    const size_t num_chunks = (surface->nodes.num + CHUNK - 1) / CHUNK;
    struct search search = {.surface = surface,
                            .tolerance = tolerance,
                            .marks = calloc(num_chunks + 1, sizeof *search.marks),
                            .max_pairs = MAX_PAIRS * surface->triangles.num};
    if (!search.marks)
        return false;
    csg_parallel(num_threads, num_chunks, look_at_chunk, &search);
    const bool ok = take_marks(&search, num_chunks, near);
    free(search.marks);
    return ok;
}
