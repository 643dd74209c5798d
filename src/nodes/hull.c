/* SPDX-License-Identifier: MIT */
/*
 * hull() of solids: of the corners that OpenSCAD's facets have, as in OpenSCAD, but for cylinders
 * side by side, and spheres and boxes.
 */
#include "nodes/compounds.h"
#include "nodes/hull_film.h"
#include "nodes/parts.h"
#include "nodes/rounded.h"
#include "nodes/sets.h"
#include "plane/cylinders.h"

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
    bool ok = true, all = !walk->is_operand;
    for (uint32_t i = node + 1; i < end && all; i++)
        if (csg_is_left_out(walk->builder, i))
            i = csg_walk_node(walk, i)->end - 1;
        else
            all = is_cylinder(walk, i);
    if (all && walk->builder->facets != CSGCAST_FACETS_AS_WRITTEN) {
        ok = csg_part_read(walk, node + 1, end, in_boolean, CSG_WANT_EXACT, &inner) &&
             (inner.has_flat || csg_disc_hull(part, &inner, taken) || csg_walk_no_memory(walk));
    }
    csg_part_finish(&inner);
    return ok;
}

static bool add_hull(struct csg_walk *walk, uint32_t node, bool in_boolean,
                     const struct csg_sets *sets, struct csg_part *part)
{
    const struct csg_points *points = &sets->convex.corners;
    const size_t num = part->shapes.num;
    if (!csg_sets_add_hull(walk, node, sets, points, part))
        return false;
    return in_boolean || walk->is_operand || part->shapes.num > num ||
           csg_hull_film(sets, points, part) || csg_walk_no_memory(walk);
}

bool csg_compound_hull(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                       bool in_boolean, struct csg_part *part)
{
    struct csg_sets sets = {0};
    bool is_there = false, taken = false;
    (void)args;
    if (!take_cylinders(walk, node, in_boolean, part, &taken) ||
        (!taken && !csg_rounded_hull(walk, node, in_boolean, part, &taken)))
        return false;
    if (taken)
        return true;
    bool ok = csg_sets_read(walk, node, node + 1, csg_walk_node(walk, node)->end, in_boolean,
                            CSG_WANT_POINTS, &sets, &is_there);
    if (ok && is_there && sets.convex.corners.points.num > 0)
        ok = add_hull(walk, node, in_boolean, &sets, part);
    csg_sets_finish(&sets);
    return ok;
}
