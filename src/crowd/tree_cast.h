/* SPDX-License-Identifier: MIT */
#ifndef CSG_CROWD_TREE_CAST_H
#define CSG_CROWD_TREE_CAST_H

/*
 * Where rays meet an object of a few convex solids, by the CPU and between bounds (crowd/cast.h).
 * Its tree has no negation but at literals, so it is monotone: literals as small as rounding lets
 * them be give a set that the shader's holds, and as large as they can be one that holds the
 * shader's.
 */

#include "crowd/cast.h"
#include "pack/frame.h"

/* Objects of more are drawn in tiles. */
enum { CSG_TREE_CAST_NODES = 12, CSG_TREE_CAST_LEAVES = 8 };

struct csg_tree_cast {
    const struct csg_node *nodes;
    uint32_t num, begin;                  /* nodes, and the number of the first one in its tree */
    uint32_t leaves[CSG_TREE_CAST_NODES]; /* of a node: in casts */
    struct csg_cast casts[CSG_TREE_CAST_LEAVES];
    float terms[CSG_TREE_CAST_LEAVES][12 + 4 * CSG_CROWD_MAX_PLANES];
};

/* Whether the object is of the kind, as far as the view does not matter. */
bool csg_tree_cast_can(const struct csgcast_scene *scene, const struct csg_object *object);

/* Of such an object, for pixels in rect; noise as of csg_cast_init. false: not in this view. */
bool csg_tree_cast_init(struct csg_tree_cast *tree, const struct csg_frame *frame,
                        const struct csgcast_scene *scene, const struct csg_object *object,
                        const struct csg_cast_rect *rect, float noise);

/* At num pixels of a row, at (dx + i, dy): keys[i], of which CSG_CAST_LANES can be read, is what
 * hides what is behind it; notes what the object certainly hides. Whether it may show at any. */
bool csg_tree_cast_draw(const struct csg_tree_cast *tree, float dx, float dy, int num, float *keys);

#endif
