/* SPDX-License-Identifier: MIT */
#include "nodes/rounded.h"

#include <stdlib.h>

#include "nodes/parts.h"
#include "plane/balls.h"
#include "polyhedra/evaluate.h"

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
                        struct csg_vec3 offset, double radius)
{
    bool ok = true;
    for (size_t i = 0; i < num && ok; i++)
        ok = csg_array_push(&balls->list, ((struct csg_ball){csg_add(corners[i], offset), radius}));
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
            ok = add_corners(balls, corners.points.data, corners.points.num, csg_vec3(0, 0, 0), 0);
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

/* The union of the sums of the convex sets and the ball. */
static enum csg_hull_result add_sums(const struct csg_clusters *clusters,
                                     const struct csg_ball *ball, double rounding,
                                     struct csg_part *part, bool *taken)
{
    enum csg_hull_result result = CSG_HULL_DONE;
    size_t begin = 0;
    *taken = clusters->ends.num > 0;
    for (size_t i = 0; i < clusters->ends.num && *taken; i++) {
        *taken = clusters->ends.data[i] - begin <= max_corners;
        begin = clusters->ends.data[i];
    }
    begin = 0;
    if (!*taken)
        return result;
    if (!csg_part_open(part, false))
        return CSG_HULL_NO_MEMORY;
    for (size_t i = 0; i < clusters->ends.num && *taken && result == CSG_HULL_DONE; i++) {
        struct balls balls = {0};
        result = add_corners(&balls, &clusters->corners.points.data[begin],
                             clusters->ends.data[i] - begin, ball->center, ball->radius)
                     ? add_hull(&balls, rounding, part, taken)
                     : CSG_HULL_NO_MEMORY;
        begin = clusters->ends.data[i];
        free(balls.list.data);
    }
    csg_part_close(part);
    return result;
}

static enum csg_hull_result add_sum(const struct csg_part *sphere, const struct csg_part *other,
                                    struct csg_part *part, bool *taken)
{
    struct csg_clusters clusters = {0};
    struct csg_ball ball, second;
    *taken = false;
    if (sphere->shapes.num != 1 || !csg_shape_is_ball(&sphere->shapes.data[0], &ball))
        return CSG_HULL_DONE;
    if (other->shapes.num == 1 && csg_shape_is_ball(&other->shapes.data[0], &second)) {
        *taken = true;
        ball.center = csg_add(ball.center, second.center);
        ball.radius += second.radius;
        return csg_ball_hull(part, &ball, 1, rounding_of(sphere) + rounding_of(other));
    }
    if (has_quadrics(other) || other->is_too_large)
        return CSG_HULL_DONE;
    const size_t first = part->shapes.num;
    enum csg_hull_result result = csg_part_evaluate(other, false, &clusters);
    if (result == CSG_HULL_DONE)
        result = add_sums(&clusters, &ball, rounding_of(sphere) + rounding_of(other), part, taken);
    set_sagitta(part, first, sphere);
    csg_clusters_finish(&clusters);
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
