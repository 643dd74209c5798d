/* SPDX-License-Identifier: MIT */
#include "values.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Longer words than this are no typing errors of ours. */
#define MAX_WORD 64

bool csg_value_int(const char *text, int *value)
{
    char *end;
    errno = 0;
    const long number = strtol(text, &end, 10);
    if (end == text || *end || errno || number < INT_MIN || number > INT_MAX)
        return false;
    *value = (int)number;
    return true;
}

bool csg_value_double(const char *text, double *value)
{
    return csg_value_list(text, value, 1) == 1;
}

size_t csg_value_list(const char *text, double *values, size_t max)
{
    for (size_t num = 0; num < max;) {
        char *end;
        values[num] = strtod(text, &end);
        if (end == text || !isfinite(values[num]))
            return 0;
        num++;
        if (!*end)
            return num;
        if (*end != ',')
            return 0;
        text = end + 1;
    }
    return 0;
}

bool csg_value_enum(const char *text, const struct csg_value_name *names, int *value)
{
    for (; names->name; names++) {
        if (!strcmp(text, names->name)) {
            *value = names->value;
            return true;
        }
    }
    return false;
}

static size_t smallest(size_t a, size_t b, size_t c)
{
    const size_t least = a < b ? a : b;
    return least < c ? least : c;
}

/* Levenshtein's table, one row at a time. */
size_t csg_value_distance(const char *a, const char *b)
{
    const size_t a_length = strlen(a), b_length = strlen(b);
    size_t row[MAX_WORD + 1];
    if (a_length > MAX_WORD || b_length > MAX_WORD)
        return MAX_WORD + 1;
    for (size_t j = 0; j <= b_length; j++)
        row[j] = j;
    for (size_t i = 0; i < a_length; i++) {
        size_t diagonal = row[0];
        row[0] = i + 1;
        for (size_t j = 0; j < b_length; j++) {
            const size_t above = row[j + 1];
            row[j + 1] = smallest(above + 1, row[j] + 1, diagonal + (a[i] != b[j]));
            diagonal = above;
        }
    }
    return row[b_length];
}
