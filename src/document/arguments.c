/* SPDX-License-Identifier: MIT */
#include "document/arguments.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What one call of csg_arguments_read works on. */
struct reader {
    struct csg_arguments *to;
    struct csg_lexer *lexer;
    struct csg_token *token;
    struct csg_report *report;
};

void csg_arguments_finish(struct csg_arguments *arguments)
{
    free(arguments->args.data);
    free(arguments->stack.data);
    free(arguments->open.data);
    csg_arena_finish(&arguments->arena);
    *arguments = (struct csg_arguments){0};
}

bool csg_token_is_name(const struct csg_token *token, const char *name)
{
    return token->type == CSG_TOKEN_NAME && token->begin[0] == name[0] &&
           strlen(name) == token->length && memcmp(token->begin, name, token->length) == 0;
}

static void advance(struct reader *reader)
{
    csg_lexer_next(reader->lexer, reader->token);
}

static enum csg_status no_memory(struct reader *reader)
{
    csg_log_memory(&reader->report->log);
    return CSG_NO_MEMORY;
}

/* What people write who take the .csg format for the OpenSCAD language. */
static const char *hint_for(const struct csg_token *token)
{
    const bool calculates = token->length > 0 && token->type != CSG_TOKEN_STRING &&
                            token->begin[0] && strchr("+-*/%<>?&|^:", token->begin[0]);
    return calculates ? "; .csg text has no arithmetic, a .scad file may have it" : "";
}

static enum csg_status expected(struct reader *reader, const char *what)
{
    char found[64];
    const struct csg_token *token = reader->token;
    csg_token_describe(token, found);
    if (token->type == CSG_TOKEN_BAD)
        csg_report_error(reader->report, CSGCAST_MESSAGE_SYNTAX, token->place, "%s: %s%s", found,
                         token->problem, hint_for(token));
    else
        csg_report_error(reader->report, CSGCAST_MESSAGE_SYNTAX, token->place,
                         "expected %s, found %s%s", what, found, hint_for(token));
    return CSG_MALFORMED;
}

static enum csg_status expected_value(struct reader *reader)
{
    char found[64];
    if (reader->token->type != CSG_TOKEN_NAME)
        return expected(reader, "a value: a number, true, false, undef, \"text\" or [a, b, c]");
    csg_report_error(reader->report, CSGCAST_MESSAGE_SYNTAX, reader->token->place,
                     "%s is no value; .csg text has no variables, a .scad file may have them",
                     csg_token_describe(reader->token, found));
    return CSG_MALFORMED;
}

static bool is_hex_digit(char c)
{
    return strchr("0123456789abcdefABCDEF", c) && c != '\0';
}

/* Appends code as UTF-8. */
static char *put_code(char *to, unsigned long code)
{
    if (code > 0x10FFFF || (code >= 0xD800 && code < 0xE000))
        code = 0xFFFD;
    if (code < 0x80) {
        *to++ = (char)code;
    } else if (code < 0x800) {
        *to++ = (char)(0xC0 | code >> 6);
        *to++ = (char)(0x80 | (code & 0x3F));
    } else if (code < 0x10000) {
        *to++ = (char)(0xE0 | code >> 12);
        *to++ = (char)(0x80 | (code >> 6 & 0x3F));
        *to++ = (char)(0x80 | (code & 0x3F));
    } else {
        *to++ = (char)(0xF0 | code >> 18);
        *to++ = (char)(0x80 | (code >> 12 & 0x3F));
        *to++ = (char)(0x80 | (code >> 6 & 0x3F));
        *to++ = (char)(0x80 | (code & 0x3F));
    }
    return to;
}

/* Replaces \x41, \u20AC or \U01F600, which from points behind; anything else is left as it is. */
static const char *unescape_code(const char *from, const char *end, char **to)
{
    const char letter = *from;
    const size_t num_digits = letter == 'x' ? 2 : letter == 'u' ? 4 : 6;
    char digits[7] = {0};
    if ((size_t)(end - from) <= num_digits) {
        *(*to)++ = '\\';
        return from;
    }
    memcpy(digits, from + 1, num_digits);
    for (size_t i = 0; i < num_digits; i++)
        if (!is_hex_digit(digits[i])) {
            *(*to)++ = '\\';
            return from;
        }
    *to = put_code(*to, strtoul(digits, NULL, 16));
    return from + 1 + num_digits;
}

/* Copies the string without its escapes; that never makes it longer. Returns the new length. */
static size_t unescape(const char *from, size_t length, char *to)
{
    const char *const end = from + length;
    char *const first = to;
    while (from < end) {
        if (*from != '\\' || end - from < 2) {
            *to++ = *from++;
            continue;
        }
        from++;
        if (strchr("xuU", *from)) {
            from = unescape_code(from, end, &to);
        } else {
            const char c = *from++;
            *to++ = c == 'n' ? '\n' : c == 't' ? '\t' : c == 'r' ? '\r' : c;
        }
    }
    return (size_t)(to - first);
}

static char *copy_text(struct reader *reader, const struct csg_token *token, size_t *length)
{
    char *copy = csg_arena_alloc(&reader->to->arena, token->length + 1);
    if (!copy)
        return NULL;
    *length = token->length;
    if (token->type == CSG_TOKEN_STRING && !token->raw)
        *length = unescape(token->begin, token->length, copy);
    else
        memcpy(copy, token->begin, token->length);
    copy[*length] = '\0';
    return copy;
}

static enum csg_status read_string(struct reader *reader, struct csg_value *value)
{
    value->type = CSG_VALUE_STRING;
    value->string = copy_text(reader, reader->token, &value->num);
    return value->string ? CSG_DONE : no_memory(reader);
}

static bool read_named_number(const struct csg_token *token, struct csg_value *value)
{
    value->type = CSG_VALUE_NUMBER;
    value->number = csg_token_is_name(token, "inf") ? (double)INFINITY : (double)NAN;
    return csg_token_is_name(token, "inf") || csg_token_is_name(token, "nan");
}

static bool read_constant(const struct csg_token *token, struct csg_value *value)
{
    value->type = CSG_VALUE_BOOL;
    value->boolean = csg_token_is_name(token, "true");
    if (csg_token_is_name(token, "undef"))
        value->type = CSG_VALUE_UNDEF;
    return value->type == CSG_VALUE_UNDEF || value->boolean || csg_token_is_name(token, "false");
}

static enum csg_status read_signed_number(struct reader *reader, struct csg_value *value)
{
    bool negative = false;
    while (csg_token_is(reader->token, '-') || csg_token_is(reader->token, '+')) {
        negative ^= csg_token_is(reader->token, '-');
        advance(reader);
    }
    const struct csg_token *token = reader->token;
    if (token->type == CSG_TOKEN_NUMBER) {
        value->type = CSG_VALUE_NUMBER;
        value->number = token->number.value;
        value->rounding = token->number.rounding;
    } else if (!read_named_number(token, value)) {
        return expected(reader, "a number");
    }
    if (negative)
        value->number = -value->number;
    return CSG_DONE;
}

/* A value that is no vector. */
static enum csg_status read_scalar(struct reader *reader, struct csg_value *value)
{
    const struct csg_token *token = reader->token;
    enum csg_status status = CSG_DONE;
    *value = (struct csg_value){.line = token->place.line, .column = token->place.column};
    if (token->type == CSG_TOKEN_STRING)
        status = read_string(reader, value);
    else if (token->type == CSG_TOKEN_NUMBER || csg_token_is(token, '-') ||
             csg_token_is(token, '+'))
        status = read_signed_number(reader, value);
    else if (!read_named_number(token, value) && !read_constant(token, value))
        status = expected_value(reader);
    if (status == CSG_DONE)
        advance(reader);
    return status;
}

/* Reads one scalar onto the stack, and the '[' of the vectors that begin in front of it. */
static enum csg_status read_item(struct reader *reader)
{
    struct csg_arguments *to = reader->to;
    while (csg_token_is(reader->token, '[')) {
        const struct csg_open_vector vector = {to->stack.num, reader->token->place};
        if (!csg_array_push(&to->open, vector))
            return no_memory(reader);
        advance(reader);
    }
    if (csg_token_is(reader->token, ']') && to->open.num > 0)
        return CSG_DONE;
    struct csg_value value;
    const enum csg_status status = read_scalar(reader, &value);
    if (status == CSG_DONE && !csg_array_push(&to->stack, value))
        return no_memory(reader);
    return status;
}

/* At a ']': the items of the innermost vector leave the stack, the vector takes their place. */
static enum csg_status close_vector(struct reader *reader)
{
    struct csg_arguments *to = reader->to;
    const struct csg_open_vector vector = to->open.data[--to->open.num];
    const size_t num = to->stack.num - vector.first;
    struct csg_value *items = csg_arena_alloc(&to->arena, num * sizeof *items);
    if (!items)
        return no_memory(reader);
    if (num > 0)
        memcpy(items, to->stack.data + vector.first, num * sizeof *items);
    to->stack.num = vector.first;
    const struct csg_value value = {.type = CSG_VALUE_VECTOR,
                                    .line = vector.place.line,
                                    .column = vector.place.column,
                                    .items = items,
                                    .num = num};
    advance(reader);
    return csg_array_push(&to->stack, value) ? CSG_DONE : no_memory(reader);
}

/* Closes the vectors that end here and steps over the ',' in front of the next item. */
static enum csg_status read_between_items(struct reader *reader)
{
    enum csg_status status = CSG_DONE;
    struct csg_arguments *to = reader->to;
    while (status == CSG_DONE && to->open.num > 0) {
        if (csg_token_is(reader->token, ',')) {
            advance(reader);
            if (!csg_token_is(reader->token, ']'))
                break;
        } else if (!csg_token_is(reader->token, ']')) {
            return expected(reader, "',' or the ']' of a vector");
        }
        status = close_vector(reader);
    }
    return status;
}

/* Any depth of nesting: the vectors that are still open lie on a stack of their own. */
static enum csg_status read_value(struct reader *reader, struct csg_value *value)
{
    struct csg_arguments *to = reader->to;
    enum csg_status status = CSG_DONE;
    to->stack.num = to->open.num = 0;
    do {
        status = read_item(reader);
        if (status == CSG_DONE)
            status = read_between_items(reader);
    } while (status == CSG_DONE && to->open.num > 0);
    if (status == CSG_DONE)
        *value = to->stack.data[0];
    return status;
}

static bool is_named(const struct reader *reader)
{
    struct csg_lexer ahead = *reader->lexer;
    struct csg_token token;
    if (reader->token->type != CSG_TOKEN_NAME)
        return false;
    csg_lexer_next(&ahead, &token);
    return csg_token_is(&token, '=');
}

static enum csg_status read_argument(struct reader *reader, bool is_text_node)
{
    struct csg_arg arg = {0};
    if (is_named(reader)) {
        size_t length;
        const bool is_text = is_text_node && csg_token_is_name(reader->token, "text");
        if (!(arg.name = copy_text(reader, reader->token, &length)))
            return no_memory(reader);
        advance(reader);
        reader->lexer->is_text_node = is_text;
        advance(reader);
        reader->lexer->is_text_node = false;
    }
    const enum csg_status status = read_value(reader, &arg.value);
    if (status == CSG_DONE && !csg_array_push(&reader->to->args, arg))
        return no_memory(reader);
    return status;
}

enum csg_status csg_arguments_read(struct csg_arguments *arguments, struct csg_lexer *lexer,
                                   struct csg_token *token, struct csg_report *report)
{
    struct reader reader = {arguments, lexer, token, report};
    const bool is_text_node = csg_token_is_name(token, "text");
    csg_arena_reset(&arguments->arena);
    arguments->args.num = 0;
    advance(&reader);
    if (!csg_token_is(token, '('))
        return expected(&reader, "'(' behind the name of a node");
    advance(&reader);
    while (!csg_token_is(token, ')')) {
        const enum csg_status status = read_argument(&reader, is_text_node);
        if (status != CSG_DONE)
            return status;
        if (csg_token_is(token, ','))
            advance(&reader);
        else if (!csg_token_is(token, ')'))
            return expected(&reader, "',' or the ')' at the end of the arguments");
    }
    arguments->behind = *lexer;
    advance(&reader);
    return CSG_DONE;
}
