/* SPDX-License-Identifier: MIT */
#include "scene_print.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

void text_add(struct text *text, const char *format, ...)
{
    char piece[4096];
    va_list args;
    va_start(args, format);
    vsnprintf(piece, sizeof piece, format, args);
    va_end(args);
    for (const char *c = piece; *c; c++)
        if (!csg_array_push(text, *c))
            abort();
    if (!csg_array_push(text, '\0'))
        abort();
    text->num--;
}

static void print_node(const struct csgcast_scene *scene, const struct csg_node *node, size_t depth,
                       struct text *text)
{
    static const char *const names[] = {"leaf", "or", "and"};
    text_add(text, "%*s", (int)(2 * depth), "");
    if (node->op == CSG_LEAF)
        text_add(text, "%s%s %u\n", node->negated ? "not " : "",
                 csg_kind_name(scene->leaves[node->leaf].kind), (unsigned)node->leaf);
    else
        text_add(text, "%s\n", names[node->op]);
}

static void print_tree(const struct csgcast_scene *scene, const struct csg_tree *tree,
                       struct text *text)
{
    CSG_ARRAY(size_t) ends = {0};
    for (size_t i = 0; i < tree->num; i++) {
        while (ends.num > 0 && ends.data[ends.num - 1] <= i)
            ends.num--;
        print_node(scene, &tree->data[i], ends.num + 1, text);
        if (!csg_array_push(&ends, (size_t)tree->data[i].end))
            abort();
    }
    free(ends.data);
}

/* No -0, and no differences beyond the digits that matter. */
static double tidy(double value)
{
    return fabs(value) < 1e-12 ? 0 : value;
}

static void print_leaf(const struct csg_leaf *leaf, size_t index, struct text *text)
{
    const struct csg_box box = csg_box_map(&leaf->shape.frame, &leaf->shape.bounds);
    text_add(text, "  %zu %s at %u:%u", index, csg_kind_name(leaf->kind), (unsigned)leaf->line,
             (unsigned)leaf->column);
    text_add(text, " box [%g %g %g] [%g %g %g]", tidy(box.lo.x), tidy(box.lo.y), tidy(box.lo.z),
             tidy(box.hi.x), tidy(box.hi.y), tidy(box.hi.z));
    if (leaf->color[0] >= 0)
        text_add(text, " color %g %g %g %g", (double)leaf->color[0], (double)leaf->color[1],
                 (double)leaf->color[2], (double)leaf->color[3]);
    if (leaf->shape.facetted)
        text_add(text, " facetted");
    if (leaf->shape.rounding > 0)
        text_add(text, " rounding %.3g", leaf->shape.rounding);
    text_add(text, "\n");
}

void scene_print(const struct csgcast_scene *scene, struct text *text)
{
    static const char *const layers[CSG_NUM_LAYERS] = {"model", "background", "highlight"};
    for (int layer = 0; layer < CSG_NUM_LAYERS; layer++)
        if (scene->trees[layer].num > 0) {
            text_add(text, "%s\n", layers[layer]);
            print_tree(scene, &scene->trees[layer], text);
        }
    if (scene->num_leaves > 0)
        text_add(text, "leaves\n");
    for (size_t i = 0; i < scene->num_leaves; i++)
        print_leaf(&scene->leaves[i], i, text);
}
