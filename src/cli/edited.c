/* SPDX-License-Identifier: MIT */
#include "edited.h"

#include "messages.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EDIT_STEP 0.01 /* of the scene's size, or a parameter's value: how far it changes at most */

/* Where the first number is that belongs to none of $fn and its like; the end: there is none. */
static const char *first_number(const char *text)
{
    for (bool is_special = false; *text; text++) {
        if (*text == '$' || *text == ',')
            is_special = *text == '$';
        const char *digits = text + (*text == '-') + (text[*text == '-'] == '.');
        if (!is_special && isdigit((unsigned char)*digits))
            return text;
        while (isalnum((unsigned char)text[0]) && isalnum((unsigned char)text[1]))
            text++; /* a name, and what digits are in it */
    }
    return text;
}

/* Of the first of the leaf's nodes that has a number that can be changed, else of the leaf's own.
 */
static bool find_parameters(struct csg_edited *edited, struct csgcast_scene *scene,
                            size_t num_nodes)
{
    struct csgcast_node node = {0};
    edited->node = 0;
    while (edited->node < num_nodes &&
           csgcast_scene_get_node(scene, edited->leaf, edited->node, &node) &&
           !*first_number(node.parameters))
        edited->node++;
    edited->node = edited->node < num_nodes ? edited->node : 0;
    if (!csgcast_scene_get_node(scene, edited->leaf, edited->node, &node))
        return false;
    edited->parameters = malloc(strlen(node.parameters) + 1);
    if (!edited->parameters)
        return csg_cli_error("out of memory"), false;
    strcpy(edited->parameters, node.parameters);
    return true;
}

bool csg_edited_init(struct csg_edited *edited, const struct csg_cli_options *options,
                     struct csgcast_scene *scene)
{
    struct csgcast_leaf leaf;
    double lo[3], hi[3];
    const size_t num = csgcast_scene_num_leaves(scene);
    if (num == 0 || options->edited_leaf >= (long)num) {
        csg_cli_error("--edit: the scene has %zu leaves", num);
        return false;
    }
    edited->what = options->edit_what;
    edited->leaf = options->edited_leaf >= 0 ? (size_t)options->edited_leaf : num - 1;
    if (!csgcast_scene_get_leaf(scene, edited->leaf, &leaf))
        return false;
    edited->leaf = leaf.first; /* the node may become fewer leaves */
    memcpy(edited->matrix, leaf.matrix, sizeof edited->matrix);
    if (!find_parameters(edited, scene, leaf.num_nodes))
        return false;
    const bool bounded = csgcast_scene_get_bounds(scene, lo, hi) && isfinite(hi[0] - lo[0]);
    edited->step = bounded ? EDIT_STEP * (hi[0] - lo[0]) : EDIT_STEP;
    return true;
}

void csg_edited_finish(struct csg_edited *edited)
{
    free(edited->parameters);
}

static bool change_parameters(const struct csg_edited *edited, struct csgcast_scene *scene,
                              double share)
{
    const char *number = first_number(edited->parameters);
    char *end;
    const double value = strtod(number, &end);
    const size_t size = strlen(edited->parameters) + 32;
    char *text = malloc(size);
    if (!text)
        return csg_cli_error("out of memory"), false;
    snprintf(text, size, "%.*s%.17g%s", (int)(number - edited->parameters), edited->parameters,
             value * (1 + share), end);
    const struct csgcast_edit edit = {.leaf = edited->leaf,
                                      .node = edited->node,
                                      .parameters = *number ? text : edited->parameters};
    const bool done = csgcast_scene_edit(scene, &edit, 1);
    free(text);
    return done;
}

bool csg_edited_change(const struct csg_edited *edited, struct csgcast_scene *scene, int frame)
{
    const double swing = sin(0.7 * (frame + 1));
    const float color[4] = {(float)(0.5 + 0.5 * swing), 0.5f, 0.25f, 1};
    double matrix[16];
    if (edited->what == CSG_CLI_EDIT_COLOR)
        return csgcast_scene_set_color(scene, edited->leaf, color);
    if (edited->what == CSG_CLI_EDIT_PARAMETERS)
        return change_parameters(edited, scene, EDIT_STEP * swing);
    memcpy(matrix, edited->matrix, sizeof matrix);
    matrix[3] += edited->step * swing; /* along x */
    return csgcast_scene_set_matrix(scene, edited->leaf, matrix);
}
