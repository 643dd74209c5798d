/* SPDX-License-Identifier: MIT */
#ifndef _DEFAULT_SOURCE
#define _DEFAULT_SOURCE /* wait4 */
#endif

/* csgcast bench: what the first image and later frames of scenes cost. */

#include "commands.h"
#include "ending.h"
#include "json.h"
#include "measure.h"
#include "messages.h"
#include "options.h"
#include "picture.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

static bool read_all(int file, void *bytes, size_t size)
{
    char *to = bytes;
    while (size > 0) {
        const ssize_t num = read(file, to, size);
        if (num == 0 || (num < 0 && errno != EINTR))
            return false;
        to += num > 0 ? num : 0;
        size -= num > 0 ? (size_t)num : 0;
    }
    return true;
}

/* The child writes less than a pipe holds, in one go. */
static void run_child(const struct csg_cli_options *options, const char *input, int file)
{
    struct csg_measurement result;
    csg_ending_begin();
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    const bool good = csg_measure(options, input, &result) &&
                      write(file, &result, sizeof result) == (ssize_t)sizeof result;
    close(file);
    _exit(good ? 0 : 1);
}

/* Each scene in a process of its own: only so its peak of memory and its first image are its own.
 */
static bool measure_apart(const struct csg_cli_options *options, const char *input,
                          struct csg_measurement *result)
{
    int ends[2], status = 0;
    struct rusage usage;
    fflush(stdout);
    if (pipe(ends) != 0)
        return csg_cli_error("cannot make a pipe: %s", strerror(errno)), false;
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        run_child(options, input, ends[1]);
    }
    close(ends[1]);
    const bool good = child > 0 && read_all(ends[0], result, sizeof *result);
    close(ends[0]);
    if (child < 0)
        return csg_cli_error("cannot start a process: %s", strerror(errno)), false;
    while (wait4(child, &status, 0, &usage) < 0 && errno == EINTR)
        ;
    result->peak_rss = 1024 * (size_t)usage.ru_maxrss;
    if (WIFSIGNALED(status))
        csg_cli_error("%s: the measurement ended by signal %d", input, WTERMSIG(status));
    return good && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/* ---- what is printed ------------------------------------------------------------------------ */

static void print_stages(struct csg_json *json, const char *key,
                         const struct csg_frame_times *times)
{
    csg_json_open(json, key);
    csg_json_number(json, "csg", times->csg);
    csg_json_number(json, "tile", times->tile);
    csg_json_number(json, "pack", times->pack);
    csg_json_number(json, "upload", times->upload);
    csg_json_number(json, "draw", times->draw);
    csg_json_number(json, "read", times->read);
    csg_json_close(json);
}

static void print_times(struct csg_json *json, const struct csg_measurement *result)
{
    csg_json_number(json, "load_ms", result->load_ms);
    csg_json_number(json, "first_image_ms", result->first_image_ms);
    print_stages(json, "first_stages_ms", &result->first);
    csg_json_open(json, "frame_ms");
    csg_json_number(json, "median", result->frame_ms.median);
    csg_json_number(json, "min", result->frame_ms.min);
    csg_json_number(json, "max", result->frame_ms.max);
    csg_json_close(json);
    csg_json_number(json, "work_ms", result->medians.work);
    csg_json_number(json, "cpu_ms", result->medians.cpu);
    csg_json_number(json, "edit_ms", result->medians.edit);
    print_stages(json, "stages_ms", &result->medians);
}

static void print_json(struct csg_json *json, const char *input,
                       const struct csg_measurement *result)
{
    csg_json_open(json, NULL);
    csg_json_string(json, "scene", input);
    csg_json_bool(json, "failed", false);
    csg_json_size(json, "width", (size_t)result->width);
    csg_json_size(json, "height", (size_t)result->height);
    csg_json_size(json, "frames", (size_t)result->num_frames);
    csg_json_size(json, "leaves", result->num_leaves);
    csg_json_string(json, "renderer", result->renderer);
    csg_json_string(json, "variants", result->stats.variants);
    print_times(json, result);
    csg_json_size(json, "programs", result->stats.programs);
    csg_json_size(json, "programs_after_first", result->stats.programs - result->first_programs);
    csg_json_number(json, "compile_ms", result->compile_ms);
    csg_json_size(json, "bytes_uploaded", result->stats.bytes_uploaded);
    csg_json_size(json, "texture_bytes", result->stats.texture_bytes);
    csg_json_size(json, "peak_rss", result->peak_rss);
    csg_json_close(json);
}

/* So that the list has an object for each file. */
static void print_failure(struct csg_json *json, const char *input)
{
    csg_json_open(json, NULL);
    csg_json_string(json, "scene", input);
    csg_json_bool(json, "failed", true);
    csg_json_close(json);
}

static void print_head(void)
{
    printf("%-24s %8s %9s %9s %9s %9s %9s %9s %4s %9s %9s %8s\n", "scene", "leaves", "first ms",
           "frame ms", "min", "max", "work ms", "cpu ms", "prog", "compile", "upload kB",
           "peak MB");
}

static void print_row(const char *input, const struct csg_measurement *result)
{
    const char *slash = strrchr(input, '/');
    printf("%-24s %8zu %9.1f %9.2f %9.2f %9.2f %9.2f %9.2f %4zu %9.1f %9.1f %8.1f\n",
           slash ? slash + 1 : input, result->num_leaves, result->first_image_ms,
           result->frame_ms.median, result->frame_ms.min, result->frame_ms.max,
           result->medians.work, result->medians.cpu, result->stats.programs, result->compile_ms,
           1e-3 * (double)result->stats.bytes_uploaded, 1e-6 * (double)result->peak_rss);
    fflush(stdout);
}

/* false: the scene cannot be measured, which was said. */
static bool run_one(const struct csg_cli_options *options, const char *input, struct csg_json *json)
{
    struct csg_measurement result;
    const bool good = measure_apart(options, input, &result);
    if (good && options->json)
        print_json(json, input, &result);
    else if (good)
        print_row(input, &result);
    else if (options->json)
        print_failure(json, input);
    return good;
}

static enum csg_cli_exit run(const struct csg_cli_options *options)
{
    struct csg_json json = {.file = stdout};
    bool all_good = true;
    if (!csg_picture_is_possible(options))
        return CSG_EXIT_USAGE;
    if (options->json)
        csg_json_list_open(&json, NULL);
    else
        print_head();
    for (size_t i = 0; i < options->num_inputs; i++)
        all_good &= run_one(options, options->inputs[i], &json);
    if (options->json)
        csg_json_list_close(&json);
    return csg_cli_end_output(all_good ? CSG_EXIT_OK : CSG_EXIT_FAILED, CSG_EXIT_OUTPUT);
}

const struct csg_cli_command csg_command_bench = {
    .name = "bench",
    .bit = CSG_COMMAND_BENCH,
    .summary = "measure what scenes cost",
    .usage = "FILE... [OPTION...]",
    .text = "Draws each scene again and again and prints, in milliseconds, the first image (from\n"
            "the file, with the OpenGL context and the compiling of programs), the median and the\n"
            "range of the frames after it, their processor time on all cores together, the part\n"
            "that csgcast prepares on the CPU, and programs, uploaded bytes and the peak of\n"
            "memory; --json also what each stage took. Each scene gets a process of its own.\n"
            "Nothing is written to image files.\n",
    .tail = "  csgcast bench part.scad\n"
            "  csgcast bench a.csg b.csg --imgsize=1024,1024 --frames=36 --orbit --json\n"
            "  csgcast bench part.csg --edit\n",
    .many = true,
    .run = run,
};
