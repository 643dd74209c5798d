/* SPDX-License-Identifier: MIT */

/*
 * The passes of a strip: the geometry pass finds the visible record of every pixel, the shading
 * pass gives it normal and colour. Translucent objects, % and # come as further rounds over the
 * same depth buffer, blended.
 */

#include "render/picture.h"

#include <string.h>

#include "render/direct.h"
#include "render/inputs.h"

/* Which batches a round draws. */
struct round {
    bool geometry;    /* all of the model; writes distance, normal and leaf */
    bool overlay;     /* blended over what is there */
    bool rear;        /* the far sides */
    uint8_t paint;    /* without geometry: what is painted so, */
    bool translucent; /* ... and is translucent or not, */
    uint32_t object;  /* ... this one; CSG_ANY_OBJECT */
};

static bool is_in_round(const struct csg_batch *batch, const struct round *round)
{
    if (round->geometry)
        return batch->layer == CSG_LAYER_MODEL;
    return batch->paint == round->paint && batch->translucent == round->translucent &&
           (batch->rear || !round->rear) &&
           (round->object == CSG_ANY_OBJECT || batch->object == round->object);
}

/* Whether some of its rectangle is in the strip, or within a pixel of it. */
static bool is_in_strip(const struct csg_picture *picture, const struct csg_draw *draw)
{
    const double scale = 0.5 * picture->request->height;
    return ((double)draw->instance.rect[3] + 1) * scale >= picture->first_row - 1 &&
           ((double)draw->instance.rect[1] + 1) * scale <=
               picture->first_row + picture->num_rows + 1;
}

/* Of a large picture's tiles, each strip has a few: those that follow each other are drawn at
 * once. */
static void draw_batch(const struct csg_picture *picture, const struct csg_batch *batch)
{
    const struct csg_draw *draws = picture->renderer->frame.draws.data;
    const uint32_t *order = picture->batches.order.data;
    const uint32_t end = batch->first + batch->num;
    struct csg_batch part = *batch;
    if (batch->run || picture->num_rows == picture->request->height) {
        csg_inputs_draw(picture, batch);
        return;
    }
    for (uint32_t i = batch->first; i < end; i += part.num + 1) {
        part.first = i;
        for (part.num = 0; i + part.num < end && is_in_strip(picture, &draws[order[i + part.num]]);)
            part.num++;
        if (part.num > 0)
            csg_inputs_draw(picture, &part);
    }
}

static void draw_batches(const struct csg_picture *picture, const struct round *round)
{
    struct csg_gl *gl = picture->gl;
    picture->renderer->programs.round++;
    gl->Enable(GL_PROGRAM_POINT_SIZE);
    for (size_t i = 0; i < picture->batches.num; i++) {
        const struct csg_batch *batch = &picture->batches.data[i];
        if (!is_in_round(batch, round))
            continue;
        const GLuint program = round->rear ? batch->rear : batch->program;
        csg_inputs_use(picture, program, round->paint);
        draw_batch(picture, batch);
    }
}

static void draw_geometry(const struct csg_picture *picture, const struct round *round)
{
    struct csg_gl *gl = picture->gl;
    const GLuint nothing[4] = {0, 0, 0, 0};
    const GLfloat far = 1;
    gl->BindFramebuffer(GL_FRAMEBUFFER, picture->renderer->targets.geometry_fbo);
    gl->Viewport(0, -picture->first_row, picture->request->width, picture->request->height);
    /* Elsewhere the depth buffer tells what has been drawn. */
    if (round->overlay || picture->visible)
        gl->ClearBufferuiv(GL_COLOR, 0, nothing);
    gl->DepthMask(GL_TRUE);
    if (!round->overlay)
        gl->ClearBufferfv(GL_DEPTH, 0, &far);
    gl->Enable(GL_DEPTH_TEST);
    gl->DepthFunc(GL_LESS);
    draw_batches(picture, round);
}

static void set_outputs(const struct csg_picture *picture, const struct round *round)
{
    const GLenum buffers[3] = {
        GL_COLOR_ATTACHMENT0,
        round->geometry && picture->want_geometry ? GL_COLOR_ATTACHMENT1 : GL_NONE,
        round->geometry && picture->want_leaf ? GL_COLOR_ATTACHMENT2 : GL_NONE};
    picture->gl->DrawBuffers(3, buffers);
}

/* To what a byte holds. */
static void round_color(GLfloat color[4])
{
    uint8_t bytes[4];
    csg_color_bytes(bytes, color, 4);
    for (int i = 0; i < 4; i++)
        color[i] = (float)bytes[i] / 255;
}

/* What a pixel without a surface has. */
static void clear_outputs(const struct csg_picture *picture, const struct round *round)
{
    struct csg_gl *gl = picture->gl;
    const float *color = picture->request->scheme->background;
    GLfloat background[4] = {color[0], color[1], color[2], 1};
    const GLfloat nowhere[4] = {0, 0, 0, INFINITY}, no_leaf[4] = {-1, -1, -1, -1};
    if (round->overlay)
        return;
    if (picture->bytes)
        round_color(background);
    gl->ClearBufferfv(GL_COLOR, 0, background);
    if (round->geometry && picture->want_geometry)
        gl->ClearBufferfv(GL_COLOR, 1, nowhere);
    if (round->geometry && picture->want_leaf)
        gl->ClearBufferfv(GL_COLOR, 2, no_leaf);
}

static int clamp_pixel(double x, int size)
{
    return x < 0 ? 0 : x > size ? size : (int)x;
}

/* Only what is inside of the draws' rectangles needs shading, with a pixel more for the rounding of
 * their corners. false: nothing of the strip. */
static bool set_shaded_part(const struct csg_picture *picture, const struct round *round)
{
    const int width = picture->request->width, rows = picture->num_rows;
    const double sx = 0.5 * width, sy = 0.5 * picture->request->height;
    float rect[4];
    if (round->overlay)
        csg_bound_object(&picture->renderer->frame, round->object, rect);
    else
        memcpy(rect, picture->rect, sizeof rect);
    const int x0 = clamp_pixel(((double)rect[0] + 1) * sx - 1, width);
    const int x1 = clamp_pixel(((double)rect[2] + 1) * sx + 2, width);
    const int lo = clamp_pixel(((double)rect[1] + 1) * sy - 1 - picture->first_row, rows);
    const int hi = clamp_pixel(((double)rect[3] + 1) * sy + 2 - picture->first_row, rows);
    if (x0 >= x1 || lo >= hi)
        return false;
    picture->gl->Viewport(x0, lo, x1 - x0, hi - lo);
    return true;
}

static void draw_shading(const struct csg_picture *picture, const struct round *round)
{
    struct csg_gl *gl = picture->gl;
    const struct csg_targets *targets = &picture->renderer->targets;
    gl->BindFramebuffer(GL_FRAMEBUFFER, picture->bytes ? targets->bytes_fbo : targets->shade_fbo);
    if (!picture->bytes)
        set_outputs(picture, round);
    clear_outputs(picture, round);
    if (!set_shaded_part(picture, round))
        return;
    gl->DepthFunc(GL_GREATER);
    gl->DepthMask(GL_FALSE);
    if (round->overlay) {
        gl->Enable(GL_BLEND);
        gl->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    }
    gl->BindVertexArray(picture->renderer->empty_array);
    csg_inputs_set(picture, picture->shade);
    gl->ActiveTexture(GL_TEXTURE1);
    gl->BindTexture(GL_TEXTURE_RECTANGLE, picture->renderer->targets.visible);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->DrawArrays(GL_TRIANGLES, 0, 3);
    gl->Disable(GL_BLEND);
}

/* Reads which pixels the geometry pass gave up on; they are filled after everything else. */
static void read_visible(const struct csg_picture *picture)
{
    struct csg_gl *gl = picture->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, picture->renderer->targets.geometry_fbo);
    gl->ReadBuffer(GL_COLOR_ATTACHMENT0);
    gl->ReadPixels(0, 0, picture->request->width, picture->num_rows, GL_RG_INTEGER, GL_UNSIGNED_INT,
                   picture->visible);
}

static void draw_round(const struct csg_picture *picture, const struct round *round)
{
    draw_geometry(picture, round);
    draw_shading(picture, round);
}

/* The far sides where there are any, then the near ones. */
static void draw_overlay(const struct csg_picture *picture, struct round round, bool has_rear)
{
    round.overlay = true;
    round.rear = true;
    if (has_rear)
        draw_round(picture, &round);
    round.rear = false;
    draw_round(picture, &round);
}

static bool is_overlay(const struct csg_batch *batch, uint8_t paint)
{
    return batch->paint == paint && !csg_batch_is_opaque(batch);
}

/* Everything of one paint that is not simply opaque, in file order. */
static void draw_overlays(const struct csg_picture *picture, uint8_t paint)
{
    uint32_t last = CSG_ANY_OBJECT;
    for (size_t i = 0; i < picture->batches.num; i++) {
        const struct csg_batch *batch = &picture->batches.data[i];
        if (!is_overlay(batch, paint) || batch->object == last)
            continue;
        last = batch->object;
        const struct round round = {
            .paint = paint, .translucent = batch->translucent, .object = last};
        draw_overlay(picture, round, batch->rear != 0);
    }
}

/* The same at once, the opaque ones of %, which have colours of their own, first: they show through
 * the others. */
static void draw_together(const struct csg_picture *picture, uint8_t paint)
{
    bool has[2] = {false}, has_rear[2] = {false};
    for (size_t i = 0; i < picture->batches.num; i++) {
        const struct csg_batch *batch = &picture->batches.data[i];
        if (!is_overlay(batch, paint))
            continue;
        has[batch->translucent] = true;
        has_rear[batch->translucent] |= batch->rear != 0;
    }
    for (int i = 0; i < 2; i++) {
        const struct round round = {
            .paint = paint, .translucent = i == 1, .object = CSG_ANY_OBJECT};
        if (has[i])
            draw_overlay(picture, round, has_rear[i]);
    }
}

/* The frame without a shading pass. */
static void draw_directly(const struct csg_picture *picture)
{
    struct csg_gl *gl = picture->gl;
    const struct round all = {.geometry = true};
    const GLfloat far = 1;
    gl->BindFramebuffer(GL_FRAMEBUFFER, picture->renderer->targets.bytes_fbo);
    gl->Viewport(0, -picture->first_row, picture->request->width, picture->request->height);
    clear_outputs(picture, &all);
    if (csg_is_disjoint(&picture->renderer->frame)) {
        gl->Disable(GL_DEPTH_TEST);
    } else {
        gl->DepthMask(GL_TRUE);
        gl->ClearBufferfv(GL_DEPTH, 0, &far);
        gl->Enable(GL_DEPTH_TEST);
        gl->DepthFunc(GL_LESS);
    }
    draw_batches(picture, &all);
}

/* Distances and leaves are those of all solids. Where some of them are translucent, colours start
 * anew with the opaque ones; the others come over them. */
void csg_passes_draw_strip(const struct csg_picture *picture)
{
    const struct round all = {.geometry = true};
    const struct round opaque = {.paint = CSG_LAYER_MODEL, .object = CSG_ANY_OBJECT};
    bool mixed = false;
    if (picture->batches.direct) {
        draw_directly(picture);
        return;
    }
    for (size_t i = 0; i < picture->batches.num; i++)
        mixed |= picture->batches.data[i].layer == CSG_LAYER_MODEL &&
                 !csg_batch_is_opaque(&picture->batches.data[i]);
    if (!mixed || picture->want_geometry || picture->want_leaf || picture->visible)
        draw_round(picture, &all);
    if (picture->visible)
        read_visible(picture);
    if (mixed)
        draw_round(picture, &opaque);
    for (uint8_t paint = 0; paint < CSG_NUM_LAYERS; paint++)
        if (picture->batches.together[paint])
            draw_together(picture, paint);
        else
            draw_overlays(picture, paint);
}

void csg_passes_draw_nothing(const struct csg_picture *picture)
{
    const struct round round = {.geometry = true};
    draw_round(picture, &round);
}
