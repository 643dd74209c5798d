/* SPDX-License-Identifier: MIT */
#ifndef CSG_OPENSCAD_PLAIN_TEXT_H
#define CSG_OPENSCAD_PLAIN_TEXT_H

#include "common/file.h"

/* Whether the file's bytes can be a scene's text. Where they hold a zero, which no text does, false
 * and an error that says what the file seems to be: openscad takes what is before it for all, and
 * says nothing. */
bool csg_plain_text_check(const char *path, const struct csg_bytes *bytes,
                          const struct csg_log *log);

#endif
