/* SPDX-License-Identifier: MIT */
#include "render/renderer.h"

#include <stdlib.h>
#include <string.h>

/* Structures that get straight-line programs of their own, at most; the others share the loop.
 * Each costs 5 to 100 ms to compile where the driver's disk cache does not know it. */
#define MAX_STRAIGHT_PROGRAMS 8

/* Program of a structure that this frame has met already. */
struct known {
    const struct csg_step *steps; /* of the first object that has it */
    size_t num;
    bool stiff;
    GLuint program;
};

struct chooser {
    struct csgcast_renderer *renderer;
    const struct csg_request *request;
    struct known straight[MAX_STRAIGHT_PROGRAMS];
    size_t num_straight;
    GLuint surfaces[CSG_NUM_FEATURE_SETS];
    GLuint loops[CSG_NUM_FEATURE_SETS], sorted[CSG_NUM_FEATURE_SETS], rears[CSG_NUM_FEATURE_SETS]; /* by features */
    GLuint cpu;                 /* for what needs double without having it */
    size_t max_handed;          /* flat inputs that the driver allows */
};

static struct csg_structure structure_of(const struct csg_request *request, uint32_t object)
{
    const struct csg_plan *plan = request->scene->plan;
    return (struct csg_structure){plan->program.data + plan->begin[object],
                                  plan->begin[object + 1] - plan->begin[object], request->scene};
}

bool csg_draws_whole(size_t object, const void *user)
{
    const struct csg_request *request = user;
    const struct csg_structure structure = structure_of(request, (uint32_t)object);
    if (request->scene->objects->data[object].crowded)
        return false;
    if (request->resolver == CSG_RESOLVER_ALGORITHM4)
        return csg_structure_crossings(&structure) <= CSG_ALGORITHM4_MAX_CROSSINGS;
    return csg_structure_is_small(&structure);
}

static bool same_leaf_shape(const struct csgcast_scene *scene, uint32_t a, uint32_t b)
{
    return scene->leaves[a].shape.num_planes == scene->leaves[b].shape.num_planes;
}

/* Same flags, planes and file order of the leaves: the same straight-line text. */
static bool same_structure(const struct csg_structure *a, bool stiff, const struct known *b)
{
    if (a->num != b->num || stiff != b->stiff)
        return false;
    for (size_t i = 0; i < a->num; i++) {
        const struct csg_step *x = &a->steps[i], *y = &b->steps[i];
        if (x->flags != y->flags)
            return false;
        if (x->flags & CSG_RECORD_POP)
            continue;
        if (!same_leaf_shape(a->scene, x->leaf, y->leaf))
            return false;
        for (size_t j = 0; j < i; j++)
            if (!(a->steps[j].flags & CSG_RECORD_POP) &&
                (x->leaf < a->steps[j].leaf) != (y->leaf < b->steps[j].leaf))
                return false;
    }
    return true;
}

static struct known *find_straight(struct chooser *chooser, const struct csg_structure *structure,
                                   bool stiff)
{
    for (size_t i = 0; i < chooser->num_straight; i++)
        if (same_structure(structure, stiff, &chooser->straight[i]))
            return &chooser->straight[i];
    return NULL;
}

static GLuint compile(struct chooser *chooser, enum csg_resolver resolver,
                      const struct csg_structure *structure, int features)
{
    features |= chooser->request->textbook ? CSG_FEATURE_TEXTBOOK : 0;
    return csg_programs_get(&chooser->renderer->programs,
                            csg_source_geometry(resolver, features, structure,
                                                chooser->max_handed));
}

static GLuint choose_straight(struct chooser *chooser, const struct csg_structure *structure,
                              bool stiff, int features)
{
    struct known *known = find_straight(chooser, structure, stiff);
    if (known)
        return known->program;
    const GLuint program = compile(chooser, CSG_RESOLVER_STRAIGHT, structure, features);
    if (program)
        chooser->straight[chooser->num_straight++] =
            (struct known){structure->steps, structure->num, stiff, program};
    return program;
}

static bool can_be_straight(struct chooser *chooser, const struct csg_structure *structure,
                            const struct csg_draw *draw)
{
    return !draw->around_eye && csg_structure_is_small(structure) &&
           (chooser->num_straight < MAX_STRAIGHT_PROGRAMS ||
            find_straight(chooser, structure, draw->stiff));
}

/* What a draw's program must do because of this view. */
static int view_features(const struct csg_draw *draw)
{
    return (draw->stiff ? CSG_FEATURE_STIFF : 0) | (draw->precise ? CSG_FEATURE_DOUBLE : 0) |
           (draw->surface ? CSG_FEATURE_SURFACE : 0);
}

static enum csg_resolver choose_resolver(struct chooser *chooser,
                                         const struct csg_structure *structure,
                                         const struct csg_draw *draw)
{
    const int forced = chooser->request->resolver;
    if (draw->precise)
        return CSG_RESOLVER_DOUBLE;
    if (forced == CSG_RESOLVER_LOOP)
        return CSG_RESOLVER_LOOP;
    if (forced == CSG_RESOLVER_ALGORITHM4)
        return csg_structure_crossings(structure) <= CSG_ALGORITHM4_MAX_CROSSINGS
                   ? CSG_RESOLVER_ALGORITHM4
                   : CSG_RESOLVER_LOOP;
    return can_be_straight(chooser, structure, draw) ? CSG_RESOLVER_STRAIGHT : CSG_RESOLVER_LOOP;
}

/* A program that any structure with these features can use. */
static GLuint choose_shared(struct chooser *chooser, enum csg_resolver resolver, int features,
                            enum csg_resolver *chosen)
{
    GLuint *shared = resolver == CSG_RESOLVER_REAR         ? chooser->rears
                     : resolver == CSG_RESOLVER_SURFACE    ? chooser->surfaces
                     : resolver == CSG_RESOLVER_ALGORITHM4 ? chooser->sorted
                                                           : chooser->loops;
    *chosen = resolver;
    if (!shared[features])
        shared[features] = compile(chooser, resolver, NULL, features);
    return shared[features];
}

static bool is_for_cpu(const struct chooser *chooser, const struct csg_draw *draw)
{
    return draw->precise && !chooser->renderer->gl->has_double;
}

static GLuint choose_cpu(struct chooser *chooser, enum csg_resolver *resolver)
{
    *resolver = CSG_RESOLVER_CPU;
    if (!chooser->cpu)
        chooser->cpu = compile(chooser, CSG_RESOLVER_CPU, NULL, 0);
    return chooser->cpu;
}

/* A surface alone in its tile counts as the loop, which draws the same. */
static GLuint choose_surface(struct chooser *chooser, const struct csg_draw *draw,
                             enum csg_resolver *resolver)
{
    const GLuint program =
        choose_shared(chooser, CSG_RESOLVER_SURFACE, view_features(draw), resolver);
    *resolver = draw->precise ? CSG_RESOLVER_DOUBLE : CSG_RESOLVER_LOOP;
    return program;
}

static GLuint choose_program(struct chooser *chooser, const struct csg_draw *draw,
                             enum csg_resolver *resolver)
{
    if (is_for_cpu(chooser, draw))
        return choose_cpu(chooser, resolver);
    if (draw->surface_alone && chooser->request->resolver != CSG_RESOLVER_LOOP)
        return choose_surface(chooser, draw, resolver);
    if (draw->tile)
        return choose_shared(chooser, draw->precise ? CSG_RESOLVER_DOUBLE : CSG_RESOLVER_LOOP,
                             CSG_FEATURE_QUADRIC | CSG_FEATURE_GAP | view_features(draw), resolver);
    const struct csg_structure structure = structure_of(chooser->request, draw->object);
    *resolver = choose_resolver(chooser, &structure, draw);
    const int features = csg_structure_features(&structure) | view_features(draw);
    if (*resolver == CSG_RESOLVER_STRAIGHT)
        return choose_straight(chooser, &structure, draw->stiff, features);
    return choose_shared(chooser, *resolver, features, resolver);
}

/* An upper bound of the turns of a loop program over the draw's records: every pass looks at all of
 * them, and a ray cannot stop more often than it has crossings. */
static bool may_give_up(const struct csg_frame *frame, const struct csg_draw *draw)
{
    double turns = 0, leaves = 0;
    for (int32_t p = draw->instance.records[0]; p < draw->instance.records[1];) {
        const float *head = frame->texels.data + 4 * (size_t)p;
        const int entries = (int)head[0], exits = (int)head[1], flags = (int)head[2];
        const bool surface = flags & CSG_RECORD_SURFACE;
        const double longest = surface ? (double)head[4 * 2 + 1] : 0;
        turns += surface ? 5 + longest : 4 + (entries + 1) / 2 + (exits + 1) / 2;
        leaves += surface ? 1 + longest / 4 : 1;
        const int terms = entries + exits + (flags & CSG_RECORD_QUADRIC ? CSG_QUADRIC_TEXELS : 0);
        p += 1 + (draw->precise && !surface ? 2 : 1) * terms;
    }
    return turns * (4 * leaves + 3) >= CSG_MAX_TURNS;
}

static bool add_draw(struct csg_batches *batches, const struct csg_draw *draw, GLuint program,
                     GLuint rear, enum csg_resolver resolver, uint32_t instance)
{
    struct csg_batch *last = batches->num ? &batches->data[batches->num - 1] : NULL;
    if (resolver == CSG_RESOLVER_CPU)
        batches->on_cpu++;
    else
        batches->drawn[resolver]++;
    const bool alone = draw->translucent || draw->paint != CSG_LAYER_MODEL;
    if (last && last->program == program && last->layer == draw->layer &&
        (!alone || last->object == draw->object) &&
        last->paint == draw->paint && last->translucent == draw->translucent &&
        last->rear == rear) {
        last->num++;
        return true;
    }
    const struct csg_batch batch = {
        program, rear, draw->layer, draw->paint, draw->translucent, draw->object, instance, 1, NULL};
    return csg_array_push(batches, batch);
}

/* What is drawn translucent and is one convex leaf shows its far side. */
static bool choose_rear(struct chooser *chooser, const struct csg_draw *draw, GLuint *rear)
{
    enum csg_resolver resolver;
    const bool shows = draw->single && !is_for_cpu(chooser, draw) && (draw->translucent || draw->paint != CSG_LAYER_MODEL);
    *rear = shows ? choose_shared(chooser, CSG_RESOLVER_REAR,
                                  CSG_FEATURE_QUADRIC | view_features(draw), &resolver)
                  : 0;
    return !shows || *rear;
}

/* One flat input goes to csg_object; more than 28 cost llvmpipe more than they save. */
static size_t max_handed(struct csg_gl *gl)
{
    GLint components = 0;
    gl->GetIntegerv(GL_MAX_VARYING_COMPONENTS, &components);
    const GLint num = components / 4 - 1;
    return num < 1 ? 1 : num > 28 ? 28 : (size_t)num;
}

/* Crowds share no carriers with other objects, so file order does not matter between them. */
static bool add_crowd(struct csg_batches *batches, struct csgcast_renderer *renderer)
{
    const struct csg_frame_crowd *crowd = &renderer->frame.crowd;
    for (size_t i = 0; i < crowd->runs.num; i++) {
        const struct csg_crowd_run *run = &crowd->runs.data[i];
        if (run->num == 0)
            continue;
        const GLuint program = csg_programs_get(
            &renderer->programs, csg_source_single(run->has_quadric, run->num_planes));
        const struct csg_batch batch = {.program = program,
                                        .layer = CSG_LAYER_MODEL,
                                        .paint = CSG_LAYER_MODEL,
                                        .object = CSG_WHOLE_LAYER,
                                        .num = (uint32_t)run->num,
                                        .run = run};
        if (!program)
            return false;
        if (!csg_array_push(batches, batch))
            return csg_log_memory(&renderer->log);
        batches->drawn_single += run->num;
    }
    return true;
}

bool csg_batches_fill(struct csg_batches *batches, struct csgcast_renderer *renderer,
                      const struct csg_request *request)
{
    struct chooser *chooser = calloc(1, sizeof *chooser);
    bool ok = chooser != NULL;
    if (!ok)
        csg_log_memory(&renderer->log);
    else
        *chooser = (struct chooser){
            .renderer = renderer, .request = request, .max_handed = max_handed(renderer->gl)};
    for (uint32_t i = 0; i < renderer->frame.draws.num && ok; i++) {
        const struct csg_draw *draw = &renderer->frame.draws.data[i];
        enum csg_resolver resolver = CSG_RESOLVER_STRAIGHT;
        GLuint rear = 0;
        const GLuint program = choose_program(chooser, draw, &resolver);
        ok = program != 0 && choose_rear(chooser, draw, &rear);
        renderer->stats.overflowed_objects +=
            request->resolver == CSG_RESOLVER_ALGORITHM4 && resolver == CSG_RESOLVER_LOOP &&
            (i == 0 || draw[-1].object != draw->object);
        batches->may_give_up |=
            resolver == CSG_RESOLVER_CPU ||
            (resolver != CSG_RESOLVER_STRAIGHT && may_give_up(&renderer->frame, draw));
        if (ok && !add_draw(batches, draw, program, rear, resolver, i))
            ok = csg_log_memory(&renderer->log);
    }
    free(chooser);
    return ok && add_crowd(batches, renderer);
}
