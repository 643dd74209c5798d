/* SPDX-License-Identifier: MIT */
#ifndef CSG_SCENE_EDITS_H
#define CSG_SCENE_EDITS_H

#include "nodes/build.h"
#include "nodes/origin.h"
#include "scene/node_texts.h"

struct csg_before;

/* What a scene has besides once it is edited. */
struct csg_edits {
    struct csg_origins origins;
    struct csg_node_texts texts;
    struct csg_text_state text;            /* fonts of nodes that are read anew */
    struct csg_tree whole[CSG_NUM_LAYERS]; /* as the text has them */
    struct csg_tree trees[CSG_NUM_LAYERS]; /* simplified, but for what boxes show */
    size_t num_dropped;                    /* solids of the text that have no leaf */
    uint32_t *patches; /* by leaf: its place + 1 among the patches of the call at hand, or 0 */
};

/* The scene's edits; made from its text where there are none yet. NULL, with a message, when
 * memory is out. */
struct csg_edits *csg_edits_of(struct csgcast_scene *scene);
void csg_edits_destroy(struct csg_edits *edits);

/* false, with a message: there is none. */
bool csg_edits_has_leaf(const struct csgcast_scene *scene, size_t leaf);
/* Counted from the leaf's own node, which is 0. */
bool csg_edits_has_node(const struct csgcast_scene *scene, size_t leaf, size_t node);

/* Nodes that the leaf's node was read with, itself included: a solid has none in it. */
uint32_t csg_edits_count_nodes(const struct csgcast_scene *scene, const struct csg_origin *origin);

/* Makes anew what follows from the leaves that have changed; shapes are theirs before. regroups: a
 * node of several solids has become translucent or opaque. false, with a message and nothing
 * changed: no memory. */
bool csg_edits_refinish(struct csgcast_scene *scene, const struct csg_shape *const *shapes,
                        const uint32_t *leaves, size_t num, bool regroups);

/* The same from nothing but leaves, trees and render() nodes, or what is left of them before. */
bool csg_edits_remake(struct csgcast_scene *scene, const struct csg_before *before);

/* A leaf as an edit will make it, by and by the leaf as it was. */
struct csg_patch {
    uint32_t index;
    struct csg_leaf leaf;
    struct csg_origin origin;
    bool has_all_digits; /* of the scene's text, see document/digits.h */
    bool is_read;        /* the first leaf of a node that is read anew */
};

/* patch becomes a copy of the leaf as it is now. false: no memory. */
bool csg_patch_init(struct csg_patch *patch, const struct csgcast_scene *scene, uint32_t leaf);
void csg_patch_finish(struct csg_patch *patch);

void csg_patch_set_color(struct csg_patch *patch, const float color[4]);
void csg_patch_set_matrix(struct csg_patch *patch, const double matrix[16]);

/* Takes the arguments of a node that is one solid from text. false, with a message: they are wrong,
 * or no memory. */
bool csg_patch_set_parameters(struct csg_patch *patch, const struct csgcast_scene *scene,
                              const char *text);

/* Takes the shape over, in the node's own space. */
void csg_patch_set_shape(struct csg_patch *patch, enum csg_kind kind, struct csg_shape *shape);

/* Makes the leaf from its origin. false: no memory. */
bool csg_patch_place(struct csg_patch *patch);

/* Exchanges the scene's leaf with the patch's. */
void csg_patch_swap(struct csg_patch *patch, struct csgcast_scene *scene);

#endif
