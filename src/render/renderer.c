/* SPDX-License-Identifier: MIT */
#include "render/renderer.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/clock.h"
#include "csg/membership.h"
#include "reference/reference.h"
#include "render/start.h"

const char *csgcast_version(void)
{
    return CSGCAST_VERSION_STRING;
}

/* In the background where that is asked for. false, with a message, where there is none. */
static bool make_context(struct csgcast_renderer *renderer,
                         const struct csgcast_renderer_params *params)
{
    if (params->backend == CSGCAST_BACKEND_REFERENCE)
        return true;
    if (params->background)
        renderer->start = csg_start_begin(renderer, params->backend);
    if (renderer->start)
        return true;
    renderer->gl = csg_gl_create(params->backend, &renderer->log);
    renderer->programs.gl = renderer->gl;
    return renderer->gl != NULL;
}

struct csgcast_renderer *csgcast_renderer_create(const struct csgcast_renderer_params *params)
{
    static const struct csgcast_renderer_params defaults;
    if (!params)
        params = &defaults;
    const struct csg_log log = {params->log, params->log_user};
    struct csgcast_renderer *renderer = calloc(1, sizeof *renderer);
    if (!renderer) {
        csg_log_memory(&log);
        return NULL;
    }
    renderer->log = log;
    renderer->num_threads = params->num_threads;
    const char *tile_size = getenv("CSGCAST_TILE_SIZE");
    renderer->tile_size = tile_size ? (int)strtol(tile_size, NULL, 10) : 0;
    if (renderer->tile_size < 0)
        renderer->tile_size = 0;
    if (make_context(renderer, params))
        return renderer;
    free(renderer);
    return NULL;
}

static void finish_gl(struct csgcast_renderer *renderer)
{
    struct csg_gl *gl = renderer->gl;
    if (csg_gl_enter(gl)) {
        csg_programs_finish(&renderer->programs);
        csg_targets_finish(&renderer->targets, gl);
        csg_cells_drop(renderer);
        gl->DeleteTextures(1, &renderer->data_texture);
        csg_buffer_finish(gl, &renderer->data_buffer);
        gl->DeleteTextures(1, &renderer->owners_texture);
        csg_buffer_finish(gl, &renderer->owners_buffer);
        csg_buffer_finish(gl, &renderer->instance_buffer);
        csg_buffer_finish(gl, &renderer->crowd_buffer);
        gl->DeleteVertexArrays(1, &renderer->crowd_array);
        gl->DeleteVertexArrays(1, &renderer->vertex_array);
        gl->DeleteVertexArrays(1, &renderer->point_array);
        gl->DeleteVertexArrays(1, &renderer->empty_array);
        csg_gl_leave(gl);
    }
    csg_gl_destroy(gl);
}

void csgcast_renderer_destroy(struct csgcast_renderer *renderer)
{
    if (!renderer)
        return;
    if (renderer->start) {
        renderer->log = csg_log_silent; /* nobody has asked for a picture */
        csg_start_join(renderer);
    }
    if (renderer->gl)
        finish_gl(renderer);
    csg_frame_finish(&renderer->frame);
    free(renderer);
}

const char *csgcast_renderer_name(const struct csgcast_renderer *renderer)
{
    if (!renderer || renderer->start)
        return "not ready yet";
    return renderer->gl ? renderer->gl->name : "reference: double precision, no OpenGL";
}

static int find_resolver(const char *name)
{
    if (!name || strcmp(name, "auto") == 0)
        return -1;
    for (int i = 0; i < CSG_NUM_RESOLVERS; i++)
        if (strcmp(csg_resolver_names[i], name) == 0)
            return i;
    return CSG_NUM_RESOLVERS;
}

static bool argument_error(const struct csgcast_renderer *renderer, const char *what,
                           const char *value)
{
    csg_log_error(&renderer->log, CSGCAST_MESSAGE_ARGUMENT, "there is no %s '%s'", what, value);
    return false;
}

/* A first picture is not to wait for programs that only later ones repay. What edits need is all
 * compiled with the first one, so it may as well be drawn by that. */
static bool is_first(const struct csgcast_renderer *renderer, const struct csg_request *request)
{
    return !renderer->has_drawn && !request->scene->keeps_structure && request->resolver < 0 &&
           !request->textbook;
}

static bool resolve_request(const struct csgcast_renderer *renderer, struct csg_request *request)
{
    const struct csgcast_view *view = request->view;
    request->width = view->width ? view->width : 512;
    request->height = view->height ? view->height : 512;
    request->scheme = csg_colorscheme_find(view->colorscheme);
    request->textbook = view->variant && strcmp(view->variant, CSG_TEXTBOOK_NAME) == 0;
    request->shared = view->variant && strcmp(view->variant, CSG_SHARED_NAME) == 0;
    request->same_inputs = !request->textbook && renderer->gl && renderer->gl->is_llvmpipe;
    request->resolver = find_resolver(request->textbook || request->shared ? NULL : view->variant);
    request->first = !request->shared && is_first(renderer, request);
    request->shared |= request->first;
    if (!request->scheme)
        return argument_error(renderer, "colour scheme", view->colorscheme);
    if (request->resolver == CSG_NUM_RESOLVERS)
        return argument_error(renderer, "variant", view->variant);
    if (request->resolver == CSG_RESOLVER_DOUBLE && renderer->gl && !renderer->gl->has_double) {
        csg_log_error(&renderer->log, CSGCAST_MESSAGE_ARGUMENT,
                      "variant 'double' needs GL_ARB_gpu_shader_fp64, which %s does not have: use "
                      "--backend=reference",
                      renderer->gl->name);
        return false;
    }
    if (request->textbook && request->scene->has_surfaces) {
        csg_log_warning(&renderer->log, CSGCAST_MESSAGE_ARGUMENT,
                        "the variant textbook has no surfaces of triangles: this picture is drawn "
                        "as without it");
        request->textbook = false;
    }
    return csgcast_view_resolve(request->scene, view, &request->frustum);
}

static void count_hits(struct csgcast_renderer *renderer, const struct csg_request *request)
{
    const size_t num = (size_t)request->width * (size_t)request->height;
    const struct csgcast_image *image = request->image;
    renderer->stats.hit_pixels = 0;
    renderer->stats.has_hit_pixels = image->id || image->z;
    if (image->id)
        csg_singles_count(&renderer->frame.singles, request->scene, image->id, num,
                          &renderer->stats);
    if (!renderer->stats.has_hit_pixels)
        return;
    for (size_t i = 0; i < num; i++)
        renderer->stats.hit_pixels +=
            (image->id && image->id[i] >= 0) || (!image->id && image->z && image->z[i] < INFINITY);
}

static bool render_with_gl(struct csgcast_renderer *renderer, const struct csg_request *request)
{
    if (!csg_gl_enter(renderer->gl))
        return false;
    const double compiled = renderer->programs.compile_ms;
    csg_programs_begin(&renderer->programs);
    const bool drawn = csg_picture_render(renderer, request);
    renderer->has_drawn |= drawn;
    renderer->last_scene = request->scene->keeps_structure ? request->scene->number : 0;
    renderer->last_revision = request->scene->revision;
    renderer->stats.compile_ms = renderer->programs.compile_ms - compiled;
    renderer->stats.programs = renderer->programs.num_compiled;
    return csg_gl_leave(renderer->gl) && drawn;
}

/*
 * Shaders square distances in float: of a scene that reaches further from the eye than the one, or
 * not as far as the other, they would show nothing, or nonsense. The CPU casts these.
 */
#define MAX_DISTANCE 1e17
#define MIN_DISTANCE 1e-15

static bool is_within_float(const struct csg_request *request)
{
    double lo[3], hi[3], reach = 0;
    const double *eye = request->frustum.eye;
    if (!csgcast_scene_get_bounds(request->scene, lo, hi))
        return true;
    for (int i = 0; i < 3; i++)
        reach = fmax(reach, fmax(fabs(lo[i] - eye[i]), fabs(hi[i] - eye[i])));
    return (reach > MIN_DISTANCE && reach < MAX_DISTANCE) || isinf(reach);
}

/* A surface's turns around the eye are one number for all rays (src/pack/surface.c). */
static bool is_off_surfaces(const struct csg_request *request)
{
    const double *eye = request->frustum.eye;
    return request->frustum.orthographic || !request->scene->has_surfaces ||
           !csg_eye_is_on_surface(request->scene, csg_vec3_of(eye));
}

/* A context that could not be made says so once; every picture fails. */
static bool is_ready(struct csgcast_renderer *renderer)
{
    if (renderer->start)
        renderer->lost = !csg_start_join(renderer);
    return !renderer->lost;
}

/* last_scene is one that may be edited. Forced variants have the programs that they ask for. */
static bool is_settled(const struct csgcast_renderer *renderer, const struct csg_request *request)
{
    return renderer->last_scene == request->scene->number && request->resolver < 0 &&
           !request->textbook;
}

bool csgcast_render(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                    const struct csgcast_view *view, const struct csgcast_image *image)
{
    static const struct csgcast_view default_view;
    static const struct csgcast_image no_image;
    if (!renderer || !scene || !is_ready(renderer))
        return false;
    const double start = csg_clock_ms();
    struct csg_request request = {.scene = scene,
                                  .view = view ? view : &default_view,
                                  .tile_size = renderer->tile_size,
                                  .image = image ? image : &no_image};
    if (!resolve_request(renderer, &request))
        return false;
    request.settled = is_settled(renderer, &request);
    request.after_edit = request.settled && renderer->last_revision < scene->revision;
    renderer->stats = (struct csgcast_stats){.load_ms = scene->load_ms, .csg_ms = scene->csg_ms};
    const struct csg_reference_params params = {&request.frustum,        request.width,
                                                request.height,          request.scheme,
                                                request.view->cut_color, renderer->num_threads};
    const struct csg_reference_part whole = {.num_rows = request.height};
    const bool by_gl = renderer->gl && is_within_float(&request) && is_off_surfaces(&request);
    const bool ok = by_gl ? render_with_gl(renderer, &request)
                          : csg_reference_render(scene, &params, &whole, request.image) ||
                                csg_log_memory(&renderer->log);
    if (!by_gl)
        memcpy(renderer->stats.variants, "reference", sizeof "reference");
    if (ok)
        count_hits(renderer, &request);
    renderer->stats.frame_ms = csg_clock_ms() - start;
    return ok;
}

bool csgcast_renderer_warm(struct csgcast_renderer *renderer)
{
    if (!renderer || !is_ready(renderer))
        return false;
    if (!renderer->gl)
        return true;
    if (!csg_gl_enter(renderer->gl))
        return false;
    const bool ok = csg_warm_programs(renderer);
    return csg_gl_leave(renderer->gl) && ok;
}

void csgcast_renderer_get_stats(const struct csgcast_renderer *renderer,
                                struct csgcast_stats *stats)
{
    *stats = renderer ? renderer->stats : (struct csgcast_stats){0};
}
