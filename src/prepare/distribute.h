/* SPDX-License-Identifier: MIT */
#ifndef CSG_PREPARE_DISTRIBUTE_H
#define CSG_PREPARE_DISTRIBUTE_H

/*
 * Sections of assemblies: (a + b + ...) - s is the same set as (a - s) + (b - s) + ..., in which
 * most operands lie on one side of s and keep nothing of it. So one large object becomes many small
 * ones, which the depth buffer unites, most of them single solids as a rule.
 */

#include "csg/object.h"

/*
 * Distributes the model's objects that are intersections with a wide union, where that makes
 * the tree not much larger; objects and their carriers have been made, and objects are split anew.
 * A part's outermost node remembers the minuend of the whole. Left alone are translucent objects
 * and scenes with highlights, which are painted by object. false: out of memory.
 */
bool csg_distribute(struct csgcast_scene *scene);

/* Whether an object of the model has what it takes, whether or not that pays. */
bool csg_distribute_may(const struct csg_tree *tree, const struct csg_object *object);

#endif
