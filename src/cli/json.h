/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_JSON_H
#define CSG_CLI_JSON_H

/* Printing flat JSON: members of one object after the other, commas put where they belong. */

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

struct csg_json {
    FILE *file;
    int depth;
    bool first; /* nothing printed in the current object yet */
};

/* key NULL: the outermost object. */
void csg_json_open(struct csg_json *json, const char *key);
void csg_json_close(struct csg_json *json);

void csg_json_string(struct csg_json *json, const char *key, const char *value);
void csg_json_size(struct csg_json *json, const char *key, size_t value);

/* A list; what is put into it has the key NULL. */
void csg_json_list_open(struct csg_json *json, const char *key);
void csg_json_list_close(struct csg_json *json);

void csg_json_bool(struct csg_json *json, const char *key, bool value);

/* An infinite number and NaN, which JSON lacks, become null. */
void csg_json_number(struct csg_json *json, const char *key, double value);

/* Three numbers; an infinite one, which JSON lacks, becomes null. */
void csg_json_vector(struct csg_json *json, const char *key, const double value[3]);

#endif
