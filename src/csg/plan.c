/* SPDX-License-Identifier: MIT */
#include "csg/program.h"

#include <stdlib.h>

static void find_singles(struct csg_plan *plan, const struct csgcast_scene *scene)
{
    bool seen[2][CSG_PLAN_MAX_PLANES + 1] = {{false}};
    for (uint32_t i = 0; i < scene->objects->num; i++) {
        if (plan->begin[i + 1] != plan->begin[i] + 1)
            continue;
        const struct csg_shape *shape =
            &scene->leaves[plan->program.data[plan->begin[i]].leaf].shape;
        if (shape->surface || shape->num_planes > CSG_PLAN_MAX_PLANES ||
            seen[shape->has_quadric][shape->num_planes])
            continue;
        seen[shape->has_quadric][shape->num_planes] = true;
        plan->singles[plan->num_singles++] = i;
    }
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
        if (!csg_program_append(&plan->program, scene, &scene->trees[object->layer],
                                object->begin))
            return false;
    }
    plan->begin[objects->num] = (uint32_t)plan->program.num;
    find_singles(plan, scene);
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
