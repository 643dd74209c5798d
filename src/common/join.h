/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMMON_JOIN_H
#define CSG_COMMON_JOIN_H

/* One text after the other, for the caller to free. NULL: out of memory. */
char *csg_join(const char *a, const char *b);
char *csg_join_three(const char *a, const char *b, const char *c);

#endif
