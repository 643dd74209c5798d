/* SPDX-License-Identifier: MIT */
#ifndef CSG_RENDER_PROGRAMS_H
#define CSG_RENDER_PROGRAMS_H

/* Compiled shader programs, kept by their text for the life of a renderer. */

#include "gl/context.h"
#include "shader/source.h"

struct csg_compiled {
    GLuint id;
    char *fragment; /* the key: its assembled text */
};

struct csg_programs {
    struct csg_gl *gl;
    CSG_ARRAY(struct csg_compiled) compiled;
    double compile_ms; /* in total */
};

/* The program of a geometry pass; takes ownership of fragment. 0, with a message, on failure. */
GLuint csg_programs_geometry(struct csg_programs *programs, char *fragment);

/* The program of the shading pass. */
GLuint csg_programs_shade(struct csg_programs *programs);

/* The context must be current. */
void csg_programs_finish(struct csg_programs *programs);

#endif
