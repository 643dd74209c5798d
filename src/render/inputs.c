/* SPDX-License-Identifier: MIT */
#include "render/inputs.h"

#include <stddef.h>

#include "pack/textbook.h"

/* Overlays coincide with surfaces that they repeat: let them win by some steps of the buffer. */
#define OVERLAY_DEPTH_BIAS 2e-6f

static void set_textbook_rays(const struct csg_picture *picture, GLuint program)
{
    struct csg_gl *gl = picture->gl;
    const struct csg_textbook_rays rays =
        csg_textbook_rays(&picture->renderer->frame.screen, picture->renderer->frame.at);
    gl->Uniform3fv(gl->GetUniformLocation(program, "csg_ray_origin"), 3, rays.origin);
    gl->Uniform3fv(gl->GetUniformLocation(program, "csg_ray_direction"), 3, rays.direction);
    gl->Uniform1f(gl->GetUniformLocation(program, "csg_ray_start"), rays.start);
}

static void set_light(const struct csg_picture *picture, const struct csg_uniforms *at)
{
    const struct csgcast_frustum *frustum = &picture->request->frustum;
    float light[3];
    for (int i = 0; i < 3; i++)
        light[i] = (float)(CSG_LIGHT_X * frustum->right[i] + CSG_LIGHT_Y * frustum->up[i] -
                           CSG_LIGHT_Z * frustum->forward[i]);
    picture->gl->Uniform4f(at->light, light[0], light[1], light[2], (float)CSG_LIGHT_AMBIENT);
}

void csg_inputs_set(const struct csg_picture *picture, GLuint program)
{
    struct csg_gl *gl = picture->gl;
    const struct csg_screen *screen = &picture->renderer->frame.screen;
    const struct csg_uniforms *at =
        &csg_programs_find(&picture->renderer->programs, program)->uniforms;
    gl->UseProgram(program);
    gl->Uniform1i(at->data, 0);
    gl->Uniform1i(at->visible, 1);
    gl->Uniform1i(at->cells, CSG_CELLS_UNIT);
    gl->Uniform1i(at->owners, CSG_OWNERS_UNIT);
    gl->Uniform2f(at->window, 0, (float)picture->first_row);
    gl->Uniform2f(at->at, (float)picture->renderer->frame.at.x,
                  (float)picture->renderer->frame.at.y);
    gl->Uniform4f(at->screen_depth, screen->depth[0], screen->depth[1], screen->depth[2],
                  screen->depth[3]);
    gl->Uniform4f(at->screen_key, (float)screen->a, (float)screen->b, (float)screen->k_far,
                  screen->orthographic || screen->textbook);
    set_light(picture, at);
    if (screen->textbook)
        set_textbook_rays(picture, program);
}

void csg_inputs_use(const struct csg_picture *picture, GLuint program, uint8_t paint)
{
    struct csg_programs *programs = &picture->renderer->programs;
    struct csg_compiled *compiled = csg_programs_find(programs, program);
    if (compiled->round == programs->round) {
        picture->gl->UseProgram(program);
        return;
    }
    compiled->round = programs->round;
    csg_inputs_set(picture, program);
    picture->gl->Uniform1f(compiled->uniforms.depth_bias, paint * OVERLAY_DEPTH_BIAS);
}

/* Points are vertices of their own, as drivers take these by the vector, but instances one by one.
 * Each way has an array of its own, which stays as it is: Mesa tells how far an array's attributes
 * are apart in another way where it changes often, and compiles the vertex stage anew for that. */
static void point_instances(struct csg_gl *gl, size_t first, bool points)
{
    const size_t size = sizeof(struct csg_instance), base = first * size;
    gl->VertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, (GLsizei)size,
                            (const void *)(base + offsetof(struct csg_instance, rect)));
    gl->VertexAttribIPointer(1, 4, GL_INT, (GLsizei)size, /* turns and side come behind records */
                             (const void *)(base + offsetof(struct csg_instance, records)));
    for (GLuint i = 0; i < 2; i++) {
        gl->EnableVertexAttribArray(i);
        gl->VertexAttribDivisor(i, points ? 0 : 1);
    }
}

/* A crowd's attributes, see crowd/run.h. */
static void point_crowd(struct csg_gl *gl, const struct csg_crowd_run *run)
{
    const GLsizei stride = (GLsizei)(run->stride * sizeof(float));
    const GLuint num = 2 + run->num_planes + (run->has_quadric ? 3 : 0);
    for (GLuint i = 0; i < num; i++) {
        const size_t place = run->first + (i == 0 ? 0 : i == 1 ? run->stride - 1 : 4 * (i - 1));
        const void *offset = (const void *)(place * sizeof(float));
        if (i == 1)
            gl->VertexAttribIPointer(i, 1, GL_INT, stride, offset);
        else
            gl->VertexAttribPointer(i, 4, GL_FLOAT, GL_FALSE, stride, offset);
        gl->EnableVertexAttribArray(i);
        gl->VertexAttribDivisor(i, 1);
    }
}

/* Of all members that own pixels, see crowd/run.h. */
static void point_owned(struct csg_gl *gl, const struct csg_crowd_run *run)
{
    const GLsizei stride = (GLsizei)sizeof(struct csg_owned_instance);
    const size_t base = run->first * sizeof(float);
    gl->VertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, stride,
                            (const void *)(base + offsetof(struct csg_owned_instance, rect)));
    gl->VertexAttribIPointer(1, 4, GL_INT, stride,
                             (const void *)(base + offsetof(struct csg_owned_instance, begin)));
    gl->VertexAttribIPointer(2, 1, GL_INT, stride,
                             (const void *)(base + offsetof(struct csg_owned_instance, width)));
    for (GLuint i = 0; i < 3; i++) {
        gl->EnableVertexAttribArray(i);
        gl->VertexAttribDivisor(i, 1);
    }
}

void csg_inputs_prepare(const struct csgcast_renderer *renderer)
{
    struct csg_gl *gl = renderer->gl;
    gl->BindBuffer(GL_ARRAY_BUFFER, renderer->instance_buffer.id);
    gl->BindVertexArray(renderer->point_array);
    point_instances(gl, 0, true);
    gl->BindVertexArray(renderer->vertex_array);
    point_instances(gl, 0, false);
}

static void draw_crowd(struct csg_gl *gl, const struct csgcast_renderer *renderer,
                       const struct csg_batch *batch)
{
    gl->BindVertexArray(renderer->crowd_array);
    gl->BindBuffer(GL_ARRAY_BUFFER, renderer->crowd_buffer.id);
    if (batch->run->owned)
        point_owned(gl, batch->run);
    else
        point_crowd(gl, batch->run);
    gl->DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, (GLsizei)batch->num);
}

static void draw_rectangles(struct csg_gl *gl, const struct csgcast_renderer *renderer,
                            const struct csg_batch *batch)
{
    gl->BindVertexArray(renderer->vertex_array);
    if (gl->DrawArraysInstancedBaseInstance) {
        gl->DrawArraysInstancedBaseInstance(GL_TRIANGLE_STRIP, 0, 4, (GLsizei)batch->num,
                                            batch->first);
        return;
    }
    gl->BindBuffer(GL_ARRAY_BUFFER, renderer->instance_buffer.id);
    point_instances(gl, batch->first, false);
    gl->DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, (GLsizei)batch->num);
}

void csg_inputs_draw(const struct csg_picture *picture, const struct csg_batch *batch)
{
    struct csg_gl *gl = picture->gl;
    if (batch->run) {
        draw_crowd(gl, picture->renderer, batch);
    } else if (batch->points) {
        gl->BindVertexArray(picture->renderer->point_array);
        gl->DrawArrays(GL_POINTS, (GLint)batch->first, (GLsizei)batch->num);
    } else {
        draw_rectangles(gl, picture->renderer, batch);
    }
}
