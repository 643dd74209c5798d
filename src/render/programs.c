/* SPDX-License-Identifier: MIT */
#include "render/programs.h"

#include <stdlib.h>
#include <string.h>

#include "common/clock.h"
#include "csg/structure.h"

/* So many programs of structures are kept: of the scenes of some viewports. */
#define MAX_STRAIGHT (4 * (size_t)CSG_MAX_STRAIGHT_PROGRAMS)

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

static void free_stages(struct csg_stages *stages)
{
    free(stages->vertex);
    free(stages->fragment);
}

static GLuint find(const struct csg_programs *programs, const struct csg_stages *key)
{
    for (size_t i = 0; i < programs->compiled.num; i++) {
        const struct csg_compiled *compiled = &programs->compiled.data[i];
        if (strcmp(compiled->stages.fragment, key->fragment) == 0 &&
            strcmp(compiled->stages.vertex, key->vertex) == 0)
            return compiled->id;
    }
    return 0;
}

static struct csg_uniforms find_uniforms(const struct csg_gl *gl, GLuint id)
{
    return (struct csg_uniforms){
        .data = gl->GetUniformLocation(id, "csg_data"),
        .cells = gl->GetUniformLocation(id, "csg_cells"),
        .owners = gl->GetUniformLocation(id, "csg_owners"),
        .window = gl->GetUniformLocation(id, "csg_window"),
        .at = gl->GetUniformLocation(id, "csg_at"),
        .screen_depth = gl->GetUniformLocation(id, "csg_view_depth"),
        .screen_key = gl->GetUniformLocation(id, "csg_view_key"),
        .depth_bias = gl->GetUniformLocation(id, "csg_depth_bias"),
        .visible = gl->GetUniformLocation(id, "csg_visible"),
        .light = gl->GetUniformLocation(id, "csg_light"),
    };
}

struct csg_compiled *csg_programs_find(struct csg_programs *programs, GLuint id)
{
    size_t i = 0;
    while (i + 1 < programs->compiled.num && programs->compiled.data[i].id != id)
        i++;
    return &programs->compiled.data[i];
}

GLuint csg_programs_noted(const struct csg_programs *programs, uint32_t name)
{
    for (size_t i = 0; i < programs->compiled.num; i++)
        if (programs->compiled.data[i].name == name)
            return programs->compiled.data[i].id;
    return 0;
}

GLuint csg_programs_noted_above(const struct csg_programs *programs, uint32_t name, uint32_t more)
{
    const GLuint same = csg_programs_noted(programs, name);
    for (size_t i = 0; i < programs->compiled.num && !same; i++) {
        const uint32_t other = programs->compiled.data[i].name;
        if ((other & name) == name && (other & ~more) == (name & ~more))
            return programs->compiled.data[i].id;
    }
    return same;
}

void csg_programs_note(struct csg_programs *programs, GLuint id, uint32_t name)
{
    if (id)
        csg_programs_find(programs, id)->name = name;
}

void csg_programs_note_straight(struct csg_programs *programs, GLuint id)
{
    if (id)
        csg_programs_find(programs, id)->asked = programs->frame;
}

GLuint csg_programs_known(const struct csg_programs *programs, struct csg_stages stages)
{
    const GLuint known = stages.vertex && stages.fragment ? find(programs, &stages) : 0;
    free_stages(&stages);
    return known;
}

GLuint csg_programs_get(struct csg_programs *programs, struct csg_stages stages)
{
    if (!stages.vertex || !stages.fragment) {
        free_stages(&stages);
        csg_log_memory(&programs->gl->log);
        return 0;
    }
    const GLuint known = find(programs, &stages);
    if (known) {
        free_stages(&stages);
        return known;
    }
    const double start = csg_clock_ms();
    GLuint id = link_program(programs->gl, stages.vertex, stages.fragment);
    programs->compile_ms += csg_clock_ms() - start;
    const struct csg_compiled compiled = {.id = id,
                                          .uniforms = id ? find_uniforms(programs->gl, id)
                                                         : (struct csg_uniforms){0},
                                          .stages = stages};
    if (id && csg_array_push(&programs->compiled, compiled)) {
        programs->num_compiled++;
        return id;
    }
    if (id)
        csg_log_memory(&programs->gl->log);
    programs->gl->DeleteProgram(id);
    free_stages(&stages);
    return 0;
}

static void delete_program(struct csg_programs *programs, struct csg_compiled *compiled)
{
    programs->gl->DeleteProgram(compiled->id);
    free_stages(&compiled->stages);
}

/* The program of a structure that was not asked for longest, where they are too many; or NULL. */
static struct csg_compiled *find_spare(const struct csg_programs *programs)
{
    struct csg_compiled *oldest = NULL;
    size_t num = 0;
    for (size_t i = 0; i < programs->compiled.num; i++) {
        struct csg_compiled *compiled = &programs->compiled.data[i];
        num += compiled->asked > 0;
        if (compiled->asked > 0 && (!oldest || compiled->asked < oldest->asked))
            oldest = compiled;
    }
    return num > MAX_STRAIGHT ? oldest : NULL;
}

void csg_programs_begin(struct csg_programs *programs)
{
    struct csg_compiled *spare;
    programs->frame++;
    while ((spare = find_spare(programs)) != NULL) {
        delete_program(programs, spare);
        *spare = programs->compiled.data[--programs->compiled.num];
    }
}

void csg_programs_finish(struct csg_programs *programs)
{
    for (size_t i = 0; i < programs->compiled.num; i++)
        delete_program(programs, &programs->compiled.data[i]);
    free(programs->compiled.data);
}
