/* SPDX-License-Identifier: MIT */
#ifndef CSG_DOCUMENT_DOCUMENT_H
#define CSG_DOCUMENT_DOCUMENT_H

/*
 * From text to nodes. The nodes lie in one array in the order of the text, which is pre-order; what
 * they mean is not looked at. Arguments are checked here but read again when they are needed
 * (csg_document_arguments): kept, they would take many times the memory of the text.
 */

#include "document/arguments.h"

enum csg_modifier {
    CSG_MODIFIER_BACKGROUND = 1, /* % */
    CSG_MODIFIER_HIGHLIGHT = 2,  /* # */
    CSG_MODIFIER_DISABLE = 4,    /* * */
    CSG_MODIFIER_ROOT = 8,       /* ! */
};

#define CSG_NO_TWIN UINT32_MAX

struct csg_parsed_node {
    size_t at; /* of the name in the text */
    struct csg_place place;
    uint32_t name_length;
    uint32_t end;      /* one past the last node of this subtree */
    uint32_t twin;     /* the first node with the same arguments (twins.h), or CSG_NO_TWIN */
    uint8_t modifiers; /* of enum csg_modifier */
    bool malformed;    /* its arguments are; a message was given */
};

struct csg_document {
    const char *text; /* borrowed */
    size_t size;
    CSG_ARRAY(struct csg_parsed_node) nodes;
    size_t num_rounded; /* numbers in it that may be rounded */
};

/*
 * Reads the whole text; what is malformed is reported and left out. false, with a message, when
 * memory is out. text must stay until csg_document_finish. num_threads: as for csg_parallel.
 */
bool csg_document_parse(struct csg_document *document, const char *text, size_t size,
                        int num_threads, struct csg_report *report);

void csg_document_finish(struct csg_document *document);

/* Reads the arguments of a node that is not malformed. false when memory is out. */
bool csg_document_arguments(const struct csg_document *document, size_t node,
                            struct csg_arguments *arguments, struct csg_report *report);

#endif
