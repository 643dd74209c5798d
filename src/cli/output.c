/* SPDX-License-Identifier: MIT */
#include "output.h"

#include "messages.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static bool is_stream(const char *path)
{
    return !strcmp(path, "-");
}

/* "dir/part.scad" gives "part.png"; NULL when memory is out. */
static char *default_output(const char *input, const char *extension)
{
    const char *slash = strrchr(input, '/');
    const char *name = slash ? slash + 1 : input;
    const char *dot = strrchr(name, '.');
    const int length = (int)(dot && dot != name ? (size_t)(dot - name) : strlen(name));
    const size_t size = strlen(name) + strlen(extension) + 2;
    char *path = malloc(size);
    if (path)
        snprintf(path, size, "%.*s.%s", length, name, extension);
    return path;
}

/* The folder of a path in a new string, "." when it names none; NULL when memory is out. */
static char *folder_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    const size_t length = !slash ? 1 : slash == path ? 1 : (size_t)(slash - path);
    char *folder = malloc(length + 1);
    if (!folder)
        return NULL;
    memcpy(folder, slash ? path : ".", length);
    folder[length] = 0;
    return folder;
}

static enum csg_cli_exit check_output(const char *input, const char *output)
{
    struct stat in, out;
    if (is_stream(output))
        return CSG_EXIT_OK;
    if (!stat(output, &out)) {
        if (S_ISDIR(out.st_mode)) {
            csg_cli_error("cannot write %s: it is a folder", output);
            return CSG_EXIT_OUTPUT;
        }
        if (!stat(input, &in) && in.st_dev == out.st_dev && in.st_ino == out.st_ino) {
            csg_cli_error("the output %s would overwrite the scene", output);
            return CSG_EXIT_USAGE;
        }
    }
    char *folder = folder_of(output);
    const bool writable = folder && !access(folder, W_OK | X_OK);
    if (!writable)
        csg_cli_error("cannot write %s: %s", output, strerror(folder ? errno : ENOMEM));
    free(folder);
    return writable ? CSG_EXIT_OK : CSG_EXIT_OUTPUT;
}

enum csg_cli_exit csg_cli_with_output(const struct csg_cli_options *options, const char *extension,
                                      csg_cli_output_fn *run, void *user)
{
    if (is_stream(options->input) && !options->output) {
        csg_cli_error("a scene from standard input needs -o FILE");
        return CSG_EXIT_USAGE;
    }
    const char *format = options->write.format ? options->write.format : extension;
    char *named = options->output ? NULL : default_output(options->input, format);
    const char *output = options->output ? options->output : named;
    if (!output) {
        csg_cli_error("out of memory");
        return CSG_EXIT_FAILED;
    }
    enum csg_cli_exit result = check_output(options->input, output);
    if (result == CSG_EXIT_OK)
        result = run(options, output, user);
    free(named);
    return result;
}

static int compare_names(const void *a, const void *b)
{
    char *const *x = a, *const *y = b;
    return strcmp(*x, *y);
}

static bool are_different(char **names, size_t num)
{
    qsort(names, num, sizeof *names, compare_names);
    for (size_t i = 1; i < num; i++) {
        if (strcmp(names[i - 1], names[i]) != 0)
            continue;
        csg_cli_error("several of the scenes would become %s", names[i]);
        return false;
    }
    return true;
}

bool csg_cli_check_outputs(const struct csg_cli_options *options, const char *extension)
{
    const char *format = options->write.format ? options->write.format : extension;
    const size_t num = options->num_inputs;
    size_t made = 0;
    if (num < 2)
        return true;
    if (options->output) {
        csg_cli_error("-o names one file: of several scenes each becomes one of its own name");
        return false;
    }
    char **names = calloc(num, sizeof *names);
    while (names && made < num && (names[made] = default_output(options->inputs[made], format)))
        made++;
    if (made < num)
        csg_cli_error("out of memory");
    const bool good = made == num && are_different(names, num);
    while (made > 0)
        free(names[--made]);
    free(names);
    return good;
}
