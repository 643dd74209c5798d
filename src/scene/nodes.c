/* SPDX-License-Identifier: MIT */
#include "scene/nodes.h"

#include <string.h>

#include "scene/transforms.h"
#include "solids/solid.h"

const struct csg_space csg_space_world = {
    .map = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}},
    .color = {-1, -1, -1, 1},
};

static const struct csg_node_ops nodes[] = {
    {"group", CSG_ROLE_UNION, NULL, NULL},
    {"union", CSG_ROLE_UNION, NULL, NULL},
    {"difference", CSG_ROLE_DIFFERENCE, NULL, NULL},
    {"intersection", CSG_ROLE_INTERSECTION, NULL, NULL},
    {"render", CSG_ROLE_UNION, "convexity", NULL},
    {"color", CSG_ROLE_UNION, "c alpha", csg_enter_color},
    {"multmatrix", CSG_ROLE_UNION, "m", csg_enter_multmatrix},
    {"translate", CSG_ROLE_UNION, "v", csg_enter_translate},
    {"rotate", CSG_ROLE_UNION, "a v", csg_enter_rotate},
    {"scale", CSG_ROLE_UNION, "v", csg_enter_scale},
    {"mirror", CSG_ROLE_UNION, "v", csg_enter_mirror},
    {"polyhedron", CSG_ROLE_UNSUPPORTED, NULL, NULL},
    {"linear_extrude", CSG_ROLE_UNSUPPORTED, NULL, NULL},
    {"rotate_extrude", CSG_ROLE_UNSUPPORTED, NULL, NULL},
    {"hull", CSG_ROLE_UNSUPPORTED, NULL, NULL},
    {"minkowski", CSG_ROLE_UNSUPPORTED, NULL, NULL},
    {"resize", CSG_ROLE_UNSUPPORTED, NULL, NULL},
    {"projection", CSG_ROLE_UNSUPPORTED, NULL, NULL},
    {"offset", CSG_ROLE_UNSUPPORTED, NULL, NULL},
    {"import", CSG_ROLE_UNSUPPORTED, NULL, NULL},
    {"surface", CSG_ROLE_UNSUPPORTED, NULL, NULL},
    {"text", CSG_ROLE_UNSUPPORTED, NULL, NULL},
    {"square", CSG_ROLE_UNSUPPORTED, NULL, NULL},
    {"circle", CSG_ROLE_UNSUPPORTED, NULL, NULL},
    {"polygon", CSG_ROLE_UNSUPPORTED, NULL, NULL},
    {"fill", CSG_ROLE_UNSUPPORTED, NULL, NULL},
    {"roof", CSG_ROLE_UNSUPPORTED, NULL, NULL},
    {"import_dxf", CSG_ROLE_UNSUPPORTED, NULL, NULL},
    {"import_stl", CSG_ROLE_UNSUPPORTED, NULL, NULL},
    {"import_off", CSG_ROLE_UNSUPPORTED, NULL, NULL},
    {"dxf_linear_extrude", CSG_ROLE_UNSUPPORTED, NULL, NULL},
    {"dxf_rotate_extrude", CSG_ROLE_UNSUPPORTED, NULL, NULL},
};

enum { num_nodes = sizeof nodes / sizeof nodes[0] };

const struct csg_node_ops *csg_node_find(const char *name, size_t length)
{
    for (size_t i = 0; i < num_nodes; i++)
        if (nodes[i].name[0] == name[0] && strncmp(nodes[i].name, name, length) == 0 &&
            nodes[i].name[length] == '\0')
            return &nodes[i];
    return NULL;
}

/* ---- suggestions ------------------------------------------------------------------------ */

enum { longest_name = 24 }; /* of those that are compared */

static char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

static size_t smaller(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* Levenshtein's edit distance, upper and lower case alike. */
static size_t edit_distance(const char *a, size_t a_length, const char *b, size_t b_length)
{
    size_t row[longest_name + 1];
    for (size_t j = 0; j <= b_length; j++)
        row[j] = j;
    for (size_t i = 1; i <= a_length; i++) {
        size_t diagonal = row[0];
        row[0] = i;
        for (size_t j = 1; j <= b_length; j++) {
            const size_t replaced = diagonal + (lower(a[i - 1]) != lower(b[j - 1]));
            diagonal = row[j];
            row[j] = smaller(replaced, smaller(row[j], row[j - 1]) + 1);
        }
    }
    return row[b_length];
}

/* Keeps candidate in best when it is nearer to name than distance, which is updated. */
static void consider(const char *candidate, const char *name, size_t length, size_t *distance,
                     const char **best)
{
    const size_t candidate_length = strlen(candidate);
    if (candidate_length > longest_name)
        return;
    const size_t candidate_distance = edit_distance(name, length, candidate, candidate_length);
    if (candidate_distance < *distance) {
        *distance = candidate_distance;
        *best = candidate;
    }
}

const char *csg_node_suggest(const char *name, size_t length)
{
    const char *best = NULL;
    size_t distance = length / 3 + 2; /* a third of the letters and one may be wrong */
    if (length > longest_name)
        return NULL;
    for (size_t i = 0; i < CSG_NUM_KINDS; i++)
        consider(csg_solids[i]->name, name, length, &distance, &best);
    for (size_t i = 0; i < num_nodes; i++)
        consider(nodes[i].name, name, length, &distance, &best);
    return best;
}
