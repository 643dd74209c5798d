/* SPDX-License-Identifier: MIT */

/* A renderer that starts in the background draws what one does that is there at once, and tells its
 * failure in the thread that asks for a picture. */

#include <pthread.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "csgcast/csgcast.h"

enum { SIZE = 96, NUM = 4 * SIZE * SIZE };

struct heard {
    pthread_t thread;
    int num;
    bool foreign; /* some message came from another thread */
    char last[512];
};

static void hear(void *user, enum csgcast_log_level level, enum csgcast_message id,
                 const char *text)
{
    struct heard *heard = user;
    (void)level, (void)id;
    heard->num++;
    heard->foreign |= !pthread_equal(heard->thread, pthread_self());
    snprintf(heard->last, sizeof heard->last, "%s", text);
}

static struct csgcast_scene *make_scene(void)
{
    static const char text[] = "difference() { cube([9, 9, 9]); sphere(r = 6); }"
                               "color([1, 0, 0, 1]) cylinder(h = 14, r1 = 2, r2 = 1);";
    return csgcast_scene_parse(text, strlen(text), NULL);
}

static bool draw(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                 uint8_t *bytes, float *z)
{
    const struct csgcast_view view = {.width = SIZE, .height = SIZE};
    const struct csgcast_image colors = {.rgba8 = bytes}, depths = {.z = z};
    return csgcast_render(renderer, scene, &view, &colors) &&
           csgcast_render(renderer, scene, &view, &depths);
}

static void test_pictures(enum csgcast_backend backend)
{
    static uint8_t bytes[2][NUM];
    static float z[2][NUM / 4];
    struct csgcast_scene *scene = make_scene();
    for (int i = 0; i < 2; i++) {
        const struct csgcast_renderer_params params = {.backend = backend, .background = i == 1};
        struct csgcast_renderer *renderer = csgcast_renderer_create(&params);
        CHECK(renderer && draw(renderer, scene, bytes[i], z[i]), "backend %d", (int)backend);
        CHECK(strchr(csgcast_renderer_name(renderer), ':'), "%s", csgcast_renderer_name(renderer));
        csgcast_renderer_destroy(renderer);
    }
    CHECK(memcmp(bytes[0], bytes[1], sizeof *bytes) == 0, "backend %d", (int)backend);
    CHECK(memcmp(z[0], z[1], sizeof *z) == 0, "backend %d", (int)backend);
    CHECK(memcmp(bytes[0], bytes[0] + 4, NUM - 4) != 0, "an empty picture");
    csgcast_scene_destroy(scene);
}

static void test_failure(void)
{
    static uint8_t bytes[NUM];
    static float z[NUM / 4];
    struct heard heard = {.thread = pthread_self()};
    const struct csgcast_renderer_params params = {
        .background = true, .log = hear, .log_user = &heard};
    struct csgcast_scene *scene = make_scene();
    setenv("CSGCAST_EGL_DEVICE", "4711", 1);
    struct csgcast_renderer *renderer = csgcast_renderer_create(&params);
    CHECK(renderer != NULL, "create does not wait");
    CHECK(!draw(renderer, scene, bytes, z) && !draw(renderer, scene, bytes, z), "no such device");
    CHECK(heard.num == 1 && strstr(heard.last, "4711"), "%d messages: %s", heard.num, heard.last);
    CHECK(!heard.foreign, "a message from the thread");
    csgcast_renderer_destroy(renderer);
    csgcast_renderer_destroy(csgcast_renderer_create(&params));
    CHECK(heard.num == 1, "nobody asked: %s", heard.last);
    unsetenv("CSGCAST_EGL_DEVICE");
    csgcast_scene_destroy(scene);
}

int main(void)
{
    test_failure();
    test_pictures(CSGCAST_BACKEND_AUTO);
    test_pictures(CSGCAST_BACKEND_OSMESA);
    test_pictures(CSGCAST_BACKEND_REFERENCE);
    return num_failed ? 1 : 0;
}
