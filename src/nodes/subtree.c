/* SPDX-License-Identifier: MIT */
#include "nodes/subtree.h"

#include <stdlib.h>
#include <string.h>

#include "document/lexer.h"
#include "nodes/nodes.h"

struct writer {
    struct csg_subtree *subtree;
    struct csg_lexer lexer;
    struct csg_token token;
    int braces, parentheses;
    bool is_text_node;     /* in the arguments of text() */
    bool is_text, is_file; /* the next string is the text of text(), the name of a file */
    bool ok;
};

static void put(struct writer *writer, const char *bytes, size_t size)
{
    writer->ok = writer->ok && csg_bytes_append(&writer->subtree->text, bytes, size);
}

static void put_text(struct writer *writer, const char *text)
{
    put(writer, text, strlen(text));
}

/* What stands for itself, as an OpenSCAD string. */
static void put_escaped(struct writer *writer, const char *bytes, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        const char c = bytes[i];
        if (c == '"' || c == '\\')
            put_text(writer, "\\");
        if (c == '\n' || c == '\r' || c == '\t')
            put_text(writer, c == '\n' ? "\\n" : c == '\r' ? "\\r" : "\\t");
        else
            put(writer, &c, 1);
    }
}

/* A file's name with its escapes taken away: \" \\ \t \n \r are those that OpenSCAD writes. */
static void remember_file(struct writer *writer)
{
    struct csg_bytes *files = &writer->subtree->files;
    const char *bytes = writer->token.begin;
    writer->ok = writer->ok && csg_array_reserve(files, writer->token.length + 1);
    for (size_t i = 0; i < writer->token.length && writer->ok; i++) {
        const bool is_escape = bytes[i] == '\\' && i + 1 < writer->token.length;
        const char c = bytes[is_escape ? ++i : i];
        const char meant = c == 'n' ? '\n' : c == 't' ? '\t' : c == 'r' ? '\r' : c;
        files->data[files->num++] = is_escape ? meant : c;
    }
    if (writer->ok)
        files->data[files->num++] = '\0';
}

static void put_string(struct writer *writer)
{
    const struct csg_token *token = &writer->token;
    put_text(writer, "\"");
    if (token->raw)
        put_escaped(writer, token->begin, token->length);
    else
        put(writer, token->begin, token->length);
    put_text(writer, "\"");
    if (writer->is_file && token->length > 0)
        remember_file(writer);
}

static void put_name(struct writer *writer)
{
    const struct csg_token *token = &writer->token;
    if (csg_token_is_name(token, "nan"))
        put_text(writer, "(0/0)");
    else if (csg_token_is_name(token, "inf"))
        put_text(writer, "(1/0)");
    else if (writer->parentheses > 0 && csg_token_is_name(token, "timestamp"))
        put_text(writer, "$timestamp"); /* written by OpenSCAD, but no parameter to it */
    else
        put(writer, token->begin, token->length);
}

/* A second ! would make its node all that there is; the first one has been obeyed already. */
static void put_mark(struct writer *writer)
{
    const char mark = writer->token.mark;
    if (mark == '!')
        return;
    put(writer, &mark, 1);
    writer->braces += (mark == '{') - (mark == '}');
    writer->parentheses += (mark == '(') - (mark == ')');
    writer->is_text_node = writer->is_text_node && writer->parentheses > 0;
}

static void put_token(struct writer *writer)
{
    if (writer->subtree->text.num > 0)
        put_text(writer, " ");
    if (writer->token.type == CSG_TOKEN_STRING)
        put_string(writer);
    else if (writer->token.type == CSG_TOKEN_NAME)
        put_name(writer);
    else if (writer->token.type == CSG_TOKEN_MARK)
        put_mark(writer);
    else
        put(writer, writer->token.begin, writer->token.length);
}

static bool is_file_name(const struct csg_token *token)
{
    return csg_token_is_name(token, "file") || csg_token_is_name(token, "filename");
}

/* Follows what the next string is: after `text =` in text(), after `file =`, or after `import(`. */
static void follow(struct writer *writer)
{
    const struct csg_token *token = &writer->token;
    if (token->type == CSG_TOKEN_NAME) {
        const bool is_argument = writer->parentheses > 0;
        writer->is_text = is_argument && writer->is_text_node && csg_token_is_name(token, "text");
        writer->is_file =
            is_argument ? is_file_name(token)
                        : csg_token_is_name(token, "import") || csg_token_is_name(token, "surface");
        if (!is_argument)
            writer->is_text_node = csg_token_is_name(token, "text");
        writer->subtree->has_text |= writer->is_text_node;
    } else if (token->type != CSG_TOKEN_MARK || (token->mark != '=' && token->mark != '(')) {
        writer->is_text = writer->is_file = false;
    }
    writer->lexer.is_text_node = writer->is_text && csg_token_is(token, '=');
}

/* Whether the token just read ends the subtree. */
static bool is_end(const struct writer *writer)
{
    return writer->token.type == CSG_TOKEN_END ||
           (writer->braces == 0 && writer->parentheses == 0 &&
            (csg_token_is(&writer->token, ';') || csg_token_is(&writer->token, '}')));
}

bool csg_subtree_write(struct csg_subtree *subtree, const struct csg_document *document,
                       uint32_t node)
{
    const struct csg_parsed_node *parsed = &document->nodes.data[node];
    struct writer writer = {.subtree = subtree, .ok = true};
    csg_lexer_init(&writer.lexer, document->text, document->size, parsed->at, parsed->place);
    do {
        csg_lexer_next(&writer.lexer, &writer.token);
        put_token(&writer);
        follow(&writer);
    } while (writer.ok && !is_end(&writer));
    put_text(&writer, "\n");
    return writer.ok;
}

void csg_subtree_finish(struct csg_subtree *subtree)
{
    free(subtree->text.data);
    free(subtree->files.data);
    *subtree = (struct csg_subtree){0};
}

/* The solids that OpenSCAD has as well; all the other nodes of the table are its own. */
static bool is_shared_solid(const char *name, size_t length)
{
    static const char *const names[] = {"cube", "sphere", "cylinder"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        if (strlen(names[i]) == length && memcmp(names[i], name, length) == 0)
            return true;
    return false;
}

uint32_t csg_subtree_find_foreign(const struct csg_document *document, uint32_t node)
{
    const struct csg_parsed_node *nodes = document->nodes.data;
    uint32_t i = node;
    while (i < nodes[node].end) {
        const char *name = document->text + nodes[i].at;
        const bool is_disabled = (nodes[i].modifiers & CSG_MODIFIER_DISABLE) != 0;
        if (!is_disabled && !csg_node_find(name, nodes[i].name_length) &&
            !is_shared_solid(name, nodes[i].name_length))
            return i;
        i = is_disabled ? nodes[i].end : i + 1;
    }
    return i;
}
