/* SPDX-License-Identifier: MIT */

/* Programs that no draw of the frame needs, but the next edit may, in scenes that are edited. */

#include <assert.h>

#include "crowd/crowd.h"
#include "render/chooser_parts.h"

/* Only frames that are not the first after an edit compile. */
static bool may_prepare(const struct csg_chooser *chooser)
{
    return chooser->request->scene->keeps_structure && !chooser->request->after_edit;
}

/* What tiles and cells need, and which of them it is, changes with each edit: in scenes that are
 * edited it is all there from the first frame on. false, with a message, on failure. */
bool csg_chooser_prepare_tiles(struct csg_chooser *chooser)
{
    enum csg_resolver resolver;
    if (chooser->tiles_prepared || !may_prepare(chooser))
        return true;
    chooser->tiles_prepared = true;
    for (int i = 0; i < CSG_NUM_CHAINS && !chooser->request->textbook; i++)
        if (chooser->may_chain[i] && csg_chain_is_general(i) && !csg_chooser_chain(chooser, i))
            return false;
    return csg_chooser_shared(chooser, CSG_RESOLVER_LOOP, CSG_FEATURE_QUADRIC | CSG_FEATURE_GAP,
                              &resolver) != 0;
}

bool csg_chooser_prepare_cells(struct csg_chooser *chooser, const struct csg_draw *draw)
{
    enum csg_resolver resolver;
    if (!draw->may_walk || !may_prepare(chooser) || chooser->prepared == draw->object + 1)
        return true;
    chooser->prepared = draw->object + 1;
    return csg_chooser_shared(chooser, CSG_RESOLVER_CELLS, csg_walk_features(chooser, draw),
                              &resolver) != 0;
}

/* An object that is drawn in tiles in one frame may be drawn whole in the next, and the other way
 * round. */
bool csg_chooser_prepare_whole(struct csg_chooser *chooser, const struct csg_draw *draw)
{
    const struct csg_request *request = chooser->request;
    if (!may_prepare(chooser) || draw->object == CSG_WHOLE_LAYER || draw->precise ||
        draw->around_eye || draw->walk || chooser->prepared_whole == draw->object + 1)
        return true;
    chooser->prepared_whole = draw->object + 1;
    const struct csg_structure structure = csg_chooser_structure(request, draw->object);
    if (request->shared || !csg_chooser_may_tile(request, &structure) ||
        !csg_structure_is_small(&structure) ||
        !csg_plan_is_common(request->scene->plan, draw->object))
        return true;
    return csg_chooser_prepare_tiles(chooser) &&
           (!csg_chooser_has_room(chooser, &structure, draw->stiff) ||
            csg_chooser_straight(chooser, &structure, draw->stiff,
                                 csg_structure_features(&structure) | csg_view_features(draw)));
}

static_assert(CSG_PLAN_MAX_PLANES == CSG_CROWD_MAX_PLANES, "members have programs of their own");

/* The programs of instances and of owned pixels. */
static bool prepare_run(struct csg_chooser *chooser, struct csg_crowd_run run)
{
    struct csg_programs *programs = &chooser->renderer->programs;
    const bool ok = csg_programs_get(programs, csg_source_single(&run, chooser->direct));
    run.owned = true;
    return ok && (chooser->request->scene->objects->num < CSG_MIN_OCCLUDERS ||
                  csg_programs_get(programs, csg_source_single(&run, chooser->direct)));
}

/* A solid that may be all that an edit leaves of an object. */
static bool prepare_left(struct csg_chooser *chooser, uint32_t leaf)
{
    const struct csg_shape *shape = &chooser->request->scene->leaves[leaf].shape;
    const struct csg_crowd_run run = {.has_quadric = shape->has_quadric,
                                      .num_planes = (uint32_t)shape->num_planes};
    struct csg_crowd_run ball = run; /* where there is no plane, it may be a sphere or none */
    ball.ball = run.has_quadric && run.num_planes == 0;
    return prepare_run(chooser, run) && prepare_run(chooser, ball);
}

static int all_features(const struct csgcast_scene *scene)
{
    return CSG_FEATURE_QUADRIC | CSG_FEATURE_GAP |
           (scene->plan->has_compounds ? CSG_FEATURE_SURFACE : 0) |
           (scene->plan->has_rings ? CSG_FEATURE_BANDS : 0);
}

/* The program of a resolver that draws any object, seen in any way; of bands there are two, see
 * more_than in render/chooser_programs.c. */
static bool prepare_any(struct csg_chooser *chooser, enum csg_resolver resolver, int features)
{
    enum csg_resolver chosen;
    return csg_chooser_shared(chooser, resolver, features | CSG_FEATURE_STIFF, &chosen) &&
           (!(features & CSG_FEATURE_BANDS) ||
            csg_chooser_shared(chooser, resolver, features, &chosen));
}

static bool prepare_general(struct csg_chooser *chooser, enum csg_resolver resolver,
                            enum csg_resolver precise)
{
    const int all = all_features(chooser->request->scene);
    return prepare_any(chooser, resolver, all) &&
           (!chooser->renderer->gl->has_double ||
            prepare_any(chooser, precise, all | CSG_FEATURE_DOUBLE));
}

static bool prepare_shade(struct csg_chooser *chooser, bool want_leaf, bool want_bytes)
{
    const int features = chooser->request->same_inputs ? CSG_FEATURE_SHARED : 0;
    return csg_programs_get(&chooser->renderer->programs,
                            csg_source_shade(want_leaf, want_bytes, features)) != 0;
}

/* Whatever channels the frame after an edit is asked for: picking asks for others than previews. */
static bool prepare_shades(struct csg_chooser *chooser)
{
    return prepare_shade(chooser, false, false) && prepare_shade(chooser, true, false) &&
           prepare_shade(chooser, false, true);
}

/* The same for what an edit makes translucent, or opaque: in a frame that is drawn directly there
 * is nothing translucent. */
static bool prepare_translucent(struct csg_chooser *chooser)
{
    struct csg_chooser *blended = csg_chooser_create(chooser->renderer, chooser->request, false);
    const bool ok =
        blended &&
        (!chooser->direct || prepare_general(blended, CSG_RESOLVER_LOOP, CSG_RESOLVER_DOUBLE)) &&
        prepare_general(blended, CSG_RESOLVER_REAR, CSG_RESOLVER_REAR);
    csg_chooser_destroy(blended);
    return ok;
}

bool csg_chooser_prepare(struct csg_chooser *chooser)
{
    const struct csg_plan *plan = chooser->request->scene->plan;
    bool ok = true;
    if (!may_prepare(chooser) || chooser->request->textbook || chooser->request->resolver >= 0)
        return true;
    for (size_t i = 0; i < plan->num_lefts && ok; i++)
        ok = prepare_left(chooser, plan->lefts[i]);
    return ok && prepare_general(chooser, CSG_RESOLVER_LOOP, CSG_RESOLVER_DOUBLE) &&
           prepare_translucent(chooser) && prepare_shades(chooser);
}

/* ---- the frame after an edit ---- */

static bool has_run(const struct csg_chooser *chooser, const struct csg_crowd_run *run)
{
    return csg_programs_known(&chooser->renderer->programs,
                              csg_source_single(run, chooser->direct)) != 0;
}

bool csg_chooser_make_do(const struct csg_chooser *chooser, struct csg_frame_params *params)
{
    const struct csg_frame *frame = &chooser->renderer->frame;
    bool can = true;
    for (size_t i = 0; i < frame->crowd.runs.num; i++) {
        const struct csg_crowd_run *run = &frame->crowd.runs.data[i];
        if (run->num == 0 || has_run(chooser, run))
            continue;
        params->crowds_without |= csg_crowd_run_bit(run);
        can = false;
    }
    for (size_t i = 0; i < frame->draws.num && can; i++) {
        const struct csg_draw *draw = &frame->draws.data[i];
        if (!draw->walk ||
            csg_chooser_knows(chooser, CSG_RESOLVER_CELLS, csg_walk_features(chooser, draw)))
            continue;
        params->cells = CSG_CELLS_NEVER;
        can = false;
    }
    return can;
}
