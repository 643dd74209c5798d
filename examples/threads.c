/* SPDX-License-Identifier: MIT */

/*
 * threads [BACKEND]: several threads, each with a renderer of its own. All of them read one scene
 * at the same time, and each edits another one that is its alone. egl (the default), osmesa or
 * reference; with 1 thread each for what a picture needs, so that they do not fight for the cores.
 */

#include <csgcast/csgcast.h>

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

enum { num_workers = 2, num_rounds = 3, size = 64 };

static const char shared_text[] = "union() { cube(10, center = true);\n"
                                  "translate([0, 0, 10]) sphere(5); }\n";
static const char own_text[] = "difference() { cube(10, center = true);\n"
                               "cylinder(h = 20, r = 2, center = true); }\n";

struct worker {
    pthread_t thread;
    enum csgcast_backend backend;
    const struct csgcast_scene *shared;
    double expected; /* height of the shared scene's middle */
    bool ok;
};

/* The distance that the middle of the picture is away, seen from (x, 0, 100) straight down. */
static double look_down(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                        double x)
{
    float z[size * size];
    const struct csgcast_image image = {.z = z};
    struct csgcast_view view = {.width = size, .height = size};
    view.camera.kind = CSGCAST_CAMERA_VECTOR;
    view.camera.eye[0] = view.camera.center[0] = x;
    view.camera.eye[2] = 100;
    if (!csgcast_render(renderer, scene, &view, &image))
        return -1;
    return (double)z[size / 2 * size + size / 2];
}

/* The cube with a hole that gets wider than the cube: in the end nothing is left. */
static bool edit_own(struct csgcast_renderer *renderer, struct csgcast_scene *own)
{
    return isinf(look_down(renderer, own, 0)) && look_down(renderer, own, 3) < 100 &&
           csgcast_scene_set_parameters(own, 1, "h = 20, r = 4, center = true") &&
           isinf(look_down(renderer, own, 3)) &&
           csgcast_scene_set_parameters(own, 1, "h = 20, r = 2, center = true");
}

static void *work(void *user)
{
    struct worker *worker = user;
    const struct csgcast_renderer_params params = {.backend = worker->backend, .num_threads = 1};
    struct csgcast_renderer *renderer = csgcast_renderer_create(&params);
    struct csgcast_scene *own = csgcast_scene_parse(own_text, strlen(own_text), NULL);
    worker->ok = renderer && own;
    for (int i = 0; i < num_rounds && worker->ok; i++) {
        const double z = look_down(renderer, worker->shared, 0);
        worker->ok = fabs(z - worker->expected) < 0.1 && edit_own(renderer, own);
    }
    csgcast_scene_destroy(own);
    csgcast_renderer_destroy(renderer);
    return NULL;
}

static enum csgcast_backend backend_of(const char *name)
{
    return !strcmp(name, "reference") ? CSGCAST_BACKEND_REFERENCE
           : !strcmp(name, "osmesa")  ? CSGCAST_BACKEND_OSMESA
                                      : CSGCAST_BACKEND_EGL;
}

int main(int argc, char **argv)
{
    struct worker workers[num_workers];
    struct csgcast_scene *shared = csgcast_scene_parse(shared_text, strlen(shared_text), NULL);
    int num = 0;
    bool ok = shared != NULL;
    for (; num < num_workers && ok; num++) {
        workers[num] = (struct worker){.shared = shared, .expected = 100 - 15};
        workers[num].backend = backend_of(argc > 1 ? argv[1] : "egl");
        ok = pthread_create(&workers[num].thread, NULL, work, &workers[num]) == 0;
        num -= !ok;
    }
    for (int i = 0; i < num; i++) {
        pthread_join(workers[i].thread, NULL);
        ok = ok && workers[i].ok;
    }
    csgcast_scene_destroy(shared);
    printf("%s\n", ok ? "all threads saw what they should" : "something is wrong");
    return !ok;
}
