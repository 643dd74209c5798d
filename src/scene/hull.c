/* SPDX-License-Identifier: MIT */
/*
 * hull() and minkowski() of solids: of the corners that OpenSCAD's facets have, as in OpenSCAD, but
 * for cylinders side by side. A Minkowski sum distributes over unions, so operands are taken as
 * unions of convex sets.
 */
#include <stdlib.h>

#include "plane/cylinders.h"
#include "polyhedra/evaluate.h"
#include "scene/compounds.h"
#include "scene/parts.h"
#include "scene/rounded.h"

/* Sums of more corners are refused. */
enum { max_sums = 4000000 };

/* What is known about the solids inside, for the shapes made of them. */
struct origin {
    double rounding;
    bool facetted, has_flat;
};

static void add_origin(struct origin *origin, const struct csg_part *part)
{
    origin->has_flat |= part->has_flat;
    for (size_t i = 0; i < part->shapes.num; i++) {
        origin->rounding = fmax(origin->rounding, part->shapes.data[i].rounding);
        origin->facetted |= part->shapes.data[i].facetted;
    }
}

/* Says what went wrong; false when memory is out. */
static bool report(struct csg_walk *walk, uint32_t node, enum csg_hull_result result)
{
    const char *name = csg_walk_ops(walk, node)->name;
    if (result == CSG_HULL_NO_MEMORY)
        return csg_log_memory(&walk->builder->report->log);
    if (result == CSG_HULL_MISSING)
        csg_walk_unsupported(walk, node,
                             "%s needs the Qhull library, which csgcast was built "
                             "without (Debian: libqhull-dev)",
                             name);
    else if (result == CSG_HULL_FLAT)
        csg_walk_unsupported(walk, node, "%s: the Booleans in it have too many pieces", name);
    return true;
}

/* ---- cylinders side by side --------------------------------------------------------------- */

static bool is_cylinder(const struct csg_walk *walk, uint32_t node)
{
    const struct csg_meaning *meaning = &walk->builder->meanings[node];
    return meaning->role == CSG_ROLE_UNION ||
           (meaning->role == CSG_ROLE_SOLID && meaning->kind == CSG_KIND_cylinder);
}

/*
 * The hull of cylinders between the same two planes is the plane hull of their discs, extruded: the
 * one that stays exact. taken: it was, and is in part.
 */
static bool take_cylinders(struct csg_walk *walk, uint32_t node, bool in_boolean,
                           struct csg_part *part, bool *taken)
{
    const uint32_t end = csg_walk_node(walk, node)->end;
    struct csg_part inner = {0};
    bool ok = true, all = walk->depth == 0;
    for (uint32_t i = node + 1; i < end && all; i++)
        if (csg_is_left_out(walk->builder, i))
            i = csg_walk_node(walk, i)->end - 1;
        else
            all = is_cylinder(walk, i);
    if (all && walk->builder->facets != CSGCAST_FACETS_AS_WRITTEN) {
        ok = csg_part_read(walk, node + 1, end, in_boolean, CSG_WANT_EXACT, &inner) &&
             (inner.has_flat || csg_disc_hull(part, &inner, taken) || csg_log_memory(&walk->builder->report->log));
    }
    csg_part_finish(&inner);
    return ok;
}

/* ---- facets ------------------------------------------------------------------------------- */

/* The sets that the solids at [begin, end) are made of, convex where more than points are wanted.
 * is_there: nothing was reported. */
static bool read_clusters(struct csg_walk *walk, uint32_t node, uint32_t begin, uint32_t end,
                          bool in_boolean, enum csg_part_wanted wanted,
                          struct csg_clusters *clusters, struct origin *origin, bool *is_there)
{
    struct csg_part inner = {0};
    enum csg_hull_result result = CSG_HULL_DONE;
    bool ok = csg_part_read(walk, begin, end, in_boolean, wanted, &inner);
    if (ok) {
        add_origin(origin, &inner);
        result = inner.is_too_large
                     ? CSG_HULL_FLAT
                     : csg_part_evaluate(&inner, wanted == CSG_WANT_POINTS, clusters);
        *is_there = result == CSG_HULL_DONE;
        ok = report(walk, node, result);
    }
    csg_part_finish(&inner);
    return ok;
}

/* A hull without volume adds nothing. */
static bool add_hull(struct csg_walk *walk, uint32_t node, const struct csg_points *points,
                     const struct origin *origin, struct csg_part *part)
{
    struct csg_shape shape = {.frame = csg_map_identity};
    const enum csg_hull_result result = csg_hull_fill(&shape, points);
    shape.rounding = origin->rounding;
    shape.facetted = origin->facetted;
    if (result == CSG_HULL_DONE)
        return csg_part_add(part, &shape, false) || csg_log_memory(&walk->builder->report->log);
    csg_shape_finish(&shape);
    return result == CSG_HULL_FLAT || report(walk, node, result);
}

bool csg_compound_hull(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                       bool in_boolean, struct csg_part *part)
{
    struct csg_clusters clusters = {0};
    struct origin origin = {0};
    bool is_there = false, taken = false;
    (void)args;
    if (!take_cylinders(walk, node, in_boolean, part, &taken) ||
        (!taken && !csg_rounded_hull(walk, node, in_boolean, part, &taken)))
        return false;
    if (taken)
        return true;
    bool ok = read_clusters(walk, node, node + 1, csg_walk_node(walk, node)->end, in_boolean,
                            CSG_WANT_POINTS, &clusters, &origin, &is_there);
    if (ok && is_there && clusters.corners.points.num > 0)
        ok = add_hull(walk, node, &clusters.corners, &origin, part);
    csg_clusters_finish(&clusters);
    return ok;
}

/* ---- minkowski ---------------------------------------------------------------------------- */

/* The sums of all corners of two sets. */
static bool add_sums(const struct csg_clusters *a, size_t i, const struct csg_clusters *b, size_t j,
                     struct csg_points *sums)
{
    const size_t a_begin = i ? a->ends.data[i - 1] : 0, b_begin = j ? b->ends.data[j - 1] : 0;
    for (size_t k = a_begin; k < a->ends.data[i]; k++)
        for (size_t l = b_begin; l < b->ends.data[j]; l++)
            if (!csg_array_push(&sums->points,
                                csg_add(a->corners.points.data[k], b->corners.points.data[l])))
                return false;
    return true;
}

/* a becomes the sums of its sets and b's. */
static bool add_clusters(struct csg_clusters *a, const struct csg_clusters *b)
{
    struct csg_clusters sums = {0};
    bool ok = true;
    for (size_t i = 0; i < a->ends.num && ok; i++)
        for (size_t j = 0; j < b->ends.num && ok; j++)
            ok = add_sums(a, i, b, j, &sums.corners) &&
                 csg_array_push(&sums.ends, sums.corners.points.num);
    csg_clusters_finish(a);
    *a = sums;
    return ok;
}

/* Corners that a sum of both would have. */
static double count_sums(const struct csg_clusters *a, const struct csg_clusters *b)
{
    return (double)a->corners.points.num * (double)b->corners.points.num;
}

static bool add_hulls(struct csg_walk *walk, uint32_t node, const struct csg_clusters *clusters,
                      const struct origin *origin, struct csg_part *part)
{
    size_t begin = 0;
    bool ok = csg_part_open(part, false) || csg_log_memory(&walk->builder->report->log);
    for (size_t i = 0; i < clusters->ends.num && ok && !part->is_too_large; i++) {
        struct csg_points points = {0};
        for (size_t k = begin; k < clusters->ends.data[i] && ok; k++)
            ok = csg_array_push(&points.points, clusters->corners.points.data[k]);
        ok = ok ? add_hull(walk, node, &points, origin, part)
                : csg_log_memory(&walk->builder->report->log);
        free(points.points.data);
        begin = clusters->ends.data[i];
    }
    if (part->open.num > 0)
        csg_part_close(part);
    return ok;
}

/* The convex sets of the child i; where nothing is left of it but what is flat, its points. */
static bool read_operand(struct csg_walk *walk, uint32_t node, uint32_t i, bool in_boolean,
                         struct csg_clusters *operand, struct origin *origin, bool *is_there)
{
    const uint32_t end = csg_walk_node(walk, i)->end;
    const bool ok = read_clusters(walk, node, i, end, in_boolean, CSG_WANT_FACETS, operand, origin,
                                  is_there);
    if (!ok || !*is_there || operand->ends.num > 0 || !origin->has_flat)
        return ok;
    return read_clusters(walk, node, i, end, in_boolean, CSG_WANT_POINTS, operand, origin,
                         is_there);
}

/* Empty operands are left out, as in OpenSCAD. */
static bool add_operand(struct csg_walk *walk, uint32_t node, struct csg_clusters *sum,
                        struct csg_clusters *operand, bool *is_there)
{
    if (operand->ends.num == 0)
        return true;
    if (sum->ends.num == 0) {
        *sum = *operand;
        *operand = (struct csg_clusters){0};
        return true;
    }
    if (count_sums(sum, operand) > max_sums) {
        csg_walk_unsupported(walk, node, "minkowski: %zu and %zu corners are too many",
                             sum->corners.points.num, operand->corners.points.num);
        *is_there = false;
        return true;
    }
    return add_clusters(sum, operand) || csg_log_memory(&walk->builder->report->log);
}

bool csg_compound_minkowski(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                            bool in_boolean, struct csg_part *part)
{
    struct csg_clusters sum = {0};
    struct origin origin = {0};
    bool is_there = true, taken;
    const uint32_t end = csg_walk_node(walk, node)->end;
    (void)args;
    bool ok = csg_rounded_sum(walk, node, in_boolean, part, &taken);
    if (!ok || taken)
        return ok;
    for (uint32_t i = node + 1; i < end && ok && is_there; i = csg_walk_node(walk, i)->end) {
        struct csg_clusters operand = {0};
        if (csg_is_left_out(walk->builder, i))
            continue;
        ok = read_operand(walk, node, i, in_boolean, &operand, &origin, &is_there);
        if (ok && is_there)
            ok = add_operand(walk, node, &sum, &operand, &is_there);
        csg_clusters_finish(&operand);
    }
    if (ok && is_there && sum.ends.num > 0)
        ok = add_hulls(walk, node, &sum, &origin, part);
    csg_clusters_finish(&sum);
    return ok;
}
