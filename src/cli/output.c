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
                                      csg_cli_output_fn *run)
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
        result = run(options, output);
    free(named);
    return result;
}
