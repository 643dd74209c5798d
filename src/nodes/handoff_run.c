/* SPDX-License-Identifier: MIT */
/*
 * One openscad for each subtree, as many at once as there are cores. A single one for all would
 * have to unite them: OpenSCAD 2021.01 exports one solid, so subtrees set side by side in one text
 * go through CGAL's union, which takes most of the time there is and rounds what a lone import or
 * resize keeps. Starting openscad takes 0.04 s.
 */
#include "nodes/handoff_jobs.h"

#include <errno.h>
#include <limits.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/clock.h"
#include "document/report.h"
#include "nodes/handoff_mesh.h"
#include "openscad/bounds.h"
#include "openscad/openscad.h"

static const double progress_after = 1; /* seconds, then once in that time */

static struct csg_place place_of(const struct csg_handoff_run *run, uint32_t node)
{
    return run->handoff->document->nodes.data[node].place;
}

/* What stays empty: an error, or a warning where the rest is to be drawn all the same. */
static void fail(const struct csg_handoff_run *run, uint32_t node, const char *what,
                 const char *remedy)
{
    const struct csg_parsed_node *parsed = &run->handoff->document->nodes.data[node];
    const bool skip = run->handoff->params->skip_unsupported;
    csg_report_print(
        run->report, skip ? CSGCAST_LOG_WARNING : CSGCAST_LOG_ERROR, CSGCAST_MESSAGE_OPENSCAD,
        parsed->place, "%.*s: only openscad can evaluate it, and %s%s; %s",
        (int)(parsed->name_length < 64 ? parsed->name_length : 64),
        run->handoff->document->text + parsed->at, what, remedy,
        skip ? "left out with all that is in it" : "--skip-unsupported draws the rest");
}

/* ---- openscad ----------------------------------------------------------------------------- */

/* A relative path must hold in the scene's directory too. */
static bool find_program(struct csg_handoff_run *run)
{
    const char *name = csg_openscad_program(run->handoff->params);
    char here[PATH_MAX] = "";
    if (name[0] != '/' && strchr(name, '/') && !getcwd(here, sizeof here))
        here[0] = '\0';
    const size_t size = strlen(here) + strlen(name) + 2;
    run->program = malloc(size);
    if (!run->program)
        return csg_handoff_no_memory(run);
    snprintf(run->program, size, "%s%s%s", here, here[0] ? "/" : "", name);
    return true;
}

/* Without openscad everything wanted is empty. */
static bool fail_all(const struct csg_handoff_run *run, int error)
{
    struct csg_handoff *handoff = run->handoff;
    const struct csg_handoff_result empty = {.seconds = 0};
    char what[PATH_MAX + 128];
    snprintf(what, sizeof what, "'%s' does not run: %s", run->program, strerror(error));
    for (size_t i = 0; i < handoff->nodes.num; i++) {
        if (handoff->nodes.data[i].is_evaluated)
            continue;
        fail(run, handoff->nodes.data[i].node, what, csg_openscad_remedy(error));
        handoff->nodes.data[i].is_evaluated = true;
        handoff->nodes.data[i].result = handoff->results.num;
    }
    handoff->num_evaluated = handoff->nodes.num;
    return csg_array_push(&handoff->results, empty) || csg_handoff_no_memory(run);
}

/* Returns an error number: openscad does not run. */
static int ask_version(struct csg_handoff_run *run)
{
    char option[] = "--version";
    char *argv[] = {run->program, option, NULL};
    struct csg_process process = {0};
    int error = csg_process_start(&process, argv, NULL, NULL, NULL, NULL);
    if (!error) {
        csg_process_wait(&process, 1, -1);
        error = process.error ? process.error : csg_process_is_missing(&process) ? ENOENT : 0;
        run->version = process.output;
        process.output = (struct csg_bytes){0};
        csg_process_finish(&process);
    }
    return error;
}

static char *file_name(const struct csg_handoff_run *run, size_t job, const char *ending)
{
    char name[64];
    snprintf(name, sizeof name, "%zu%s", job, ending);
    return csg_folder_file(&run->folder, name);
}

/* Fonts that are not the machine's are not in the text. */
static void write_fonts(FILE *file, const struct csgcast_scene_params *params)
{
    for (size_t i = 0; i < params->num_fonts; i++) {
        char *path = csg_path_absolute(params->fonts[i]);
        if (path)
            fprintf(file, "use <%s> ", path);
        free(path);
    }
}

static bool write_input(const struct csg_handoff_run *run, const char *name,
                        const struct csg_bytes *text)
{
    FILE *file = fopen(name, "wb");
    if (!file)
        return false;
    write_fonts(file, run->handoff->params);
    const bool done = fwrite(text->data, 1, text->num, file) == text->num;
    return fclose(file) == 0 && done;
}

/* openscad -o N.stl --export-format=binstl - < N.scad, in the scene's directory. */
static int start_openscad(struct csg_handoff_run *run, struct csg_handoff_job *job, char *input,
                          char *output)
{
    char option_o[] = "-o", option_format[] = "--export-format=binstl", from_input[] = "-";
    char *argv[] = {run->program, option_o, output, option_format, from_input, NULL};
    const char *directory = run->handoff->params->directory;
    const struct csg_process_bounds bounds = csg_openscad_bounds(run->handoff->params);
    const int error = write_input(run, input, &run->handoff->results.data[job->result].text)
                          ? csg_process_start(&job->process, argv, input, directory, NULL, &bounds)
                          : errno;
    job->begun = csg_clock_ms() / 1000;
    return error;
}

static bool start(struct csg_handoff_run *run, size_t index)
{
    struct csg_handoff_job *job = &run->jobs.data[index];
    char *input = file_name(run, index, ".scad"), *output = file_name(run, index, ".stl");
    const bool has_names = input && output;
    const int error = has_names ? start_openscad(run, job, input, output) : 0;
    if (error) {
        char what[PATH_MAX + 64];
        snprintf(what, sizeof what, "'%s' does not start: %s", run->program, strerror(error));
        fail(run, job->node, what, "");
        run->num_done++;
    }
    free(input);
    free(output);
    return has_names || csg_handoff_no_memory(run);
}

/* ---- results ------------------------------------------------------------------------------ */

/* In the cache: what openscad said, then its file. */
static bool make_value(const struct csg_bytes *messages, double seconds,
                       const struct csg_bytes *stl, struct csg_bytes *value)
{
    const uint64_t size = messages->num;
    return csg_bytes_append(value, &size, sizeof size) &&
           csg_bytes_append(value, &seconds, sizeof seconds) &&
           csg_bytes_append(value, messages->data, messages->num) &&
           csg_bytes_append(value, stl->data, stl->num);
}

static bool contains(const struct csg_bytes *bytes, const char *text)
{
    const size_t length = strlen(text);
    for (size_t i = 0; i + length <= bytes->num; i++)
        if (memcmp(bytes->data + i, text, length) == 0)
            return true;
    return false;
}

/* Says what openscad said, with the place of the subtree. */
static void pass_on(const struct csg_handoff_run *run, uint32_t node, struct csg_bytes *messages,
                    bool failed)
{
    char prefix[PATH_MAX + 32];
    const struct csg_place place = place_of(run, node);
    snprintf(prefix, sizeof prefix, "%s:%u:%u: ", run->report->file, (unsigned)place.line,
             (unsigned)place.column);
    csg_openscad_pass_on(&run->report->log, prefix, messages, failed);
}

/* Takes a value apart; false: out of memory. An empty file is an empty mesh. */
static bool take_value(struct csg_handoff_run *run, const struct csg_handoff_job *job,
                       const struct csg_bytes *value)
{
    struct csg_handoff_result *result = &run->handoff->results.data[job->result];
    uint64_t size = 0;
    const size_t begin = sizeof size + sizeof result->seconds;
    struct csg_bytes messages = {0};
    if (value->num >= begin) {
        memcpy(&size, value->data, sizeof size);
        memcpy(&result->seconds, value->data + sizeof size, sizeof result->seconds);
    }
    if (value->num < begin || size > value->num - begin) {
        fail(run, job->node, "the cache holds something else for it", "; clear the cache");
        return true;
    }
    bool ok = csg_bytes_append(&messages, value->data + begin, size);
    if (ok)
        pass_on(run, job->node, &messages, false);
    free(messages.data);
    const struct csg_bytes stl = {.data = value->data + begin + size,
                                  .num = value->num - begin - size};
    if (!ok || stl.num == 0)
        return ok || csg_handoff_no_memory(run);
    const enum csg_mesh_file read = csg_stl_read(&stl, &result->mesh);
    if (read == CSG_MESH_FILE_MALFORMED)
        fail(run, job->node, "its STL file cannot be read", "");
    return read != CSG_MESH_FILE_NO_MEMORY || csg_handoff_no_memory(run);
}

static void fail_job(const struct csg_handoff_run *run, struct csg_handoff_job *job)
{
    const struct csg_process_bounds bounds = csg_openscad_bounds(run->handoff->params);
    char end[CSG_OPENSCAD_END_SIZE], what[CSG_OPENSCAD_END_SIZE + 16];
    csg_openscad_describe_end(&job->process, &bounds, end);
    snprintf(what, sizeof what, "openscad %s", end);
    pass_on(run, job->node, &job->process.output, true);
    fail(run, job->node, what, "");
}

/* The file that openscad has written; nothing where the subtree is empty, which it takes for an
 * error. false: it is one. */
static bool read_output(const struct csg_handoff_run *run, const struct csg_handoff_job *job,
                        const char *name, struct csg_bytes *stl)
{
    const int status = job->process.status;
    *stl = (struct csg_bytes){0};
    if (job->process.error || !WIFEXITED(status))
        return false;
    if (WEXITSTATUS(status) == 0) /* also where the disk was full, and then it may have no bytes */
        return csg_file_read(name, stl, &run->report->log) && stl->num > 0;
    return contains(&job->process.output, "top level object is empty");
}

static bool finish_job(struct csg_handoff_run *run, size_t index)
{
    struct csg_handoff_job *job = &run->jobs.data[index];
    struct csg_bytes stl = {0}, value = {0};
    char *name = file_name(run, index, ".stl");
    bool ok = name != NULL;
    run->num_done++;
    if (ok && !read_output(run, job, name, &stl)) {
        fail_job(run, job);
    } else if (ok) {
        const double seconds = csg_clock_ms() / 1000 - job->begun;
        const struct csg_mesh *mesh = &run->handoff->results.data[job->result].mesh;
        ok =
            make_value(&job->process.output, seconds, &stl, &value) && take_value(run, job, &value);
        if (ok && (stl.num == 0 || mesh->faces.num > 0))
            csg_cache_put(&run->cache, &job->key, &value);
    }
    free(name);
    free(stl.data);
    free(value.data);
    csg_process_finish(&job->process);
    return ok || csg_handoff_no_memory(run);
}

/* ---- all of them ---------------------------------------------------------------------------- */

static void tell(struct csg_handoff_run *run)
{
    const double now = csg_clock_ms() / 1000;
    if (now - run->told < progress_after)
        return;
    run->told = now;
    csg_log_print(&run->report->to, CSGCAST_LOG_INFO, CSGCAST_MESSAGE_PROGRESS,
                  "%s: openscad evaluates what only it can: %zu of %zu subtrees done, %.0f s",
                  run->report->file, run->num_done, run->jobs.num, now - run->begun);
}

static size_t num_cores(void)
{
    const long num = sysconf(_SC_NPROCESSORS_ONLN);
    return num > 0 ? (size_t)num : 1;
}

/* The processes at work, side by side, so that one call waits for all of them. */
struct slots {
    struct csg_process *processes;
    size_t *jobs; /* of each process */
    size_t num;
};

static bool take_ended(struct csg_handoff_run *run, struct slots *slots)
{
    bool ok = true;
    for (size_t i = 0; i < slots->num;) {
        if (slots->processes[i].is_running) {
            i++;
            continue;
        }
        const size_t job = slots->jobs[i];
        run->jobs.data[job].process = slots->processes[i];
        slots->processes[i] = slots->processes[--slots->num];
        slots->jobs[i] = slots->jobs[slots->num];
        ok = finish_job(run, job) && ok;
    }
    return ok;
}

static bool work(struct csg_handoff_run *run, struct slots *slots, size_t max)
{
    bool ok = true;
    for (size_t next = 0; ok && (next < run->jobs.num || slots->num > 0);) {
        for (; ok && slots->num < max && next < run->jobs.num; next++) {
            ok = start(run, next);
            if (!run->jobs.data[next].process.is_running)
                continue;
            slots->jobs[slots->num] = next;
            slots->processes[slots->num++] = run->jobs.data[next].process;
            run->jobs.data[next].process = (struct csg_process){0};
        }
        csg_process_wait(slots->processes, slots->num, 1000);
        ok = take_ended(run, slots) && ok;
        tell(run);
    }
    return ok;
}

static bool evaluate(struct csg_handoff_run *run)
{
    const size_t max = num_cores();
    struct slots slots = {calloc(max, sizeof *slots.processes), calloc(max, sizeof *slots.jobs), 0};
    bool ok = slots.processes && slots.jobs;
    run->begun = run->told = csg_clock_ms() / 1000;
    const bool has_folder = csg_folder_make(&run->folder);
    if (!has_folder)
        csg_log_error(&run->report->log, CSGCAST_MESSAGE_FILE,
                      "the environment variable TMPDIR has to name a place for temporary files, "
                      "which is /tmp otherwise: %s",
                      strerror(errno));
    ok = ok && (!has_folder || work(run, &slots, max));
    for (size_t i = 0; i < slots.num; i++)
        csg_process_finish(&slots.processes[i]);
    free(slots.processes);
    free(slots.jobs);
    return ok || csg_handoff_no_memory(run);
}

/* Takes the jobs that the cache has done. */
static bool use_cache(struct csg_handoff_run *run)
{
    size_t num = 0;
    bool ok = true;
    for (size_t i = 0; i < run->jobs.num; i++) {
        struct csg_handoff_job *job = &run->jobs.data[i];
        struct csg_bytes value;
        if (ok && csg_cache_get(&run->cache, &job->key, &value)) {
            run->handoff->results.data[job->result].is_cached = true;
            ok = take_value(run, job, &value);
            free(value.data);
            free(job->key.data);
        } else {
            run->jobs.data[num++] = *job;
        }
    }
    run->jobs.num = num;
    return ok;
}

static void finish(struct csg_handoff_run *run)
{
    for (size_t i = 0; i < run->jobs.num; i++) {
        csg_process_finish(&run->jobs.data[i].process);
        free(run->jobs.data[i].key.data);
    }
    csg_folder_remove(&run->folder);
    free(run->jobs.data);
    free(run->version.data);
    free(run->program);
    csg_cache_finish(&run->cache);
}

bool csg_handoff_run(struct csg_handoff *handoff, struct csg_report *report)
{
    struct csg_handoff_run run = {.handoff = handoff, .report = report};
    csg_cache_init(&run.cache, handoff->params->cache, handoff->params->cache_size);
    csg_handoff_settle(handoff);
    bool ok = find_program(&run);
    const int error = ok ? ask_version(&run) : 0;
    if (ok && error)
        ok = fail_all(&run, error);
    else if (ok)
        ok = csg_handoff_add_jobs(&run) && use_cache(&run) && (run.jobs.num == 0 || evaluate(&run));
    finish(&run);
    return ok;
}
