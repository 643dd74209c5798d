/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_PROGRAM_H
#define CSG_CSG_PROGRAM_H

/*
 * A tree as steps of a machine with one accumulator and a stack (shaders/csg/program.glsl). Of a
 * node's operands the one that needs the deepest stack comes first and works in the accumulator
 * itself, so the stack holds at most log2(leaves) operands (Sethi and Ullman 1970).
 */

#include "csg/object.h"
#include "common/layout.glsl"

struct csg_step {
    uint32_t leaf;  /* unused by POP */
    uint32_t flags; /* CSG_RECORD_... */
};

/* Of those that begin at once the one that shows has the least: solids before complements, then in
 * the order of the file (csg_choose in shaders/csg). */
static inline uint64_t csg_step_rank(const struct csg_step *step)
{
    return step->leaf + (step->flags & CSG_RECORD_NEGATED ? (uint64_t)1 << 32 : 0);
}

struct csg_program {
    struct csg_step *data;
    size_t num, capacity;
};

/* CSG_RECORD_NEGATED, _SURFACE, _QUADRIC and _GAP of a leaf's node. */
uint32_t csg_node_flags(const struct csgcast_scene *scene, const struct csg_node *node);

/*
 * Whether the node, not the root, is an intersection of convex solids, or the complement of one, in
 * the order of the file: rays are inside of it between two keys, so it may be one literal.
 */
bool csg_node_is_product(const struct csgcast_scene *scene, const struct csg_tree *tree,
                         uint32_t node);

/* What it takes to append to one: zeroed before the first time, kept for the next. */
struct csg_program_room {
    bool products; /* intersections of convex solids, or their complements, are one literal */
    CSG_ARRAY(uint8_t) needs; /* stack entries that a subtree needs, by node */
    CSG_ARRAY(struct csg_program_task {
        uint32_t node;
        uint32_t flags; /* of the subtree's first step, or CSG_RECORD_POP */
    })
    tasks; /* still to do: run a subtree, or combine with the stack */
};

/* Appends the steps of the subtree at nodes [begin, end) of tree. false: out of memory. */
bool csg_program_append(struct csg_program_room *room, struct csg_program *program,
                        const struct csgcast_scene *scene, const struct csg_tree *tree,
                        uint32_t begin);
void csg_program_room_finish(struct csg_program_room *room);

/* Members of crowds (crowd/crowd.h) have at most so many planes, and are no surfaces. */
enum { CSG_PLAN_MAX_PLANES = 6, CSG_PLAN_MAX_LEFTS = 2 * (CSG_PLAN_MAX_PLANES + 1) };

/* Different structures of several solids that are counted. */
enum { CSG_PLAN_MAX_STRUCTURES = 64 };

/* The steps of all objects of a scene. */
struct csg_plan {
    struct csg_program program;
    uint32_t *begin; /* per object: its first step; one more at the end */
    /* Where edits follow: of the solids that may be all that is left of a small object, the first
     * ones with a quadric or without and each number of planes. */
    uint32_t lefts[CSG_PLAN_MAX_LEFTS];
    size_t num_lefts;
    uint8_t *structures; /* per object, see csg/structure.h */
    bool is_common[CSG_PLAN_MAX_STRUCTURES], is_frequent[CSG_PLAN_MAX_STRUCTURES];
    bool has_rings;     /* ... and whether some leaf may be part of a stack, */
    bool has_compounds; /* ... some become a surface of triangles */
};

/* NULL: out of memory. */
struct csg_plan *csg_plan_create(const struct csgcast_scene *scene);
void csg_plan_destroy(struct csg_plan *plan);

/* Texels of a record behind its header (shaders/common/layout.glsl); those of planes and quadrics
 * are two each where it is in double. */
static inline int32_t csg_record_terms(const float *head)
{
    return (int32_t)head[0] + (int32_t)head[1] +
           ((int)head[2] & CSG_RECORD_QUADRIC ? CSG_QUADRIC_TEXELS : 0);
}

#endif
