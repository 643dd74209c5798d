/* SPDX-License-Identifier: MIT */
#ifndef CSG_FILES_AMF_H
#define CSG_FILES_AMF_H

/*
 * Meshes in AMF, plain or in a ZIP archive, read as OpenSCAD 2021.01 reads them (import_amf.cc):
 * the triangles of each object; units, constellations, curves and materials do not count.
 */

#include "common/file.h"
#include "files/mesh_list.h"
#include "xml/module.h"

enum csg_amf_result {
    CSG_AMF_DONE,
    CSG_AMF_MALFORMED, /* error tells what and where; the objects before that are there */
    CSG_AMF_ENTITY,    /* likewise: the text has one that it defines itself */
    CSG_AMF_NO_MEMORY,
};

/* archived: the entry to read where the file is an archive. The meshes are not clean yet. */
enum csg_amf_result csg_amf_read(const struct csg_bytes *bytes, const char *archived,
                                 const struct csg_xml_module *xml, struct csg_mesh_list *list,
                                 struct csg_xml_error *error);

#endif
