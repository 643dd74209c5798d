/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_HANDOFF_JOBS_H
#define CSG_NODES_HANDOFF_JOBS_H

/* What a hand-off has openscad evaluate: a text for each subtree, and its key in the cache. */

#include "common/array.h"
#include "common/folder.h"
#include "common/process.h"
#include "document/report.h"
#include "nodes/handoff.h"
#include "openscad/cache.h"

/* A text that openscad is to evaluate. */
struct csg_handoff_job {
    size_t result;        /* in handoff->results */
    uint32_t node;        /* the first that asks for it */
    struct csg_bytes key; /* of the cache */
    struct csg_process process;
    double begun;
};

struct csg_handoff_run {
    struct csg_handoff *handoff;
    struct csg_report *report;
    struct csg_cache cache;
    struct csg_bytes version; /* what openscad says about itself */
    uint64_t fonts;           /* as csg_text_fonts, once it is asked for */
    bool fonts_known;
    char *program;
    struct csg_folder folder; /* for files in between */
    CSG_ARRAY(struct csg_handoff_job) jobs;
    double begun, told; /* when work began, when the last word about it was said */
    size_t num_done;
};

/* Says that memory is out; false. */
bool csg_handoff_no_memory(const struct csg_handoff_run *run);

/* Sorts all nodes; drops what is part of another one or asked for twice. */
void csg_handoff_settle(struct csg_handoff *handoff);

/* Adds a job for each text that is wanted and not there. false, with a message: memory is out. */
bool csg_handoff_add_jobs(struct csg_handoff_run *run);

#endif
