/* SPDX-License-Identifier: MIT */
#include "scene/node_texts.h"

#include <stdlib.h>
#include <string.h>

#include "document/digits.h"
#include "nodes/nodes.h"

bool csg_node_texts_init(struct csg_node_texts *texts, struct csg_document *document)
{
    texts->document = *document;
    *document = (struct csg_document){0};
    texts->arguments = calloc(texts->document.nodes.num + 1, sizeof *texts->arguments);
    return texts->arguments != NULL;
}

void csg_node_texts_finish(struct csg_node_texts *texts)
{
    for (size_t i = 0; i < texts->document.nodes.num && texts->arguments; i++)
        free(texts->arguments[i]);
    free(texts->arguments);
    csg_document_finish(&texts->document);
}

const char *csg_node_texts_name(const struct csg_node_texts *texts, uint32_t node)
{
    const struct csg_parsed_node *parsed = &texts->document.nodes.data[node];
    const char *name = texts->document.text + parsed->at;
    const struct csg_node_ops *ops = csg_node_find(name, parsed->name_length);
    const enum csg_kind kind = csg_solid_find(name, parsed->name_length);
    return ops ? ops->name : kind < CSG_NUM_KINDS ? csg_solids[kind]->name : "";
}

/* Bytes of a text. */
struct range {
    size_t begin, end;
};

/* Where the text has the node's arguments. false: out of memory. */
static bool find_arguments(const struct csg_document *document, uint32_t node, struct range *range)
{
    const struct csg_parsed_node *parsed = &document->nodes.data[node];
    struct csg_arguments arguments = {0};
    struct csg_report report;
    struct csg_lexer lexer;
    struct csg_token token;
    csg_report_init(&report, &csg_log_silent, "");
    csg_lexer_init(&lexer, document->text, document->size, parsed->at, parsed->place);
    csg_lexer_next(&lexer, &token);
    struct csg_lexer ahead = lexer;
    struct csg_token parenthesis;
    csg_lexer_next(&ahead, &parenthesis);
    range->begin = ahead.at;
    const bool ok = csg_arguments_read(&arguments, &lexer, &token, &report) == CSG_DONE;
    range->end = ok ? arguments.behind.at - 1 : range->begin;
    csg_arguments_finish(&arguments);
    return ok;
}

const char *csg_node_texts_get(struct csg_node_texts *texts, uint32_t node)
{
    struct range range;
    if (texts->arguments[node] || !find_arguments(&texts->document, node, &range))
        return texts->arguments[node];
    const size_t length = range.end - range.begin;
    char *copy = malloc(length + 1);
    if (copy) {
        memcpy(copy, texts->document.text + range.begin, length);
        copy[length] = '\0';
    }
    return texts->arguments[node] = copy;
}

/* ---- excerpts ------------------------------------------------------------------------------ */

static bool write_modifiers(struct csg_bytes *text, uint8_t modifiers)
{
    return (!(modifiers & CSG_MODIFIER_DISABLE) || csg_bytes_append_text(text, "*")) &&
           (!(modifiers & CSG_MODIFIER_BACKGROUND) || csg_bytes_append_text(text, "%")) &&
           (!(modifiers & CSG_MODIFIER_HIGHLIGHT) || csg_bytes_append_text(text, "#"));
}

static bool write_arguments(struct csg_bytes *text, const struct csg_node_texts *texts,
                            uint32_t node)
{
    const char *arguments = texts->arguments[node];
    struct range range;
    if (arguments) /* they begin the first line */
        return csg_bytes_append_text(text, "\n") && csg_bytes_append_text(text, arguments);
    return find_arguments(&texts->document, node, &range) &&
           csg_bytes_append(text, texts->document.text + range.begin, range.end - range.begin);
}

/* "#cube(size = 3\n)": a comment may end the arguments. *at: where the name stands. */
static bool write_node(struct csg_bytes *text, const struct csg_node_texts *texts, uint32_t node,
                       uint8_t modifiers, size_t *at)
{
    const struct csg_document *document = &texts->document;
    const struct csg_parsed_node *parsed = &document->nodes.data[node];
    if (!write_modifiers(text, modifiers))
        return false;
    *at = text->num;
    return csg_bytes_append(text, document->text + parsed->at, parsed->name_length) &&
           csg_bytes_append_text(text, "(") && write_arguments(text, texts, node) &&
           csg_bytes_append_text(text, "\n)");
}

static bool add_node(struct csg_excerpt *excerpt, const struct csg_node_texts *texts, uint32_t node,
                     uint32_t begin)
{
    struct csg_parsed_node copy = texts->document.nodes.data[node];
    copy.end -= begin;
    copy.twin = CSG_NO_TWIN;
    if (begin > 0)
        copy.modifiers &= (uint8_t)~CSG_MODIFIER_ROOT; /* it has been obeyed */
    if (texts->arguments[node])
        copy.place = (struct csg_place){0, 1};
    return write_node(&excerpt->text, texts, node, copy.modifiers, &copy.at) &&
           csg_array_push(&excerpt->document.nodes, copy);
}

bool csg_excerpt_init(struct csg_excerpt *excerpt, const struct csg_node_texts *texts,
                      uint32_t begin, uint32_t end)
{
    const struct csg_document *document = &texts->document;
    CSG_ARRAY(uint32_t) open = {0}; /* ends of the nodes around */
    bool ok = true;
    for (uint32_t i = begin; i < end && ok; i++) {
        const uint32_t node_end = document->nodes.data[i].end;
        const bool has_children = node_end > i + 1;
        ok = add_node(excerpt, texts, i, begin) &&
             csg_bytes_append_text(&excerpt->text, has_children ? "{\n" : ";\n") &&
             (!has_children || csg_array_push(&open, node_end));
        for (; ok && open.num > 0 && open.data[open.num - 1] == i + 1; open.num--)
            ok = csg_bytes_append_text(&excerpt->text, "}\n");
    }
    free(open.data);
    if (csg_digits_are_all(document->text, document->size))
        ok = ok && csg_bytes_append_text(&excerpt->text, CSG_DIGITS_MARK);
    excerpt->document.text = excerpt->text.data;
    excerpt->document.size = excerpt->text.num;
    return ok;
}

void csg_excerpt_finish(struct csg_excerpt *excerpt)
{
    free(excerpt->text.data);
    csg_document_finish(&excerpt->document);
}
