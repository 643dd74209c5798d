/* SPDX-License-Identifier: MIT */
/* Arguments that make no sense: the call says so and fails, and what it was given still works. */
#include <string.h>

#include "check.h"
#include "csgcast/csgcast.h"

static int num_errors;

static void count(void *user, enum csgcast_log_level level, enum csgcast_message id,
                  const char *text)
{
    (void)user, (void)text;
    num_errors += level == CSGCAST_LOG_ERROR && id == CSGCAST_MESSAGE_ARGUMENT;
}

#define FAILS(call)                                                                                \
    do {                                                                                           \
        const int before = num_errors;                                                             \
        CHECK(!(call), "is accepted");                                                             \
        CHECK(num_errors == before + 1, "%d messages", num_errors - before);                       \
    } while (0)

static struct csgcast_scene *parse(const struct csgcast_scene_params *params)
{
    return csgcast_scene_parse("cube(10);", 9, params);
}

static void test_scenes(void)
{
    const struct csgcast_scene_params facets = {.log = count, .facets = (enum csgcast_facets)77};
    const struct csgcast_scene_params fonts = {.log = count, .num_fonts = 2};
    const struct csgcast_scene_params defines = {.log = count, .num_defines = 1};
    FAILS(parse(&facets));
    FAILS(parse(&fonts));
    FAILS(parse(&defines));
    FAILS(csgcast_scene_load("x.csg", &fonts));
    FAILS(csgcast_animation_load("x.scad", 2, &fonts));
}

static void test_views(struct csgcast_scene *scene)
{
    const struct csgcast_view kind = {.camera = {.kind = (enum csgcast_camera_kind)3}};
    const struct csgcast_view projection = {
        .camera = {.projection = (enum csgcast_projection) - 1}};
    const struct csgcast_view color = {.cut_color = (enum csgcast_cut_color)2};
    struct csgcast_frustum frustum;
    FAILS(csgcast_view_resolve(scene, &kind, &frustum));
    FAILS(csgcast_view_resolve(scene, &projection, &frustum));
    FAILS(csgcast_view_resolve(scene, &color, &frustum));
    CHECK(csgcast_view_resolve(scene, NULL, &frustum), "the default view");
}

static void test_edits(struct csgcast_scene *scene)
{
    FAILS(csgcast_scene_edit(scene, NULL, 2));
    CHECK(csgcast_scene_edit(scene, NULL, 0), "no edits are none");
    CHECK(csgcast_scene_set_parameters(scene, 0, "size = 3"), "the scene can be edited still");
}

static void test_fixed(void)
{
    const struct csgcast_scene_params fixed = {.log = count, .fixed = true};
    struct csgcast_scene *scene = parse(&fixed);
    struct csgcast_leaf leaf;
    CHECK(scene, "no scene");
    FAILS(csgcast_scene_set_parameters(scene, 0, "size = 3"));
    FAILS(csgcast_scene_get_leaf(scene, 0, &leaf));
    csgcast_scene_destroy(scene);
}

int main(void)
{
    const struct csgcast_scene_params params = {.log = count};
    struct csgcast_scene *scene = parse(&params);
    CHECK(scene, "no scene");
    test_scenes();
    test_views(scene);
    test_edits(scene);
    test_fixed();
    csgcast_scene_destroy(scene);
    return num_failed > 0;
}
