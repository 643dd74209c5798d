/* SPDX-License-Identifier: MIT */
/*
 * import() of meshes that need no library: STL and OFF. What OpenSCAD cannot read is empty there.
 */
#include "scene/import.h"

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common/module.h"
#include "scene/compounds.h"
#include "scene/mesh_file.h"
#include "scene/polyhedron.h"

const char *csg_import_name(const struct csg_args *args)
{
    const struct csg_value *file = csg_args_find(args, "file");
    return file && file->type == CSG_VALUE_STRING ? file->string : NULL;
}

bool csg_import_has_ending(const char *name, const char *ending)
{
    const char *dot = name ? strrchr(name, '.') : NULL;
    return dot && strcasecmp(dot, ending) == 0;
}

bool csg_import_is_mesh(const char *name)
{
    return csg_import_has_ending(name, ".stl") || csg_import_has_ending(name, ".off");
}

bool csg_import_is_drawing(const char *name)
{
    return csg_import_has_ending(name, ".dxf") || csg_import_has_ending(name, ".svg");
}

const struct csg_xml_module *csg_import_xml(struct csg_walk *walk)
{
    struct csg_xml_state *state = &walk->builder->xml;
    if (state->was_opened)
        return state->module;
    state->was_opened = true;
    state->handle = csg_module_open("csgcast-xml.so", "CSGCAST_XML_MODULE");
    if (state->handle)
        state->module = (const struct csg_xml_module *)dlsym(state->handle, CSG_XML_MODULE_NAME);
    return state->module;
}

void csg_import_refuse(struct csg_walk *walk, uint32_t node, const char *name,
                       const struct csg_xml_error *error)
{
    csg_report_error(walk->builder->report, CSGCAST_MESSAGE_SCENE, csg_walk_node(walk, node)->place,
                     "import: %.80s:%zu: %s is not read, for it may name any other file; write "
                     "what it stands for (xmllint --noent)",
                     name, error->line, error->text);
}

void csg_import_finish(struct csg_xml_state *state)
{
    if (state->handle)
        dlclose(state->handle);
    *state = (struct csg_xml_state){0};
}

static char *path_of(const struct csg_walk *walk, const char *name)
{
    const char *directory = walk->builder->directory;
    const size_t size = strlen(directory) + strlen(name) + 2;
    char *path = malloc(size);
    if (path && name[0] == '/')
        snprintf(path, size, "%s", name);
    else if (path)
        snprintf(path, size, "%s/%s", directory, name);
    return path;
}

/* errno has the reason where it cannot be read. */
static bool read_regular(const char *path, struct csg_bytes *bytes)
{
    struct stat info;
    const int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    bool ok = fd >= 0 && fstat(fd, &info) == 0;
    if (ok && !S_ISREG(info.st_mode)) {
        errno = EINVAL;
        ok = false;
    }
    ok = ok && csg_file_read_all(fd, bytes);
    const int reason = errno;
    if (fd >= 0)
        close(fd);
    errno = reason;
    return ok;
}

bool csg_import_read(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                     const char **name, struct csg_bytes *bytes)
{
    const char *named = csg_import_name(args);
    *name = NULL;
    if (!named || !*named)
        return true;
    char *path = path_of(walk, named);
    if (path && read_regular(path, bytes))
        *name = named;
    const bool is_out_of_memory = !path || (!*name && errno == ENOMEM);
    if (!is_out_of_memory && !*name)
        csg_walk_warning(walk, node, "%.160s: %s; nothing is drawn", path, strerror(errno));
    free(path);
    return !is_out_of_memory || csg_log_memory(&walk->builder->report->log);
}

static bool add_file(struct csg_walk *walk, uint32_t node, const char *name,
                     const struct csg_bytes *bytes, struct csg_part *part)
{
    struct csg_mesh mesh = {0};
    size_t line;
    const enum csg_mesh_file result = csg_import_has_ending(name, ".off")
                                          ? csg_off_file_read(bytes, &mesh, &line)
                                          : csg_stl_file_read(bytes, &mesh, &line);
    bool ok = result != CSG_MESH_FILE_NO_MEMORY || csg_log_memory(&walk->builder->report->log);
    if (result == CSG_MESH_FILE_FOREIGN)
        csg_walk_unsupported(walk, node, "import: %.100s is of a kind that is not supported", name);
    else if (result == CSG_MESH_FILE_MALFORMED && line > 0)
        csg_walk_warning(walk, node, "%.160s:%zu: malformed; nothing is drawn", name, line);
    else if (result == CSG_MESH_FILE_MALFORMED)
        csg_walk_warning(walk, node, "%.160s: malformed; nothing is drawn", name);
    if (result == CSG_MESH_FILE_DONE)
        ok = csg_polyhedron_clean(walk, node, false, &mesh) &&
             csg_polyhedron_add(walk, node, &mesh, part);
    csg_mesh_finish(&mesh);
    return ok;
}

bool csg_compound_import(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                         bool in_boolean, struct csg_part *part)
{
    struct csg_bytes bytes = {0};
    const char *name;
    (void)in_boolean;
    bool ok = csg_import_read(walk, node, args, &name, &bytes);
    if (ok && name)
        ok = add_file(walk, node, name, &bytes, part);
    free(bytes.data);
    return ok;
}
