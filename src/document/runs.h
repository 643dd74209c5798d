/* SPDX-License-Identifier: MIT */
#ifndef CSG_DOCUMENT_RUNS_H
#define CSG_DOCUMENT_RUNS_H

/*
 * Large texts are parsed in runs, side by side: from a line that follows a '}' or ';' and begins
 * with a letter, as the outermost nodes do in what OpenSCAD writes, to the next such one. Where a
 * run ends within a node or has anything to be said, the cuts mean nothing, and one parser reads
 * everything, so that messages come in the order of the text.
 */

#include "document/document.h"
#include "document/twins.h"

struct csg_run {
    const char *text;
    size_t size;                  /* of all of the text */
    size_t begin, end;            /* bytes */
    struct csg_document document; /* places and nodes are counted from the beginning of the run */
    struct csg_twins twins;
    uint32_t num_lines; /* that end in it */
    bool is_whole;      /* nothing in it depends on what is before or behind it */
    bool ok;            /* false: memory is out */
};

/* Parses one run, in parser.c. */
void csg_run_parse(struct csg_run *run, struct csg_report *report);
void csg_run_finish(struct csg_run *run);

/* Fills document, which has text and size. false: nothing has happened, one parser is needed. */
bool csg_runs_parse(struct csg_document *document, const char *file, int num_threads);

#endif
