/* SPDX-License-Identifier: MIT */
/*
 * import() of meshes. What OpenSCAD cannot read is empty there.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "files/amf.h"
#include "files/threemf.h"
#include "nodes/compounds.h"
#include "nodes/import.h"
#include "nodes/mesh_file.h"
#include "nodes/polyhedron.h"

/* The file at hand. */
struct source {
    struct csg_walk *walk;
    uint32_t node;
    bool in_boolean;
    const char *name;
    struct csg_bytes bytes;
    struct csg_mesh_list list; /* what was read of it */
};

static void lacks(const struct source *source, const char *module, const char *packages)
{
    csg_walk_unsupported(source->walk, source->node,
                         "import: %s is missing, or lacks its libraries (Debian: %s)", module,
                         packages);
}

static void warn_if_empty(const struct source *source)
{
    bool is_empty = true;
    for (size_t i = 0; i < source->list.meshes.num; i++)
        is_empty &= source->list.meshes.data[i].faces.num == 0;
    if (is_empty)
        csg_walk_warning(source->walk, source->node, "%.160s: no face in it; nothing is drawn",
                         source->name);
}

/* ---- STL and OFF ---------------------------------------------------------------------------- */

static void warn_of_lines(const struct source *source, size_t line, const char *what)
{
    char place[32] = "";
    if (line > 0)
        snprintf(place, sizeof place, ":%zu", line);
    csg_walk_warning(source->walk, source->node, "%.160s%s: %s", source->name, place, what);
}

static bool read_plain(struct source *source,
                       enum csg_mesh_file (*read)(const struct csg_bytes *bytes,
                                                  struct csg_mesh *mesh, size_t *line))
{
    struct csg_mesh *mesh = csg_mesh_list_add(&source->list);
    size_t line;
    if (!mesh)
        return csg_walk_no_memory(source->walk);
    const enum csg_mesh_file result = read(&source->bytes, mesh, &line);
    if (result == CSG_MESH_FILE_NO_MEMORY)
        return csg_walk_no_memory(source->walk);
    if (result == CSG_MESH_FILE_FOREIGN)
        csg_walk_unsupported(source->walk, source->node,
                             "import: %.100s is of a kind that is not supported", source->name);
    if (result == CSG_MESH_FILE_MALFORMED)
        warn_of_lines(source, line, "malformed; nothing is drawn");
    if (result == CSG_MESH_FILE_PARTLY)
        warn_of_lines(source, line, "a corner is not finite; such triangles are left out");
    if (result == CSG_MESH_FILE_DONE || result == CSG_MESH_FILE_PARTLY)
        warn_if_empty(source);
    else
        csg_mesh_list_finish(&source->list);
    return true;
}

static bool read_stl(struct source *source)
{
    return read_plain(source, csg_stl_file_read);
}

static bool read_off(struct source *source)
{
    return read_plain(source, csg_off_file_read);
}

/* ---- AMF ------------------------------------------------------------------------------------ */

static bool read_amf(struct source *source)
{
    const struct csg_xml_module *xml = csg_import_xml(source->walk);
    const char *slash = strrchr(source->name, '/');
    struct csg_xml_error error = {0};
    if (!xml) {
        lacks(source, "csgcast-xml.so", "libxml2 libzip4");
        return true;
    }
    const enum csg_amf_result result =
        csg_amf_read(&source->bytes, slash ? slash + 1 : source->name, xml, &source->list, &error);
    if (result == CSG_AMF_ENTITY)
        csg_import_refuse(source->walk, source->node, source->name, &error);
    else if (result == CSG_AMF_MALFORMED)
        csg_walk_warning(source->walk, source->node, "%.80s:%zu: %s; %s", source->name, error.line,
                         error.text,
                         source->list.meshes.num > 0 ? "only the objects before that are drawn"
                                                     : "nothing is drawn");
    else if (result == CSG_AMF_DONE)
        warn_if_empty(source);
    return result != CSG_AMF_NO_MEMORY || csg_walk_no_memory(source->walk);
}

/* ---- 3MF ------------------------------------------------------------------------------------ */

static bool read_3mf(struct source *source)
{
    char error[120] = "";
    switch (csg_3mf_read(&source->bytes, &source->list, error, sizeof error)) {
    case CSG_3MF_FILE_NO_MODULE:
        lacks(source, "csgcast-3mf.so", "lib3mf1");
        return true;
    case CSG_3MF_FILE_MALFORMED:
        csg_walk_warning(source->walk, source->node, "%.80s: %s; nothing is drawn", source->name,
                         error);
        return true;
    case CSG_3MF_FILE_NO_MEMORY:
        return csg_walk_no_memory(source->walk);
    default:
        warn_if_empty(source);
        return true;
    }
}

/* ---- the node ------------------------------------------------------------------------------- */

/* The kinds of files: what reads one fills the list. false, with a message, when memory is out. */
static const struct format {
    const char *ending;
    bool (*read)(struct source *source);
} formats[] = {{".stl", read_stl}, {".off", read_off}, {".amf", read_amf}, {".3mf", read_3mf}};

static const struct format *find_format(const char *name)
{
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if (csg_import_has_ending(name, formats[i].ending))
            return &formats[i];
    return NULL;
}

bool csg_import_is_mesh(const char *name)
{
    return find_format(name) != NULL;
}

/* OpenSCAD unites several objects. */
static bool add_meshes(const struct source *source, struct csg_part *part)
{
    const bool is_union = source->list.meshes.num > 1;
    bool ok = !is_union || csg_part_open(part, false) || csg_walk_no_memory(source->walk);
    for (size_t i = 0; i < source->list.meshes.num && ok; i++) {
        struct csg_mesh *mesh = &source->list.meshes.data[i];
        ok = csg_polyhedron_clean(source->walk, source->node, false, mesh) &&
             csg_polyhedron_add(source->walk, source->node, source->in_boolean, mesh, part);
    }
    if (is_union && ok)
        csg_part_close(part);
    return ok;
}

bool csg_compound_import(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                         bool in_boolean, struct csg_part *part)
{
    struct source source = {.walk = walk, .node = node, .in_boolean = in_boolean};
    bool ok = csg_import_read(walk, node, args, &source.name, &source.bytes);
    if (ok && source.name)
        ok = find_format(source.name)->read(&source) && add_meshes(&source, part);
    csg_mesh_list_finish(&source.list);
    free(source.bytes.data);
    return ok;
}
