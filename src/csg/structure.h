/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_STRUCTURE_H
#define CSG_CSG_STRUCTURE_H

/*
 * What straight-line code is made for: the steps of one object, whatever its parameters. Only a few
 * structures of a scene have a program of their own (CSG_MAX_STRAIGHT_PROGRAMS). Which ones does
 * not depend on the view, so that no camera that moves has another one compiled.
 */

#include "csg/program.h"

/* The largest tree for straight-line code: compile time grows by some ms a leaf. */
#define CSG_STRAIGHT_MAX_STEPS 24
#define CSG_STRAIGHT_MAX_PLANES 8

/* At most; the others share programs. Each costs 5 to 100 ms to compile where the driver's disk
 * cache does not know it. */
#define CSG_MAX_STRAIGHT_PROGRAMS 8

/* Steps of one object, and the number of planes of each. */
struct csg_structure {
    const struct csg_step *steps;
    size_t num;
    const struct csgcast_scene *scene;
};

/* Whether a step has no leaf. */
static inline bool csg_structure_is_pop(const struct csg_structure *structure, size_t step)
{
    return structure->steps[step].flags & CSG_RECORD_POP;
}

bool csg_structure_is_small(const struct csg_structure *structure);

/* Finds the plan's common structures; its steps are there. false: out of memory. */
bool csg_plan_count_structures(struct csg_plan *plan, const struct csgcast_scene *scene);

/* Whether the object is a single solid that crowds hold, or one of the scene's small structures that
 * are met most often. */
bool csg_plan_is_common(const struct csg_plan *plan, size_t object);

/* Whether so many objects have its structure that one picture repays the program. */
bool csg_plan_is_frequent(const struct csg_plan *plan, size_t object);

#endif
