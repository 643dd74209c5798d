/* SPDX-License-Identifier: MIT */
#include "render/chooser.h"

#include <stdlib.h>

#include "crowd/crowd.h"
#include "render/structures.h"

/* Structures of more steps are drawn in tiles where steps times pixels are more than this: a tile
 * leaves out most of the solids, but takes as long to make as some hundred pixels. */
#define MANY_STEPS 10
#define MAX_STEP_PIXELS 3e5

struct csg_chooser {
    struct csgcast_renderer *renderer;
    const struct csg_request *request;
    struct csg_known_structures straight;
    GLuint surfaces[CSG_NUM_FEATURE_SETS];
    GLuint loops[CSG_NUM_FEATURE_SETS], sorted[CSG_NUM_FEATURE_SETS], rears[CSG_NUM_FEATURE_SETS];
    GLuint cells[CSG_NUM_FEATURE_SETS];
    GLuint cpu; /* for what needs double without having it */
    GLuint chains[CSG_NUM_CHAINS];
    int common_chain; /* that all tiles take which are chains; -1: each its own */
    bool tiles_prepared, direct;
    uint32_t prepared;       /* the object whose cells' program is there, + 1 */
    uint32_t prepared_whole; /* ... whose programs for tiles and for all of it are */
    size_t max_handed;       /* flat inputs that the driver allows */
    int max_point;           /* pixels of a point's side */
};

static struct csg_structure structure_of(const struct csg_request *request, uint32_t object)
{
    const struct csg_plan *plan = request->scene->plan;
    return (struct csg_structure){plan->program.data + plan->begin[object],
                                  plan->begin[object + 1] - plan->begin[object], request->scene};
}

/* Whether a small structure is drawn in one piece only where it covers few pixels. */
static bool may_be_tiled(const struct csg_request *request, const struct csg_structure *structure)
{
    return request->resolver < 0 && !request->textbook && structure->num > MANY_STEPS;
}

bool csg_draws_whole(size_t object, double area, const void *user)
{
    const struct csg_request *request = user;
    const struct csg_structure structure = structure_of(request, (uint32_t)object);
    if (request->scene->objects->data[object].crowded || request->tile_size ||
        request->resolver == CSG_RESOLVER_CHAIN || request->resolver == CSG_RESOLVER_CELLS ||
        (request->shared && structure.num > 1))
        return false;
    if (request->resolver == CSG_RESOLVER_ALGORITHM4)
        return csg_structure_crossings(&structure) <= CSG_ALGORITHM4_MAX_CROSSINGS;
    return csg_structure_is_small(&structure) &&
           (!may_be_tiled(request, &structure) || (double)structure.num * area <= MAX_STEP_PIXELS);
}

static int frame_features(const struct csg_chooser *chooser)
{
    return (chooser->direct ? CSG_FEATURE_DIRECT : 0) |
           (chooser->request->shared ? CSG_FEATURE_SHARED : 0);
}

static GLuint compile(struct csg_chooser *chooser, enum csg_resolver resolver,
                      const struct csg_structure *structure, int features)
{
    features |= chooser->request->textbook ? CSG_FEATURE_TEXTBOOK : 0;
    features |= frame_features(chooser);
    return csg_programs_get(
        &chooser->renderer->programs,
        csg_source_geometry(resolver, features, structure, chooser->max_handed));
}

/* What a program is noted under that needs no structure: a chain is a resolver of its own. */
static uint32_t name_of(const struct csg_chooser *chooser, enum csg_resolver resolver, int chain,
                        int features)
{
    const int all = features | frame_features(chooser) |
                    (chooser->request->textbook ? CSG_FEATURE_TEXTBOOK : 0);
    return (uint32_t)all << 16 | (uint32_t)(chain + 1) << 8 | ((uint32_t)resolver + 1);
}

/* The program of a resolver that needs no structure. */
static GLuint compile_shared(struct csg_chooser *chooser, enum csg_resolver resolver, int features)
{
    struct csg_programs *programs = &chooser->renderer->programs;
    const uint32_t name = name_of(chooser, resolver, -1, features);
    const GLuint noted = csg_programs_noted(programs, name);
    if (noted)
        return noted;
    const GLuint program = compile(chooser, resolver, NULL, features);
    csg_programs_note(programs, program, name);
    return program;
}

static GLuint choose_straight(struct csg_chooser *chooser, const struct csg_structure *structure,
                              bool stiff, int features)
{
    const GLuint known = csg_structures_find(&chooser->straight, structure, stiff);
    if (known)
        return known;
    const GLuint program = compile(chooser, CSG_RESOLVER_STRAIGHT, structure, features);
    if (program)
        csg_structures_add(&chooser->straight, structure, stiff, program);
    return program;
}

/* Whether a structure can have a program of its own: there is one, or room for one. */
static bool has_room(const struct csg_chooser *chooser, const struct csg_structure *structure,
                     bool stiff)
{
    return chooser->straight.num < CSG_MAX_STRAIGHT_PROGRAMS ||
           csg_structures_find(&chooser->straight, structure, stiff);
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
        head += 4 * (1 + (int)head[0] + (int)head[1] +
                     (flags & CSG_RECORD_QUADRIC ? CSG_QUADRIC_TEXELS : 0));
    }
    return true;
}

static bool can_be_straight(struct csg_chooser *chooser, const struct csg_structure *structure,
                            const struct csg_draw *draw)
{
    return !draw->around_eye && csg_structure_is_small(structure) &&
           (chooser->request->textbook || has_exits(chooser, structure, draw)) &&
           (structure->num == 1 || !chooser->request->shared) &&
           has_room(chooser, structure, draw->stiff);
}

/* What a draw's program must do because of this view. */
static int view_features(const struct csg_draw *draw)
{
    return (draw->stiff ? CSG_FEATURE_STIFF : 0) | (draw->precise ? CSG_FEATURE_DOUBLE : 0) |
           (draw->surface ? CSG_FEATURE_SURFACE : 0) | (draw->bands ? CSG_FEATURE_BANDS : 0);
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

/* A program that any structure with these features can use. */
static GLuint choose_shared(struct csg_chooser *chooser, enum csg_resolver resolver, int features,
                            enum csg_resolver *chosen)
{
    GLuint *shared = resolver == CSG_RESOLVER_REAR         ? chooser->rears
                     : resolver == CSG_RESOLVER_CELLS      ? chooser->cells
                     : resolver == CSG_RESOLVER_SURFACE    ? chooser->surfaces
                     : resolver == CSG_RESOLVER_ALGORITHM4 ? chooser->sorted
                                                           : chooser->loops;
    *chosen = resolver;
    if (!shared[features])
        shared[features] = compile_shared(chooser, resolver, features);
    return shared[features];
}

static bool is_for_cpu(const struct csg_chooser *chooser, const struct csg_draw *draw)
{
    return draw->precise && !chooser->renderer->gl->has_double;
}

static GLuint choose_cpu(struct csg_chooser *chooser, enum csg_resolver *resolver)
{
    *resolver = CSG_RESOLVER_CPU;
    if (!chooser->cpu)
        chooser->cpu = compile_shared(chooser, CSG_RESOLVER_CPU, 0);
    return chooser->cpu;
}

/* A surface alone in its tile counts as the loop, which draws the same. */
static GLuint choose_surface(struct csg_chooser *chooser, const struct csg_draw *draw,
                             enum csg_resolver *resolver)
{
    const GLuint program =
        choose_shared(chooser, CSG_RESOLVER_SURFACE, view_features(draw), resolver);
    *resolver = draw->precise ? CSG_RESOLVER_DOUBLE : CSG_RESOLVER_LOOP;
    return program;
}

/* Tiles hold trees of any kind; most are chains. */
static int find_chain(const struct csg_chooser *chooser, const struct csg_draw *draw)
{
    const struct csg_request *request = chooser->request;
    const bool wanted = request->resolver < 0 || request->resolver == CSG_RESOLVER_STRAIGHT ||
                        request->resolver == CSG_RESOLVER_CHAIN;
    const float *texels = chooser->renderer->frame.texels.data;
    if (!wanted || !draw->tile || draw->stiff || draw->precise || draw->around_eye ||
        request->textbook)
        return -1;
    const int chain = csg_chain_find(texels, (size_t)draw->instance.records[0],
                                     (size_t)draw->instance.records[1]);
    const size_t size = chain < 0 ? 0 : csg_chain_size(chain, chooser->direct);
    if (chain >= 0 && chooser->common_chain >= 0)
        return chooser->common_chain;
    return size <= chooser->max_handed ? chain : -1;
}

/* One picture does not repay what several chains take to compile or to read from the driver's
 * cache: the smallest one that covers all tiles draws them. */
static int find_common_chain(const struct csg_chooser *chooser)
{
    const struct csg_frame *frame = &chooser->renderer->frame;
    struct csg_chain all = {0};
    for (size_t i = 0; i < frame->draws.num && chooser->request->shared; i++) {
        const int chain = find_chain(chooser, &frame->draws.data[i]);
        if (chain < 0)
            continue;
        all.slots = csg_chains[chain].slots > all.slots ? csg_chains[chain].slots : all.slots;
        all.quadrics |= csg_chains[chain].quadrics;
    }
    for (int i = 0; i < CSG_NUM_CHAINS && all.slots > 0; i++)
        if (all.slots <= csg_chains[i].slots && all.quadrics == csg_chains[i].quadrics)
            return csg_chain_size(i, chooser->direct) <= chooser->max_handed ? i : -1;
    return -1;
}

static GLuint compile_chain(struct csg_chooser *chooser, int chain)
{
    struct csg_programs *programs = &chooser->renderer->programs;
    const uint32_t name = name_of(chooser, CSG_RESOLVER_CHAIN, chain, 0);
    const GLuint noted = csg_programs_noted(programs, name);
    if (noted)
        return noted;
    const GLuint program =
        csg_programs_get(programs, csg_source_geometry_chain(chain, frame_features(chooser)));
    csg_programs_note(programs, program, name);
    return program;
}

static GLuint choose_chain(struct csg_chooser *chooser, int chain)
{
    if (!chooser->chains[chain])
        chooser->chains[chain] = compile_chain(chooser, chain);
    return chooser->chains[chain];
}

/* What tiles and cells need, and which of them it is, changes with each edit: in scenes that are
 * edited it is all there from the first frame on. false, with a message, on failure. */
static bool prepare_tiles(struct csg_chooser *chooser)
{
    enum csg_resolver resolver;
    if (chooser->tiles_prepared || !chooser->request->scene->keeps_structure)
        return true;
    chooser->tiles_prepared = true;
    for (int i = 0; i < CSG_NUM_CHAINS && !chooser->request->textbook; i++)
        if (!choose_chain(chooser, i))
            return false;
    return choose_shared(chooser, CSG_RESOLVER_LOOP, CSG_FEATURE_QUADRIC | CSG_FEATURE_GAP,
                         &resolver) != 0;
}

static int walk_features(const struct csg_chooser *chooser, const struct csg_draw *draw)
{
    const struct csg_structure structure = structure_of(chooser->request, draw->object);
    return csg_structure_features(&structure) | view_features(draw) |
           (draw->nested ? CSG_FEATURE_NESTED : 0) | (draw->bunched ? CSG_FEATURE_BUNCHES : 0);
}

static bool prepare_cells(struct csg_chooser *chooser, const struct csg_draw *draw)
{
    enum csg_resolver resolver;
    if (!draw->may_walk || !chooser->request->scene->keeps_structure ||
        chooser->prepared == draw->object + 1)
        return true;
    chooser->prepared = draw->object + 1;
    return choose_shared(chooser, CSG_RESOLVER_CELLS, walk_features(chooser, draw), &resolver) != 0;
}

/* An object that is drawn in tiles in one frame may be drawn whole in the next, and the other way
 * round. */
static bool prepare_whole(struct csg_chooser *chooser, const struct csg_draw *draw)
{
    const struct csg_request *request = chooser->request;
    if (!request->scene->keeps_structure || draw->object == CSG_WHOLE_LAYER || draw->precise ||
        draw->around_eye || draw->walk || chooser->prepared_whole == draw->object + 1)
        return true;
    chooser->prepared_whole = draw->object + 1;
    const struct csg_structure structure = structure_of(request, draw->object);
    if (request->shared || request->scene->objects->data[draw->object].crowded ||
        !may_be_tiled(request, &structure) || !csg_structure_is_small(&structure))
        return true;
    return prepare_tiles(chooser) &&
           (!has_room(chooser, &structure, draw->stiff) ||
            choose_straight(chooser, &structure, draw->stiff,
                            csg_structure_features(&structure) | view_features(draw)));
}

static GLuint choose_program(struct csg_chooser *chooser, const struct csg_draw *draw,
                             enum csg_resolver *resolver)
{
    if (((draw->tile || draw->walk) && !prepare_tiles(chooser)) || !prepare_cells(chooser, draw) ||
        !prepare_whole(chooser, draw))
        return 0;
    if (is_for_cpu(chooser, draw))
        return choose_cpu(chooser, resolver);
    if (draw->walk)
        return choose_shared(chooser, CSG_RESOLVER_CELLS, walk_features(chooser, draw), resolver);
    if (draw->surface_alone && chooser->request->resolver != CSG_RESOLVER_LOOP)
        return choose_surface(chooser, draw, resolver);
    const int chain = find_chain(chooser, draw);
    *resolver = CSG_RESOLVER_CHAIN;
    if (chain >= 0)
        return choose_chain(chooser, chain);
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

static bool choose_rear(struct csg_chooser *chooser, const struct csg_draw *draw, GLuint *rear)
{
    enum csg_resolver resolver;
    const bool shows = draw->has_rear && !is_for_cpu(chooser, draw);
    const int features =
        CSG_FEATURE_QUADRIC | (draw->single ? 0 : CSG_FEATURE_GAP) | view_features(draw);
    *rear = shows ? choose_shared(chooser, CSG_RESOLVER_REAR, features, &resolver) : 0;
    return !shows || *rear;
}

/* Five flat inputs are the object's, the screen's and the light; more than 27 others cost llvmpipe
 * more than they save. */
static size_t max_handed(struct csg_gl *gl)
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

bool csg_chooser_choose(struct csg_chooser *chooser, const struct csg_draw *draw,
                        struct csg_choice *choice)
{
    choice->draw = *draw;
    choice->point = draw->instance.side > 0 && draw->instance.side <= chooser->max_point;
    choice->draw.instance.side = choice->point ? draw->instance.side : 0;
    choice->program = choose_program(chooser, draw, &choice->resolver);
    return choice->program != 0 && choose_rear(chooser, draw, &choice->rear);
}

/* The programs of instances and of owned pixels. */
static bool prepare_run(struct csg_chooser *chooser, struct csg_crowd_run run)
{
    struct csg_programs *programs = &chooser->renderer->programs;
    const bool ok = csg_programs_get(programs, csg_source_single(&run, chooser->direct));
    run.owned = true;
    return ok && (chooser->request->scene->objects->num < CSG_MIN_OCCLUDERS ||
                  csg_programs_get(programs, csg_source_single(&run, chooser->direct)));
}

/* Both programs of an object that is one solid: an edit may take it into the crowd or out of it. */
static bool prepare_single(struct csg_chooser *chooser, uint32_t object,
                           bool seen[2][CSG_CROWD_MAX_PLANES + 1])
{
    const struct csg_structure structure = structure_of(chooser->request, object);
    if (structure.num != 1)
        return true;
    const struct csg_shape *shape = &chooser->request->scene->leaves[structure.steps[0].leaf].shape;
    if (shape->num_planes > CSG_CROWD_MAX_PLANES || shape->surface ||
        seen[shape->has_quadric][shape->num_planes])
        return true;
    seen[shape->has_quadric][shape->num_planes] = true;
    const struct csg_crowd_run run = {.has_quadric = shape->has_quadric,
                                      .num_planes = (uint32_t)shape->num_planes};
    struct csg_crowd_run ball = run; /* where there is no plane, it may be a sphere or none */
    ball.ball = run.has_quadric && run.num_planes == 0;
    return prepare_run(chooser, run) && prepare_run(chooser, ball) &&
           (!has_room(chooser, &structure, false) ||
            choose_straight(chooser, &structure, false, csg_structure_features(&structure)));
}

bool csg_chooser_prepare(struct csg_chooser *chooser)
{
    const struct csg_request *request = chooser->request;
    bool seen[2][CSG_CROWD_MAX_PLANES + 1] = {{false}};
    bool ok = true;
    if (!request->scene->keeps_structure || request->textbook || request->resolver >= 0)
        return true;
    for (uint32_t i = 0; i < request->scene->objects->num && ok; i++)
        ok = prepare_single(chooser, i, seen);
    return ok;
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
    chooser->max_handed = max_handed(renderer->gl);
    chooser->max_point = max_point(renderer->gl);
    chooser->common_chain = -1;
    chooser->common_chain = find_common_chain(chooser);
    return chooser;
}

void csg_chooser_destroy(struct csg_chooser *chooser)
{
    free(chooser);
}
