/* SPDX-License-Identifier: MIT */
#include "scene/parameters.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "document/digits.h"
#include "scene/source.h"

/* "cube(size = 3\n)": the line's end, as a comment may end the parameters. NULL: no memory. */
static char *node_text(const char *node, const char *parameters, size_t *size)
{
    *size = strlen(node) + strlen(parameters) + 3;
    char *text = malloc(*size + 1);
    if (text)
        snprintf(text, *size + 1, "%s(%s\n)", node, parameters);
    return text;
}

bool csg_parameters_read(struct csg_parameters *parameters, const struct csgcast_scene *scene,
                         uint32_t leaf, const char *node, const char *text)
{
    const struct csg_source *source = scene->source;
    struct csg_lexer lexer;
    struct csg_token token;
    size_t size;
    *parameters = (struct csg_parameters){.text = node_text(node, text, &size)};
    snprintf(parameters->file, sizeof parameters->file, "<edit of leaf %u>", (unsigned)leaf);
    csg_report_init(&parameters->report, &scene->log, parameters->file);
    if (!parameters->text)
        return csg_log_memory(&parameters->report.log);
    csg_lexer_init(&lexer, parameters->text, size, 0, (struct csg_place){1, 1});
    csg_lexer_next(&lexer, &token);
    lexer.has_all_digits = csg_digits_are_all(source->text, source->size);
    lexer.line_begin = strlen(node) + 1; /* columns count from the first parameter */
    if (csg_arguments_read(&parameters->arguments, &lexer, &token, &parameters->report) != CSG_DONE)
        return false;
    if (token.type != CSG_TOKEN_END)
        csg_report_error(&parameters->report, CSGCAST_MESSAGE_SYNTAX, token.place,
                         "nothing may follow the parameters of %s", node);
    return token.type == CSG_TOKEN_END;
}

bool csg_parameters_finish(struct csg_parameters *parameters)
{
    csg_arguments_finish(&parameters->arguments);
    free(parameters->text);
    return csg_report_finish(&parameters->report);
}
