/* SPDX-License-Identifier: MIT */
#include "edited.h"

#include "messages.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EDIT_STEP 0.01 /* of the scene's size, or a parameter's value: how far it changes at most */

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
    memcpy(edited->matrix, leaf.matrix, sizeof edited->matrix);
    edited->parameters = malloc(strlen(leaf.parameters) + 1);
    if (!edited->parameters)
        return csg_cli_error("out of memory"), false;
    strcpy(edited->parameters, leaf.parameters);
    const bool bounded = csgcast_scene_get_bounds(scene, lo, hi) && isfinite(hi[0] - lo[0]);
    edited->step = bounded ? EDIT_STEP * (hi[0] - lo[0]) : EDIT_STEP;
    return true;
}

void csg_edited_finish(struct csg_edited *edited)
{
    free(edited->parameters);
}

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
    const bool done =
        csgcast_scene_set_parameters(scene, edited->leaf, *number ? text : edited->parameters);
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
