/* SPDX-License-Identifier: MIT */
#include "solids/value.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "solids/solid.h"

/* The place of name in the positional order "h r1 r2 center"; SIZE_MAX when it has none. */
static size_t position_of(const char *parameters, const char *name)
{
    const size_t length = strlen(name);
    size_t position = 0;
    for (const char *word = parameters ? parameters : ""; *word; position++) {
        const size_t word_length = strcspn(word, " ");
        if (word_length == length && memcmp(word, name, length) == 0)
            return position;
        word += word_length;
        word += strspn(word, " ");
    }
    return SIZE_MAX;
}

/* As in OpenSCAD the last argument for a parameter wins, and unnamed ones count by themselves. */
const struct csg_value *csg_args_find(const struct csg_args *args, const char *name)
{
    const size_t position = position_of(args->parameters, name);
    const struct csg_value *found = NULL;
    size_t num_positional = 0;
    for (size_t i = 0; i < args->num; i++) {
        const struct csg_arg *arg = &args->args[i];
        if (arg->name ? strcmp(arg->name, name) == 0 : num_positional++ == position)
            found = &arg->value;
    }
    return found && found->type != CSG_VALUE_UNDEF ? found : NULL;
}

double csg_args_number(const struct csg_args *args, const char *name, double fallback,
                       double *rounding)
{
    const struct csg_value *value = csg_args_find(args, name);
    if (!value || value->type != CSG_VALUE_NUMBER)
        return fallback;
    if (rounding)
        *rounding += (double)value->rounding;
    return value->number;
}

/* OpenSCAD lets any value stand for a truth value; here only numbers do beside true and false. */
bool csg_args_bool(const struct csg_args *args, const char *name)
{
    const struct csg_value *value = csg_args_find(args, name);
    if (value && value->type == CSG_VALUE_BOOL)
        return value->boolean;
    if (value && value->type == CSG_VALUE_NUMBER)
        return value->number != 0;
    return false;
}

bool csg_value_numbers(const struct csg_value *value, size_t num, double *numbers, double *rounding)
{
    if (!value || value->type != CSG_VALUE_VECTOR || value->num != num)
        return false;
    for (size_t i = 0; i < num; i++)
        if (value->items[i].type != CSG_VALUE_NUMBER)
            return false;
    for (size_t i = 0; i < num; i++) {
        numbers[i] = value->items[i].number;
        if (rounding)
            *rounding += (double)value->items[i].rounding;
    }
    return true;
}

int csg_args_error(const struct csg_args *args, const char *format, ...)
{
    char small[CSG_LOG_SMALL];
    va_list list;
    va_start(list, format);
    char *large = csg_log_format(small, format, list);
    va_end(list);
    csg_log_error(args->log, CSGCAST_MESSAGE_SCENE, "%s:%u:%u: %s: %s", args->file,
                  (unsigned)args->line, (unsigned)args->column, args->node, large ? large : small);
    free(large);
    return CSG_READ_ERROR;
}
