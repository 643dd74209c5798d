/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_IMPORT_H
#define CSG_NODES_IMPORT_H

#include "common/file.h"
#include "nodes/walk.h"
#include "plane/drawing.h"
#include "xml/module.h"

/* The file that a node names by "file", as a string; NULL: it names none. */
const char *csg_import_name(const struct csg_args *args);

/* Whether a file's name, or NULL, ends so, in large letters or small. */
bool csg_import_has_ending(const char *name, const char *ending);

/* Whether the name, or NULL, has an ending of the table in import_mesh.c. */
bool csg_import_is_mesh(const char *name);

/* Whether the name, or NULL, has an ending of the table in import_drawing.c. */
bool csg_import_is_drawing(const char *name);

/* Reads the drawing in the file that an extrusion names; scale: of DXF. What is wrong with the file
 * is reported. false, with a message, when memory is out. */
bool csg_import_drawing(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                        double scale, struct csg_drawing *drawing);

/* csgcast-xml.so; NULL: it is missing. */
const struct csg_xml_module *csg_import_xml(struct csg_walk *walk);

/* An error: the text of an XML file has an entity of its own, which could name any other file. */
void csg_import_refuse(struct csg_walk *walk, uint32_t node, const char *name,
                       const struct csg_xml_error *error);

/* Reads the file that a node names, relative to the scene's directory. name: its name; NULL where
 * it names none or, after a warning, cannot be read: the node is empty, as in OpenSCAD. false, with
 * a message, when memory is out. The caller frees the bytes. */
bool csg_import_read(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                     const char **name, struct csg_bytes *bytes);

#endif
