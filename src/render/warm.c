/* SPDX-License-Identifier: MIT */

/*
 * Drawing nothing, so that a driver has compiled what pictures ask for: a little of it while a
 * renderer starts, or all that its cache can keep for other processes. Drivers compile when they
 * first draw, for the state that they draw in: the same passes therefore draw it as in a picture.
 */

#include <stdlib.h>
#include <string.h>

#include "common/clock.h"
#include "prepare/scene.h"
#include "render/chooser.h"
#include "render/picture.h"

#define PROGRESS_AFTER_MS 1000

static int shared_feature(const struct csgcast_renderer *renderer)
{
    return renderer->gl->is_llvmpipe ? CSG_FEATURE_SHARED : 0;
}

/* ---- while a renderer starts ---- */

void csg_warm_up(struct csgcast_renderer *renderer)
{
    const struct csg_request request = {
        .scheme = csg_colorscheme_find(NULL), .width = 1, .height = 1, .resolver = -1};
    struct csg_picture picture = {.renderer = renderer,
                                  .gl = renderer->gl,
                                  .request = &request,
                                  .num_rows = 1,
                                  .bytes = true,
                                  .rect = {-1, -1, 1, 1}};
    const struct csg_targets_use use = {.bytes = true};
    if (!csg_gl_enter(renderer->gl))
        return;
    picture.shade = csg_programs_get(&renderer->programs,
                                     csg_source_shade(false, true, shared_feature(renderer)));
    if (picture.shade && csg_upload_frame(renderer, &picture.batches, false) &&
        csg_targets_resize(&renderer->targets, renderer->gl, 1, 1, &use)) {
        csg_passes_draw_nothing(&picture);
        renderer->gl->Finish();
    }
    csg_gl_leave(renderer->gl);
}

/* ---- what pictures of most scenes take ---- */

#define GENERAL (CSG_FEATURE_QUADRIC | CSG_FEATURE_GAP)

/* Of tiles that are no chains. */
static const struct way {
    enum csg_resolver resolver;
    int features;
} ways[] = {
    {CSG_RESOLVER_LOOP, GENERAL},
    {CSG_RESOLVER_LOOP, GENERAL | CSG_FEATURE_SURFACE},
    {CSG_RESOLVER_LOOP, GENERAL | CSG_FEATURE_STIFF},
    {CSG_RESOLVER_LOOP, GENERAL | CSG_FEATURE_BANDS},
    {CSG_RESOLVER_LOOP, GENERAL | CSG_FEATURE_BANDS | CSG_FEATURE_STIFF},
    {CSG_RESOLVER_DOUBLE, GENERAL | CSG_FEATURE_DOUBLE},
    {CSG_RESOLVER_DOUBLE, GENERAL | CSG_FEATURE_DOUBLE | CSG_FEATURE_SURFACE},
    {CSG_RESOLVER_SURFACE, CSG_FEATURE_SURFACE},
    {CSG_RESOLVER_SURFACE, CSG_FEATURE_SURFACE | CSG_FEATURE_DOUBLE},
};

/* Of the far sides of single solids, of objects, and of those with surfaces. */
static const int rears[] = {CSG_FEATURE_QUADRIC, GENERAL, GENERAL | CSG_FEATURE_SURFACE};

/* Single solids, of each number of planes that has a program of its own. */
static const char *const solids[] = {
    "sphere($fn = 0, r = 1);",
    "cylinder($fn = 0, h = 1, r1 = 1, r2 = 1);",
    "cylinder($fn = 3, h = 1, r1 = 1, r2 = 0);",
    "cylinder($fn = 3, h = 1, r1 = 1, r2 = 1);",
    "cube([1, 1, 1]);",
    "cylinder($fn = 4, h = 1, r1 = 2, r2 = 1);",
    "cylinder($fn = 5, h = 1, r1 = 1, r2 = 1);",
    "cylinder($fn = 6, h = 1, r1 = 1, r2 = 1);",
    "cylinder($fn = 6, h = 1, r1 = 2, r2 = 1);",
};

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

/* A picture of nothing, drawn again and again. */
struct warming {
    struct csgcast_renderer *renderer;
    struct csg_request request;
    struct csg_picture picture;
    struct csg_batch batch;
    double told;
    int num_drawn;
};

static void tell(struct warming *warming)
{
    const double now = csg_clock_ms();
    warming->num_drawn++;
    if (now - warming->told < PROGRESS_AFTER_MS)
        return;
    warming->told = now;
    csg_log_print(&warming->renderer->log, CSGCAST_LOG_INFO, CSGCAST_MESSAGE_PROGRESS,
                  "%d programs compiled", warming->num_drawn);
}

static bool prepare_shading(struct warming *warming, bool want_leaf, bool bytes)
{
    struct csg_picture *picture = &warming->picture;
    picture->want_geometry = picture->want_leaf = want_leaf;
    picture->bytes = bytes;
    picture->shade =
        csg_programs_get(&warming->renderer->programs,
                         csg_source_shade(want_leaf, bytes, shared_feature(warming->renderer)));
    return picture->shade != 0;
}

/* Objects that hardly overlap need a depth buffer where colours are drawn directly, a single one
 * does not. Squares are drawn as points where there are many. */
static void draw_all_forms(struct warming *warming)
{
    struct csg_picture *picture = &warming->picture;
    const size_t num_forms = picture->batches.direct ? 2 : 1;
    for (size_t i = 0; i < 2 * num_forms; i++) {
        warming->renderer->frame.draws.num = 1 + i % num_forms;
        warming->batch.points = i >= num_forms;
        csg_passes_draw_strip(picture);
    }
    picture->gl->Finish();
}

static bool draw(struct warming *warming, struct csg_stages stages, bool direct)
{
    warming->batch.program = csg_programs_get(&warming->renderer->programs, stages);
    warming->picture.batches.direct = direct;
    if (!warming->batch.program)
        return false;
    draw_all_forms(warming);
    tell(warming);
    return true;
}

static bool draw_chains(struct warming *warming, int features)
{
    const bool direct = features & CSG_FEATURE_DIRECT;
    bool ok = true;
    for (int i = 0; i < CSG_NUM_CHAINS && ok; i++)
        if (csg_chain_size(i, direct) <= csg_max_handed(warming->renderer->gl))
            ok = draw(warming, csg_source_geometry_chain(i, features), direct);
    return ok;
}

static struct csg_stages source_of(const struct warming *warming, const struct way *way,
                                   const struct csg_structure *structure, int features)
{
    return csg_source_geometry(way->resolver, way->features | features, structure,
                               csg_max_handed(warming->renderer->gl));
}

static bool draw_ways(struct warming *warming, int features)
{
    const bool has_double = warming->renderer->gl->has_double;
    bool ok = true;
    for (int i = 0; i < COUNT(ways) && ok; i++)
        if (has_double || !(ways[i].features & CSG_FEATURE_DOUBLE))
            ok = draw(warming, source_of(warming, &ways[i], NULL, features),
                      features & CSG_FEATURE_DIRECT);
    return ok;
}

static bool draw_solid(struct warming *warming, const char *text, int features)
{
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), NULL);
    if (!scene)
        return false;
    const struct csg_structure structure = {scene->plan->program.data, 1, scene};
    const struct way way = {CSG_RESOLVER_STRAIGHT, csg_structure_features(&structure)};
    const bool ok = draw(warming, source_of(warming, &way, &structure, features),
                         features & CSG_FEATURE_DIRECT);
    csgcast_scene_destroy(scene);
    return ok;
}

static bool draw_solids(struct warming *warming, int features)
{
    bool ok = true;
    for (int i = 0; i < COUNT(solids) && ok; i++)
        ok = draw_solid(warming, solids[i], features);
    return ok;
}

/* Behind what is translucent; that is blended, which takes floats. */
static bool draw_rears(struct warming *warming, int features)
{
    bool ok = prepare_shading(warming, false, false);
    warming->batch.translucent = true;
    for (int i = 0; i < COUNT(rears) && ok; i++) {
        const struct way way = {CSG_RESOLVER_REAR, rears[i]};
        warming->batch.rear = csg_programs_get(&warming->renderer->programs,
                                               source_of(warming, &way, NULL, features));
        ok = warming->batch.rear &&
             draw(warming, source_of(warming, &ways[0], NULL, features), false);
    }
    warming->batch.translucent = false;
    warming->batch.rear = 0;
    return ok;
}

/* With distances, normals and leaves. */
static bool draw_channels(struct warming *warming, int features)
{
    return prepare_shading(warming, true, false) &&
           draw(warming, source_of(warming, &ways[0], NULL, features), false);
}

static bool draw_all(struct warming *warming)
{
    const int shared = shared_feature(warming->renderer), direct = shared | CSG_FEATURE_DIRECT;
    return prepare_shading(warming, false, true) && draw_solids(warming, direct) &&
           draw_chains(warming, direct) && draw_ways(warming, direct) &&
           draw_solids(warming, shared) && draw_chains(warming, shared) &&
           draw_ways(warming, shared) && draw_rears(warming, shared) &&
           draw_channels(warming, shared);
}

/* Two objects of no size. */
static bool fill_frame(struct warming *warming)
{
    struct csg_frame *frame = &warming->renderer->frame;
    frame->draws.num = frame->texels.num = 0; /* of a picture before */
    for (uint32_t i = 0; i < 2; i++)
        if (!csg_array_push(&frame->draws, ((struct csg_draw){.object = i})))
            return false;
    return csg_array_push(&warming->picture.batches.order, 0);
}

static bool prepare_targets(struct warming *warming)
{
    static const struct csg_targets_use uses[] = {
        {.direct = true, .bytes = true}, {.bytes = true}, {.geometry = true, .leaf = true}};
    bool ok = true;
    for (int i = 0; i < COUNT(uses) && ok; i++)
        ok = csg_targets_resize(&warming->renderer->targets, warming->renderer->gl, 1, 1, &uses[i]);
    return ok;
}

bool csg_warm_programs(struct csgcast_renderer *renderer)
{
    struct warming warming = {
        .renderer = renderer,
        .request = {.scheme = csg_colorscheme_find(NULL), .width = 1, .height = 1, .resolver = -1},
        .batch = {.num = 1},
        .told = csg_clock_ms()};
    warming.picture = (struct csg_picture){.renderer = renderer,
                                           .gl = renderer->gl,
                                           .request = &warming.request,
                                           .num_rows = 1,
                                           .rect = {-1, -1, 1, 1}};
    struct csg_batches *batches = &warming.picture.batches;
    batches->data = &warming.batch;
    batches->num = 1;
    bool ok = fill_frame(&warming) || csg_log_memory(&renderer->log);
    ok = ok && prepare_targets(&warming) && csg_upload_frame(renderer, batches, false);
    if (ok)
        csg_picture_bind_textures(&warming.picture);
    ok = ok && draw_all(&warming);
    renderer->gl->ends_display = true;
    free(batches->order.data);
    return ok;
}
