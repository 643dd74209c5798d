/* SPDX-License-Identifier: MIT */
#include "instrument_options.h"

#include "values.h"

#include <math.h>

const struct csg_compare_options csg_compare_defaults = {
    .limits = {.wrong = 1e-4, .depth = INFINITY, .depth_p99 = INFINITY, .normal_p99 = INFINITY}};

static const char *set_number(const char *value, double max, double *number, const char *expected)
{
    return csg_value_double(value, number) && *number >= 0 && *number <= max ? NULL : expected;
}

const char *csg_set_mesh(struct csg_cli_options *options, const char *value)
{
    options->compare.mesh = value;
    return *value ? NULL : "a file name";
}

const char *csg_set_side_by_side(struct csg_cli_options *options, const char *value)
{
    options->compare.side_by_side = value;
    return *value ? NULL : "a file name";
}

const char *csg_set_difference(struct csg_cli_options *options, const char *value)
{
    options->compare.difference = value;
    return *value ? NULL : "a file name";
}

const char *csg_set_sagitta(struct csg_cli_options *options, const char *value)
{
    return set_number(value, INFINITY, &options->compare.sagitta, "a length, 0 or more");
}

const char *csg_set_max_wrong(struct csg_cli_options *options, const char *value)
{
    return set_number(value, 1, &options->compare.limits.wrong, "a number from 0 to 1");
}

const char *csg_set_min_iou(struct csg_cli_options *options, const char *value)
{
    return set_number(value, 1, &options->compare.limits.iou, "a number from 0 to 1");
}

const char *csg_set_max_depth(struct csg_cli_options *options, const char *value)
{
    return set_number(value, INFINITY, &options->compare.limits.depth, "a length, 0 or more");
}

const char *csg_set_max_depth_p99(struct csg_cli_options *options, const char *value)
{
    return set_number(value, INFINITY, &options->compare.limits.depth_p99, "a length, 0 or more");
}

const char *csg_set_max_normal_p99(struct csg_cli_options *options, const char *value)
{
    return set_number(value, 180, &options->compare.limits.normal_p99, "degrees from 0 to 180");
}

const char *csg_set_limit(struct csg_cli_options *options, const char *value)
{
    if (!csg_value_double(value, &options->report.limit) || !(options->report.limit > 0))
        return "seconds above 0";
    options->compare.limit = options->report.limit;
    return NULL;
}

const char *csg_set_wasm(struct csg_cli_options *options, const char *value)
{
    options->report.wasm = value;
    return *value ? NULL : "a folder";
}
