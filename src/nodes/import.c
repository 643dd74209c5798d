/* SPDX-License-Identifier: MIT */
/*
 * What import() of meshes and of drawings have in common: the file.
 */
#include "nodes/import.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/file.h"
#include "common/module.h"

const char *csg_import_name(const struct csg_args *args)
{
    const struct csg_value *file = csg_args_find(args, "file");
    return file && file->type == CSG_VALUE_STRING ? file->string : NULL;
}

bool csg_import_has_ending(const char *name, const char *ending)
{
    return name && csg_path_ends(name, ending);
}

const struct csg_xml_module *csg_import_xml(struct csg_walk *walk)
{
    struct csg_xml_state *state = &walk->builder->xml;
    if (state->was_opened)
        return state->module;
    state->was_opened = true;
    state->module = csg_module_symbol("csgcast-xml.so", "CSGCAST_XML_MODULE", CSG_XML_MODULE_NAME);
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

bool csg_import_read(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                     const char **name, struct csg_bytes *bytes)
{
    const char *named = csg_import_name(args);
    *name = NULL;
    if (!named || !*named)
        return true;
    char *path = path_of(walk, named);
    if (path && csg_file_read_regular(path, bytes))
        *name = named;
    const bool is_out_of_memory = !path || (!*name && errno == ENOMEM);
    if (!is_out_of_memory && !*name)
        csg_walk_warning(walk, node, "%.160s: %s; nothing is drawn", path, strerror(errno));
    free(path);
    return !is_out_of_memory || csg_walk_no_memory(walk);
}
