/* SPDX-License-Identifier: MIT */
#include "csg/structure.h"

#include <stdlib.h>

#include "common/hash.h"
#include "csg/scene.h"

/* What an object has in place of a number of a structure. */
enum { SINGLE = CSG_PLAN_MAX_STRUCTURES, RARE };

static const struct csg_shape *shape_of(const struct csg_structure *structure, size_t step)
{
    return &structure->scene->leaves[structure->steps[step].leaf].shape;
}

bool csg_structure_is_small(const struct csg_structure *structure)
{
    if (structure->num > CSG_STRAIGHT_MAX_STEPS)
        return false;
    for (size_t i = 0; i < structure->num; i++)
        if (structure->steps[i].flags & CSG_RECORD_SURFACE ||
            (!csg_structure_is_pop(structure, i) &&
             shape_of(structure, i)->num_planes > CSG_STRAIGHT_MAX_PLANES))
            return false;
    return true;
}

/* Crowds draw such solids; those of more planes, and what is not convex, are drawn one by one. */
static bool is_single(const struct csg_structure *structure)
{
    return structure->num == 1 && shape_of(structure, 0)->convex &&
           shape_of(structure, 0)->num_planes <= CSG_PLAN_MAX_PLANES;
}

/* Of what straight-line text depends on: flags, planes and file order of the leaves. */
static uint64_t hash_of(const struct csg_structure *structure)
{
    uint64_t hash = CSG_HASH_START;
    for (size_t i = 0; i < structure->num; i++) {
        hash = csg_hash_number(hash, structure->steps[i].flags);
        if (csg_structure_is_pop(structure, i))
            continue;
        const struct csg_shape *shape = shape_of(structure, i);
        hash = csg_hash_number(hash, 2 * shape->num_planes + csg_shape_is_paired(shape));
        size_t rank = 0;
        for (size_t j = 0; j < i; j++)
            rank += !csg_structure_is_pop(structure, j) &&
                    structure->steps[j].leaf < structure->steps[i].leaf;
        hash = csg_hash_number(hash, rank);
    }
    return hash;
}

/* Objects of a structure from which on one picture repays its program, as each of them would be cut
 * into tiles, and so much of the scene that few structures are. */
enum { MIN_FREQUENT = 64, MAX_FREQUENT_STRUCTURES = 6 };

struct tally {
    uint64_t hash;
    size_t num; /* objects; 0: nothing here */
};

/* Scenes of more structures than there is room for have those counted that come first. */
static uint8_t count(struct tally *tallies, uint64_t hash)
{
    for (size_t i = 0; i < CSG_PLAN_MAX_STRUCTURES; i++) {
        const size_t at = (hash + i) % CSG_PLAN_MAX_STRUCTURES;
        if (tallies[at].num == 0)
            tallies[at].hash = hash;
        if (tallies[at].hash == hash) {
            tallies[at].num++;
            return (uint8_t)at;
        }
    }
    return RARE;
}

static bool is_frequent(const struct tally *tally, size_t num_objects)
{
    return tally->num >= MIN_FREQUENT && tally->num * MAX_FREQUENT_STRUCTURES >= num_objects;
}

static void choose_common(struct csg_plan *plan, struct tally *tallies, size_t num_objects)
{
    for (int k = 0; k < CSG_MAX_STRAIGHT_PROGRAMS; k++) {
        size_t most = 0;
        for (size_t i = 1; i < CSG_PLAN_MAX_STRUCTURES; i++)
            most = tallies[i].num > tallies[most].num ? i : most;
        plan->is_common[most] |= tallies[most].num > 0;
        plan->is_frequent[most] |= is_frequent(&tallies[most], num_objects);
        tallies[most].num = 0;
    }
}

bool csg_plan_count_structures(struct csg_plan *plan, const struct csgcast_scene *scene)
{
    const size_t num_objects = scene->objects->num;
    struct tally tallies[CSG_PLAN_MAX_STRUCTURES] = {{0}};
    plan->structures = malloc(num_objects + 1);
    if (!plan->structures)
        return false;
    for (size_t i = 0; i < num_objects; i++) {
        const struct csg_structure structure = {plan->program.data + plan->begin[i],
                                                plan->begin[i + 1] - plan->begin[i], scene};
        plan->structures[i] = is_single(&structure) ? SINGLE
                              : csg_structure_is_small(&structure)
                                  ? count(tallies, hash_of(&structure))
                                  : RARE;
    }
    choose_common(plan, tallies, num_objects);
    return true;
}

bool csg_plan_is_common(const struct csg_plan *plan, size_t object)
{
    const uint8_t structure = plan->structures[object];
    return structure == SINGLE || (structure != RARE && plan->is_common[structure]);
}

bool csg_plan_is_frequent(const struct csg_plan *plan, size_t object)
{
    const uint8_t structure = plan->structures[object];
    return structure < CSG_PLAN_MAX_STRUCTURES && plan->is_frequent[structure];
}
