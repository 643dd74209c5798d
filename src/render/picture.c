/* SPDX-License-Identifier: MIT */

/* A frame: what it takes is chosen and handed over, then drawn, large pictures in strips. */

#include "render/picture.h"

#include <stdlib.h>
#include <string.h>

#include "common/clock.h"
#include "render/chooser.h"
#include "render/direct.h"
#include "render/inputs.h"

#define MAX_STRIP_PIXELS (4 << 20)
#define PROGRESS_AFTER_MS 1000

void csg_picture_bind_textures(const struct csg_picture *picture)
{
    struct csg_gl *gl = picture->gl;
    gl->ActiveTexture(GL_TEXTURE0 + CSG_OWNERS_UNIT);
    gl->BindTexture(GL_TEXTURE_BUFFER, picture->renderer->owners_texture);
    gl->ActiveTexture(GL_TEXTURE0 + CSG_CELLS_UNIT);
    gl->BindTexture(GL_TEXTURE_BUFFER, picture->renderer->cells.texture);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_BUFFER, picture->renderer->data_texture);
}

static bool draw_strip(struct csg_picture *picture, float *pixels)
{
    struct csgcast_stats *stats = &picture->renderer->stats;
    const double start = csg_clock_ms();
    csg_passes_draw_strip(picture);
    picture->gl->Finish(); /* reading waits for it anyway */
    const double drawn = csg_clock_ms();
    csg_picture_read_strip(picture, pixels);
    const bool ok = !picture->batches.may_give_up ||
                    csg_unfinished_fill(picture->renderer, picture->request, picture->visible,
                                        picture->first_row, picture->num_rows);
    stats->draw_ms += drawn - start;
    stats->read_ms += csg_clock_ms() - drawn;
    return ok;
}

/* told: when there was a message, or the picture was begun. */
static void tell(const struct csg_picture *picture, double *told)
{
    const int done = picture->first_row + picture->num_rows;
    const double now = csg_clock_ms();
    if (now - *told < PROGRESS_AFTER_MS || done == picture->request->height)
        return;
    *told = now;
    csg_log_print(&picture->renderer->log, CSGCAST_LOG_INFO, CSGCAST_MESSAGE_PROGRESS,
                  "%d of %d rows drawn", done, picture->request->height);
}

static bool draw_strips(struct csg_picture *picture)
{
    const struct csg_request *request = picture->request;
    int rows = MAX_STRIP_PIXELS / request->width / CSG_PIXEL_BLOCK * CSG_PIXEL_BLOCK;
    rows = rows > request->height ? request->height : rows;
    const struct csg_targets_use use = {picture->batches.direct, picture->bytes,
                                        picture->want_geometry, picture->want_leaf};
    if (!csg_targets_resize(&picture->renderer->targets, picture->gl, request->width, rows, &use))
        return false;
    const size_t num_pixels = (size_t)request->width * (size_t)rows;
    picture->num_rows = rows;
    const size_t num_read = (size_t)request->width * (size_t)csg_picture_rows_at_once(picture);
    float *pixels = picture->bytes ? NULL : malloc(4 * num_read * sizeof *pixels);
    const bool marks = picture->batches.may_give_up && !picture->batches.direct;
    if (marks)
        picture->visible = malloc(2 * num_pixels * sizeof *picture->visible);
    bool ok = (pixels || picture->bytes) && (picture->visible || !marks);
    if (!ok)
        csg_log_memory(&picture->renderer->log);
    csg_picture_bind_textures(picture);
    double told = csg_clock_ms();
    for (int row = 0; row < request->height && ok; row += rows) {
        picture->first_row = row;
        picture->num_rows = rows < request->height - row ? rows : request->height - row;
        ok = draw_strip(picture, pixels);
        tell(picture, &told);
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
        picture->bytes &= csg_batch_is_opaque(&picture->batches.data[i]);
    if (picture->batches.direct)
        return true;
    csg_bound_draws(&picture->renderer->frame, picture->rect);
    picture->shade = csg_programs_get(
        &picture->renderer->programs,
        csg_source_shade(picture->want_leaf, picture->bytes,
                         (picture->request->textbook ? CSG_FEATURE_TEXTBOOK : 0) |
                             (picture->request->same_inputs ? CSG_FEATURE_SHARED : 0)));
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

/* Whether the frame can be drawn with what is compiled, or may be. params: see
 * csg_chooser_make_do. */
static bool can_draw(struct csg_picture *picture, struct csg_frame_params *params)
{
    if (!picture->request->after_edit)
        return true;
    struct csg_chooser *chooser =
        csg_chooser_create(picture->renderer, picture->request, picture->batches.direct);
    const bool can = !chooser || csg_chooser_make_do(chooser, params);
    csg_chooser_destroy(chooser);
    return can;
}

/* What the frame hands over, and how it is drawn. */
static bool fill_frame(struct csg_picture *picture, struct csg_frame_params *params)
{
    do {
        if (!csg_frame_fill(&picture->renderer->frame, picture->request->scene, params))
            return csg_log_memory(&picture->renderer->log);
        picture->batches.direct = csg_draws_directly(picture->renderer, picture->request);
    } while (!can_draw(picture, params));
    return true;
}

bool csg_picture_render(struct csgcast_renderer *renderer, const struct csg_request *request)
{
    struct csg_frame_params params = {
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
        .few_programs = request->shared,
    };
    struct csg_picture picture = {.renderer = renderer, .gl = renderer->gl, .request = request};
    picture.want_geometry = request->image->z || request->image->normal;
    picture.want_leaf = request->image->id != NULL;
    const double start = csg_clock_ms();
    if (!fill_frame(&picture, &params))
        return false;
    renderer->stats.cpu_ms = csg_clock_ms() - start;
    const bool ok = csg_batches_fill(&picture.batches, renderer, request) &&
                    prepare_shading(&picture) &&
                    csg_upload_frame(renderer, &picture.batches, request->scene->keeps_structure) &&
                    draw_strips(&picture);
    csg_picture_count(&picture);
    csg_batches_finish(&picture.batches);
    return ok;
}
