/* SPDX-License-Identifier: MIT */
#include "document/runs.h"

#include <stdlib.h>
#include <string.h>

#include "document/digits.h"
#include "document/plain.h"

/* What is still open around the current token. */
enum open_type {
    OPEN_NODE,   /* cube() { ... */
    OPEN_PARENT, /* translate() and now its only child, without braces */
    OPEN_BLOCK,  /* { ... without a node: its content belongs to the node around it */
};

struct open {
    enum open_type type;
    uint32_t node;
    struct csg_place place; /* of the '{' */
};

struct parser {
    struct csg_document *document;
    struct csg_report *report;
    struct csg_lexer lexer;
    struct csg_token token;
    struct csg_arguments arguments;
    struct csg_twins twins;
    CSG_ARRAY(struct open) open;
    uint8_t modifiers; /* in front of the node to come */
    bool has_text;     /* strings whose end depends on all that follows */
};

/* Words that begin a statement of the OpenSCAD language but no node. */
static const char *const language_words[] = {
    "module", "function", "use",  "include",          "for",      "if", "let",
    "each",   "assert",   "echo", "intersection_for", "children", NULL,
};

static void advance(struct parser *parser)
{
    csg_lexer_next(&parser->lexer, &parser->token);
}

static enum csg_status no_memory(struct parser *parser)
{
    csg_log_memory(&parser->report->log);
    return CSG_NO_MEMORY;
}

static void expected(struct parser *parser, const char *what)
{
    char found[64];
    const struct csg_token *token = &parser->token;
    csg_token_describe(token, found);
    if (token->type == CSG_TOKEN_BAD)
        csg_report_error(parser->report, CSGCAST_MESSAGE_SYNTAX, token->place, "%s: %s", found,
                         token->problem);
    else
        csg_report_error(parser->report, CSGCAST_MESSAGE_SYNTAX, token->place,
                         "expected %s, found %s", what, found);
}

/* To the next ';' '{' '}' or the end, none of which occurs inside a node's arguments. */
static void skip_to_statement_end(struct parser *parser)
{
    const struct csg_token *token = &parser->token;
    while (token->type != CSG_TOKEN_END && !csg_token_is(token, ';') && !csg_token_is(token, '{') &&
           !csg_token_is(token, '}'))
        advance(parser);
}

/* The same from within malformed arguments. A string without its end has taken the ';' with it. */
static void skip_arguments(struct parser *parser)
{
    const struct csg_token *token = &parser->token;
    const bool is_open_string = token->type == CSG_TOKEN_BAD && token->begin[0] == '"';
    if (is_open_string)
        advance(parser);
    else
        skip_to_statement_end(parser);
}

/* Over a statement of the OpenSCAD language: to its ';' or over its { ... }. */
static void skip_statement(struct parser *parser)
{
    size_t depth = 0;
    do {
        skip_to_statement_end(parser);
        if (csg_token_is(&parser->token, '{'))
            depth++;
        else if (csg_token_is(&parser->token, '}') && depth-- == 0)
            return; /* of the node around it */
        if (parser->token.type != CSG_TOKEN_END)
            advance(parser);
    } while (depth > 0 && parser->token.type != CSG_TOKEN_END);
}

static bool is_language_word(const struct csg_token *token)
{
    size_t i = 0;
    while (language_words[i] && !csg_token_is_name(token, language_words[i]))
        i++;
    return language_words[i] != NULL;
}

/* One message for an if with all its elses. */
static void skip_language(struct parser *parser)
{
    char found[64];
    const bool is_line =
        csg_token_is_name(&parser->token, "use") || csg_token_is_name(&parser->token, "include");
    csg_report_error(parser->report, CSGCAST_MESSAGE_SYNTAX, parser->token.place,
                     "%s belongs to the OpenSCAD language, not to .csg text; give the file a name "
                     "that ends in .scad and openscad will flatten it",
                     csg_token_describe(&parser->token, found));
    if (is_line) {
        csg_lexer_skip_line(&parser->lexer);
        advance(parser);
        return;
    }
    do
        skip_statement(parser);
    while (csg_token_is_name(&parser->token, "else"));
}

/* Ends the node; a node that it is the only child of ends with it. */
static void end_node(struct parser *parser)
{
    const uint32_t end = (uint32_t)parser->document->nodes.num;
    while (parser->open.num > 0 && parser->open.data[parser->open.num - 1].type == OPEN_PARENT)
        parser->document->nodes.data[parser->open.data[--parser->open.num].node].end = end;
}

static enum csg_status push_open(struct parser *parser, enum open_type type, uint32_t node)
{
    const struct open open = {type, node, parser->token.place};
    return csg_array_push(&parser->open, open) ? CSG_DONE : no_memory(parser);
}

/* At a '}'. */
static void close_braces(struct parser *parser)
{
    end_node(parser);
    if (parser->open.num == 0) {
        csg_report_error(parser->report, CSGCAST_MESSAGE_SYNTAX, parser->token.place,
                         "this '}' closes nothing; there is one too many, or a '{' is missing");
    } else {
        const struct open open = parser->open.data[--parser->open.num];
        if (open.type == OPEN_NODE)
            parser->document->nodes.data[open.node].end = (uint32_t)parser->document->nodes.num;
        end_node(parser);
    }
    advance(parser);
}

static uint8_t modifier_of(const struct csg_token *token)
{
    switch (token->mark) {
    case '%':
        return CSG_MODIFIER_BACKGROUND;
    case '#':
        return CSG_MODIFIER_HIGHLIGHT;
    case '*':
        return CSG_MODIFIER_DISABLE;
    case '!':
        return CSG_MODIFIER_ROOT;
    default:
        return 0;
    }
}

static bool starts_node(const struct csg_token *token)
{
    return token->type == CSG_TOKEN_NAME || modifier_of(token) != 0;
}

/* What follows the arguments of node. */
static enum csg_status read_children(struct parser *parser, uint32_t node)
{
    const struct csg_token *token = &parser->token;
    enum csg_status status = CSG_DONE;
    if (csg_token_is(token, '{')) {
        status = push_open(parser, OPEN_NODE, node);
        advance(parser);
    } else if (starts_node(token)) {
        status = push_open(parser, OPEN_PARENT, node);
    } else {
        if (csg_token_is(token, ';'))
            advance(parser);
        else
            expected(parser, "';' or '{' behind the ')' of a node");
        end_node(parser);
    }
    return status;
}

static enum csg_status add_node(struct parser *parser, const struct csg_token *name)
{
    const size_t num = parser->document->nodes.num;
    const struct csg_parsed_node node = {.at = (size_t)(name->begin - parser->lexer.text),
                                         .place = name->place,
                                         .name_length = (uint32_t)name->length,
                                         .end = (uint32_t)num + 1,
                                         .twin = CSG_NO_TWIN,
                                         .modifiers = parser->modifiers};
    parser->modifiers = 0;
    if (num >= UINT32_MAX - 1 || name->length > UINT32_MAX) {
        csg_report_error(parser->report, CSGCAST_MESSAGE_SCENE, name->place,
                         "more than 4294967294 nodes, or a name that long");
        return CSG_NO_MEMORY;
    }
    return csg_array_push(&parser->document->nodes, node) ? CSG_DONE : no_memory(parser);
}

static bool is_assignment(const struct parser *parser)
{
    struct csg_lexer ahead = parser->lexer;
    struct csg_token token;
    csg_lexer_next(&ahead, &token);
    return csg_token_is(&token, '=');
}

static void skip_assignment(struct parser *parser)
{
    char found[64];
    csg_report_error(
        parser->report, CSGCAST_MESSAGE_SYNTAX, parser->token.place,
        "%s is assigned a value, but .csg text has no variables; write the value where "
        "it is used, or give the file a name that ends in .scad",
        csg_token_describe(&parser->token, found));
    skip_statement(parser);
}

/* Steps over the arguments of a node as they were stepped over where its twin stands. */
static void repeat(struct parser *parser, struct csg_parsed_node *node, const struct csg_twin *twin)
{
    struct csg_lexer *lexer = &parser->lexer;
    node->twin = twin->node;
    lexer->at = node->at + twin->length;
    lexer->line += twin->num_lines;
    if (twin->num_lines)
        lexer->line_begin = node->at + twin->line_begin;
    lexer->num_rounded += twin->num_rounded;
    advance(parser);
}

/* Checks the arguments of a node; behind is the lexer just behind them. */
static enum csg_status check_arguments(struct parser *parser, bool is_text,
                                       struct csg_lexer *behind)
{
    if (!is_text && csg_plain_skip(&parser->lexer)) {
        *behind = parser->lexer;
        advance(parser);
        return CSG_DONE;
    }
    const enum csg_status status =
        csg_arguments_read(&parser->arguments, &parser->lexer, &parser->token, parser->report);
    *behind = parser->arguments.behind;
    return status;
}

/* Checks the arguments of a node and, where they are long, remembers it. before: the lexer at its
 * name. */
static enum csg_status read_arguments(struct parser *parser, uint32_t index,
                                      const struct csg_lexer *before)
{
    struct csg_lexer *lexer = &parser->lexer;
    struct csg_parsed_node *node = &parser->document->nodes.data[index];
    const bool is_text = csg_token_is_name(&parser->token, "text");
    parser->has_text |= is_text;
    struct csg_lexer behind;
    const enum csg_status status = check_arguments(parser, is_text, &behind);
    if (status != CSG_DONE || is_text || !csg_twins_want(behind.at - node->at))
        return status;
    const struct csg_twin twin = {.at = node->at,
                                  .length = behind.at - node->at,
                                  .node = index,
                                  .num_lines = behind.line - before->line,
                                  .line_begin = behind.line_begin - node->at,
                                  .num_rounded = behind.num_rounded - before->num_rounded};
    node->twin = index;
    return csg_twins_add(&parser->twins, lexer, &twin) ? CSG_DONE : no_memory(parser);
}

static enum csg_status read_node(struct parser *parser)
{
    const uint32_t node = (uint32_t)parser->document->nodes.num;
    enum csg_status status = add_node(parser, &parser->token);
    if (status != CSG_DONE)
        return status;
    const struct csg_lexer before = parser->lexer;
    const struct csg_twin *twin =
        csg_twins_find(&parser->twins, &before, parser->document->nodes.data[node].at);
    if (twin)
        repeat(parser, &parser->document->nodes.data[node], twin);
    else
        status = read_arguments(parser, node, &before);
    if (status == CSG_MALFORMED) {
        parser->document->nodes.data[node].malformed = true;
        skip_arguments(parser);
        if (!csg_token_is(&parser->token, ';') && !csg_token_is(&parser->token, '{')) {
            end_node(parser);
            return CSG_DONE;
        }
    }
    return status == CSG_NO_MEMORY ? status : read_children(parser, node);
}

static enum csg_status read_name(struct parser *parser)
{
    if (is_language_word(&parser->token)) {
        skip_language(parser);
    } else if (is_assignment(parser)) {
        skip_assignment(parser);
    } else {
        return read_node(parser);
    }
    parser->modifiers = 0;
    end_node(parser);
    return CSG_DONE;
}

/* Anything that cannot begin a statement. */
static void skip_malformed(struct parser *parser)
{
    expected(parser, "a node such as cube(size = [1, 1, 1]);");
    skip_to_statement_end(parser);
}

/* A ';' alone is the empty statement, also where a node would have its only child. */
static void read_empty(struct parser *parser)
{
    end_node(parser);
    advance(parser);
}

static enum csg_status read_statement(struct parser *parser)
{
    const struct csg_token *token = &parser->token;
    const uint8_t modifier = modifier_of(token);
    enum csg_status status = CSG_DONE;
    if (modifier) {
        parser->modifiers |= modifier;
        advance(parser);
    } else if (token->type == CSG_TOKEN_NAME) {
        status = read_name(parser);
    } else if (parser->modifiers) {
        expected(parser, "a node behind the modifier");
        parser->modifiers = 0;
    } else if (csg_token_is(token, ';')) {
        read_empty(parser);
    } else if (csg_token_is(token, '{')) {
        status = push_open(parser, OPEN_BLOCK, 0);
        advance(parser);
    } else if (csg_token_is(token, '}')) {
        close_braces(parser);
    } else {
        skip_malformed(parser);
    }
    return status;
}

/* The end of the text ends all that is open; one message for the innermost '{'. */
static void close_all(struct parser *parser)
{
    bool reported = false;
    if (parser->modifiers)
        expected(parser, "a node behind the modifier");
    for (; parser->open.num > 0; parser->open.num--) {
        const struct open *open = &parser->open.data[parser->open.num - 1];
        if (open->type != OPEN_BLOCK)
            parser->document->nodes.data[open->node].end = (uint32_t)parser->document->nodes.num;
        if (open->type != OPEN_PARENT && !reported)
            csg_report_error(parser->report, CSGCAST_MESSAGE_SYNTAX, open->place,
                             "this '{' is never closed by a '}'");
        reported |= open->type != OPEN_PARENT;
    }
}

void csg_run_parse(struct csg_run *run, struct csg_report *report)
{
    enum csg_status status = CSG_DONE;
    struct parser parser = {.document = &run->document, .report = report};
    run->document = (struct csg_document){.text = run->text, .size = run->size};
    csg_lexer_init(&parser.lexer, run->text, run->end, run->begin, (struct csg_place){1, 1});
    parser.lexer.has_all_digits = csg_digits_are_all(run->text, run->size);
    advance(&parser);
    while (status != CSG_NO_MEMORY && parser.token.type != CSG_TOKEN_END)
        status = read_statement(&parser);
    run->is_whole = parser.open.num == 0 && !parser.has_text;
    close_all(&parser);
    run->document.num_rounded = parser.lexer.num_rounded;
    run->num_lines = parser.lexer.line - 1;
    run->twins = parser.twins;
    run->ok = status != CSG_NO_MEMORY;
    csg_arguments_finish(&parser.arguments);
    free(parser.open.data);
}
