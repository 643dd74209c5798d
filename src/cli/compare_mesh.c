/* SPDX-License-Identifier: MIT */
#ifndef _XOPEN_SOURCE
#define _XOPEN_SOURCE 700 /* realpath */
#endif

/* Where the mesh of `csgcast compare` comes from: a file, or openscad. */

#include "common/file.h"
#include "compare_mesh.h"
#include "messages.h"
#include "process.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void show_log(const char *path, const char *begin)
{
    char line[1024];
    FILE *file = fopen(path, "r");
    while (file && fgets(line, sizeof line, file))
        if (!*begin || strncmp(line, begin, strlen(begin)) == 0)
            fprintf(stderr, "csgcast: openscad: %s%s", line, strchr(line, '\n') ? "" : "\n");
    if (file)
        fclose(file);
}

static bool log_has(const char *path, const char *text)
{
    char line[1024];
    bool found = false;
    FILE *file = fopen(path, "r");
    while (file && !found && fgets(line, sizeof line, file))
        found = strstr(line, text) != NULL;
    if (file)
        fclose(file);
    return found;
}

static const char *openscad_program(const struct csg_mesh_source *source)
{
    const char *program = source->params->openscad ? source->params->openscad : getenv("OPENSCAD");
    return program && *program ? program : "openscad";
}

/* openscad takes -o relative to its input file: the folder is absolute. */
static enum csg_process_end run_openscad(struct csg_mesh_source *source, const char *input,
                                         const char *stl, const char *log)
{
    const size_t num = source->params->num_defines;
    const char **argv = calloc(2 * num + 5, sizeof *argv);
    size_t n = 0;
    if (!argv)
        return CSG_PROCESS_FAILED;
    argv[n++] = openscad_program(source);
    argv[n++] = "-o";
    argv[n++] = stl;
    for (size_t i = 0; i < num; i++) {
        argv[n++] = "-D";
        argv[n++] = source->params->defines[i];
    }
    argv[n++] = input;
    const enum csg_process_end end =
        csg_process_run(argv, log, source->options->compare.limit, source->params->openscad_memory,
                        &source->seconds);
    free(argv);
    return end;
}

static bool read_mesh(struct csg_mesh_source *source, const struct csg_compare_module *module,
                      const char *path)
{
    return csg_soup_is_ascii_stl(path) ? csg_soup_read(path, &source->soup, &source->log)
                                       : module->import(path, &source->soup, &source->log);
}

/* Takes over what openscad made. An empty scene is no failure, a node that it lacks is one. */
static bool take_mesh(struct csg_mesh_source *source, const struct csg_compare_module *module,
                      enum csg_process_end end, const char *input, const char *stl, const char *log)
{
    if (end == CSG_PROCESS_MISSING) {
        csg_cli_error(
            "'%s' does not run: install OpenSCAD (Debian: apt-get install openscad), name "
            "it by --openscad=PROGRAM, or give a mesh by --mesh=FILE",
            openscad_program(source));
        return false;
    }
    if (end == CSG_PROCESS_TIMED_OUT) {
        csg_cli_error("%s has made no mesh of %s after %g s: raise --limit, or give a mesh by "
                      "--mesh=FILE",
                      openscad_program(source), input, source->options->compare.limit);
        return false;
    }
    if (log_has(log, "Ignoring unknown module")) {
        show_log(log, "WARNING: Ignoring unknown module");
        csg_cli_error("OpenSCAD does not know all of %s: give a mesh by --mesh=FILE", input);
        return false;
    }
    if (log_has(log, "top level object is empty")) {
        source->soup.bounds = csg_box_empty;
        return true;
    }
    if (end == CSG_PROCESS_DONE)
        return read_mesh(source, module, stl);
    show_log(log, "");
    csg_cli_error("%s makes no mesh of %s", openscad_program(source), input);
    return false;
}

/* Has openscad write STL of input, a scene in its language; folder: for temporary files. */
static bool make_mesh(struct csg_mesh_source *source, const struct csg_compare_module *module,
                      const char *input, const char *folder)
{
    char stl[PATH_MAX + 16], log[PATH_MAX + 16];
    snprintf(stl, sizeof stl, "%s/mesh.stl", folder);
    snprintf(log, sizeof log, "%s/log", folder);
    const enum csg_process_end end = run_openscad(source, input, stl, log);
    return take_mesh(source, module, end, input, stl, log);
}

/* assimp 5.2 finds nothing in the 3MF that OpenSCAD writes: openscad converts it. */
static bool convert_mesh(struct csg_mesh_source *source, const struct csg_compare_module *module,
                         const char *mesh, const char *folder)
{
    char scad[PATH_MAX + 16], path[PATH_MAX];
    snprintf(scad, sizeof scad, "%s/mesh.scad", folder);
    FILE *file = realpath(mesh, path) ? fopen(scad, "w") : NULL;
    if (!file) {
        csg_cli_error("cannot read %s: %s", mesh, strerror(errno));
        return false;
    }
    fputs("import(\"", file);
    for (const char *c = path; *c; c++)
        fprintf(file, *c == '"' || *c == '\\' ? "\\%c" : "%c", *c);
    fputs("\");\n", file);
    fclose(file);
    const bool ok = make_mesh(source, module, scad, folder);
    source->seconds = 0;
    return ok;
}

/* The given mesh, or the one that openscad makes. */
bool csg_mesh_source_read(struct csg_mesh_source *source, const struct csg_compare_module *module)
{
    const char *given = source->options->compare.mesh;
    struct csg_folder folder = {0};
    source->name = given ? given : openscad_program(source);
    if (given && !csg_path_ends(given, ".3mf"))
        return read_mesh(source, module, given);
    if (!given && strcmp(source->options->input, "-") == 0) {
        csg_cli_error("a scene from standard input needs --mesh=FILE");
        return false;
    }
    if (!csg_process_make_folder(&folder))
        return false;
    const bool ok = given ? convert_mesh(source, module, given, folder.path)
                          : make_mesh(source, module, source->options->input, folder.path);
    csg_folder_remove(&folder);
    return ok;
}
