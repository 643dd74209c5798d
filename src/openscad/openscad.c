/* SPDX-License-Identifier: MIT */
#include "openscad/openscad.h"

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/process.h"
#include "document/digits.h"
#include "openscad/bounds.h"
#include "openscad/plain_text.h"
#include "openscad/viewpoint.h"

/* One run of openscad. It starts as zeroes. */
struct run {
    const char *path; /* as the caller named it */
    const char *program;
    const struct csg_log *log;
    struct csg_flattened *flattened;
    char *input;     /* absolute: openscad resolves -o beside its input file */
    char *output;    /* in the folder; the ending tells openscad the format */
    char frames[24]; /* how many, as text */
    struct csg_process_bounds bounds;
    struct csg_process process;
};

static bool fail(const struct run *run, const char *what, int error)
{
    csg_log_error(run->log, CSGCAST_MESSAGE_OPENSCAD, "cannot flatten %s: %s: %s", run->path, what,
                  strerror(error));
    return false;
}

const char *csg_openscad_remedy(int error)
{
    const bool is_missing =
        error == ENOENT || error == ENOTDIR || error == EACCES || error == ENOEXEC;
    return is_missing
               ? "; install OpenSCAD (on Debian and Ubuntu: apt-get install openscad) or set "
                 "the environment variable OPENSCAD to the program"
               : "";
}

static bool fail_to_start(const struct run *run, int error)
{
    const char *remedy = csg_openscad_remedy(error);
    csg_log_error(run->log, CSGCAST_MESSAGE_OPENSCAD,
                  "cannot flatten %s: '%s' does not run: %s%s%s", run->path, run->program,
                  strerror(error), remedy, remedy[0] ? ", or give a .csg file" : "");
    return false;
}

static bool make_folder(struct run *run)
{
    struct csg_folder *folder = &run->flattened->folder;
    if (!csg_folder_make(folder))
        return fail(run,
                    "the environment variable TMPDIR has to name a place for temporary files, "
                    "which is /tmp otherwise",
                    errno);
    run->output = csg_folder_file(folder, CSG_DIGITS_STILL);
    return run->output || csg_log_memory(run->log);
}

static bool make_absolute(struct run *run)
{
    run->input = csg_path_absolute(run->path);
    return run->input || csg_log_memory(run->log);
}

/* openscad's own words for a file that is not there are less clear, and without the customizer's
 * parameters it goes on. */
static bool check_readable(const struct run *run, const char *path)
{
    struct stat info;
    int error = stat(path, &info) != 0 || access(path, R_OK) != 0 ? errno : 0;
    if (!error && S_ISDIR(info.st_mode))
        error = EISDIR;
    if (error)
        csg_log_error(run->log, CSGCAST_MESSAGE_FILE, "cannot read %s: %s", path, strerror(error));
    return !error;
}

/* JSON has one way, that anybody uses, to write it. */
static bool is_plain(const char *name)
{
    for (; *name; name++)
        if (*name < ' ' || *name > '~' || strchr("\"\\/", *name))
            return false;
    return true;
}

/* openscad does not say that it has not found the set. */
static bool check_set(const struct run *run, const char *path, const char *set)
{
    struct csg_bytes text = {0};
    char name[256];
    const int length = snprintf(name, sizeof name, "\"%s\"", set);
    if (length >= (int)sizeof name || !is_plain(set) || !csg_file_read_regular(path, &text))
        return true;
    if (!csg_bytes_append(&text, "", 1)) {
        free(text.data);
        return csg_log_memory(run->log);
    }
    if (!strstr(text.data, name))
        csg_log_warning(run->log, CSGCAST_MESSAGE_ARGUMENT,
                        "%s has no set of parameters '%s': openscad takes those of %s", path, set,
                        run->path);
    free(text.data);
    return true;
}

/* Of a pipe nothing would be left for openscad. */
static bool check_text(const struct run *run)
{
    struct stat info;
    struct csg_bytes text;
    if (stat(run->input, &info) == 0 && !S_ISREG(info.st_mode))
        return true;
    if (!csg_file_read(run->input, &text, run->log))
        return false;
    const bool ok = csg_plain_text_check(run->path, &text, run->log);
    free(text.data);
    return ok;
}

static bool prepare(struct run *run, const struct csgcast_scene_params *params)
{
    return make_absolute(run) && check_readable(run, run->path) && check_text(run) &&
           (!params->parameter_file || check_readable(run, params->parameter_file)) &&
           (!params->parameter_file || !params->parameter_set ||
            check_set(run, params->parameter_file, params->parameter_set)) &&
           make_folder(run);
}

static void finish(struct run *run)
{
    csg_process_finish(&run->process);
    free(run->output);
    free(run->input);
}

/*
 * A -D is an assignment at the end of the file: variables before it that were made of $preview
 * would keep the old one. openscad --render sets it before the file is read.
 */
static bool is_render(const char *define)
{
    return strcmp(define, "$preview=false") == 0;
}

/* Two more arguments where there is a value. */
static size_t put_pair(char **argv, size_t num, const char *name, const char *value)
{
    if (!value)
        return num;
    argv[num++] = (char *)(uintptr_t)name;
    argv[num++] = (char *)(uintptr_t)value;
    return num;
}

/* openscad [--render] [--animate N] [-p FILE -P SET] -o OUTPUT [-D name=value]... INPUT. The
 * strings are borrowed; the caller frees argv. */
static char **make_argv(struct run *run, const struct csgcast_scene_params *params)
{
    const size_t num_defines = params->defines ? params->num_defines : 0;
    char **argv = calloc(2 * num_defines + 14, sizeof *argv);
    bool render = false;
    size_t num = 0;
    if (!argv)
        return NULL;
    for (size_t i = 0; i < num_defines; i++)
        render |= is_render(params->defines[i]);
    argv[num++] = (char *)(uintptr_t)run->program;
    if (render) /* not in front of the input, which it would take for its value */
        argv[num++] = (char *)(uintptr_t) "--render";
    if (run->flattened->num_frames > 0) {
        snprintf(run->frames, sizeof run->frames, "%zu", run->flattened->num_frames);
        num = put_pair(argv, num, "--animate", run->frames);
    }
    num = put_pair(argv, num, "-p", params->parameter_file);
    num = put_pair(argv, num, "-P", params->parameter_set);
    num = put_pair(argv, num, "-o", run->output);
    for (size_t i = 0; i < num_defines; i++) {
        if (!is_render(params->defines[i]))
            num = put_pair(argv, num, "-D", params->defines[i]);
    }
    num = put_pair(argv, num, "-D", csg_viewpoint_define);
    argv[num++] = run->input;
    return argv;
}

static bool run_once(struct run *run, char *const *argv, char *const *environment)
{
    const int error = csg_process_start(&run->process, argv, NULL, NULL, environment, &run->bounds);
    if (error)
        return fail_to_start(run, error);
    csg_process_wait(&run->process, 1, -1);
    return !run->process.error || fail(run, run->program, run->process.error);
}

static bool has_failed(const struct run *run)
{
    const int status = run->process.status;
    return !WIFEXITED(status) || WEXITSTATUS(status) != 0;
}

/* Whether the module that makes it write all digits may be to blame: ld.so names it, or a crash. */
static bool may_be_of_digits(const struct run *run)
{
    return has_failed(run) && (WIFSIGNALED(run->process.status) ||
                               csg_openscad_mentions(&run->process.output, csg_digits_module));
}

static bool execute(struct run *run, const struct csgcast_scene_params *params)
{
    char **argv = make_argv(run, params);
    char **environment = csg_digits_environment(run->flattened->folder.path);
    bool done = argv ? run_once(run, argv, environment) : csg_log_memory(run->log);
    if (done && environment && may_be_of_digits(run)) {
        csg_process_finish(&run->process);
        done = run_once(run, argv, NULL);
    }
    csg_digits_environment_free(environment);
    free(argv);
    return done && (!csg_process_is_missing(&run->process) || fail_to_start(run, ENOENT));
}

/* The cameras, out of what openscad printed. */
static bool take_cameras(struct run *run)
{
    struct csg_bytes source = {0};
    if (csg_viewpoint_is_asked(&run->process.output) &&
        !csg_file_read(run->input, &source, run->log))
        return false;
    const bool taken = csg_viewpoint_take(run->flattened, &run->process.output, &source);
    free(source.data);
    return taken || csg_log_memory(run->log);
}

static bool check(struct run *run)
{
    char end[CSG_OPENSCAD_END_SIZE];
    const bool failed = has_failed(run);
    const bool has_error = csg_openscad_pass_on(run->log, "", &run->process.output, failed);
    if (!failed && !has_error)
        return true;
    csg_openscad_describe_end(&run->process, &run->bounds, end);
    csg_log_error(run->log, CSGCAST_MESSAGE_OPENSCAD, "cannot flatten %s: %s %s", run->path,
                  run->program, end);
    return false;
}

const char *csg_openscad_program(const struct csgcast_scene_params *params)
{
    const char *program = params->openscad ? params->openscad : getenv("OPENSCAD");
    return program && program[0] ? program : "openscad";
}

bool csg_openscad_flatten(const char *path, const struct csgcast_scene_params *params,
                          size_t num_frames, const struct csg_log *log,
                          struct csg_flattened *flattened)
{
    struct run run = {.path = path,
                      .program = csg_openscad_program(params),
                      .log = log,
                      .bounds = csg_openscad_bounds(params)};
    run.flattened = flattened;
    flattened->num_frames = num_frames;
    const bool done = prepare(&run, params) && execute(&run, params) && take_cameras(&run) &&
                      check(&run) && csg_flattened_find_fonts(flattened, params, log);
    finish(&run);
    return done;
}
