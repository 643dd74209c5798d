/* SPDX-License-Identifier: MIT */

/* Programs that no draw of the frame needs, but the next edit may, in scenes that are edited. */

#include <assert.h>

#include "crowd/crowd.h"
#include "render/chooser_parts.h"

/* What tiles and cells need, and which of them it is, changes with each edit: in scenes that are
 * edited it is all there from the first frame on. false, with a message, on failure. */
bool csg_chooser_prepare_tiles(struct csg_chooser *chooser)
{
    enum csg_resolver resolver;
    if (chooser->tiles_prepared || !chooser->request->scene->keeps_structure)
        return true;
    chooser->tiles_prepared = true;
    for (int i = 0; i < CSG_NUM_CHAINS && !chooser->request->textbook; i++)
        if (!csg_chooser_chain(chooser, i))
            return false;
    return csg_chooser_shared(chooser, CSG_RESOLVER_LOOP, CSG_FEATURE_QUADRIC | CSG_FEATURE_GAP,
                              &resolver) != 0;
}

bool csg_chooser_prepare_cells(struct csg_chooser *chooser, const struct csg_draw *draw)
{
    enum csg_resolver resolver;
    if (!draw->may_walk || !chooser->request->scene->keeps_structure ||
        chooser->prepared == draw->object + 1)
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
    if (!request->scene->keeps_structure || draw->object == CSG_WHOLE_LAYER || draw->precise ||
        draw->around_eye || draw->walk || chooser->prepared_whole == draw->object + 1)
        return true;
    chooser->prepared_whole = draw->object + 1;
    const struct csg_structure structure = csg_chooser_structure(request, draw->object);
    if (request->shared || request->scene->objects->data[draw->object].crowded ||
        !csg_chooser_may_tile(request, &structure) || !csg_structure_is_small(&structure))
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

/* An object that may be drawn by itself where it is in a crowd now. */
static bool prepare_object(struct csg_chooser *chooser, uint32_t object)
{
    const struct csg_structure structure = csg_chooser_structure(chooser->request, object);
    const int features = csg_structure_features(&structure);
    enum csg_resolver resolver;
    if (csg_structure_is_small(&structure) && csg_chooser_has_room(chooser, &structure, false))
        return csg_chooser_straight(chooser, &structure, false, features) != 0;
    return csg_chooser_shared(chooser, CSG_RESOLVER_LOOP, features, &resolver) != 0;
}

static bool may_change(const struct csg_request *request)
{
    return request->scene->keeps_structure && !request->textbook && request->resolver < 0;
}

bool csg_chooser_prepare(struct csg_chooser *chooser)
{
    const struct csg_plan *plan = chooser->request->scene->plan;
    bool ok = true;
    if (!may_change(chooser->request))
        return true;
    for (size_t i = 0; i < plan->num_lefts && ok; i++)
        ok = prepare_left(chooser, plan->lefts[i]);
    for (size_t i = 0; i < plan->num_singles && ok; i++)
        ok = prepare_object(chooser, plan->singles[i]);
    return ok;
}

bool csg_chooser_prepare_spared(struct csg_chooser *chooser)
{
    const struct csg_plan *plan = chooser->request->scene->plan;
    bool ok = true;
    for (size_t i = 0; i < plan->num_spared && may_change(chooser->request) && ok; i++)
        ok = chooser->request->shared || prepare_object(chooser, plan->spared[i]);
    return ok;
}
