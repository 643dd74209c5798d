/* SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/arguments.h"
#include "scene/digits.h"
#include "scene/edits.h"
#include "scene/load.h"
#include "scene/walk.h"

bool csg_patch_init(struct csg_patch *patch, const struct csgcast_scene *scene, uint32_t leaf)
{
    const struct csg_origin *origin = &scene->edits->origins.data[leaf];
    *patch = (struct csg_patch){.index = leaf, .leaf = scene->leaves[leaf], .origin = *origin};
    patch->has_all_digits = csg_digits_are_all(scene->source->text, scene->source->size);
    patch->leaf.shape.planes = patch->origin.shape.planes = NULL;
    patch->leaf.shape.surface = patch->origin.shape.surface = NULL;
    patch->origin.parameters = NULL;
    if (origin->parameters) {
        const size_t size = strlen(origin->parameters) + 1;
        patch->origin.parameters = malloc(size);
        if (!patch->origin.parameters)
            return false;
        memcpy(patch->origin.parameters, origin->parameters, size);
    }
    return csg_shape_copy(&patch->leaf.shape, &scene->leaves[leaf].shape) &&
           csg_shape_copy(&patch->origin.shape, &origin->shape);
}

void csg_patch_finish(struct csg_patch *patch)
{
    csg_shape_finish(&patch->leaf.shape);
    csg_shape_finish(&patch->origin.shape);
    free(patch->origin.parameters);
}

void csg_patch_set_color(struct csg_patch *patch, const float color[4])
{
    csg_leaf_set_color(&patch->leaf, color);
}

/* Of a number as the text would have it, see csg_value.rounding. */
static double rounding_of(const struct csg_patch *patch, double number)
{
    char text[32];
    struct csg_number read;
    snprintf(text, sizeof text, "%.6g", fabs(number));
    const bool is_short = csg_number_read(text, strlen(text), &read) && read.value == fabs(number);
    return is_short && !patch->has_all_digits ? (double)read.rounding : 0;
}

void csg_patch_set_matrix(struct csg_patch *patch, const double matrix[16])
{
    struct csg_space *space = &patch->origin.space;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++) {
            /* No zero is negative, as in the products of matrices that a text gives. */
            const double entry = matrix[4 * i + j] + 0.0;
            if (space->map.m[i][j] == entry)
                continue;
            space->map.m[i][j] = entry;
            space->error[i][j] = space->in_boolean ? rounding_of(patch, entry) : 0;
        }
    space->is_empty = false;
}

/* "cube(size = 3\n)": the line's end, as a comment may end the parameters. NULL: no memory. */
static char *node_text(const char *name, const char *parameters, size_t *size)
{
    *size = strlen(name) + strlen(parameters) + 3;
    char *text = malloc(*size + 1);
    if (text)
        snprintf(text, *size + 1, "%s(%s\n)", name, parameters);
    return text;
}

/* Reads the solid from its node's text. */
static bool read_solid(struct csg_patch *patch, const struct csgcast_scene *scene, const char *text,
                       size_t size, struct csg_report *report)
{
    const struct csg_solid_ops *ops = csg_solids[patch->leaf.kind];
    struct csg_arguments arguments = {0};
    struct csg_shape shape = {.frame = csg_map_identity};
    struct csg_lexer lexer;
    struct csg_token token;
    csg_lexer_init(&lexer, text, size, 0, (struct csg_place){1, 1});
    csg_lexer_next(&lexer, &token);
    lexer.has_all_digits = patch->has_all_digits;
    lexer.line_begin = strlen(ops->name) + 1; /* columns count from the first parameter */
    bool done = csg_arguments_read(&arguments, &lexer, &token, report) == CSG_DONE;
    if (done && token.type != CSG_TOKEN_END) {
        csg_report_error(report, CSGCAST_MESSAGE_SYNTAX, token.place,
                         "nothing may follow the parameters of %s", ops->name);
        done = false;
    }
    if (done) {
        const struct csg_args args = {.args = arguments.args.data,
                                      .num = arguments.args.num,
                                      .parameters = ops->parameters,
                                      .facets = scene->source->params.facets,
                                      .log = &report->log,
                                      .file = report->file,
                                      .line = 1,
                                      .column = 1,
                                      .node = ops->name};
        csg_warn_of_strange_names(&args);
        const enum csg_read_result result = ops->read(&args, &shape);
        done = result != CSG_READ_ERROR;
        patch->origin.is_nothing = result == CSG_READ_EMPTY;
    }
    csg_arguments_finish(&arguments);
    csg_shape_finish(&patch->origin.shape);
    patch->origin.shape = shape;
    return done;
}

static bool keep_parameters(struct csg_patch *patch, const char *text)
{
    const size_t size = strlen(text) + 1;
    char *copy = malloc(size);
    if (!copy)
        return false;
    memcpy(copy, text, size);
    free(patch->origin.parameters);
    patch->origin.parameters = copy;
    return true;
}

bool csg_patch_set_parameters(struct csg_patch *patch, const struct csgcast_scene *scene,
                              const char *parameters)
{
    struct csg_report report;
    char name[48];
    size_t size;
    if (!patch->origin.parameters) {
        csg_log_error(&scene->log, CSGCAST_MESSAGE_ARGUMENT,
                      "%s:%u:%u: leaf %u is one of the solids that this %s became: its parameters "
                      "cannot be set; load the changed text instead",
                      scene->name, (unsigned)patch->leaf.line, (unsigned)patch->leaf.column,
                      (unsigned)patch->index, csg_kind_name(patch->leaf.kind));
        return false;
    }
    char *text = node_text(csg_solids[patch->leaf.kind]->name, parameters, &size);
    if (!text || !keep_parameters(patch, parameters)) {
        free(text);
        return csg_log_memory(&scene->log);
    }
    snprintf(name, sizeof name, "<edit of leaf %u>", (unsigned)patch->index);
    csg_report_init(&report, &scene->log, name);
    const bool done = read_solid(patch, scene, text, size, &report);
    free(text);
    return csg_report_finish(&report) && done;
}

bool csg_patch_place(struct csg_patch *patch)
{
    struct csg_shape shape;
    patch->leaf.is_empty = true;
    if (patch->origin.is_nothing)
        return true;
    if (!csg_shape_copy(&shape, &patch->origin.shape))
        return false;
    patch->leaf.is_empty = !csg_space_place(&patch->origin.space, &shape);
    csg_shape_finish(&patch->leaf.shape);
    patch->leaf.shape = shape;
    return true;
}

void csg_patch_swap(struct csg_patch *patch, struct csgcast_scene *scene)
{
    struct csg_leaf *leaf = &scene->leaves[patch->index];
    struct csg_origin *origin = &scene->edits->origins.data[patch->index];
    const struct csg_patch before = {patch->index, *leaf, *origin, patch->has_all_digits};
    *leaf = patch->leaf;
    *origin = patch->origin;
    *patch = before;
}
