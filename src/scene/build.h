/* SPDX-License-Identifier: MIT */
#ifndef CSG_SCENE_BUILD_H
#define CSG_SCENE_BUILD_H

/*
 * From nodes to a scene, in three walks over the array of nodes:
 *   meaning.c  what each node is, and which are left out,
 *   leaves.c   the solids, in world space,
 *   build.c    the Boolean trees of the layers.
 */

#include "csg/scene.h"
#include "scene/nodes.h"
#include "scene/parser.h"

#define CSG_NO_LEAF UINT32_MAX

/* What a node of the document is. */
struct csg_meaning {
    uint8_t role;    /* enum csg_role */
    uint8_t kind;    /* ROLE_SOLID: enum csg_kind */
    bool is_covered; /* all of it is part of a highlighted subtree around it */
    uint32_t leaf;   /* ROLE_SOLID: its index; CSG_NO_LEAF when it is empty */
};

struct csg_builder {
    const struct csg_document *document;
    struct csg_report *report;
    struct csgcast_scene *scene;
    enum csgcast_facets facets;
    bool skip_unsupported;
    uint32_t begin, end;          /* the nodes that count: all, or those of the ! node */
    struct csg_meaning *meanings; /* one for each node of the document */
};

/*
 * Fills scene's leaves and trees; the trees are not simplified. All errors are reported; what is
 * wrong is then left out of the scene. false, with a message, when memory is out.
 */
bool csg_build(struct csgcast_scene *scene, const struct csg_document *document,
               enum csgcast_facets facets, bool skip_unsupported, struct csg_report *report);

/* The walks. false, with a message, when memory is out. */
bool csg_build_meanings(struct csg_builder *builder);
bool csg_build_leaves(struct csg_builder *builder);

/* Whether node is no operand of the node around it: under * or %. */
static inline bool csg_is_left_out(const struct csg_parsed_node *node)
{
    return (node->modifiers & (CSG_MODIFIER_DISABLE | CSG_MODIFIER_BACKGROUND)) != 0;
}

/* Whether what is below the node takes part. */
static inline bool csg_has_children(const struct csg_meaning *meaning)
{
    return meaning->role == CSG_ROLE_UNION || meaning->role == CSG_ROLE_DIFFERENCE ||
           meaning->role == CSG_ROLE_INTERSECTION;
}

#endif
