/* SPDX-License-Identifier: MIT */
#ifndef CSG_SHADER_FILES_H
#define CSG_SHADER_FILES_H

/* The GLSL files of shaders/, built into the library by cmake/embed.cmake, sorted by name. */

#include <stddef.h>

struct csg_shader_file {
    const char *name; /* relative to shaders/, e.g. "csg/resolve.glsl" */
    const char *text; /* zero-terminated */
};

extern const struct csg_shader_file csg_shader_files[]; /* a row of NULLs after the last */
extern const size_t csg_num_shader_files;

#endif
