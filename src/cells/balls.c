/* SPDX-License-Identifier: MIT */
#include "cells/balls.h"

struct ball {
    struct csg_vec3 center;
    double radius;
};

/* The ball that others are compared with, by its place in the tree; 0: there is none. */
struct dominator {
    struct ball ball;
    double height; /* of the box's center over its surface */
    uint32_t place;
};

static bool ball_of(const struct csg_cell_leaf *leaves, uint32_t leaf, struct ball *ball)
{
    const struct csg_box *box = &leaves[leaf].box;
    ball->center = csg_box_middle(box);
    ball->radius = leaves[leaf].radius;
    return ball->radius > 0;
}

/*
 * Whether outer holds what inner has in the box, and margin around that. With g = |x - c|^2 - r^2,
 * at most 0 inside, g of outer less g of inner is affine, so its maximum over the box is known:
 * below -h, h > 0, g of outer is below -h where inner is. To the surface of outer it is further
 * from there than h / 2 r.
 */
static bool holds(const struct ball *outer, const struct ball *inner, const struct csg_box *box,
                  double margin)
{
    const struct csg_vec3 half = csg_scale(0.5, csg_sub(box->hi, box->lo));
    const struct csg_vec3 middle = csg_box_middle(box);
    const struct csg_vec3 slope = csg_scale(2, csg_sub(inner->center, outer->center));
    const struct csg_vec3 between = csg_scale(0.5, csg_add(inner->center, outer->center));
    const double most = csg_dot(slope, csg_sub(middle, between)) + fabs(slope.x) * half.x +
                        fabs(slope.y) * half.y + fabs(slope.z) * half.z +
                        (inner->radius - outer->radius) * (inner->radius + outer->radius);
    return most < -2 * outer->radius * margin;
}

/* Of an intersection the ball that the box is furthest out of, of those that are subtracted the one
 * that it is deepest in. */
static void find_dominators(const struct csg_cell_leaf *leaves, const struct csg_tree *tree,
                            const struct csg_box *box, struct dominator found[2])
{
    const struct csg_vec3 middle = csg_box_middle(box);
    for (uint32_t i = 1; i < tree->num; i++) {
        struct dominator own = {.place = i};
        if (!ball_of(leaves, tree->data[i].leaf, &own.ball))
            continue;
        struct dominator *best = &found[tree->data[i].negated];
        own.height = csg_length(csg_sub(middle, own.ball.center)) - own.ball.radius;
        if (!best->place ||
            (tree->data[i].negated ? own.height < best->height : own.height > best->height))
            *best = own;
    }
}

void csg_balls_drop(const struct csg_cell_leaf *leaves, struct csg_tree *tree,
                    const struct csg_box *box, double margin)
{
    struct dominator found[2] = {{.place = 0}, {.place = 0}};
    uint32_t num = 1;
    find_dominators(leaves, tree, box, found);
    if (!found[0].place && !found[1].place)
        return;
    for (uint32_t i = 1; i < tree->num; i++) {
        const struct csg_node node = tree->data[i];
        const struct dominator *other = &found[node.negated];
        struct ball own;
        if (i != other->place && ball_of(leaves, node.leaf, &own) &&
            (node.negated ? holds(&other->ball, &own, box, margin)
                          : holds(&own, &other->ball, box, margin)))
            continue;
        tree->data[num] = node;
        tree->data[num].end = num + 1;
        num++;
    }
    tree->num = num;
    tree->data[0].end = num;
}
