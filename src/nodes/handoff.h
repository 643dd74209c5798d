/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_HANDOFF_H
#define CSG_NODES_HANDOFF_H

/*
 * Subtrees that only OpenSCAD can evaluate. While a scene is built they are noted and taken for
 * empty; then openscad makes a mesh of each, and the scene is built once more with the meshes in
 * their places. A drawing comes as the floor of a mesh.
 */

#include "common/file.h"
#include "document/document.h"
#include "nodes/nodes.h"
#include "plane/drawing.h"
#include "polyhedra/mesh.h"

/* What openscad made of a text. */
struct csg_handoff_result {
    struct csg_bytes text; /* what it was asked */
    struct csg_mesh mesh;  /* clean; empty where the subtree is */
    double seconds;        /* that it took, now or when it went to the cache */
    bool is_cached;
};

struct csg_handed_off {
    uint32_t node, end; /* in the document; the highest node for which it was asked */
    uint8_t dimension;  /* 2 or 3 */
    bool is_evaluated;
    size_t result; /* IS_EVALUATED: its index; equal texts share one */
    char reason[160];
};

struct csg_handoff {
    const struct csgcast_scene_params *params;
    const struct csg_document *document;    /* its names */
    CSG_ARRAY(struct csg_handed_off) nodes; /* those that are evaluated first, sorted by node */
    size_t num_evaluated;
    CSG_ARRAY(struct csg_handoff_result) results;
};

void csg_handoff_init(struct csg_handoff *handoff, const struct csgcast_scene_params *params,
                      const struct csg_document *document);
void csg_handoff_finish(struct csg_handoff *handoff);

/* Notes that the node of that dimension needs openscad. false: it is not to be had, because that is
 * switched off, something in the node is unknown to openscad, or it was evaluated already. */
bool csg_handoff_want(struct csg_handoff *handoff, uint32_t node, uint8_t dimension,
                      const char *reason);

static inline bool csg_handoff_is_wanted(const struct csg_handoff *handoff)
{
    return handoff->nodes.num > handoff->num_evaluated;
}

/* Evaluates what is wanted. What openscad cannot do becomes empty, and is reported: as an error,
 * with skip_unsupported as a warning. false, with a message, when memory is out. */
bool csg_handoff_run(struct csg_handoff *handoff, struct csg_report *report);

/* Notes in the scene what was evaluated, for its info. false, with a message, when memory is out.
 */
bool csg_handoff_note(const struct csg_handoff *handoff, struct csgcast_scene *scene);

/* What was made of the node; NULL: nothing. */
const struct csg_handed_off *csg_handoff_find(const struct csg_handoff *handoff, uint32_t node);

/* How such a node is read, in place of its row in the table of nodes. */
const struct csg_node_ops *csg_handoff_ops(uint8_t dimension);

#endif
