/* SPDX-License-Identifier: MIT */
#include "polyhedra/clusters.h"

#include <stdlib.h>

void csg_clusters_finish(struct csg_clusters *clusters)
{
    free(clusters->corners.points.data);
    free(clusters->ends.data);
    *clusters = (struct csg_clusters){0};
}

/* A point of two faces lies on an edge, where a cell that was joined to this one had a corner. What
 * is that much further off counts as on a face: a point that is kept in vain does no harm. */
static bool is_corner(const struct csg_cell *cell, struct csg_vec3 p, double near)
{
    int num = 0;
    for (size_t i = 0; i < cell->faces.num && num < 3; i++) {
        const struct csg_plane *plane = &cell->faces.data[i].plane;
        num += fabs(csg_dot(plane->normal, p) - plane->offset) <= 1000 * near;
    }
    return num == 3;
}

/* Whether the first of the corners, in the order of x, comes from three faces. */
static bool is_thrice(const struct csg_vec3 *corners, size_t num, double near)
{
    int times = 0;
    for (size_t i = 0; i < num && times < 3 && corners[i].x - corners[0].x <= near; i++)
        times += csg_length(csg_sub(corners[i], corners[0])) <= near;
    return times == 3;
}

bool csg_clusters_add_cell(struct csg_clusters *clusters, const struct csg_cell *cell, double near)
{
    const size_t begin = clusters->corners.points.num;
    bool ok = true;
    for (size_t i = 0; i < cell->faces.num && ok; i++)
        for (size_t j = 0; j < cell->faces.data[i].points.num && ok; j++)
            ok = csg_array_push(&clusters->corners.points, cell->faces.data[i].points.data[j]);
    struct csg_vec3 *corners = &clusters->corners.points.data[begin];
    const size_t num = clusters->corners.points.num - begin;
    size_t kept = 0;
    csg_corners_sort(corners, num);
    for (size_t i = 0; i < num; i++)
        if (!csg_corners_have(corners, kept, corners[i], near) &&
            (is_thrice(&corners[i], num - i, near) || is_corner(cell, corners[i], near)))
            corners[kept++] = corners[i];
    clusters->corners.points.num = begin + kept;
    return ok && csg_array_push(&clusters->ends, clusters->corners.points.num);
}

bool csg_clusters_add_sum(struct csg_clusters *clusters, const struct csg_vec3 *a, size_t num_a,
                          const struct csg_vec3 *b, size_t num_b)
{
    for (size_t i = 0; i < num_a; i++)
        for (size_t j = 0; j < num_b; j++)
            if (!csg_array_push(&clusters->corners.points, csg_add(a[i], b[j])))
                return false;
    return csg_array_push(&clusters->ends, clusters->corners.points.num);
}

bool csg_clusters_append(struct csg_clusters *clusters, const struct csg_clusters *other)
{
    const size_t begin = clusters->corners.points.num;
    bool ok = true;
    for (size_t i = 0; i < other->corners.points.num && ok; i++)
        ok = csg_array_push(&clusters->corners.points, other->corners.points.data[i]);
    for (size_t i = 0; i < other->ends.num && ok; i++)
        ok = csg_array_push(&clusters->ends, begin + other->ends.data[i]);
    return ok;
}
