/* SPDX-License-Identifier: MIT */
#include "polyhedra/edges.h"

#include <stdlib.h>

static int compare_edges(const void *a, const void *b)
{
    const struct csg_mesh_edge *x = a, *y = b;
    if (x->high != y->high)
        return x->high < y->high ? -1 : 1;
    return x->face < y->face ? -1 : x->face > y->face;
}

static uint32_t next_corner(const struct csg_mesh_face *face, uint32_t corner)
{
    return corner + 1 < face->end ? corner + 1 : face->begin;
}

/* Calls for each directed edge of the mesh; counts where place is false. */
static void scatter(struct csg_mesh_edges *edges, const struct csg_mesh *mesh, bool place)
{
    for (uint32_t i = 0; i < mesh->faces.num; i++) {
        const struct csg_mesh_face *face = &mesh->faces.data[i];
        for (uint32_t j = face->begin; j < face->end; j++) {
            const uint32_t a = mesh->corners.data[j];
            const uint32_t b = mesh->corners.data[next_corner(face, j)];
            const uint32_t low = a < b ? a : b, high = a < b ? b : a;
            if (place)
                edges->edges[edges->begin[low + 1]++] =
                    (struct csg_mesh_edge){high, i, a < b ? 1 : -1};
            else
                edges->begin[low + 2]++;
        }
    }
}

/* Counting sort by the lower end, then the few edges of each by the higher one. */
bool csg_mesh_edges_init(struct csg_mesh_edges *edges, const struct csg_mesh *mesh)
{
    const size_t num = mesh->points.num;
    edges->begin = calloc(num + 2, sizeof *edges->begin);
    edges->edges = malloc((mesh->corners.num + 1) * sizeof *edges->edges);
    if (!edges->begin || !edges->edges)
        return false;
    scatter(edges, mesh, false);
    for (size_t i = 2; i < num + 2; i++)
        edges->begin[i] += edges->begin[i - 1];
    scatter(edges, mesh, true);
    for (size_t i = 0; i < num; i++) {
        const size_t length = edges->begin[i + 1] - edges->begin[i];
        if (length > 1)
            qsort(&edges->edges[edges->begin[i]], length, sizeof *edges->edges, compare_edges);
    }
    return true;
}

void csg_mesh_edges_finish(struct csg_mesh_edges *edges)
{
    free(edges->begin);
    free(edges->edges);
    *edges = (struct csg_mesh_edges){0};
}

uint32_t csg_mesh_edges_run(const struct csg_mesh_edges *edges, uint32_t i, uint32_t end)
{
    uint32_t j = i + 1;
    while (j < end && edges->edges[j].high == edges->edges[i].high)
        j++;
    return j;
}
