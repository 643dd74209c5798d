/* SPDX-License-Identifier: MIT */
#include "csg/part.h"

#include <stdlib.h>

void csg_part_finish(struct csg_part *part)
{
    for (size_t i = 0; i < part->shapes.num; i++)
        csg_shape_finish(&part->shapes.data[i]);
    free(part->shapes.data);
    free(part->tree.data);
    free(part->open.data);
    *part = (struct csg_part){0};
}

bool csg_part_open(struct csg_part *part, bool is_and)
{
    const struct csg_node node = {.op = is_and ? CSG_AND : CSG_OR};
    return csg_array_push(&part->tree, node) &&
           csg_array_push(&part->open, (uint32_t)part->tree.num - 1);
}

void csg_part_close(struct csg_part *part)
{
    part->tree.data[part->open.data[--part->open.num]].end = (uint32_t)part->tree.num;
}

bool csg_part_add(struct csg_part *part, struct csg_shape *shape, bool negated)
{
    const struct csg_node node = {.op = CSG_LEAF,
                                  .negated = negated,
                                  .leaf = (uint32_t)part->shapes.num,
                                  .end = (uint32_t)part->tree.num + 1};
    part->is_too_large |= part->shapes.num >= CSG_PART_MAX_SHAPES;
    if (part->is_too_large) {
        csg_shape_finish(shape);
        return true;
    }
    if (!csg_array_push(&part->shapes, *shape)) {
        csg_shape_finish(shape);
        return false;
    }
    return csg_array_push(&part->tree, node);
}

/* De Morgan: complemented, unions and intersections change places. */
static bool append_nodes(struct csg_part *part, const struct csg_part *other, bool negated)
{
    const uint32_t first = (uint32_t)part->tree.num;
    const uint32_t first_shape = (uint32_t)(part->shapes.num - other->shapes.num);
    for (size_t i = 0; i < other->tree.num; i++) {
        struct csg_node node = other->tree.data[i];
        node.end += first;
        if (node.op == CSG_LEAF) {
            node.leaf += first_shape;
            node.negated = node.negated != negated;
        } else if (negated) {
            node.op = node.op == CSG_OR ? CSG_AND : CSG_OR;
        }
        if (!csg_array_push(&part->tree, node))
            return false;
    }
    return true;
}

bool csg_part_append(struct csg_part *part, struct csg_part *other, bool negated)
{
    bool ok = csg_array_reserve(&part->shapes, other->shapes.num);
    part->is_too_large |=
        other->is_too_large || part->shapes.num + other->shapes.num > CSG_PART_MAX_SHAPES;
    if (ok && !part->is_too_large) {
        for (size_t i = 0; i < other->shapes.num; i++)
            part->shapes.data[part->shapes.num++] = other->shapes.data[i];
        ok = append_nodes(part, other, negated);
        other->shapes.num = 0;
    }
    csg_part_finish(other);
    return ok;
}

struct csg_box csg_part_box(const struct csg_part *part)
{
    struct csg_box box = csg_box_empty;
    for (size_t i = 0; i < part->shapes.num; i++) {
        const struct csg_shape *shape = &part->shapes.data[i];
        const struct csg_box own = csg_box_map(&shape->frame, &shape->bounds);
        box = csg_box_union(&box, &own);
    }
    return box;
}

bool csg_part_is_union(const struct csg_part *part)
{
    for (size_t i = 0; i < part->tree.num; i++) {
        const struct csg_node *node = &part->tree.data[i];
        if (node->op == CSG_LEAF ? node->negated : node->op == CSG_AND && node->end != i + 2)
            return false;
    }
    return true;
}

size_t csg_part_next_uncut(const struct csg_part *part, size_t i)
{
    while (i < part->tree.num) {
        const struct csg_node *node = &part->tree.data[i];
        if (node->op == CSG_LEAF && !node->negated)
            return i;
        i = node->op == CSG_AND && node->end > i + 2 ? node->end : i + 1;
    }
    return i;
}
