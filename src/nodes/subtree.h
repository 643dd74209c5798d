/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_SUBTREE_H
#define CSG_NODES_SUBTREE_H

#include "common/file.h"
#include "document/document.h"

/* A subtree of a document as text that OpenSCAD reads as it was meant. Zero-initialise it. */
struct csg_subtree {
    struct csg_bytes text;
    /* The files that nodes in it read, one zero-terminated name behind the other as OpenSCAD is to
     * read them: relative to the document's directory. */
    struct csg_bytes files;
    bool has_text; /* some text() is in it, which depends on fonts */
};

/*
 * Writes the node and all that is in it, without its modifiers. As OpenSCAD would read its own .csg
 * text wrong in places, the text of text() is escaped, and nan and inf are expressions. false: out
 * of memory.
 */
bool csg_subtree_write(struct csg_subtree *subtree, const struct csg_document *document,
                       uint32_t node);

void csg_subtree_finish(struct csg_subtree *subtree);

/* The first node of the subtree that OpenSCAD does not know; end of the subtree: there is none. */
uint32_t csg_subtree_find_foreign(const struct csg_document *document, uint32_t node);

#endif
