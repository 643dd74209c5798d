/* SPDX-License-Identifier: MIT */
#include "csg/program.h"

#include <stdlib.h>

/* ---- what edits may ask for ---------------------------------------------------------------- */

struct survey {
    struct csg_plan *plan;
    const struct csgcast_scene *scene;
    bool singles[2][CSG_PLAN_MAX_PLANES + 1], lefts[2][CSG_PLAN_MAX_PLANES + 1]; /* were met */
};

/* The first solid of its kind that could be a member of a crowd. */
static bool is_first(const struct survey *survey, uint32_t leaf,
                     bool met[2][CSG_PLAN_MAX_PLANES + 1])
{
    const struct csg_shape *shape = &survey->scene->leaves[leaf].shape;
    if (shape->surface || shape->num_planes > CSG_PLAN_MAX_PLANES ||
        met[shape->has_quadric][shape->num_planes])
        return false;
    return met[shape->has_quadric][shape->num_planes] = true;
}

static bool is_like(const struct survey *survey, uint32_t a, uint32_t b)
{
    const struct csg_plan *plan = survey->plan;
    const struct csg_step *x = plan->program.data + plan->begin[a];
    const struct csg_step *y = plan->program.data + plan->begin[b];
    const size_t num = plan->begin[a + 1] - plan->begin[a];
    bool same = num == plan->begin[b + 1] - plan->begin[b];
    for (size_t i = 0; i < num && same; i++)
        same = x[i].flags == y[i].flags && (x[i].flags & CSG_RECORD_POP ||
                                            survey->scene->leaves[x[i].leaf].shape.num_planes ==
                                                survey->scene->leaves[y[i].leaf].shape.num_planes);
    return same;
}

/* There may be more structures than these, in which case an edit compiles one. */
static void add_spared(struct survey *survey, uint32_t object)
{
    struct csg_plan *plan = survey->plan;
    for (size_t i = 0; i < plan->num_spared; i++)
        if (is_like(survey, plan->spared[i], object))
            return;
    if (plan->num_spared < CSG_PLAN_MAX_SPARED)
        plan->spared[plan->num_spared++] = object;
}

static void look_at(struct survey *survey, uint32_t index)
{
    struct csg_plan *plan = survey->plan;
    const struct csg_object *object = &survey->scene->objects->data[index];
    const struct csg_node *nodes = survey->scene->trees[object->layer].data;
    size_t num = 0, num_spare = 0;
    if (plan->begin[index + 1] == plan->begin[index] + 1) {
        const uint32_t leaf = plan->program.data[plan->begin[index]].leaf;
        if (is_first(survey, leaf, survey->singles))
            plan->singles[plan->num_singles++] = index;
    }
    if (object->crowded)
        return;
    for (uint32_t i = object->begin; i < object->end; i++) {
        if (nodes[i].op != CSG_LEAF)
            continue;
        num++;
        num_spare += nodes[i].spare;
        if (!nodes[i].negated && is_first(survey, nodes[i].leaf, survey->lefts))
            plan->lefts[plan->num_lefts++] = nodes[i].leaf;
    }
    if (num > 1 && num_spare == num - 1)
        add_spared(survey, index);
}

static bool fill(struct csg_plan *plan, const struct csgcast_scene *scene)
{
    const struct csg_objects *objects = scene->objects;
    plan->begin = malloc((objects->num + 1) * sizeof *plan->begin);
    if (!plan->begin)
        return false;
    for (size_t i = 0; i < objects->num; i++) {
        const struct csg_object *object = &objects->data[i];
        plan->begin[i] = (uint32_t)plan->program.num;
        if (!csg_program_append(&plan->program, scene, &scene->trees[object->layer], object->begin))
            return false;
    }
    plan->begin[objects->num] = (uint32_t)plan->program.num;
    struct survey survey = {.plan = plan, .scene = scene};
    for (uint32_t i = 0; i < objects->num && scene->keeps_structure; i++)
        look_at(&survey, i);
    return true;
}

struct csg_plan *csg_plan_create(const struct csgcast_scene *scene)
{
    struct csg_plan *plan = calloc(1, sizeof *plan);
    if (plan && fill(plan, scene))
        return plan;
    csg_plan_destroy(plan);
    return NULL;
}

void csg_plan_destroy(struct csg_plan *plan)
{
    if (!plan)
        return;
    free(plan->program.data);
    free(plan->begin);
    free(plan);
}
