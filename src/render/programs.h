/* SPDX-License-Identifier: MIT */
#ifndef CSG_RENDER_PROGRAMS_H
#define CSG_RENDER_PROGRAMS_H

/* Compiled shader programs, kept by their text: for the life of a renderer, but those of single
 * structures, of which every scene has others. */

#include "gl/context.h"
#include "shader/source.h"

/* Where a program's uniforms are; -1: it has no such. */
struct csg_uniforms {
    GLint data, cells, owners, window, at, screen_depth, screen_key, depth_bias, visible, light;
};

struct csg_compiled {
    GLuint id;
    struct csg_uniforms uniforms;
    uint64_t round;           /* in which its uniforms were set */
    uint32_t name;            /* of csg_programs_note; 0: none */
    uint64_t asked;           /* the last frame of csg_programs_note_straight; 0: none */
    struct csg_stages stages; /* the key */
};

struct csg_programs {
    struct csg_gl *gl;
    CSG_ARRAY(struct csg_compiled) compiled;
    size_t num_compiled; /* so far, those that are gone included */
    double compile_ms;   /* in total */
    uint64_t round;      /* counts the rounds that set uniforms anew */
    uint64_t frame;      /* counts frames */
};

/* Begins a frame: of programs of a structure it deletes what was not asked for longest, if they
 * are many, as each holds some MB of llvmpipe's. */
void csg_programs_begin(struct csg_programs *programs);

/* The program of these stages, which it takes ownership of. 0, with a message, on failure. */
GLuint csg_programs_get(struct csg_programs *programs, struct csg_stages stages);

/* The same where there is such a program; 0: there is none, and none is compiled. */
GLuint csg_programs_known(const struct csg_programs *programs, struct csg_stages stages);

/* A program that has been noted under that name, whose text need not be made again; 0: none. */
GLuint csg_programs_noted(const struct csg_programs *programs, uint32_t name);

/* The same, or one whose name has bits of more besides. */
GLuint csg_programs_noted_above(const struct csg_programs *programs, uint32_t name, uint32_t more);

/* Notes a program. name: not 0, and the same for the same text only. */
void csg_programs_note(struct csg_programs *programs, GLuint id, uint32_t name);

/* Notes that this frame has asked for the program, that of a structure. */
void csg_programs_note_straight(struct csg_programs *programs, GLuint id);

/* The record of one of its programs, until the next one is compiled. */
struct csg_compiled *csg_programs_find(struct csg_programs *programs, GLuint id);

/* The context must be current. */
void csg_programs_finish(struct csg_programs *programs);

#endif
