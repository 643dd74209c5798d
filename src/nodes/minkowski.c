/* SPDX-License-Identifier: MIT */
/*
 * minkowski() of solids: of the corners that OpenSCAD's facets have, but for sums with a sphere. It
 * distributes over unions, so operands are taken as unions of convex sets and of surfaces of
 * triangles.
 */
#include <stdlib.h>

#include "mesh/surface.h"
#include "nodes/compounds.h"
#include "nodes/rounded.h"
#include "nodes/sets.h"

/* Sums of more corners are refused: each takes some 110 bytes while Qhull is at work. */
enum { max_sums = 10000000 };

/* ---- convex sets -------------------------------------------------------------------------- */

/* The corners of the i-th set. */
static const struct csg_vec3 *corners_of(const struct csg_clusters *clusters, size_t i, size_t *num)
{
    const size_t begin = i ? clusters->ends.data[i - 1] : 0;
    *num = clusters->ends.data[i] - begin;
    return &clusters->corners.points.data[begin];
}

static bool add_convex(const struct csg_clusters *a, const struct csg_clusters *b,
                       struct csg_clusters *sums)
{
    bool ok = true;
    for (size_t i = 0; i < a->ends.num && ok; i++)
        for (size_t j = 0; j < b->ends.num && ok; j++) {
            size_t num_a, num_b;
            const struct csg_vec3 *corners_a = corners_of(a, i, &num_a);
            const struct csg_vec3 *corners_b = corners_of(b, j, &num_b);
            ok = csg_clusters_add_sum(sums, corners_a, num_a, corners_b, num_b);
        }
    return ok;
}

/* ---- surfaces ----------------------------------------------------------------------------- */

/* The sums of a surface and b's convex sets. */
static bool add_surface(const struct csg_shape *shape, const struct csg_sets *b,
                        struct csg_sets *sum)
{
    bool ok = true;
    for (size_t i = 0; i < b->convex.ends.num && ok; i++) {
        size_t num;
        const struct csg_vec3 *corners = corners_of(&b->convex, i, &num);
        ok = csg_sets_add_sum(sum, shape, corners, num);
    }
    return ok;
}

static bool add_surfaces(const struct csg_sets *a, const struct csg_sets *b, struct csg_sets *sum)
{
    bool ok = true;
    for (size_t i = 0; i < a->surfaces.num && ok; i++)
        ok = add_surface(&a->surfaces.data[i], b, sum);
    return ok;
}

/* Corners to take sums of. */
static double count_corners(const struct csg_sets *sets)
{
    double num = (double)sets->convex.corners.points.num;
    for (size_t i = 0; i < sets->surfaces.num; i++)
        num += 3 * (double)sets->surfaces.data[i].surface->triangles.num;
    return num;
}

/* ---- operands ----------------------------------------------------------------------------- */

static bool is_empty(const struct csg_sets *sets)
{
    return sets->convex.ends.num == 0 && sets->surfaces.num == 0;
}

/* Where nothing is left of the child i but what is flat, it is its points. */
static bool read_operand(struct csg_walk *walk, uint32_t node, uint32_t i, bool in_boolean,
                         struct csg_sets *operand, bool *is_there)
{
    const uint32_t end = csg_walk_node(walk, i)->end;
    const bool ok =
        csg_sets_read(walk, node, i, end, in_boolean, CSG_WANT_FACETS, operand, is_there);
    if (!ok || !*is_there || !is_empty(operand) || !operand->has_flat)
        return ok;
    return csg_sets_read(walk, node, i, end, in_boolean, CSG_WANT_POINTS, operand, is_there);
}

/* The sum, which is not empty, becomes its sum with the operand. */
static bool add_sets(struct csg_walk *walk, struct csg_sets *sum, const struct csg_sets *operand)
{
    struct csg_sets both = {.rounding = fmax(sum->rounding, operand->rounding),
                            .facetted = sum->facetted || operand->facetted};
    const bool ok = add_convex(&sum->convex, &operand->convex, &both.convex) &&
                    add_surfaces(sum, operand, &both) && add_surfaces(operand, sum, &both);
    csg_sets_finish(sum);
    *sum = both;
    return ok || csg_walk_no_memory(walk);
}

/* Empty operands are left out, as in OpenSCAD. */
static bool add_operand(struct csg_walk *walk, uint32_t node, struct csg_sets *sum,
                        struct csg_sets *operand, bool *is_there)
{
    if (is_empty(operand))
        return true;
    if (is_empty(sum)) {
        *sum = *operand;
        *operand = (struct csg_sets){0};
        return true;
    }
    const bool has_surfaces = sum->surfaces.num > 0 && operand->surfaces.num > 0;
    *is_there = !has_surfaces && count_corners(sum) * count_corners(operand) <= max_sums;
    if (*is_there)
        return add_sets(walk, sum, operand);
    if (has_surfaces)
        csg_walk_unsupported(walk, node, "minkowski: two operands of many faces, not convex");
    else
        csg_walk_unsupported(walk, node, "minkowski: %.0f and %.0f corners are too many",
                             count_corners(sum), count_corners(operand));
    return true;
}

/* ---- the part ----------------------------------------------------------------------------- */

static bool add_hull(struct csg_walk *walk, uint32_t node, const struct csg_sets *sum, size_t i,
                     struct csg_part *part)
{
    struct csg_points points = {0};
    size_t num;
    const struct csg_vec3 *corners = corners_of(&sum->convex, i, &num);
    bool ok = true;
    for (size_t k = 0; k < num && ok; k++)
        ok = csg_array_push(&points.points, corners[k]);
    ok = ok ? csg_sets_add_hull(walk, node, sum, &points, part) : csg_walk_no_memory(walk);
    free(points.points.data);
    return ok;
}

static bool add_sum_to_part(struct csg_walk *walk, uint32_t node, struct csg_sets *sum,
                            struct csg_part *part)
{
    bool ok = csg_part_open(part, false) || csg_walk_no_memory(walk);
    for (size_t i = sum->surfaces.num; i > 0 && ok; i--) {
        sum->surfaces.num--;
        ok = csg_part_add(part, &sum->surfaces.data[i - 1], false) || csg_walk_no_memory(walk);
    }
    for (size_t i = 0; i < sum->convex.ends.num && ok && !part->is_too_large; i++)
        ok = add_hull(walk, node, sum, i, part);
    if (part->open.num > 0)
        csg_part_close(part);
    return ok;
}

bool csg_compound_minkowski(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                            bool in_boolean, struct csg_part *part)
{
    struct csg_sets sum = {0};
    bool is_there = true, taken;
    const uint32_t end = csg_walk_node(walk, node)->end;
    (void)args;
    bool ok = csg_rounded_sum(walk, node, in_boolean, part, &taken);
    if (!ok || taken)
        return ok;
    for (uint32_t i = node + 1; i < end && ok && is_there; i = csg_walk_node(walk, i)->end) {
        struct csg_sets operand = {0};
        if (csg_is_left_out(walk->builder, i))
            continue;
        ok = read_operand(walk, node, i, in_boolean, &operand, &is_there);
        if (ok && is_there)
            ok = add_operand(walk, node, &sum, &operand, &is_there);
        csg_sets_finish(&operand);
    }
    if (ok && is_there && !is_empty(&sum))
        ok = add_sum_to_part(walk, node, &sum, part);
    csg_sets_finish(&sum);
    return ok;
}
