/* SPDX-License-Identifier: MIT */
#ifndef CSG_CROWD_KIN_H
#define CSG_CROWD_KIN_H

/* Kin: objects with a carrier in common. They have equal depths on it, so file order decides which
 * one shows. */

#include "csg/scene.h"

/* parents: per object, each its own parent at first. Afterwards kin have one root. false: out of
 * memory. */
bool csg_kin_find(const struct csgcast_scene *scene, uint32_t *parents);

/* The least number among the kin of an object. */
uint32_t csg_kin_root(uint32_t *parents, uint32_t object);

#endif
