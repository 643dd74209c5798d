/* SPDX-License-Identifier: MIT */
#include "render/programs.h"

#include <stdlib.h>
#include <string.h>

#include "common/clock.h"

#define SHADE_KEY "shade"

/* A compiler's message refers to lines of a text that no file has: show that text. */
static void report(const struct csg_gl *gl, const char *what, const char *log, const char *source)
{
    csg_log_error(&gl->log, CSGCAST_MESSAGE_SHADER, "%s: %s", what, log);
    if (!getenv("CSGCAST_DEBUG") || !source)
        return;
    int line = 1;
    for (const char *at = source; *at; line++) {
        const size_t length = strcspn(at, "\n");
        csg_log_print(&gl->log, CSGCAST_LOG_INFO, CSGCAST_MESSAGE_SHADER, "%4d  %.*s", line,
                      (int)length, at);
        at += length + (at[length] != 0);
    }
}

static GLuint compile(const struct csg_gl *gl, GLenum stage, const char *source)
{
    const GLuint shader = gl->CreateShader(stage);
    GLint ok = 0;
    gl->ShaderSource(shader, 1, &source, NULL);
    gl->CompileShader(shader);
    gl->GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (ok)
        return shader;
    char log[2048] = "";
    gl->GetShaderInfoLog(shader, sizeof log, NULL, log);
    report(gl, "the driver rejects a shader", log, source);
    gl->DeleteShader(shader);
    return 0;
}

static GLuint link_program(const struct csg_gl *gl, const char *vertex, const char *fragment)
{
    const GLuint v = compile(gl, GL_VERTEX_SHADER, vertex);
    const GLuint f = v ? compile(gl, GL_FRAGMENT_SHADER, fragment) : 0;
    GLuint program = 0;
    if (f) {
        GLint ok = 0;
        program = gl->CreateProgram();
        gl->AttachShader(program, v);
        gl->AttachShader(program, f);
        gl->LinkProgram(program);
        gl->GetProgramiv(program, GL_LINK_STATUS, &ok);
        if (!ok) {
            char log[2048] = "";
            gl->GetProgramInfoLog(program, sizeof log, NULL, log);
            report(gl, "the driver cannot link a program", log, fragment);
            gl->DeleteProgram(program);
            program = 0;
        }
    }
    gl->DeleteShader(f);
    gl->DeleteShader(v);
    return program;
}

static GLuint find(const struct csg_programs *programs, const char *key)
{
    for (size_t i = 0; i < programs->compiled.num; i++)
        if (strcmp(programs->compiled.data[i].fragment, key) == 0)
            return programs->compiled.data[i].id;
    return 0;
}

static GLuint keep(struct csg_programs *programs, GLuint id, char *key)
{
    if (id && csg_array_push(&programs->compiled, ((struct csg_compiled){id, key})))
        return id;
    if (id)
        csg_log_memory(&programs->gl->log);
    programs->gl->DeleteProgram(id);
    free(key);
    return 0;
}

GLuint csg_programs_geometry(struct csg_programs *programs, char *fragment)
{
    static const char *const vertex_files[] = {"passes/geometry.vert.glsl", NULL};
    if (!fragment) {
        csg_log_memory(&programs->gl->log);
        return 0;
    }
    const GLuint known = find(programs, fragment);
    if (known) {
        free(fragment);
        return known;
    }
    const double start = csg_clock_ms();
    char *vertex = csg_source_stage(vertex_files);
    const GLuint id = vertex ? link_program(programs->gl, vertex, fragment) : 0;
    free(vertex);
    programs->compile_ms += csg_clock_ms() - start;
    return keep(programs, id, fragment);
}

GLuint csg_programs_shade(struct csg_programs *programs)
{
    static const char *const vertex_files[] = {"passes/shade.vert.glsl", NULL};
    static const char *const fragment_files[] = {"common/data.glsl",     "common/screen.glsl",
                                                 "solids/planes.glsl",   "solids/quadric.glsl",
                                                 "passes/shade.frag.glsl", NULL};
    const GLuint known = find(programs, SHADE_KEY);
    if (known)
        return known;
    const double start = csg_clock_ms();
    char *vertex = csg_source_stage(vertex_files), *fragment = csg_source_stage(fragment_files);
    char *key = malloc(sizeof SHADE_KEY);
    GLuint id = 0;
    if (vertex && fragment && key) {
        memcpy(key, SHADE_KEY, sizeof SHADE_KEY);
        id = link_program(programs->gl, vertex, fragment);
    } else {
        csg_log_memory(&programs->gl->log);
    }
    free(vertex);
    free(fragment);
    programs->compile_ms += csg_clock_ms() - start;
    return keep(programs, id, key);
}

void csg_programs_finish(struct csg_programs *programs)
{
    for (size_t i = 0; i < programs->compiled.num; i++) {
        programs->gl->DeleteProgram(programs->compiled.data[i].id);
        free(programs->compiled.data[i].fragment);
    }
    free(programs->compiled.data);
}
