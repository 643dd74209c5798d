/* SPDX-License-Identifier: MIT */

/*
 * A frame: the geometry pass finds the visible record of every pixel, the shading pass gives it
 * normal and colour. Translucent objects, % and # come as further rounds over the same depth
 * buffer, blended. Large pictures are drawn in bands.
 */

#include "render/picture.h"

#include <stdlib.h>
#include <string.h>

#include "common/clock.h"
#include "render/direct.h"
#include "render/inputs.h"

#define MAX_BAND_PIXELS (4 << 20)

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
        csg_inputs_use(picture, program, round->paint == CSG_LAYER_HIGHLIGHT);
        csg_inputs_bind(picture, batch);
        if (batch->points)
            gl->DrawArrays(GL_POINTS, 0, (GLsizei)batch->num);
        else
            gl->DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, (GLsizei)batch->num);
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
 * their corners. false: nothing of the band. */
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

static bool is_opaque(const struct csg_batch *batch)
{
    return !batch->translucent && batch->paint == CSG_LAYER_MODEL;
}

/* The far sides, then the near ones. */
static void draw_overlay(const struct csg_picture *picture, const struct csg_batch *batch,
                         uint32_t object)
{
    struct round round = {.overlay = true,
                          .rear = true,
                          .paint = batch->paint,
                          .translucent = batch->translucent,
                          .object = object};
    if (batch->rear)
        draw_round(picture, &round);
    round.rear = false;
    draw_round(picture, &round);
}

static size_t count_overlays(const struct csg_picture *picture, uint8_t paint)
{
    uint32_t last = CSG_ANY_OBJECT;
    size_t num = 0;
    for (size_t i = 0; i < picture->batches.num; i++) {
        const struct csg_batch *batch = &picture->batches.data[i];
        if (batch->paint != paint || is_opaque(batch))
            continue;
        num += batch->object != last;
        last = batch->object;
    }
    return num;
}

/* Everything of one paint that is not simply opaque, in file order. */
static void draw_overlays(const struct csg_picture *picture, uint8_t paint)
{
    uint32_t last = CSG_ANY_OBJECT;
    const bool together = count_overlays(picture, paint) > CSG_MAX_OVERLAYS ||
                          (paint == CSG_LAYER_MODEL && picture->renderer->frame.crowd.together);
    for (size_t i = 0; i < picture->batches.num; i++) {
        const struct csg_batch *batch = &picture->batches.data[i];
        if (batch->paint != paint || is_opaque(batch) || batch->object == last)
            continue;
        last = batch->object;
        draw_overlay(picture, batch, together ? CSG_ANY_OBJECT : last);
        if (together)
            return;
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
static void draw_band(const struct csg_picture *picture)
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
                 !is_opaque(&picture->batches.data[i]);
    if (!mixed || picture->want_geometry || picture->want_leaf || picture->visible)
        draw_round(picture, &all);
    if (picture->visible)
        read_visible(picture);
    if (mixed)
        draw_round(picture, &opaque);
    for (uint8_t paint = 0; paint < CSG_NUM_LAYERS; paint++)
        draw_overlays(picture, paint);
}

static bool draw_bands(struct csg_picture *picture)
{
    const struct csg_request *request = picture->request;
    int rows = MAX_BAND_PIXELS / request->width;
    rows = rows < 1 ? 1 : rows > request->height ? request->height : rows;
    if (!csg_targets_resize(&picture->renderer->targets, picture->gl, request->width, rows,
                            picture->bytes))
        return false;
    const size_t num_pixels = (size_t)request->width * (size_t)rows;
    float *pixels = picture->bytes ? NULL : malloc(4 * num_pixels * sizeof *pixels);
    const bool marks = picture->batches.may_give_up && !picture->batches.direct;
    if (marks)
        picture->visible = malloc(2 * num_pixels * sizeof *picture->visible);
    bool ok = (pixels || picture->bytes) && (picture->visible || !marks);
    if (!ok)
        csg_log_memory(&picture->renderer->log);
    picture->gl->ActiveTexture(GL_TEXTURE0 + CSG_OWNERS_UNIT);
    picture->gl->BindTexture(GL_TEXTURE_BUFFER, picture->renderer->owners_texture);
    picture->gl->ActiveTexture(GL_TEXTURE0 + CSG_CELLS_UNIT);
    picture->gl->BindTexture(GL_TEXTURE_BUFFER, picture->renderer->cells.texture);
    picture->gl->ActiveTexture(GL_TEXTURE0);
    picture->gl->BindTexture(GL_TEXTURE_BUFFER, picture->renderer->data_texture);
    for (int row = 0; row < request->height && ok; row += rows) {
        picture->first_row = row;
        picture->num_rows = rows < request->height - row ? rows : request->height - row;
        struct csgcast_stats *stats = &picture->renderer->stats;
        const double start = csg_clock_ms();
        draw_band(picture);
        picture->gl->Finish(); /* reading waits for it anyway */
        const double drawn = csg_clock_ms();
        csg_picture_read_band(picture, pixels);
        if (picture->batches.may_give_up)
            ok = csg_unfinished_fill(picture->renderer, request, picture->visible, row,
                                     picture->num_rows);
        stats->draw_ms += drawn - start;
        stats->read_ms += csg_clock_ms() - drawn;
    }
    free(picture->visible);
    free(pixels);
    return ok;
}

/* Blending needs floats. */
static bool prepare_shading(struct csg_picture *picture)
{
    const struct csgcast_image *image = picture->request->image;
    picture->bytes = image->rgba8 && !image->rgba && !picture->want_geometry && !picture->want_leaf;
    for (size_t i = 0; i < picture->batches.num; i++)
        picture->bytes &= is_opaque(&picture->batches.data[i]);
    csg_bound_draws(&picture->renderer->frame, picture->rect);
    if (picture->batches.direct)
        return true;
    picture->shade = csg_programs_get(
        &picture->renderer->programs,
        csg_source_shade(picture->want_leaf, picture->bytes,
                         (picture->request->textbook ? CSG_FEATURE_TEXTBOOK : 0) |
                             (picture->request->shared ? CSG_FEATURE_SHARED : 0)));
    return picture->shade != 0;
}

/* Fewer objects are drawn faster than one more set of inputs is compiled for, see
 * shaders/common/inputs.glsl. */
#define MIN_SHARED_CROWD 500

static bool has_crowds(const struct csg_request *request)
{
    return request->resolver < 0 && !request->textbook && !request->tile_size &&
           (!request->shared || request->scene->objects->num >= MIN_SHARED_CROWD);
}

static size_t max_owners(struct csg_gl *gl)
{
    GLint num = 0;
    gl->GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &num);
    return num > 0 ? (size_t)num : 0;
}

static enum csg_cells_use choose_cells(const struct csg_request *request)
{
    if (request->resolver == CSG_RESOLVER_CELLS)
        return CSG_CELLS_ALWAYS;
    return request->resolver >= 0 || request->textbook || request->tile_size
               ? CSG_CELLS_NEVER
               : CSG_CELLS_WHERE_BETTER;
}

bool csg_picture_render(struct csgcast_renderer *renderer, const struct csg_request *request)
{
    const struct csg_frame_params params = {
        .frustum = &request->frustum,
        .width = request->width,
        .height = request->height,
        .num_threads = renderer->num_threads,
        .scheme = request->scheme,
        .cut_color = request->view->cut_color,
        .whole = csg_draws_whole,
        .user = request,
        .textbook = request->textbook,
        .precise = request->resolver == CSG_RESOLVER_DOUBLE,
        .leaves = request->image->id != NULL,
        .has_double = renderer->gl->has_double,
        .crowds = has_crowds(request),
        .max_owners = max_owners(renderer->gl),
        .tile_size = request->tile_size,
        .cells = choose_cells(request),
    };
    const double start = csg_clock_ms();
    if (!csg_frame_fill(&renderer->frame, request->scene, &params))
        return csg_log_memory(&renderer->log);
    renderer->stats.cpu_ms = csg_clock_ms() - start;
    struct csg_picture picture = {.renderer = renderer, .gl = renderer->gl, .request = request};
    picture.want_geometry = request->image->z || request->image->normal;
    picture.want_leaf = request->image->id != NULL;
    picture.batches.direct = csg_draws_directly(renderer, request);
    const bool ok = csg_batches_fill(&picture.batches, renderer, request) &&
                    prepare_shading(&picture) && csg_upload_frame(renderer) && draw_bands(&picture);
    csg_picture_count(&picture);
    free(picture.batches.data);
    return ok;
}

void csg_picture_warm_up(struct csgcast_renderer *renderer)
{
    const struct csg_request request = {
        .scheme = csg_colorscheme_find(NULL), .width = 1, .height = 1, .resolver = -1};
    const struct round round = {.geometry = true};
    struct csg_picture picture = {.renderer = renderer, .gl = renderer->gl, .request = &request,
                                  .num_rows = 1, .bytes = true, .rect = {-1, -1, 1, 1}};
    if (!csg_gl_enter(renderer->gl))
        return;
    picture.shade =
        csg_programs_get(&renderer->programs, csg_source_shade(false, true, CSG_FEATURE_SHARED));
    if (picture.shade && csg_upload_frame(renderer) &&
        csg_targets_resize(&renderer->targets, renderer->gl, 1, 1, true)) {
        draw_round(&picture, &round);
        renderer->gl->Finish();
    }
    csg_gl_leave(renderer->gl);
}
