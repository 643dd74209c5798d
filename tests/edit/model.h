/* SPDX-License-Identifier: MIT */
#ifndef TESTS_EDIT_MODEL_H
#define TESTS_EDIT_MODEL_H

/* A random scene that can be changed in one place: each solid has its own matrix and colour. */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MODEL_MAX_LEAVES 512
#define MODEL_MAX_NODES 1024
#define MODEL_MAX_TEXT 262144

struct model_leaf {
    const char *kind;
    char parameters[128];
    double matrix[16];
    float color[4];   /* r < 0: none */
    double place[3];  /* of its object, where there are many */
    bool is_rendered; /* in a render(), where no colour stands */
};

/* The tree in pre-order: a leaf, or an op with this many operands. */
struct model_node {
    int op; /* 0 leaf, 1 union, 2 difference, 3 intersection */
    int num;
    const char *mark; /* before it: "#", "%" or "render() "; NULL: nothing */
};

struct model {
    uint64_t state; /* of the random numbers */
    struct model_leaf leaves[MODEL_MAX_LEAVES];
    struct model_node nodes[MODEL_MAX_NODES];
    int num_leaves, num_nodes;
};

/* Uniform in [lo, hi). */
double model_random(struct model *model, double lo, double hi);

/* Not more than max_leaves, at most 48. */
void model_init(struct model *model, uint64_t seed, int max_leaves);

/* Objects of one solid to three in a grid of places, some of them with flush faces; marked: some
 * under #, % or render(); has_surfaces: some are surfaces of triangles, whose parameters cannot be
 * set. */
void model_init_many(struct model *model, uint64_t seed, int num_objects, bool marked,
                     bool has_surfaces);

/* Whether the parameters can be set. */
bool model_has_parameters(const struct model_leaf *leaf);

void model_random_matrix(struct model *model, double matrix[16]);

/* Other parameters of the same kind, with as many faces. */
void model_random_parameters(struct model *model, const char *kind, char parameters[128]);

void model_random_color(struct model *model, float color[4]);

/* The scene as .csg text. */
void model_print(const struct model *model, char text[MODEL_MAX_TEXT]);

#endif
