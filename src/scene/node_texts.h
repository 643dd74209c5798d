/* SPDX-License-Identifier: MIT */
#ifndef CSG_SCENE_NODE_TEXTS_H
#define CSG_SCENE_NODE_TEXTS_H

/* The nodes of a scene that is edited, and what stands between their parentheses by now. */

#include "common/file.h"
#include "document/document.h"

struct csg_node_texts {
    struct csg_document document; /* the scene's text */
    char **arguments; /* by node, owned: since an edit, or once they were asked for; or NULL */
};

/* document is taken over, also where it fails. false: out of memory. */
bool csg_node_texts_init(struct csg_node_texts *texts, struct csg_document *document);
void csg_node_texts_finish(struct csg_node_texts *texts);

/* Lives until the node's arguments are changed. NULL: out of memory. */
const char *csg_node_texts_get(struct csg_node_texts *texts, uint32_t node);

/* The name of a node, as the tables of nodes and solids have it. */
const char *csg_node_texts_name(const struct csg_node_texts *texts, uint32_t node);

/* The nodes from begin on, below end, as a document of their own: there begin is node 0. Places are
 * those in the scene's text, but in nodes whose arguments were changed or asked for: there they
 * count from the first byte between the parentheses. */
struct csg_excerpt {
    struct csg_bytes text;
    struct csg_document document;
};

/* false: out of memory. Zero-initialise it. */
bool csg_excerpt_init(struct csg_excerpt *excerpt, const struct csg_node_texts *texts,
                      uint32_t begin, uint32_t end);
void csg_excerpt_finish(struct csg_excerpt *excerpt);

#endif
