/* SPDX-License-Identifier: MIT */
/*
 * Cutting one solid after the other out of a cell leaves more pieces than are needed. Two that do
 * not overlap are convex together where they have a whole face in common and neither reaches beyond
 * the other's other faces: the common face's plane cuts their union in one convex polygon, which is
 * a face of both.
 */
#include "polyhedra/join.h"

#include <stdlib.h>

/* Faces are looked for by how far along it they are: two in common are at one place, others hardly
 * ever. Any direction does that no axis and no diagonal is near to. */
static const struct csg_vec3 direction = {0.5436891, 0.2955977, 0.7854981};

struct place {
    double at;
    uint32_t cell, face;
};

struct joiner {
    struct csg_cell *cells;
    size_t num;
    double near;
    CSG_ARRAY(struct place) places; /* of all faces, in the order of at */
    bool *is_new;                   /* cells whose faces are no longer those of places */
};

static int compare_places(const void *a, const void *b)
{
    const struct place *x = a, *y = b;
    return x->at < y->at ? -1 : x->at > y->at;
}

/* The middle of the box, which corners on straight sides do not change. */
static double place_of(const struct csg_polygon *polygon)
{
    struct csg_box box = csg_box_empty;
    for (size_t i = 0; i < polygon->points.num; i++)
        csg_box_extend(&box, polygon->points.data[i]);
    return csg_dot(direction, csg_add(box.lo, box.hi)) / 2;
}

static bool list_places(struct joiner *joiner)
{
    bool ok = true;
    joiner->places.num = 0;
    for (uint32_t i = 0; i < joiner->num; i++) {
        const struct csg_cell *cell = &joiner->cells[i];
        joiner->is_new[i] = false;
        for (uint32_t j = 0; j < cell->faces.num && ok; j++)
            ok = csg_array_push(&joiner->places,
                                ((struct place){place_of(&cell->faces.data[j]), i, j}));
    }
    if (ok && joiner->places.num > 0)
        qsort(joiner->places.data, joiner->places.num, sizeof *joiner->places.data, compare_places);
    return ok;
}

/* Whether p, on the polygon's plane, is in it. */
static bool is_in(const struct csg_polygon *polygon, struct csg_vec3 p, double near)
{
    for (size_t i = 0; i < polygon->points.num; i++) {
        const struct csg_vec3 a = polygon->points.data[i];
        const struct csg_vec3 side =
            csg_sub(polygon->points.data[(i + 1) % polygon->points.num], a);
        const double area = csg_dot(csg_cross(side, csg_sub(p, a)), polygon->plane.normal);
        if (area < -near * csg_length(side))
            return false;
    }
    return true;
}

static bool covers(const struct csg_polygon *a, const struct csg_polygon *b, double near)
{
    for (size_t i = 0; i < b->points.num; i++) {
        const struct csg_vec3 p = b->points.data[i];
        if (fabs(csg_dot(a->plane.normal, p) - a->plane.offset) > near || !is_in(a, p, near))
            return false;
    }
    return true;
}

/* Whether b reaches beyond a face of a but the one in common. */
static bool is_beyond(const struct csg_cell *a, size_t common, const struct csg_cell *b,
                      double near)
{
    for (size_t i = 0; i < a->faces.num; i++) {
        double lo = 0, hi = -INFINITY;
        if (i != common)
            csg_cell_range(b, &a->faces.data[i].plane, &lo, &hi);
        if (hi > near)
            return true;
    }
    return false;
}

static bool are_convex(const struct csg_cell *a, size_t i, const struct csg_cell *b, size_t j,
                       double near)
{
    const struct csg_polygon *f = &a->faces.data[i], *g = &b->faces.data[j];
    return csg_dot(f->plane.normal, g->plane.normal) < 0 && covers(f, g, near) &&
           covers(g, f, near) && !is_beyond(a, i, b, near) && !is_beyond(b, j, a, near);
}

static bool try_pair(struct joiner *joiner, const struct place *x, const struct place *y)
{
    struct csg_cell *a = &joiner->cells[x->cell], *b = &joiner->cells[y->cell];
    if (x->cell == y->cell || joiner->is_new[y->cell] ||
        !are_convex(a, x->face, b, y->face, joiner->near))
        return true;
    joiner->is_new[x->cell] = joiner->is_new[y->cell] = true;
    return csg_cell_join(a, x->face, b, y->face, joiner->near);
}

/* *joined: there were some. */
static bool join_once(struct joiner *joiner, bool *joined)
{
    bool ok = list_places(joiner);
    for (size_t i = 0; i < joiner->places.num && ok; i++) {
        const struct place *x = &joiner->places.data[i];
        for (size_t j = i + 1; j < joiner->places.num && ok && !joiner->is_new[x->cell]; j++) {
            if (joiner->places.data[j].at > x->at + 4 * joiner->near)
                break;
            ok = try_pair(joiner, x, &joiner->places.data[j]);
        }
        *joined |= joiner->is_new[x->cell];
    }
    return ok;
}

bool csg_cells_join(struct csg_cell *cells, size_t num, double near)
{
    struct joiner joiner = {.cells = cells, .num = num, .near = near};
    bool joined = true;
    joiner.is_new = malloc((num + 1) * sizeof *joiner.is_new);
    bool ok = joiner.is_new != NULL;
    while (joined && ok) {
        joined = false;
        ok = join_once(&joiner, &joined);
    }
    free(joiner.places.data);
    free(joiner.is_new);
    return ok;
}
