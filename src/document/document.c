/* SPDX-License-Identifier: MIT */
#include "document/document.h"

#include <stdlib.h>

#include "document/runs.h"

bool csg_document_parse(struct csg_document *document, const char *text, size_t size,
                        int num_threads, struct csg_report *report)
{
    struct csg_run run = {.text = text, .size = size, .end = size};
    *document = (struct csg_document){.text = text, .size = size};
    if (csg_runs_parse(document, report->file, num_threads))
        return true;
    free(document->nodes.data);
    csg_run_parse(&run, report);
    csg_twins_finish(&run.twins);
    *document = run.document;
    return run.ok;
}

void csg_document_finish(struct csg_document *document)
{
    free(document->nodes.data);
    *document = (struct csg_document){0};
}

bool csg_document_arguments(const struct csg_document *document, size_t node,
                            struct csg_arguments *arguments, struct csg_report *report)
{
    const struct csg_parsed_node *parsed = &document->nodes.data[node];
    struct csg_lexer lexer;
    struct csg_token token;
    csg_lexer_init(&lexer, document->text, document->size, parsed->at, parsed->place);
    csg_lexer_next(&lexer, &token);
    return csg_arguments_read(arguments, &lexer, &token, report) == CSG_DONE;
}
