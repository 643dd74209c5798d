/* SPDX-License-Identifier: MIT */
#ifndef CSG_CELLS_BUNCH_H
#define CSG_CELLS_BUNCH_H

/*
 * The literals of a cell in bunches of CSG_BUNCH_LITERALS, between few surfaces: neighbours mostly
 * share theirs, so the shader finds far fewer keys than the literals have faces
 * (shaders/csg/bunch.glsl). Only intersections of convex leaves of few faces go into bunches.
 */

#include "cells/leaf.h"

/* Texels: places of terms of planes, of quadrics where the object has any, then of the literals
 * their surfaces as bits, and places of their leaves, + 1, negative where negated. Four numbers
 * each. */
struct csg_bunches {
    const struct csgcast_scene *scene;
    const struct csg_cell_leaf *leaves;
    const uint32_t *places; /* of the leaves' terms, by leaf; a header each, then the faces */
    bool quadrics;          /* the object has some: there are fewer planes */
    CSG_ARRAY(struct csg_bunch_literal {
        uint32_t leaf;
        bool negated;
    })
    literals;
    CSG_ARRAY(float) texels;
};

/* Whether an object's cells can be put in bunches. quadrics: whether it has any. */
bool csg_bunches_can_hold(const struct csgcast_scene *scene, const struct csg_object *object,
                          bool *quadrics);

/* Appends a cell's tree, box being what it holds in. false: out of memory. */
bool csg_bunches_add(struct csg_bunches *bunches, const struct csg_tree *tree,
                     const struct csg_box *box);

#endif
