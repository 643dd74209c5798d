/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_SPELLING_H
#define CSG_COMMON_SPELLING_H

#include <stddef.h>

/* How many letters of a word to insert, delete or change to get another one, upper and lower case
 * alike (Levenshtein's distance); a large number where one of them is too long to be a slip. */
size_t csg_spelling_distance(const char *a, size_t a_length, const char *b, size_t b_length);

#endif
