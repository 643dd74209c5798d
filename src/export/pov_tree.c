/* SPDX-License-Identifier: MIT */

/*
 * A Boolean tree as POV-Ray's union, intersection and difference. Here complements stand at the
 * leaves; a difference is easier to read, and POV-Ray finds its bounds: operands of an intersection
 * that reach to infinity because a complement is in them are complemented and subtracted.
 */

#include <stdlib.h>

#include "export/pov.h"

/* What is still to be written, last first. */
struct item {
    enum what { NODE, CLOSE, CLOSE_INVERSE } what;
    uint32_t node;
    bool flip; /* NODE: the complement of it */
};

struct writer {
    struct csg_pov *pov;
    const struct csg_object *object;
    const struct csg_node *nodes;
    bool *is_outer; /* per node: a complement reaches to infinity in it */
    bool translucent;
    CSG_ARRAY(struct item) items;
    bool ok;
};

/* A union is as large as its largest operand, an intersection as its smallest. */
static void fill_outer(struct writer *writer)
{
    const struct csg_object *object = writer->object;
    for (uint32_t i = object->end; i-- > object->begin;) {
        const struct csg_node *node = &writer->nodes[i];
        bool outer = node->op == CSG_AND;
        if (node->op == CSG_LEAF)
            outer = node->negated;
        for (uint32_t child = i + 1; child < node->end; child = writer->nodes[child].end)
            outer = node->op == CSG_AND ? outer && writer->is_outer[child - object->begin]
                                        : outer || writer->is_outer[child - object->begin];
        writer->is_outer[i - object->begin] = outer;
    }
}

static bool is_outer(const struct writer *writer, uint32_t node, bool flip)
{
    return writer->is_outer[node - writer->object->begin] != flip;
}

static void push(struct writer *writer, enum what what, uint32_t node, bool flip)
{
    const struct item item = {what, node, flip};
    writer->ok = writer->ok && csg_array_push(&writer->items, item);
}

static void reverse(struct item *items, size_t num)
{
    for (size_t i = 0; i < num / 2; i++) {
        const struct item swapped = items[i];
        items[i] = items[num - 1 - i];
        items[num - 1 - i] = swapped;
    }
}

enum which { INNER, OUTER, ALL }; /* children that reach to infinity, or do not, or either */

/* In an order in which the first one is written first. */
static void push_children(struct writer *writer, uint32_t node, bool flip, enum which which,
                          bool flip_children)
{
    const size_t first = writer->items.num;
    for (uint32_t i = node + 1; i < writer->nodes[node].end; i = writer->nodes[i].end)
        if (which == ALL || is_outer(writer, i, flip) == (which == OUTER))
            push(writer, NODE, i, flip_children);
    if (writer->items.num > first)
        reverse(writer->items.data + first, writer->items.num - first);
}

static size_t count_children(const struct writer *writer, uint32_t node, bool flip, bool outer)
{
    size_t num = 0;
    for (uint32_t i = node + 1; i < writer->nodes[node].end; i = writer->nodes[i].end)
        num += is_outer(writer, i, flip) == outer;
    return num;
}

static const char *union_head(const struct writer *writer)
{
    return writer->translucent ? "merge" : "union"; /* merge: without faces inside */
}

/* The items lie on a stack: what is pushed last is written first. */
static void write_intersection(struct writer *writer, uint32_t node, bool flip)
{
    struct csg_text *text = writer->pov->text;
    const size_t num_inner = count_children(writer, node, flip, false);
    const size_t num_outer = count_children(writer, node, flip, true);
    if (num_inner == 0) {
        csg_text_open(text, union_head(writer));
        push(writer, CLOSE_INVERSE, 0, false);
        push_children(writer, node, flip, OUTER, !flip);
        return;
    }
    if (num_outer) {
        csg_text_open(text, "difference");
        push(writer, CLOSE, 0, false);
        push_children(writer, node, flip, OUTER, !flip);
    }
    if (num_inner > 1) {
        csg_text_open(text, "intersection");
        push(writer, CLOSE, 0, false);
    }
    push_children(writer, node, flip, INNER, flip);
}

static void write_union(struct writer *writer, uint32_t node, bool flip)
{
    csg_text_open(writer->pov->text, union_head(writer));
    push(writer, CLOSE, 0, false);
    push_children(writer, node, flip, ALL, flip);
}

static void write_leaf(struct writer *writer, const struct csg_node *node, bool flip)
{
    char tail[64];
    const size_t paint = csg_pov_paint_find(writer->pov, writer->object, node);
    snprintf(tail, sizeof tail, "texture { Paint%zu }%s", paint,
             node->negated != flip ? " inverse" : "");
    if (!node->negated) {
        writer->ok = writer->ok &&
                     csg_pov_leaf(writer->pov->text, &writer->pov->scene->leaves[node->leaf], tail);
        return;
    }
    struct csg_leaf moved;
    if (!csg_pov_flush_move(writer->pov, node->leaf, &moved)) {
        writer->ok = false;
        return;
    }
    writer->ok = writer->ok && csg_pov_leaf(writer->pov->text, &moved, tail);
    free(moved.shape.planes);
}

static void write_item(struct writer *writer, const struct item *item)
{
    const struct csg_node *node = &writer->nodes[item->node];
    if (item->what != NODE) {
        if (item->what == CLOSE_INVERSE)
            csg_text_line(writer->pov->text, "inverse");
        csg_text_close(writer->pov->text);
    } else if (node->op == CSG_LEAF) {
        write_leaf(writer, node, item->flip);
    } else if ((node->op == CSG_AND) != item->flip) {
        write_intersection(writer, item->node, item->flip);
    } else {
        write_union(writer, item->node, item->flip);
    }
}

static bool is_translucent(const struct writer *writer)
{
    const struct csg_object *object = writer->object;
    for (uint32_t i = object->begin; i < object->end; i++)
        if (writer->nodes[i].op == CSG_LEAF &&
            writer->pov->paints.data[csg_pov_paint_find(writer->pov, object, &writer->nodes[i])]
                    .rgba[3] < 1)
            return true;
    return false;
}

static void write_tree(struct writer *writer)
{
    writer->translucent = is_translucent(writer);
    fill_outer(writer);
    push(writer, NODE, writer->object->begin, false);
    while (writer->ok && writer->items.num) {
        const struct item item = writer->items.data[--writer->items.num];
        write_item(writer, &item);
    }
}

bool csg_pov_object(struct csg_pov *pov, const struct csg_object *object)
{
    char unit[CSG_TEXT_NUMBER];
    struct writer writer = {.pov = pov,
                            .object = object,
                            .nodes = pov->scene->trees[object->layer].data,
                            .is_outer = malloc((object->end - object->begin) * sizeof(bool))};
    writer.ok = writer.is_outer != NULL;
    if (writer.ok) {
        if (pov->unit != 1)
            csg_text_open(pov->text, "object");
        csg_pov_flush_begin(pov, object);
        write_tree(&writer);
        csg_pov_flush_end(pov, object);
        if (pov->unit != 1) {
            csg_text_line(pov->text, "scale %s", csg_text_number(unit, pov->unit));
            csg_text_close(pov->text);
        }
    }
    free(writer.is_outer);
    free(writer.items.data);
    return writer.ok;
}
