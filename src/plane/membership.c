/* SPDX-License-Identifier: MIT */
#include "plane/membership.h"

#include <stdlib.h>

#define NO_PARENT UINT32_MAX

struct csg_membership_node {
    uint8_t op;
    bool value;
    bool is_first;    /* child of its parent */
    bool first_value; /* of the first child */
    bool by_winding;  /* of a figure: num_turns counts */
    int32_t num_turns;
    uint32_t parent;
    uint32_t num_children, num_true;
};

static bool value_of(const struct csg_membership_node *node)
{
    switch (node->op) {
    case CSG_DRAW_UNION:
        return node->num_true > 0;
    case CSG_DRAW_INTERSECTION:
        return node->num_children > 0 && node->num_true == node->num_children;
    case CSG_DRAW_DIFFERENCE:
        return node->first_value && node->num_true == 1;
    default:
        return node->by_winding ? node->num_turns > 0 : node->num_turns & 1;
    }
}

bool csg_membership_init(struct csg_membership *membership, const struct csg_drawing *drawing,
                         uint32_t root)
{
    const struct csg_draw_node *nodes = drawing->nodes.data;
    membership->num = nodes[root].end - root;
    membership->nodes = calloc(membership->num, sizeof *membership->nodes);
    membership->node_of = calloc(drawing->figures.num + 1, sizeof *membership->node_of);
    if (!membership->nodes || !membership->node_of) {
        csg_membership_finish(membership);
        return false;
    }
    membership->nodes[0].parent = NO_PARENT;
    for (uint32_t i = root; i < nodes[root].end; i++) {
        struct csg_membership_node *node = &membership->nodes[i - root];
        node->op = nodes[i].op;
        if (node->op == CSG_DRAW_FIGURE) {
            membership->node_of[nodes[i].figure] = i - root;
            node->by_winding = drawing->figures.data[nodes[i].figure].by_winding;
        }
        for (uint32_t child = i + 1; child < nodes[i].end; child = nodes[child].end) {
            membership->nodes[child - root].parent = i - root;
            membership->nodes[child - root].is_first = child == i + 1;
            node->num_children++;
        }
    }
    return true;
}

void csg_membership_finish(struct csg_membership *membership)
{
    free(membership->nodes);
    free(membership->node_of);
    *membership = (struct csg_membership){0};
}

void csg_membership_step(struct csg_membership *membership, uint32_t figure, bool is_down)
{
    struct csg_membership_node *node = &membership->nodes[membership->node_of[figure]];
    node->num_turns += is_down ? 1 : -1;
    bool value = value_of(node);
    while (value != node->value) {
        node->value = value;
        if (node->parent == NO_PARENT)
            return;
        struct csg_membership_node *parent = &membership->nodes[node->parent];
        parent->num_true += value ? 1 : UINT32_MAX;
        if (node->is_first)
            parent->first_value = value;
        value = value_of(parent);
        node = parent;
    }
}

bool csg_membership_is_inside(const struct csg_membership *membership)
{
    return membership->nodes[0].value;
}
