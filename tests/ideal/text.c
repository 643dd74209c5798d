/* SPDX-License-Identifier: MIT */
#include "text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/random.h"

static void make_room(struct text *text, size_t length)
{
    if (text->num + length + 1 <= text->capacity)
        return;
    text->capacity = 2 * (text->num + length + 1);
    text->data = realloc(text->data, text->capacity);
    if (!text->data)
        abort();
}

void text_put(struct text *text, const char *format, ...)
{
    va_list args, again;
    va_start(args, format);
    va_copy(again, args);
    const int length = vsnprintf(NULL, 0, format, args);
    make_room(text, (size_t)length);
    vsnprintf(text->data + text->num, (size_t)length + 1, format, again);
    text->num += (size_t)length;
    va_end(again);
    va_end(args);
}

void text_free(struct text *text)
{
    free(text->data);
    memset(text, 0, sizeof *text);
}

void text_number(struct text *text, double value, enum text_digits digits)
{
    text_put(text, digits == TEXT_SIX ? "%.6g" : "%.17g", value);
}

void text_vector(struct text *text, double x, double y, double z, enum text_digits digits)
{
    const double v[3] = {x, y, z};
    for (int i = 0; i < 3; i++) {
        text_put(text, i ? ", " : "[");
        text_number(text, v[i], digits);
    }
    text_put(text, "]");
}

double dice_between(struct dice *dice, double lo, double hi)
{
    return csg_random_between(&dice->state, lo, hi);
}

int dice_pick(struct dice *dice, int num)
{
    return (int)(csg_random(&dice->state) % (uint64_t)num);
}
