/* SPDX-License-Identifier: MIT */
#ifndef CSG_XML_MODULE_H
#define CSG_XML_MODULE_H

/*
 * The border between libcsgcast and csgcast-xml.so, which wraps libxml2 and libzip. Nothing but the
 * bytes at hand is read: no other file, and nothing from a network.
 */

#include <stdbool.h>
#include <stddef.h>

struct csg_xml_attribute {
    const char *name, *value;
};

/* Takes the elements. Names are those of the text, with their prefix. false ends it. */
struct csg_xml_sink {
    void *user;
    /* is_empty: <name/>, for which end is not called. */
    bool (*begin)(void *user, const char *name, const struct csg_xml_attribute *attributes,
                  size_t num, bool is_empty);
    bool (*end)(void *user, const char *name);
    bool (*text)(void *user, const char *text); /* not if it is all blank; NULL: not wanted */
};

enum csg_xml_result {
    CSG_XML_DONE,
    CSG_XML_MALFORMED, /* the sink has got what is before that */
    CSG_XML_ENTITY,    /* its text has one that it defines itself, see error */
    CSG_XML_ENDED,     /* by the sink; error tells in which line */
    CSG_XML_NO_MEMORY,
};

/* What is wrong. */
struct csg_xml_error {
    size_t line; /* 0: nowhere */
    char text[120];
};

struct csg_xml_module {
    /* archived: where the bytes are a ZIP archive, the entry to read, or its only one. NULL: they
     * are none. */
    enum csg_xml_result (*read)(const char *data, size_t size, const char *archived,
                                const struct csg_xml_sink *sink, struct csg_xml_error *error);
};

/* The module's one symbol, a const struct csg_xml_module, named with the version of this border. */
#define CSG_XML_MODULE csg_xml_module_1
#define CSG_XML_MODULE_NAME "csg_xml_module_1"

#endif
