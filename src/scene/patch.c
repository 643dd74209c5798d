/* SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "document/digits.h"
#include "nodes/walk.h"
#include "scene/edits.h"
#include "scene/parameters.h"
#include "scene/source.h"

bool csg_patch_init(struct csg_patch *patch, const struct csgcast_scene *scene, uint32_t leaf)
{
    const struct csg_origin *origin = &scene->edits->origins.data[leaf];
    *patch = (struct csg_patch){.index = leaf, .leaf = scene->leaves[leaf], .origin = *origin};
    patch->has_all_digits = csg_digits_are_all(scene->source->text, scene->source->size);
    patch->leaf.shape.planes = patch->origin.shape.planes = NULL;
    patch->leaf.shape.surface = patch->origin.shape.surface = NULL;
    return csg_shape_copy(&patch->leaf.shape, &scene->leaves[leaf].shape) &&
           csg_shape_copy(&patch->origin.shape, &origin->shape);
}

void csg_patch_finish(struct csg_patch *patch)
{
    csg_shape_finish(&patch->leaf.shape);
    csg_shape_finish(&patch->origin.shape);
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

/* Reads the solid from its node's parameters. */
static bool read_solid(struct csg_patch *patch, const struct csgcast_scene *scene,
                       const struct csg_parameters *parameters)
{
    const struct csg_solid_ops *ops = csg_solids[patch->leaf.kind];
    struct csg_shape shape = {.frame = csg_map_identity};
    const struct csg_args args = {.args = parameters->arguments.args.data,
                                  .num = parameters->arguments.args.num,
                                  .parameters = ops->parameters,
                                  .facets = scene->source->params.facets,
                                  .log = &parameters->report.log,
                                  .file = parameters->file,
                                  .line = 1,
                                  .column = 1,
                                  .node = ops->name};
    csg_warn_of_strange_names(&args);
    const enum csg_read_result result = ops->read(&args, &shape);
    patch->origin.is_nothing = result == CSG_READ_EMPTY;
    csg_shape_finish(&patch->origin.shape);
    patch->origin.shape = shape;
    return result != CSG_READ_ERROR;
}

bool csg_patch_set_parameters(struct csg_patch *patch, const struct csgcast_scene *scene,
                              const char *text)
{
    const char *node = csg_solids[patch->leaf.kind]->name;
    struct csg_parameters parameters;
    const bool done = csg_parameters_read(&parameters, scene, patch->index, node, text) &&
                      read_solid(patch, scene, &parameters);
    return csg_parameters_finish(&parameters) && done;
}

void csg_patch_set_shape(struct csg_patch *patch, enum csg_kind kind, struct csg_shape *shape)
{
    patch->leaf.kind = kind;
    patch->origin.is_nothing = false;
    csg_shape_finish(&patch->origin.shape);
    patch->origin.shape = *shape;
    *shape = (struct csg_shape){0};
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
    const struct csg_patch before = {patch->index, *leaf, *origin, patch->has_all_digits,
                                     patch->is_read};
    *leaf = patch->leaf;
    *origin = patch->origin;
    *patch = before;
}
