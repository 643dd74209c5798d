/* SPDX-License-Identifier: MIT */
#define _GNU_SOURCE /* RTLD_NEXT */

/*
 * Preloaded, makes the driver one that is not llvmpipe and allows no more than OpenGL 3.3 asks for:
 * points of one pixel, no base instance, small textures, and so many components between the stages. A
 * vertex stage with more of them does not compile.
 */

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <EGL/egl.h>
#include <GL/glcorearb.h>

enum { MAX_COMPONENTS = 60, MAX_TEXELS = 65536, MAX_SIZE = 1024, MAX_NAMES = 64 };

typedef void (*proc)(void);

static PFNGLGETSTRINGPROC get_string;
static PFNGLGETINTEGERVPROC get_integers;
static PFNGLGETFLOATVPROC get_floats;
static PFNGLSHADERSOURCEPROC set_source;
static proc (*get_proc)(const char *name);

static const GLubyte *narrow_string(GLenum name)
{
    return name == GL_RENDERER ? (const GLubyte *)"narrow" : get_string(name);
}

static void narrow_integers(GLenum name, GLint *value)
{
    get_integers(name, value);
    if (name == GL_MAX_VARYING_COMPONENTS)
        *value = MAX_COMPONENTS;
    if (name == GL_MAX_TEXTURE_BUFFER_SIZE)
        *value = MAX_TEXELS;
    if (name == GL_MAX_RECTANGLE_TEXTURE_SIZE || name == GL_MAX_RENDERBUFFER_SIZE)
        *value = MAX_SIZE;
}

static void narrow_floats(GLenum name, GLfloat *value)
{
    get_floats(name, value);
    if (name == GL_POINT_SIZE_RANGE)
        value[1] = 1;
}

/* The number that a text stands for: digits, or what #define says. */
static int value_of(const char *source, const char *text, size_t length)
{
    char define[128];
    if (*text >= '0' && *text <= '9')
        return atoi(text);
    snprintf(define, sizeof define, "#define %.*s ", (int)length, text);
    const char *at = strstr(source, define);
    return at ? value_of(source, at + strlen(define), strcspn(at + strlen(define), " \n/")) : 0;
}

/* Components of all outputs; of those that are declared twice, for two cases, once. */
static int count_outputs(const char *source)
{
    static const char word[] = "flat out ";
    const char *names[MAX_NAMES];
    int num = 0, sum = 0;
    for (const char *at = source; num < MAX_NAMES && (at = strstr(at, word)); num++) {
        at += sizeof word - 1;
        const size_t type = strcspn(at, " ");
        names[num] = at + type;
        const size_t length = strcspn(names[num], ";[");
        int known = 0;
        for (int i = 0; i < num; i++)
            known |= strncmp(names[i], names[num], length + 1) == 0;
        const char *many = names[num] + length;
        const int times = *many == '[' ? value_of(source, many + 1, strcspn(many + 1, "]")) : 1;
        const char size = at[type - 1];
        sum += known ? 0 : times * (size >= '2' && size <= '4' ? size - '0' : 1);
    }
    return sum;
}

static void narrow_source(GLuint shader, GLsizei num, const GLchar *const *texts,
                          const GLint *lengths)
{
    static const GLchar *const refused = "#error more outputs than this driver allows\n";
    const int count = num == 1 ? count_outputs(texts[0]) : 0;
    if (count > MAX_COMPONENTS)
        set_source(shader, 1, &refused, NULL);
    else
        set_source(shader, num, texts, lengths);
}

static proc narrow_proc(const char *name)
{
    const proc found = get_proc(name);
#define NARROW(gl_name, real, own)                                                                 \
    if (!strcmp(name, gl_name)) {                                                                  \
        memcpy(&real, &found, sizeof real);                                                        \
        return (proc)own;                                                                          \
    }
    if (!strcmp(name, "glDrawArraysInstancedBaseInstance"))
        return NULL;
    NARROW("glGetString", get_string, narrow_string)
    NARROW("glGetIntegerv", get_integers, narrow_integers)
    NARROW("glGetFloatv", get_floats, narrow_floats)
    NARROW("glShaderSource", set_source, narrow_source)
#undef NARROW
    return found;
}

/* EGL is loaded at run time, so what it is asked for comes by here. */
__attribute__((visibility("default"))) void *dlsym(void *library, const char *name)
{
    static void *(*find)(void *, const char *);
    if (!find) {
        void *const real = dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.2.5");
        memcpy(&find, &real, sizeof find);
    }
    void *found = find(library, name);
    if (found && !strcmp(name, "eglGetProcAddress")) {
        proc (*const own)(const char *) = narrow_proc;
        memcpy(&get_proc, &found, sizeof get_proc);
        memcpy(&found, &own, sizeof found);
    }
    return found;
}
