/* SPDX-License-Identifier: MIT */
#include "nodes/rounded.h"

#include <stdlib.h>

#include "nodes/sets.h"
#include "plane/balls.h"

/* Of a convex set, each perhaps several times. */
enum { max_corners = 4 * CSG_BALLS_MAX };

struct balls {
    CSG_ARRAY(struct csg_ball) list;
};

/* Whether a node is a solid of that kind, or only holds others. */
static bool is_kind(const struct csg_walk *walk, uint32_t node, enum csg_kind kind)
{
    const struct csg_meaning *meaning = &walk->builder->meanings[node];
    return meaning->role == CSG_ROLE_UNION ||
           (meaning->role == CSG_ROLE_SOLID && meaning->kind == kind);
}

static bool add_corners(struct balls *balls, const struct csg_vec3 *corners, size_t num,
                        double radius)
{
    bool ok = true;
    for (size_t i = 0; i < num && ok; i++)
        ok = csg_array_push(&balls->list, ((struct csg_ball){corners[i], radius}));
    return ok;
}

static enum csg_hull_result add_hull(struct balls *balls, double rounding, struct csg_part *part,
                                     bool *taken)
{
    balls->list.num = csg_balls_drop_inner(balls->list.data, balls->list.num);
    *taken = balls->list.num > 0 && balls->list.num <= CSG_BALLS_MAX;
    return *taken ? csg_ball_hull(part, balls->list.data, balls->list.num, rounding)
                  : CSG_HULL_DONE;
}

static double rounding_of(const struct csg_part *part)
{
    double rounding = 0;
    for (size_t i = 0; i < part->shapes.num; i++)
        rounding = fmax(rounding, part->shapes.data[i].rounding);
    return rounding;
}

/* What is made of facetted solids is no further off than the worst of them. */
static void set_sagitta(struct csg_part *part, size_t first, const struct csg_part *from)
{
    double largest = 0;
    for (size_t i = 0; i < from->shapes.num; i++)
        largest = fmax(largest, from->shapes.data[i].sagitta);
    for (size_t i = first; i < part->shapes.num; i++)
        part->shapes.data[i].sagitta = part->shapes.data[i].has_quadric ? largest : 0;
}

/* ---- hull --------------------------------------------------------------------------------- */

static bool is_simple(const struct csg_walk *walk, uint32_t node)
{
    const uint32_t end = csg_walk_node(walk, node)->end;
    bool has_sphere = false;
    for (uint32_t i = node + 1; i < end; i++) {
        if (csg_is_left_out(walk->builder, i)) {
            i = csg_walk_node(walk, i)->end - 1;
            continue;
        }
        const bool is_sphere = is_kind(walk, i, CSG_KIND_sphere);
        if (!is_sphere && !is_kind(walk, i, CSG_KIND_cube))
            return false;
        has_sphere |= is_sphere && walk->builder->meanings[i].role == CSG_ROLE_SOLID;
    }
    return has_sphere;
}

/* Facetted spheres are points, ellipsoids are not taken. */
static enum csg_hull_result collect(const struct csg_part *part, struct balls *balls, bool *taken)
{
    enum csg_hull_result result = CSG_HULL_DONE;
    *taken = true;
    for (size_t i = 0; i < part->shapes.num && *taken && result == CSG_HULL_DONE; i++) {
        const struct csg_shape *shape = &part->shapes.data[i];
        struct csg_points corners = {0};
        struct csg_ball ball;
        bool ok = true;
        if (csg_shape_is_ball(shape, &ball)) {
            ok = csg_array_push(&balls->list, ball);
        } else if (shape->has_quadric) {
            *taken = false;
        } else {
            result = csg_shape_corners(shape, &corners);
            ok = add_corners(balls, corners.points.data, corners.points.num, 0);
        }
        free(corners.points.data);
        if (!ok)
            result = CSG_HULL_NO_MEMORY;
        *taken = *taken && balls->list.num <= max_corners;
    }
    return result;
}

/* What went wrong otherwise goes wrong once more on the way of facets, and is reported there. */
static bool finish(struct csg_walk *walk, enum csg_hull_result result, bool *taken)
{
    *taken = *taken && result == CSG_HULL_DONE;
    return result != CSG_HULL_NO_MEMORY || csg_walk_no_memory(walk);
}

bool csg_rounded_hull(struct csg_walk *walk, uint32_t node, bool in_boolean, struct csg_part *part,
                      bool *taken)
{
    struct csg_part inner = {0};
    struct balls balls = {0};
    *taken = false;
    if (walk->builder->facets == CSGCAST_FACETS_AS_WRITTEN || !is_simple(walk, node))
        return true;
    bool ok = csg_part_read(walk, node + 1, csg_walk_node(walk, node)->end, in_boolean,
                            CSG_WANT_EXACT, &inner);
    if (ok && !inner.has_flat) {
        const size_t first = part->shapes.num;
        enum csg_hull_result result = collect(&inner, &balls, taken);
        if (result == CSG_HULL_DONE && *taken)
            result = add_hull(&balls, rounding_of(&inner), part, taken);
        set_sagitta(part, first, &inner);
        ok = finish(walk, result, taken);
    }
    free(balls.list.data);
    csg_part_finish(&inner);
    return ok;
}

/* ---- minkowski ---------------------------------------------------------------------------- */

/* Whether all there is in the child is one sphere. */
static bool is_one_sphere(const struct csg_walk *walk, uint32_t child)
{
    int num = 0;
    for (uint32_t i = child; i < csg_walk_node(walk, child)->end; i++) {
        if (i != child && csg_is_left_out(walk->builder, i)) {
            i = csg_walk_node(walk, i)->end - 1;
            continue;
        }
        if (!is_kind(walk, i, CSG_KIND_sphere))
            return false;
        num += walk->builder->meanings[i].role == CSG_ROLE_SOLID;
    }
    return num == 1;
}

/* The two operands; false unless there are two and one is a sphere. */
static bool find_operands(const struct csg_walk *walk, uint32_t node, uint32_t *sphere,
                          uint32_t *other)
{
    uint32_t operands[2];
    int num = 0;
    for (uint32_t i = node + 1; i < csg_walk_node(walk, node)->end; i = csg_walk_node(walk, i)->end)
        if (!csg_is_left_out(walk->builder, i)) {
            if (num == 2)
                return false;
            operands[num++] = i;
        }
    if (num < 2)
        return false;
    const int at = is_one_sphere(walk, operands[1]);
    if (!is_one_sphere(walk, operands[at]))
        return false;
    *sphere = operands[at];
    *other = operands[1 - at];
    return true;
}

static bool has_quadrics(const struct csg_part *part)
{
    for (size_t i = 0; i < part->shapes.num; i++)
        if (part->shapes.data[i].has_quadric)
            return true;
    return part->shapes.num == 0;
}

static bool move_sets(const struct csg_sets *sets, struct csg_vec3 by, struct csg_sets *moved)
{
    const struct csg_clusters *convex = &sets->convex;
    size_t begin = 0;
    bool ok = true;
    for (size_t i = 0; i < convex->ends.num && ok; i++) {
        ok = csg_clusters_add_sum(&moved->convex, &convex->corners.points.data[begin],
                                  convex->ends.data[i] - begin, &by, 1);
        begin = convex->ends.data[i];
    }
    for (size_t i = 0; i < sets->surfaces.num && ok; i++)
        ok = csg_sets_add_sum(moved, &sets->surfaces.data[i], &by, 1);
    return ok;
}

static bool has_small_sets(const struct csg_clusters *clusters)
{
    size_t begin = 0;
    for (size_t i = 0; i < clusters->ends.num; i++) {
        if (clusters->ends.data[i] - begin > max_corners)
            return false;
        begin = clusters->ends.data[i];
    }
    return clusters->ends.num > 0;
}

static bool add_surfaces(struct csg_sets *sets, struct csg_part *part)
{
    bool ok = true;
    while (sets->surfaces.num > 0 && ok)
        ok = csg_part_add(part, &sets->surfaces.data[--sets->surfaces.num], false);
    return ok;
}

/* The union of the surfaces and of the sums of the convex sets and a ball about the origin; not
 * taken where these are too many solids, of which facets make fewer. */
static enum csg_hull_result add_sums(struct csg_sets *sets, double radius, double rounding,
                                     struct csg_part *part, bool *taken)
{
    const struct csg_clusters *convex = &sets->convex;
    enum csg_hull_result result = CSG_HULL_DONE;
    size_t begin = 0;
    *taken = has_small_sets(convex);
    if (!*taken)
        return result;
    if (!csg_part_open(part, false) || !add_surfaces(sets, part))
        return CSG_HULL_NO_MEMORY;
    for (size_t i = 0;
         i < convex->ends.num && *taken && !part->is_too_large && result == CSG_HULL_DONE; i++) {
        struct balls balls = {0};
        result = add_corners(&balls, &convex->corners.points.data[begin],
                             convex->ends.data[i] - begin, radius)
                     ? add_hull(&balls, rounding, part, taken)
                     : CSG_HULL_NO_MEMORY;
        begin = convex->ends.data[i];
        free(balls.list.data);
    }
    csg_part_close(part);
    *taken = *taken && !part->is_too_large;
    return result;
}

/* other is used up. */
static enum csg_hull_result add_sets(const struct csg_ball *ball, struct csg_part *other,
                                     double rounding, struct csg_part *part, bool *taken)
{
    struct csg_sets sets = {0}, moved = {0};
    enum csg_hull_result result = CSG_HULL_NO_MEMORY;
    if (csg_sets_take_surfaces(&sets, other))
        result = csg_part_evaluate(other, false, &sets.convex);
    if (result == CSG_HULL_DONE)
        result = move_sets(&sets, ball->center, &moved)
                     ? add_sums(&moved, ball->radius, rounding, part, taken)
                     : CSG_HULL_NO_MEMORY;
    csg_sets_finish(&sets);
    csg_sets_finish(&moved);
    return result;
}

static enum csg_hull_result add_sum(const struct csg_part *sphere, struct csg_part *other,
                                    struct csg_part *part, bool *taken)
{
    const double rounding = rounding_of(sphere) + rounding_of(other);
    struct csg_ball ball, second;
    *taken = false;
    if (sphere->shapes.num != 1 || !csg_shape_is_ball(&sphere->shapes.data[0], &ball))
        return CSG_HULL_DONE;
    if (other->shapes.num == 1 && csg_shape_is_ball(&other->shapes.data[0], &second)) {
        *taken = true;
        ball.center = csg_add(ball.center, second.center);
        ball.radius += second.radius;
        return csg_ball_hull(part, &ball, 1, rounding);
    }
    if (has_quadrics(other) || other->is_too_large)
        return CSG_HULL_DONE;
    const size_t first = part->shapes.num;
    const enum csg_hull_result result = add_sets(&ball, other, rounding, part, taken);
    set_sagitta(part, first, sphere);
    return result;
}

bool csg_rounded_sum(struct csg_walk *walk, uint32_t node, bool in_boolean, struct csg_part *part,
                     bool *taken)
{
    struct csg_part parts[2] = {{.is_too_large = false}}, sum = {0};
    uint32_t operands[2];
    *taken = false;
    if (walk->builder->facets == CSGCAST_FACETS_AS_WRITTEN ||
        !find_operands(walk, node, &operands[0], &operands[1]))
        return true;
    bool ok = true;
    for (int i = 0; i < 2 && ok; i++)
        ok = csg_part_read(walk, operands[i], csg_walk_node(walk, operands[i])->end, in_boolean,
                           CSG_WANT_EXACT, &parts[i]);
    ok = ok && finish(walk, add_sum(&parts[0], &parts[1], &sum, taken), taken);
    if (ok && *taken)
        ok = csg_part_append(part, &sum, false) || csg_walk_no_memory(walk);
    csg_part_finish(&sum);
    csg_part_finish(&parts[0]);
    csg_part_finish(&parts[1]);
    return ok;
}
