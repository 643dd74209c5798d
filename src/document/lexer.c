/* SPDX-License-Identifier: MIT */
#include "document/lexer.h"

#include <stdio.h>
#include <string.h>

#include "document/digits.h"

/* Characters of one token that a message quotes. */
enum { shown_length = 32 };

#define TEXT_OF(macro) TEXT_OF_TOKENS(macro)
#define TEXT_OF_TOKENS(tokens) #tokens

static const char raw_terminator[] = "\", size = ";

void csg_lexer_init(struct csg_lexer *lexer, const char *text, size_t size, size_t at,
                    struct csg_place place)
{
    *lexer = (struct csg_lexer){.text = text, .size = size, .at = at, .line = place.line};
    lexer->line_begin = at + 1 - place.column;
    lexer->has_all_digits = csg_digits_are_all(text, size);
}

enum { BLANK = 1, DIGIT = 2, LETTER = 4, MARK = 8 };

/* What a byte can be; 0 for those that mean nothing. */
static const unsigned char classes[256] = {
    [' '] = BLANK,  ['\t'] = BLANK, ['\n'] = BLANK, ['\r'] = BLANK, ['\f'] = BLANK, ['\v'] = BLANK,
    ['0'] = DIGIT,  ['1'] = DIGIT,  ['2'] = DIGIT,  ['3'] = DIGIT,  ['4'] = DIGIT,  ['5'] = DIGIT,
    ['6'] = DIGIT,  ['7'] = DIGIT,  ['8'] = DIGIT,  ['9'] = DIGIT,  ['_'] = LETTER, ['$'] = LETTER,
    ['a'] = LETTER, ['b'] = LETTER, ['c'] = LETTER, ['d'] = LETTER, ['e'] = LETTER, ['f'] = LETTER,
    ['g'] = LETTER, ['h'] = LETTER, ['i'] = LETTER, ['j'] = LETTER, ['k'] = LETTER, ['l'] = LETTER,
    ['m'] = LETTER, ['n'] = LETTER, ['o'] = LETTER, ['p'] = LETTER, ['q'] = LETTER, ['r'] = LETTER,
    ['s'] = LETTER, ['t'] = LETTER, ['u'] = LETTER, ['v'] = LETTER, ['w'] = LETTER, ['x'] = LETTER,
    ['y'] = LETTER, ['z'] = LETTER, ['A'] = LETTER, ['B'] = LETTER, ['C'] = LETTER, ['D'] = LETTER,
    ['E'] = LETTER, ['F'] = LETTER, ['G'] = LETTER, ['H'] = LETTER, ['I'] = LETTER, ['J'] = LETTER,
    ['K'] = LETTER, ['L'] = LETTER, ['M'] = LETTER, ['N'] = LETTER, ['O'] = LETTER, ['P'] = LETTER,
    ['Q'] = LETTER, ['R'] = LETTER, ['S'] = LETTER, ['T'] = LETTER, ['U'] = LETTER, ['V'] = LETTER,
    ['W'] = LETTER, ['X'] = LETTER, ['Y'] = LETTER, ['Z'] = LETTER, ['('] = MARK,   [')'] = MARK,
    ['{'] = MARK,   ['}'] = MARK,   ['['] = MARK,   [']'] = MARK,   [','] = MARK,   [';'] = MARK,
    ['='] = MARK,   ['-'] = MARK,   ['+'] = MARK,   ['%'] = MARK,   ['#'] = MARK,   ['!'] = MARK,
    ['*'] = MARK,
};

static bool is(char c, int class_bits)
{
    return (classes[(unsigned char)c] & class_bits) != 0;
}

static char peek(const struct csg_lexer *lexer, size_t ahead)
{
    return lexer->size - lexer->at > ahead ? lexer->text[lexer->at + ahead] : '\0';
}

static void step_over_line(struct csg_lexer *lexer)
{
    lexer->line++;
    lexer->line_begin = lexer->at;
}

/* Moves to the given byte, counting lines. */
static void move_to(struct csg_lexer *lexer, size_t at)
{
    while (lexer->at < at)
        if (lexer->text[lexer->at++] == '\n')
            step_over_line(lexer);
}

void csg_lexer_skip_line(struct csg_lexer *lexer)
{
    const char *rest = lexer->text + lexer->at;
    const char *end = lexer->at < lexer->size ? memchr(rest, '\n', lexer->size - lexer->at) : NULL;
    lexer->at = end ? (size_t)(end - lexer->text) : lexer->size;
}

/* false: the comment that starts here never ends. */
static bool skip_block_comment(struct csg_lexer *lexer)
{
    size_t at = lexer->at + 2;
    while (at + 1 < lexer->size && !(lexer->text[at] == '*' && lexer->text[at + 1] == '/'))
        at++;
    if (at + 1 >= lexer->size)
        return false;
    move_to(lexer, at + 2);
    return true;
}

/* Skips what stands between tokens; false at a comment that never ends. */
static bool skip_blanks(struct csg_lexer *lexer)
{
    static const char byte_order_mark[] = "\xEF\xBB\xBF";
    if (lexer->at == 0 && lexer->size >= 3 && memcmp(lexer->text, byte_order_mark, 3) == 0)
        lexer->at = 3;
    for (;;) {
        while (lexer->at < lexer->size && is(lexer->text[lexer->at], BLANK))
            if (lexer->text[lexer->at++] == '\n')
                step_over_line(lexer);
        if (peek(lexer, 0) != '/')
            return true;
        if (peek(lexer, 1) == '/')
            csg_lexer_skip_line(lexer);
        else if (peek(lexer, 1) != '*')
            return true;
        else if (!skip_block_comment(lexer))
            return false;
    }
}

static void set_bad(struct csg_token *token, const char *problem)
{
    token->type = CSG_TOKEN_BAD;
    token->problem = problem;
}

static void read_name(struct csg_lexer *lexer, struct csg_token *token)
{
    while (is(peek(lexer, 0), LETTER | DIGIT))
        lexer->at++;
    token->type = CSG_TOKEN_NAME;
    token->length = (size_t)(lexer->text + lexer->at - token->begin);
}

static bool is_exponent_sign(const struct csg_lexer *lexer)
{
    const char before = lexer->text[lexer->at - 1], c = lexer->text[lexer->at];
    return (c == '-' || c == '+') && (before == 'e' || before == 'E');
}

/* Takes all that could be meant as one number, so that 1.2.3 is one error and not two numbers. */
static void read_number(struct csg_lexer *lexer, struct csg_token *token)
{
    lexer->at++;
    while (lexer->at < lexer->size &&
           (is(peek(lexer, 0), DIGIT | LETTER) || peek(lexer, 0) == '.' || is_exponent_sign(lexer)))
        lexer->at++;
    token->length = (size_t)(lexer->text + lexer->at - token->begin);
    token->type = CSG_TOKEN_NUMBER;
    if (!csg_number_read(token->begin, token->length, &token->number))
        set_bad(token, token->length > CSG_NUMBER_LENGTH_MAX
                           ? "a number of more than " TEXT_OF(CSG_NUMBER_LENGTH_MAX) " characters"
                           : "not a number; numbers look like 12, 0.5 or 1e-07");
    if (lexer->has_all_digits)
        token->number.rounding = 0;
    lexer->num_rounded += token->number.rounding > 0;
}

/* The quote that ends the string from byte at on; size when the line or the text ends before. */
static size_t find_quote(const struct csg_lexer *lexer, size_t at)
{
    for (; at < lexer->size && lexer->text[at] != '"'; at++) {
        if (lexer->text[at] == '\\' && at + 1 < lexer->size)
            at++;
        if (lexer->text[at] == '\n')
            return lexer->size;
    }
    return at;
}

/* Whether `name =` or `)` follows the closing quote at `quote`, so that it does end the string. */
static bool ends_argument(const struct csg_lexer *lexer, size_t quote)
{
    struct csg_lexer ahead = *lexer;
    struct csg_token token;
    ahead.at = quote + 1;
    ahead.is_text_node = false;
    if (quote >= lexer->size || !skip_blanks(&ahead))
        return false;
    if (peek(&ahead, 0) == ')')
        return true;
    if (peek(&ahead, 0) != ',')
        return false;
    ahead.at++;
    if (!skip_blanks(&ahead) || !is(peek(&ahead, 0), LETTER))
        return false;
    token.begin = ahead.text + ahead.at;
    read_name(&ahead, &token);
    return skip_blanks(&ahead) && peek(&ahead, 0) == '=';
}

static bool matches_raw_terminator(const struct csg_lexer *lexer, size_t at)
{
    const size_t length = sizeof raw_terminator - 1;
    return lexer->size - at >= length && memcmp(lexer->text + at, raw_terminator, length) == 0;
}

/* The first `", size = ` from byte at on; size when there is none. Remembered, so that many text
 * nodes without one do not make reading quadratic. */
static size_t find_raw_end(struct csg_lexer *lexer, size_t at)
{
    if (lexer->raw_end >= at)
        return lexer->raw_end;
    while (at < lexer->size && !matches_raw_terminator(lexer, at)) {
        const char *quote = memchr(lexer->text + at + 1, '"', lexer->size - at - 1);
        at = quote ? (size_t)(quote - lexer->text) : lexer->size;
    }
    return lexer->raw_end = at;
}

/*
 * OpenSCAD writes the string of text() as it is: quotes, backslashes and newlines in it are not
 * escaped, `", size = ` follows. Anything that reads well as an escaped string is taken as one.
 */
static size_t find_string_end(struct csg_lexer *lexer, size_t at, bool *raw)
{
    const size_t quote = find_quote(lexer, at);
    if (!lexer->is_text_node)
        return quote;
    lexer->is_text_node = false;
    const bool ends = ends_argument(lexer, quote);
    *raw = ends && matches_raw_terminator(lexer, quote);
    if (ends)
        return quote;
    const size_t end = find_raw_end(lexer, at);
    *raw = end < lexer->size;
    return *raw ? end : quote;
}

static void read_string(struct csg_lexer *lexer, struct csg_token *token)
{
    const size_t begin = lexer->at + 1;
    const size_t end = find_string_end(lexer, begin, &token->raw);
    if (end >= lexer->size) {
        csg_lexer_skip_line(lexer);
        set_bad(token, "a string without its closing quote '\"' on the same line");
        return;
    }
    token->type = CSG_TOKEN_STRING;
    token->begin = lexer->text + begin;
    token->length = end - begin;
    move_to(lexer, end + 1);
}

static bool starts_token(char c)
{
    return is(c, BLANK | LETTER | DIGIT | MARK) || c == '"' || c == '/';
}

/* A run of bytes that mean nothing is one token: binary files are not worth a line per byte. */
static void read_garbage(struct csg_lexer *lexer, struct csg_token *token)
{
    lexer->at++;
    while (lexer->at < lexer->size && !starts_token(peek(lexer, 0)))
        lexer->at++;
    token->length = (size_t)(lexer->text + lexer->at - token->begin);
    set_bad(token, "means nothing here");
}

static struct csg_place place_of(const struct csg_lexer *lexer)
{
    const size_t column = lexer->at - lexer->line_begin + 1;
    return (struct csg_place){lexer->line, column < UINT32_MAX ? (uint32_t)column : UINT32_MAX};
}

void csg_lexer_next(struct csg_lexer *lexer, struct csg_token *token)
{
    const bool complete = skip_blanks(lexer);
    const char c = peek(lexer, 0);
    *token = (struct csg_token){.begin = lexer->text + lexer->at, .place = place_of(lexer)};
    if (!complete) {
        lexer->at = lexer->size;
        token->length = 2;
        set_bad(token, "a comment without its closing '*/'");
    } else if (lexer->at >= lexer->size) {
        token->type = CSG_TOKEN_END;
    } else if (is(c, LETTER)) {
        read_name(lexer, token);
    } else if (is(c, DIGIT) || (c == '.' && is(peek(lexer, 1), DIGIT))) {
        read_number(lexer, token);
    } else if (c == '"') {
        token->length = 1;
        read_string(lexer, token);
    } else if (is(c, MARK)) {
        *token = (struct csg_token){CSG_TOKEN_MARK, .mark = c, .begin = token->begin, .length = 1,
                                    .place = token->place};
        lexer->at++;
    } else {
        read_garbage(lexer, token);
    }
}

const char *csg_token_describe(const struct csg_token *token, char buffer[64])
{
    const size_t shown = token->length < shown_length ? token->length : shown_length;
    const char *dots = token->length > shown ? "..." : "";
    bool printable = true;
    for (size_t i = 0; i < shown; i++)
        printable &= token->begin[i] >= ' ' && token->begin[i] <= '~';
    if (token->type == CSG_TOKEN_END)
        snprintf(buffer, 64, "the end of the text");
    else if (token->type == CSG_TOKEN_STRING)
        snprintf(buffer, 64, "a string");
    else if (printable)
        snprintf(buffer, 64, "'%.*s%s'", (int)shown, token->begin, dots);
    else
        snprintf(buffer, 64, "byte 0x%02X", (unsigned)(unsigned char)token->begin[0]);
    return buffer;
}
