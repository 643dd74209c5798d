/* SPDX-License-Identifier: MIT */
#include "openscad/bounds.h"

#include <signal.h>
#include <stdio.h>
#include <sys/wait.h>

#include "openscad/openscad.h"

struct csg_process_bounds csg_openscad_bounds(const struct csgcast_scene_params *params)
{
    return (struct csg_process_bounds){.memory = params->openscad_memory,
                                       .seconds = params->openscad_seconds};
}

void csg_openscad_describe_end(const struct csg_process *process,
                               const struct csg_process_bounds *bounds,
                               char text[CSG_OPENSCAD_END_SIZE])
{
    const int status = process->status;
    const bool is_killed = WIFSIGNALED(status);
    if (csg_openscad_mentions(&process->output, "std::bad_alloc") ||
        csg_openscad_mentions(&process->output, "GNU MP: Cannot allocate memory"))
        snprintf(text, CSG_OPENSCAD_END_SIZE,
                 "needs more than %.0f MiB of memory (--openscad-memory)",
                 (double)csg_process_memory(bounds) / (1 << 20));
    else if (is_killed && WTERMSIG(status) == SIGXCPU)
        snprintf(text, CSG_OPENSCAD_END_SIZE,
                 "needs more than %u s of processor time (--openscad-time)",
                 (unsigned)bounds->seconds);
    else if (is_killed)
        snprintf(text, CSG_OPENSCAD_END_SIZE, "was killed by signal %d", WTERMSIG(status));
    else
        snprintf(text, CSG_OPENSCAD_END_SIZE, "reports an error (exit status %d)",
                 WEXITSTATUS(status));
}
