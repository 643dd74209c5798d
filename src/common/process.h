/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_PROCESS_H
#define CSG_COMMON_PROCESS_H

/*
 * Programs that run beside us: what they print is collected, several are waited for at once. They
 * end with the thread that has started them, so with a process that is killed.
 */

#include <stdint.h>
#include <sys/types.h>

#include "common/file.h"

/* What a program may use up before the system ends it. */
struct csg_process_bounds {
    uint64_t memory;  /* bytes. 0: half of the machine's; UINT64_MAX: all that there is */
    uint32_t seconds; /* of processor time. 0: no bound */
};

struct csg_process {
    bool is_running;
    int error;               /* of waiting or reading, when it has ended; 0: none */
    int status;              /* as from waitpid, when it has ended */
    struct csg_bytes output; /* both of its output streams; the caller frees data */
    pid_t pid;
    int pipe;
};

/*
 * Starts argv[0], looked for in the path, without a shell: names with blanks and quotes need no
 * care. input: the file that is its standard input, NULL: an empty one. directory: where it starts,
 * NULL: where we are. environment: its variables, "NAME=value" with NULL behind the last one; NULL:
 * ours. bounds: NULL: ours. Returns an error number; process then needs no finish.
 */
int csg_process_start(struct csg_process *process, char *const *argv, const char *input,
                      const char *directory, char *const *environment,
                      const struct csg_process_bounds *bounds);

/* The bytes that bounds->memory stands for. */
uint64_t csg_process_memory(const struct csg_process_bounds *bounds);

/*
 * Waits until one of the processes has ended, or for the time given in ms; below 0: without end.
 * Several may have ended: see is_running. Processes that do not run are passed over.
 */
void csg_process_wait(struct csg_process *processes, size_t num, int ms);

/* Ends the process if it runs, and frees its output. */
void csg_process_finish(struct csg_process *process);

/* Whether it could not even be started: the exit status by which some systems say so. */
bool csg_process_is_missing(const struct csg_process *process);

#endif
