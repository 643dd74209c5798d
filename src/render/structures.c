/* SPDX-License-Identifier: MIT */
#include "render/structures.h"

static bool same_leaf_shape(const struct csgcast_scene *scene, uint32_t a, uint32_t b)
{
    const struct csg_shape *x = &scene->leaves[a].shape, *y = &scene->leaves[b].shape;
    return x->num_planes == y->num_planes && csg_shape_is_paired(x) == csg_shape_is_paired(y);
}

/* Same flags, planes and file order of the leaves: the same straight-line text. */
static bool same_structure(const struct csg_structure *a, bool stiff,
                           const struct csg_known_structure *b)
{
    if (a->num != b->num || stiff != b->stiff)
        return false;
    for (size_t i = 0; i < a->num; i++) {
        const struct csg_step *x = &a->steps[i], *y = &b->steps[i];
        if (x->flags != y->flags)
            return false;
        if (x->flags & CSG_RECORD_POP)
            continue;
        if (!same_leaf_shape(a->scene, x->leaf, y->leaf))
            return false;
        for (size_t j = 0; j < i; j++)
            if (!(a->steps[j].flags & CSG_RECORD_POP) &&
                (x->leaf < a->steps[j].leaf) != (y->leaf < b->steps[j].leaf))
                return false;
    }
    return true;
}

const struct csg_known_structure *csg_structures_find(const struct csg_known_structures *known,
                                                      const struct csg_structure *structure,
                                                      bool stiff)
{
    for (size_t i = 0; i < known->num; i++)
        if (same_structure(structure, stiff, &known->data[i]))
            return &known->data[i];
    return NULL;
}

void csg_structures_add(struct csg_known_structures *known, const struct csg_structure *structure,
                        bool stiff, GLuint program)
{
    known->data[known->num++] =
        (struct csg_known_structure){structure->steps, structure->num, stiff, program};
}
