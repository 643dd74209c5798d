/* SPDX-License-Identifier: MIT */
#include "model.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/random.h"

double model_random(struct model *model, double lo, double hi)
{
    return csg_random_between(&model->state, lo, hi);
}

static int pick(struct model *model, int num)
{
    return (int)model_random(model, 0, num);
}

void model_random_matrix(struct model *model, double matrix[16])
{
    static const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    memcpy(matrix, identity, sizeof identity);
    const bool grid = pick(model, 2);
    for (int i = 0; i < 3; i++)
        matrix[4 * i + 3] = grid ? pick(model, 7) : model_random(model, 0, 7);
    if (grid)
        return;
    const double angle = model_random(model, 0, 6.28);
    const int i = pick(model, 3), j = (i + 1) % 3;
    matrix[5 * i] = matrix[5 * j] = cos(angle);
    matrix[4 * i + j] = -sin(angle);
    matrix[4 * j + i] = sin(angle);
    for (int k = 0; k < 3; k++)
        matrix[5 * k] *= model_random(model, 0.5, 1.5);
}

void model_random_parameters(struct model *model, const char *kind, char parameters[128])
{
    const int a = 1 + pick(model, 4), b = 1 + pick(model, 4), c = 1 + pick(model, 4);
    if (strcmp(kind, "cube") == 0)
        snprintf(parameters, 128, "size = [%d, %d, %.9g]", a, b, model_random(model, 0.5, 5));
    else if (strcmp(kind, "sphere") == 0)
        snprintf(parameters, 128, "r = %.9g", model_random(model, 0.5, 3));
    else
        snprintf(parameters, 128, "h = %d, r1 = %d, r2 = %.9g, center = true", a, b,
                 pick(model, 2) ? b : 0.25 * c);
}

bool model_has_parameters(const struct model_leaf *leaf)
{
    return strcmp(leaf->kind, "linear_extrude") != 0;
}

void model_random_color(struct model *model, float color[4])
{
    for (int i = 0; i < 3; i++)
        color[i] = (float)pick(model, 5) / 4;
    color[3] = pick(model, 4) ? 1 : 0.5f;
}

/* What has no parameters that an edit can set, but a polygon: a surface of triangles. */
static void add_twisted(struct model *model)
{
    struct model_leaf *leaf = &model->leaves[model->num_leaves++];
    leaf->kind = "linear_extrude";
    snprintf(leaf->parameters, sizeof leaf->parameters,
             "height = %d, twist = 90, slices = 8) square([%d, %d]", 1 + pick(model, 3),
             1 + pick(model, 3), 1 + pick(model, 3));
    model_random_matrix(model, leaf->matrix);
    leaf->color[0] = -1;
}

static void add_leaf(struct model *model)
{
    static const char *const kinds[] = {"cube", "sphere", "cylinder"};
    struct model_leaf *leaf = &model->leaves[model->num_leaves++];
    leaf->kind = kinds[pick(model, 3)];
    model_random_parameters(model, leaf->kind, leaf->parameters);
    model_random_matrix(model, leaf->matrix);
    leaf->color[0] = -1;
    if (pick(model, 3) == 0)
        model_random_color(model, leaf->color);
}

/* Recursion is four deep. */
static void add_node(struct model *model, int max_leaves, int depth)
{
    struct model_node *node = &model->nodes[model->num_nodes++];
    const bool is_leaf = depth == 0 || model->num_leaves + 2 > max_leaves || pick(model, 4) == 0;
    *node = (struct model_node){is_leaf ? 0 : 1 + pick(model, 3), 0, NULL};
    if (is_leaf) {
        add_leaf(model);
        return;
    }
    const int num = 2 + pick(model, 2);
    for (; node->num < num && model->num_leaves < max_leaves; node->num++)
        add_node(model, max_leaves, depth - 1);
}

void model_init(struct model *model, uint64_t seed, int max_leaves)
{
    memset(model, 0, sizeof *model);
    model->state = seed;
    struct model_node *root = &model->nodes[model->num_nodes++];
    root->op = 1;
    for (; model->num_leaves < max_leaves && model->num_nodes < 64; root->num++)
        add_node(model, max_leaves, 4);
}

/* Cells of the grid, and their size. */
enum { NUM_CELLS = 6, CELL = 5 };

void model_init_many(struct model *model, uint64_t seed, int num_objects, bool marked,
                     bool has_surfaces)
{
    static const char *const marks[] = {"#", "%", "render() "};
    memset(model, 0, sizeof *model);
    model->state = seed;
    model->nodes[model->num_nodes++] = (struct model_node){1, num_objects, NULL};
    for (int i = 0; i < num_objects; i++) {
        const int num = pick(model, 3) ? 1 : 2 + pick(model, 2), first = model->num_leaves;
        const int place[3] = {i % NUM_CELLS, i / NUM_CELLS % NUM_CELLS, i / NUM_CELLS / NUM_CELLS};
        const char *mark = marked && i % 20 == 0 ? marks[pick(model, 3)] : NULL;
        const int node = model->num_nodes;
        if (num > 1)
            model->nodes[model->num_nodes++] = (struct model_node){2 + pick(model, 2), num, NULL};
        for (int j = 0; j < num; j++) {
            model->nodes[model->num_nodes++] = (struct model_node){0, 0, NULL};
            if (has_surfaces && pick(model, 10) == 0)
                add_twisted(model);
            else
                add_leaf(model);
        }
        model->nodes[node].mark = mark;
        for (int j = first; j < model->num_leaves && mark && mark[0] == 'r'; j++) {
            model->leaves[j].is_rendered = true;
            model->leaves[j].color[0] = -1;
        }
        for (int j = first; j < model->num_leaves; j++)
            for (int k = 0; k < 3; k++) {
                model->leaves[j].place[k] = CELL * place[k];
                model->leaves[j].matrix[4 * k + 3] += CELL * place[k];
            }
    }
}

struct printer {
    char *text;
    size_t num;
    const struct model *model;
    int node, leaf;
};

static void put(struct printer *printer, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    printer->num += (size_t)vsnprintf(printer->text + printer->num, MODEL_MAX_TEXT - printer->num,
                                      format, args);
    va_end(args);
    if (printer->num >= MODEL_MAX_TEXT)
        abort();
}

static void put_leaf(struct printer *printer)
{
    const struct model_leaf *leaf = &printer->model->leaves[printer->leaf++];
    if (leaf->color[0] >= 0)
        put(printer, "color([%.9g, %.9g, %.9g, %.9g]) ", (double)leaf->color[0],
            (double)leaf->color[1], (double)leaf->color[2], (double)leaf->color[3]);
    put(printer, "multmatrix([");
    for (int i = 0; i < 4; i++)
        put(printer, "[%.17g, %.17g, %.17g, %.17g]%s", leaf->matrix[4 * i], leaf->matrix[4 * i + 1],
            leaf->matrix[4 * i + 2], leaf->matrix[4 * i + 3], i < 3 ? ", " : "]) ");
    put(printer, "%s(%s);\n", leaf->kind, leaf->parameters);
}

static void put_node(struct printer *printer)
{
    static const char *const ops[] = {"", "union", "difference", "intersection"};
    const struct model_node *node = &printer->model->nodes[printer->node++];
    put(printer, "%s", node->mark ? node->mark : "");
    if (node->op == 0) {
        put_leaf(printer);
        return;
    }
    put(printer, "%s() {\n", ops[node->op]);
    for (int i = 0; i < node->num; i++)
        put_node(printer);
    put(printer, "}\n");
}

void model_print(const struct model *model, char text[MODEL_MAX_TEXT])
{
    struct printer printer = {.text = text, .model = model};
    put_node(&printer);
}
