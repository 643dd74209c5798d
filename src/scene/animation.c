/* SPDX-License-Identifier: MIT */

/* A .scad file at moments of its $t. */

#include <stdlib.h>

#include "common/join.h"
#include "scene/load.h"

#define MAX_FRAMES 100000

struct csgcast_animation {
    char *path;
    struct csg_flattened flattened;
    struct csg_source *source; /* the parameters alone, and no text */
};

static struct csgcast_animation *fail(struct csgcast_animation *animation)
{
    csgcast_animation_destroy(animation);
    return NULL;
}

/* What the frames need later; the defines are done with when openscad has run. */
static bool keep(struct csgcast_animation *animation, const char *path,
                 const struct csgcast_scene_params *params)
{
    struct csgcast_scene_params placed = *params;
    char *own;
    const bool is_placed = csg_scene_place(&placed, path, &own);
    animation->path = csg_join(path, "");
    animation->source = is_placed ? csg_source_create(NULL, 0, &placed) : NULL;
    free(own);
    if (!animation->path || !animation->source)
        return false;
    animation->source->params.log = params->log;
    animation->source->params.log_user = params->log_user;
    return true;
}

struct csgcast_animation *csgcast_animation_load(const char *path, int num_frames,
                                                 const struct csgcast_scene_params *params)
{
    static const struct csgcast_scene_params default_params;
    const struct csgcast_scene_params *used = params ? params : &default_params;
    const struct csg_log log = {used->log, used->log_user};
    if (!path || num_frames < 1 || num_frames > MAX_FRAMES) {
        csg_log_error(&log, CSGCAST_MESSAGE_ARGUMENT,
                      "an animation needs a path and 1 to 100000 frames");
        return NULL;
    }
    if (!csg_scene_check(used, &log))
        return NULL;
    struct csgcast_animation *animation = calloc(1, sizeof *animation);
    if (!animation || !keep(animation, path, used)) {
        csg_log_memory(&log);
        return fail(animation);
    }
    const bool flat =
        csg_openscad_flatten(path, used, (size_t)num_frames, &log, &animation->flattened);
    return flat ? animation : fail(animation);
}

struct csgcast_scene *csgcast_animation_scene(const struct csgcast_animation *animation, int frame)
{
    if (!animation)
        return NULL;
    const struct csgcast_scene_params *params = &animation->source->params;
    const struct csg_log log = {params->log, params->log_user};
    if (frame < 0 || (size_t)frame >= animation->flattened.num_frames) {
        csg_log_error(&log, CSGCAST_MESSAGE_ARGUMENT, "the animation has no frame %d", frame);
        return NULL;
    }
    return csg_scene_of_frame(&animation->flattened, (size_t)frame, animation->path, params);
}

void csgcast_animation_destroy(struct csgcast_animation *animation)
{
    if (!animation)
        return;
    csg_flattened_finish(&animation->flattened);
    csg_source_destroy(animation->source);
    free(animation->path);
    free(animation);
}
