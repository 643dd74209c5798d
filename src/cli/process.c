/* SPDX-License-Identifier: MIT */
#include "process.h"

#include "messages.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/clock.h"
#include "common/process.h"

static void write_log(const char *path, const struct csg_bytes *output)
{
    FILE *file = path ? fopen(path, "w") : NULL;
    if (!file)
        return;
    if (output->num)
        fwrite(output->data, 1, output->num, file);
    fclose(file);
}

enum csg_process_end csg_process_run(const char *const *argv, const char *log, double limit,
                                     uint64_t memory, double *seconds)
{
    const struct csg_process_bounds bounds = {.memory = memory};
    struct csg_process process;
    const double begun = csg_clock_ms();
    if (csg_process_start(&process, (char *const *)(uintptr_t)argv, NULL, NULL, NULL, &bounds))
        return CSG_PROCESS_MISSING;
    csg_process_wait(&process, 1, limit > 0 ? (int)fmin(1e3 * limit, INT_MAX) : -1);
    if (seconds)
        *seconds = (csg_clock_ms() - begun) / 1e3;
    const bool timed_out = process.is_running;
    const bool missing = csg_process_is_missing(&process);
    const bool done = WIFEXITED(process.status) && WEXITSTATUS(process.status) == 0;
    write_log(log, &process.output);
    csg_process_finish(&process);
    if (timed_out)
        return CSG_PROCESS_TIMED_OUT;
    return missing ? CSG_PROCESS_MISSING : done ? CSG_PROCESS_DONE : CSG_PROCESS_FAILED;
}

static bool is_in(const char *folder, size_t length, const char *program)
{
    char path[PATH_MAX];
    const int num = snprintf(path, sizeof path, "%.*s/%s", (int)length, folder, program);
    return num > 0 && (size_t)num < sizeof path && access(path, X_OK) == 0;
}

bool csg_process_exists(const char *program)
{
    const char *path = getenv("PATH");
    if (strchr(program, '/'))
        return access(program, X_OK) == 0;
    while (path && *path) {
        const size_t length = strcspn(path, ":");
        if (is_in(path, length, program))
            return true;
        path += length + (path[length] == ':');
    }
    return false;
}

bool csg_process_make_folder(struct csg_folder *folder)
{
    if (csg_folder_make(folder))
        return true;
    csg_cli_error("cannot make a folder for temporary files: %s", strerror(errno));
    return false;
}
