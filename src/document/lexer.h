/* SPDX-License-Identifier: MIT */
#ifndef CSG_DOCUMENT_LEXER_H
#define CSG_DOCUMENT_LEXER_H

/* From bytes to tokens. Any bytes will do: what is no token becomes a CSG_TOKEN_BAD. */

#include <stdbool.h>
#include <stddef.h>

#include "common/number.h"
#include "document/report.h"

enum csg_token_type {
    CSG_TOKEN_END, /* of the text */
    CSG_TOKEN_NAME,
    CSG_TOKEN_NUMBER, /* without a sign */
    CSG_TOKEN_STRING,
    CSG_TOKEN_MARK, /* one character: ( ) { } [ ] , ; = - + % # ! * */
    CSG_TOKEN_BAD,
};

struct csg_token {
    enum csg_token_type type;
    char mark;         /* MARK: the character; else 0 */
    bool raw;          /* STRING: stands for itself, without escapes */
    const char *begin; /* first byte; STRING: behind the quote */
    size_t length;     /* bytes; STRING: between the quotes */
    struct csg_place place;
    struct csg_number number; /* NUMBER */
    const char *problem;      /* BAD: what is wrong with it, static */
};

struct csg_lexer {
    const char *text;
    size_t size;
    size_t at;         /* the next byte */
    size_t line_begin; /* of the current line */
    uint32_t line;
    bool is_text_node;   /* the next string may be one that OpenSCAD wrote without escapes */
    size_t raw_end;      /* end of the next such string, once looked for */
    bool has_all_digits; /* numbers are as they stand, see document/digits.h */
    size_t num_rounded;  /* numbers so far that may be rounded */
};

/* Starts at byte at, which is at the given place. text is borrowed. */
void csg_lexer_init(struct csg_lexer *lexer, const char *text, size_t size, size_t at,
                    struct csg_place place);

void csg_lexer_next(struct csg_lexer *lexer, struct csg_token *token);

/* Skips to the end of the line. */
void csg_lexer_skip_line(struct csg_lexer *lexer);

/* "'cube'", "the end of the text", ...: for messages. Returns buffer. */
const char *csg_token_describe(const struct csg_token *token, char buffer[64]);

#endif
