/* SPDX-License-Identifier: MIT */
#include "solids/checked.h"

bool csg_checked_number(const struct csg_args *args, const char *name, double *number,
                        double *rounding)
{
    if (!csg_args_find(args, name))
        return true;
    const double found = csg_args_number(args, name, NAN, rounding);
    if (!isfinite(found)) {
        csg_args_error(args, "%s must be a finite number", name);
        return false;
    }
    *number = found;
    return true;
}

bool csg_checked_positive(const struct csg_args *args, const char *name, double *number,
                          double *rounding)
{
    double found = 1;
    if (!csg_checked_number(args, name, &found, rounding))
        return false;
    if (!(found > 0)) {
        csg_args_error(args, "%s is %g, but must be above 0", name, found);
        return false;
    }
    if (csg_args_find(args, name))
        *number = found;
    return true;
}

bool csg_checked_vector(const struct csg_args *args, const char *name, size_t num, double *numbers,
                        double *rounding)
{
    const struct csg_value *value = csg_args_find(args, name);
    double found[3];
    if (!value)
        return true;
    bool ok = csg_value_numbers(value, num, found, rounding);
    for (size_t i = 0; ok && i < num; i++)
        ok = isfinite(found[i]);
    if (!ok) {
        csg_args_error(args, "%s must be a vector of %d finite numbers", name, (int)num);
        return false;
    }
    for (size_t i = 0; i < num; i++)
        numbers[i] = found[i];
    return true;
}

bool csg_checked_lengths(const struct csg_args *args, const char *name, size_t num, double *lengths,
                         double *rounding)
{
    const struct csg_value *value = csg_args_find(args, name);
    if (value && value->type == CSG_VALUE_NUMBER) {
        double all = 1;
        const bool ok = csg_checked_positive(args, name, &all, rounding);
        for (size_t i = 0; ok && i < num; i++)
            lengths[i] = all;
        return ok;
    }
    if (!csg_checked_vector(args, name, num, lengths, rounding))
        return false;
    for (size_t i = 0; value && i < num; i++)
        if (!(lengths[i] > 0)) {
            csg_args_error(args, "%s[%d] is %g, but must be above 0", name, (int)i, lengths[i]);
            return false;
        }
    return true;
}
