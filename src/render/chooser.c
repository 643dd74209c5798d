/* SPDX-License-Identifier: MIT */
#include "render/chooser.h"

#include <stdlib.h>

#include "render/chooser_parts.h"

/* Objects of several steps are drawn in tiles where steps times pixels are more than this: a tile
 * leaves out most of the solids, and all where it is empty, but takes as long to make as some
 * hundred pixels, on one core, and several programs where it would be one. */
#define MAX_STEP_PIXELS 3e5

/* The same for objects of any steps whose structure has no program of its own, which the loop
 * draws. */
#define MAX_LOOP_STEP_PIXELS 2e3

/* A frame that has spent that on compiling compiles no further chain. A driver's cache has one in 1
 * to 3 ms. */
#define MAX_COMPILE_MS 10

struct csg_structure csg_chooser_structure(const struct csg_request *request, uint32_t object)
{
    const struct csg_plan *plan = request->scene->plan;
    return (struct csg_structure){plan->program.data + plan->begin[object],
                                  plan->begin[object + 1] - plan->begin[object], request->scene};
}

/* A picture alone has programs of their own for single solids only, whichever they are; the first of
 * several for what the scene has many of, too. */
static bool may_be_straight(const struct csg_request *request,
                            const struct csg_structure *structure, size_t object)
{
    const struct csg_plan *plan = request->scene->plan;
    if (!request->shared)
        return csg_plan_is_common(plan, object);
    return structure->num == 1 || (request->first && csg_plan_is_frequent(plan, object));
}

/* Whether a small structure with a program of its own is drawn in one piece only where it covers
 * few pixels. */
bool csg_chooser_may_tile(const struct csg_request *request, const struct csg_structure *structure)
{
    return request->resolver < 0 && !request->textbook && structure->num > 1;
}

/* What a draw's program must do because of this view. */
int csg_view_features(const struct csg_draw *draw)
{
    return (draw->stiff ? CSG_FEATURE_STIFF : 0) | (draw->precise ? CSG_FEATURE_DOUBLE : 0) |
           (draw->surface ? CSG_FEATURE_SURFACE : 0) | (draw->bands ? CSG_FEATURE_BANDS : 0);
}

int csg_walk_features(const struct csg_chooser *chooser, const struct csg_draw *draw)
{
    const struct csg_structure structure = csg_chooser_structure(chooser->request, draw->object);
    return csg_structure_features(&structure) | csg_view_features(draw) |
           (draw->nested ? CSG_FEATURE_NESTED : 0) | (draw->bunched ? CSG_FEATURE_BUNCHES : 0);
}

bool csg_draws_whole(size_t object, double area, const void *user)
{
    const struct csg_request *request = user;
    const struct csg_structure structure = csg_chooser_structure(request, (uint32_t)object);
    if (request->tile_size || request->resolver == CSG_RESOLVER_CHAIN ||
        request->resolver == CSG_RESOLVER_CELLS ||
        (request->shared && !may_be_straight(request, &structure, object)))
        return false;
    if (request->resolver == CSG_RESOLVER_ALGORITHM4)
        return csg_structure_crossings(&structure) <= CSG_ALGORITHM4_MAX_CROSSINGS;
    const double cost = (double)structure.num * area;
    const bool small = csg_structure_is_small(&structure);
    if (may_be_straight(request, &structure, object))
        return small && (!csg_chooser_may_tile(request, &structure) || cost <= MAX_STEP_PIXELS);
    return small && (request->resolver >= 0 || request->textbook || cost <= MAX_LOOP_STEP_PIXELS);
}

/* Straight-line code takes half of the planes of paired leaves for exits, as they always are but
 * for the rounding of planes along the rays. */
static bool has_exits(const struct csg_chooser *chooser, const struct csg_structure *structure,
                      const struct csg_draw *draw)
{
    const float *head =
        chooser->renderer->frame.texels.data + 4 * (size_t)draw->instance.records[0];
    for (size_t i = 0; i < structure->num; i++) {
        const uint32_t flags = structure->steps[i].flags;
        const uint32_t leaf = structure->steps[i].leaf;
        if (!(flags & CSG_RECORD_POP) && head[0] > head[1] &&
            csg_shape_is_paired(&structure->scene->leaves[leaf].shape))
            return false;
        head += 4 * (1 + csg_record_terms(head));
    }
    return true;
}

static bool can_be_straight(struct csg_chooser *chooser, const struct csg_structure *structure,
                            const struct csg_draw *draw)
{
    return !draw->around_eye && csg_structure_is_small(structure) &&
           (chooser->request->textbook || has_exits(chooser, structure, draw)) &&
           may_be_straight(chooser->request, structure, draw->object) &&
           csg_chooser_has_room(chooser, structure, draw->stiff);
}

static enum csg_resolver choose_resolver(struct csg_chooser *chooser,
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

static bool is_for_cpu(const struct csg_chooser *chooser, const struct csg_draw *draw)
{
    return draw->precise && !chooser->renderer->gl->has_double;
}

static bool is_drawn_alone(const struct csg_chooser *chooser, const struct csg_draw *draw)
{
    return draw->surface_alone && chooser->request->resolver != CSG_RESOLVER_LOOP &&
           (!chooser->request->after_edit ||
            csg_chooser_knows(chooser, CSG_RESOLVER_SURFACE, csg_view_features(draw)));
}

/* A view that moves is not to stop for all chains that it asks for: while the driver takes its time
 * for them they come one a frame, and those that there are do for the others. Scenes that may be
 * edited have those for any tile from the first frame on. */
static bool may_compile_chain(const struct csg_chooser *chooser)
{
    const struct csg_request *request = chooser->request;
    const double compiled = chooser->renderer->programs.compile_ms - chooser->compiled_ms;
    return !request->settled &&
           (request->scene->keeps_structure || request->resolver >= 0 || compiled < MAX_COMPILE_MS);
}

/* The smallest chain that can be used for that; -1: none. */
static int fit_chain(const struct csg_chooser *chooser, const struct csg_chain_need *needed)
{
    const bool may_compile = may_compile_chain(chooser);
    for (int i = 0; i < CSG_NUM_CHAINS; i++)
        if (chooser->may_chain[i] && (chooser->chains[i] || may_compile) &&
            csg_chain_fits(i, needed))
            return i;
    return -1;
}

/* Tiles hold trees of any kind; most are chains. */
static bool is_chain(const struct csg_chooser *chooser, const struct csg_draw *draw)
{
    const struct csg_request *request = chooser->request;
    const bool wanted = request->resolver < 0 || request->resolver == CSG_RESOLVER_STRAIGHT ||
                        request->resolver == CSG_RESOLVER_CHAIN;
    return wanted && draw->chain.slots > 0 && !draw->stiff && !draw->precise && !draw->around_eye &&
           !request->textbook && !(request->shared && draw->chain.clauses);
}

static int find_chain(const struct csg_chooser *chooser, const struct csg_draw *draw)
{
    if (!is_chain(chooser, draw))
        return -1;
    return chooser->common_chain >= 0 ? chooser->common_chain : fit_chain(chooser, &draw->chain);
}

/* One picture does not repay what several chains take to compile or to read from the driver's
 * cache: the smallest one that covers all tiles draws them. */
static int find_common_chain(const struct csg_chooser *chooser)
{
    const struct csg_frame *frame = &chooser->renderer->frame;
    struct csg_chain_need all = {.planes = CSG_CHAIN_PLANES};
    for (size_t i = 0; i < frame->draws.num && chooser->request->shared; i++) {
        const struct csg_draw *draw = &frame->draws.data[i];
        if (!is_chain(chooser, draw))
            continue;
        all.slots = draw->chain.slots > all.slots ? draw->chain.slots : all.slots;
        all.quadrics |= draw->chain.quadrics;
    }
    return all.slots > 0 ? fit_chain(chooser, &all) : -1;
}

struct csg_way csg_chooser_way(struct csg_chooser *chooser, const struct csg_draw *draw)
{
    const int features = csg_view_features(draw);
    if (is_for_cpu(chooser, draw))
        return (struct csg_way){CSG_RESOLVER_CPU, 0, -1};
    if (draw->walk)
        return (struct csg_way){CSG_RESOLVER_CELLS, csg_walk_features(chooser, draw), -1};
    if (is_drawn_alone(chooser, draw))
        return (struct csg_way){CSG_RESOLVER_SURFACE, features, -1};
    const int chain = find_chain(chooser, draw);
    if (chain >= 0)
        return (struct csg_way){CSG_RESOLVER_CHAIN, 0, chain};
    if (draw->tile)
        return (struct csg_way){draw->precise ? CSG_RESOLVER_DOUBLE : CSG_RESOLVER_LOOP,
                                CSG_FEATURE_QUADRIC | CSG_FEATURE_GAP | features, -1};
    const struct csg_structure structure = csg_chooser_structure(chooser->request, draw->object);
    return (struct csg_way){choose_resolver(chooser, &structure, draw),
                            csg_structure_features(&structure) | features, -1};
}

static GLuint choose_straight(struct csg_chooser *chooser, const struct csg_draw *draw,
                              const struct csg_way *way, enum csg_resolver *resolver)
{
    const struct csg_structure structure = csg_chooser_structure(chooser->request, draw->object);
    const GLuint straight = csg_chooser_straight(chooser, &structure, draw->stiff, way->features);
    return straight || !chooser->request->after_edit
               ? straight
               : csg_chooser_shared(chooser, CSG_RESOLVER_LOOP, way->features, resolver);
}

/* A surface alone in its tile counts as the loop, which draws the same. */
static GLuint choose_surface(struct csg_chooser *chooser, const struct csg_draw *draw,
                             const struct csg_way *way, enum csg_resolver *resolver)
{
    const GLuint program =
        csg_chooser_shared(chooser, CSG_RESOLVER_SURFACE, way->features, resolver);
    *resolver = draw->precise ? CSG_RESOLVER_DOUBLE : CSG_RESOLVER_LOOP;
    return program;
}

static GLuint choose_program(struct csg_chooser *chooser, const struct csg_draw *draw,
                             enum csg_resolver *resolver)
{
    if (((draw->tile || draw->walk) && !csg_chooser_prepare_tiles(chooser)) ||
        !csg_chooser_prepare_cells(chooser, draw) || !csg_chooser_prepare_whole(chooser, draw))
        return 0;
    const struct csg_way way = csg_few_way(chooser, draw, csg_chooser_way(chooser, draw));
    *resolver = way.resolver;
    switch (way.resolver) {
    case CSG_RESOLVER_CPU:
        return csg_chooser_cpu(chooser, resolver);
    case CSG_RESOLVER_SURFACE:
        return choose_surface(chooser, draw, &way, resolver);
    case CSG_RESOLVER_CHAIN:
        return csg_chooser_chain(chooser, way.chain);
    case CSG_RESOLVER_STRAIGHT:
        return choose_straight(chooser, draw, &way, resolver);
    default:
        return csg_chooser_shared(chooser, way.resolver, way.features, resolver);
    }
}

static bool choose_rear(struct csg_chooser *chooser, const struct csg_draw *draw, GLuint *rear)
{
    enum csg_resolver resolver;
    const bool shows = draw->has_rear && !is_for_cpu(chooser, draw);
    const int features =
        CSG_FEATURE_QUADRIC | (draw->single ? 0 : CSG_FEATURE_GAP) | csg_view_features(draw);
    *rear = shows ? csg_chooser_shared(chooser, CSG_RESOLVER_REAR, features, &resolver) : 0;
    return !shows || *rear;
}

/* Five flat inputs are the object's, the screen's and the light; more than 27 others cost llvmpipe
 * more than they save. */
size_t csg_max_handed(struct csg_gl *gl)
{
    GLint components = 0;
    gl->GetIntegerv(GL_MAX_VARYING_COMPONENTS, &components);
    const GLint num = components / 4 - 5;
    return num < 1 ? 1 : num > 27 ? 27 : (size_t)num;
}

static int max_point(struct csg_gl *gl)
{
    GLfloat range[2] = {1, 1};
    gl->GetFloatv(GL_POINT_SIZE_RANGE, range);
    return (int)range[1];
}

/* After an edit, and in a picture alone, a program that can do more may take the place of the one
 * that is asked for. Scenes that may be edited have the same answer in all frames, as instances
 * that are the same are not handed over again. */
static int possible_features(const struct csg_chooser *chooser, const struct csg_draw *draw)
{
    const struct csgcast_scene *scene = chooser->request->scene;
    if (scene->keeps_structure || chooser->few.features >= 0)
        return CSG_FEATURE_SURFACE | CSG_FEATURE_BANDS;
    return csg_view_features(draw) | (!draw->tile && scene->has_surfaces ? CSG_FEATURE_SURFACE : 0);
}

bool csg_chooser_choose(struct csg_chooser *chooser, const struct csg_draw *draw,
                        struct csg_choice *choice)
{
    choice->point = draw->instance.side > 0 && draw->instance.side <= chooser->max_point &&
                    !chooser->few.no_points;
    choice->features = possible_features(chooser, draw);
    choice->program = choose_program(chooser, draw, &choice->resolver);
    return choice->program != 0 && choose_rear(chooser, draw, &choice->rear);
}

struct csg_chooser *csg_chooser_create(struct csgcast_renderer *renderer,
                                       const struct csg_request *request, bool direct)
{
    struct csg_chooser *chooser = calloc(1, sizeof *chooser);
    if (!chooser)
        return NULL;
    chooser->renderer = renderer;
    chooser->request = request;
    chooser->direct = direct;
    chooser->max_handed = csg_max_handed(renderer->gl);
    chooser->max_point = max_point(renderer->gl);
    chooser->compiled_ms = renderer->programs.compile_ms;
    for (int i = 0; i < CSG_NUM_CHAINS; i++) {
        chooser->may_chain[i] = csg_chain_size(i, direct) <= chooser->max_handed;
        chooser->chains[i] = csg_chooser_known_chain(chooser, i);
    }
    chooser->common_chain = -1;
    chooser->common_chain = find_common_chain(chooser);
    if (csg_few_find(chooser))
        return chooser;
    csg_chooser_destroy(chooser);
    return NULL;
}

void csg_chooser_destroy(struct csg_chooser *chooser)
{
    if (chooser)
        free(chooser->few.ways.data);
    free(chooser);
}
