/* SPDX-License-Identifier: MIT */
#include "document/plain.h"

#include <string.h>

/* A number with fewer or more digits that count is not rounded, see csg_number_read. */
enum { MIN_ROUNDED = 5, MAX_ROUNDED = 6 };

/* Longer ones are read. */
enum { MAX_PLAIN = 64 };

struct skipper {
    struct csg_lexer at; /* of which only place, lines and rounded numbers change */
    const char *c, *end;
};

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$';
}

/* The next character that is no blank; 0 at the end of the text, which is not plain. */
static char next(struct skipper *skipper)
{
    for (; skipper->c < skipper->end; skipper->c++) {
        const char c = *skipper->c;
        if (c == '\n') {
            skipper->at.line++;
            skipper->at.line_begin = (size_t)(skipper->c + 1 - skipper->at.text);
        } else if (c != ' ' && c != '\t' && c != '\r' && c != '\f' && c != '\v') {
            return c;
        }
    }
    return '\0';
}

static bool take(struct skipper *skipper, char mark)
{
    const bool is_there = next(skipper) == mark;
    skipper->c += is_there;
    return is_there;
}

/* All that could be meant as one number, as the lexer takes it. */
static const char *number_end(const struct skipper *skipper)
{
    const char *c = skipper->c + 1;
    while (c < skipper->end && (is_digit(*c) || is_letter(*c) || *c == '.' ||
                                ((*c == '-' || *c == '+') && (c[-1] == 'e' || c[-1] == 'E'))))
        c++;
    return c;
}

static bool skip_read_number(struct skipper *skipper, const char *end)
{
    struct csg_number number;
    if (!csg_number_read(skipper->c, (size_t)(end - skipper->c), &number))
        return false;
    skipper->at.num_rounded += !skipper->at.has_all_digits && number.rounding > 0;
    skipper->c = end;
    return true;
}

/* Numbers without an exponent are only looked at, unless their digits may be rounded. */
static bool skip_number(struct skipper *skipper)
{
    const char *c = skipper->c, *first = NULL, *last = NULL, *point = NULL;
    for (; c < skipper->end && (is_digit(*c) || (*c == '.' && !point)); c++) {
        if (*c == '.') {
            point = c;
        } else if (*c != '0') {
            first = first ? first : c;
            last = c;
        }
    }
    const bool is_number = c - skipper->c > (point != NULL) && c - skipper->c <= MAX_PLAIN;
    const bool has_more = c < skipper->end && (is_letter(*c) || *c == '.');
    const long num_digits = first ? last - first + 1 - (point && point > first && point < last) : 0;
    if (!is_number || has_more ||
        (num_digits >= MIN_ROUNDED && num_digits <= MAX_ROUNDED && !skipper->at.has_all_digits))
        return is_number && skip_read_number(skipper, number_end(skipper));
    skipper->c = c;
    return true;
}

static bool take_word(struct skipper *skipper, const char *word, size_t length)
{
    const bool is_there =
        (size_t)(skipper->end - skipper->c) >= length && memcmp(skipper->c, word, length) == 0;
    skipper->c += is_there ? length : 0;
    return is_there;
}

static size_t name_length(const struct skipper *skipper)
{
    const char *c = skipper->c;
    while (c < skipper->end && (is_letter(*c) || is_digit(*c)))
        c++;
    return (size_t)(c - skipper->c);
}

static bool skip_constant(struct skipper *skipper, bool is_signed)
{
    const size_t length = name_length(skipper);
    if (length == 3)
        return take_word(skipper, "inf", 3) || take_word(skipper, "nan", 3);
    return !is_signed &&
           ((length == 4 && take_word(skipper, "true", 4)) ||
            (length == 5 && (take_word(skipper, "false", 5) || take_word(skipper, "undef", 5))));
}

static bool skip_scalar(struct skipper *skipper)
{
    bool is_signed = false;
    char c = next(skipper);
    for (; c == '-' || c == '+'; c = next(skipper)) {
        skipper->c++;
        is_signed = true;
    }
    return is_digit(c) || c == '.' ? skip_number(skipper) : skip_constant(skipper, is_signed);
}

/* Closes the vectors that end here and steps over the ',' in front of the next item. */
static bool skip_between_items(struct skipper *skipper, size_t *depth)
{
    while (*depth > 0) {
        const bool has_comma = take(skipper, ',');
        if (take(skipper, ']'))
            --*depth;
        else
            return has_comma;
    }
    return true;
}

static bool skip_value(struct skipper *skipper)
{
    size_t depth = 0;
    do {
        while (take(skipper, '['))
            depth++;
        if ((depth == 0 || next(skipper) != ']') && !skip_scalar(skipper))
            return false;
        if (!skip_between_items(skipper, &depth))
            return false;
    } while (depth > 0);
    return true;
}

/* "r =" in front of a value; what else begins with a letter is a value. */
static void skip_name(struct skipper *skipper)
{
    if (!is_letter(next(skipper)))
        return;
    struct skipper ahead = *skipper;
    ahead.c += name_length(&ahead);
    if (take(&ahead, '='))
        *skipper = ahead;
}

bool csg_plain_skip(struct csg_lexer *lexer)
{
    struct skipper skipper = {*lexer, lexer->text + lexer->at, lexer->text + lexer->size};
    if (!take(&skipper, '('))
        return false;
    while (!take(&skipper, ')')) {
        skip_name(&skipper);
        if (!skip_value(&skipper) || (!take(&skipper, ',') && next(&skipper) != ')'))
            return false;
    }
    *lexer = skipper.at;
    lexer->at = (size_t)(skipper.c - lexer->text);
    return true;
}
