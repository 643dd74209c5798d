/* SPDX-License-Identifier: MIT */
#ifndef CSG_RENDER_PROGRAMS_H
#define CSG_RENDER_PROGRAMS_H

/* Compiled shader programs, kept by their text for the life of a renderer. */

#include "gl/context.h"
#include "shader/source.h"

struct csg_compiled {
    GLuint id;
    struct csg_stages stages; /* the key */
};

struct csg_programs {
    struct csg_gl *gl;
    CSG_ARRAY(struct csg_compiled) compiled;
    double compile_ms; /* in total */
};

/* The program of these stages, which it takes ownership of. 0, with a message, on failure. */
GLuint csg_programs_get(struct csg_programs *programs, struct csg_stages stages);

/* The context must be current. */
void csg_programs_finish(struct csg_programs *programs);

#endif
