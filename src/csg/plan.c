/* SPDX-License-Identifier: MIT */
#include "csg/structure.h"

#include <stdlib.h>

#include "csg/prune.h"

/* ---- what edits may ask for ---------------------------------------------------------------- */

/* Met are those with a quadric or without and each number of planes. */
typedef bool met_leaves[2][CSG_PLAN_MAX_PLANES + 1];

/* The first solid of its kind that could be a member of a crowd. */
static bool is_first(const struct csg_shape *shape, met_leaves met)
{
    if (shape->surface || shape->num_planes > CSG_PLAN_MAX_PLANES ||
        met[shape->has_quadric][shape->num_planes])
        return false;
    return met[shape->has_quadric][shape->num_planes] = true;
}

static void list_lefts(struct csg_plan *plan, const struct csgcast_scene *scene, met_leaves met,
                       const struct csg_object *object)
{
    const struct csg_node *nodes = scene->trees[object->layer].data;
    const bool is_small = object->end - object->begin <= CSG_KEPT_MAX_NODES;
    for (uint32_t i = object->begin; i < object->end && is_small; i++)
        if (nodes[i].op == CSG_LEAF && !nodes[i].negated &&
            is_first(&scene->leaves[nodes[i].leaf].shape, met))
            plan->lefts[plan->num_lefts++] = nodes[i].leaf;
}

static bool add_objects(struct csg_plan *plan, const struct csgcast_scene *scene)
{
    const struct csg_objects *objects = scene->objects;
    struct csg_program_room room = {0};
    bool ok = true;
    for (size_t i = 0; i < objects->num && ok; i++) {
        const struct csg_object *object = &objects->data[i];
        plan->begin[i] = (uint32_t)plan->program.num;
        ok = csg_program_append(&room, &plan->program, scene, &scene->trees[object->layer],
                                object->begin);
    }
    plan->begin[objects->num] = (uint32_t)plan->program.num;
    csg_program_room_finish(&room);
    return ok;
}

static bool fill(struct csg_plan *plan, const struct csgcast_scene *scene)
{
    const struct csg_objects *objects = scene->objects;
    plan->begin = malloc((objects->num + 1) * sizeof *plan->begin);
    if (!plan->begin || !add_objects(plan, scene) || !csg_plan_count_structures(plan, scene))
        return false;
    for (size_t i = 0; i < scene->num_leaves && scene->keeps_structure; i++) {
        plan->has_rings |= scene->leaves[i].kind == CSG_KIND_ROTATE_EXTRUDE;
        plan->has_compounds |= scene->leaves[i].kind >= CSG_NUM_KINDS;
    }
    met_leaves met = {{false}};
    for (size_t i = 0; i < objects->num && scene->keeps_structure; i++)
        list_lefts(plan, scene, met, &objects->data[i]);
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
    free(plan->structures);
    free(plan);
}
