/* SPDX-License-Identifier: MIT */
#include <stdatomic.h>
#include <string.h>

#include "common/parallel.h"
#include "csg/membership.h"
#include "reference/bounds.h"
#include "reference/reference.h"

struct job {
    const struct csgcast_scene *scene;
    const struct csg_reference_params *params;
    const struct csg_reference_part *part;
    const struct csgcast_image *image;
    const struct csg_tree_bounds *bounds; /* may be NULL */
    double near;                          /* where rays start */
    atomic_bool failed;
};

static struct csg_vec3 combine(const struct csgcast_frustum *frustum, double x, double y, double z)
{
    double v[3];
    for (int i = 0; i < 3; i++)
        v[i] = frustum->right[i] * x + frustum->up[i] * y + frustum->forward[i] * z;
    return csg_vec3_of(v);
}

/* Row 0 is on top. */
static struct csg_ray ray_of_pixel(const struct csg_reference_params *params, int x, int y)
{
    const struct csgcast_frustum *frustum = params->frustum;
    const double sx = ((x + 0.5) * 2 / params->width - 1) * frustum->half_width;
    const double sy = (1 - (y + 0.5) * 2 / params->height) * frustum->half_height;
    const struct csg_vec3 eye = csg_vec3(frustum->eye[0], frustum->eye[1], frustum->eye[2]);
    if (frustum->orthographic)
        return (struct csg_ray){csg_add(eye, combine(frustum, sx, sy, 0)),
                                combine(frustum, 0, 0, 1), -INFINITY};
    return (struct csg_ray){eye, combine(frustum, sx, sy, 1), 0};
}

/* The minuend of the object that the hit leaf is in. */
static const struct csg_leaf *minuend_of(const struct csgcast_scene *scene,
                                         const struct csg_hit *hit)
{
    const struct csg_tree *tree = &scene->trees[hit->layer];
    for (size_t i = 0; i < scene->objects->num; i++) {
        const struct csg_object *object = &scene->objects->data[i];
        for (uint32_t j = object->begin; object->layer == hit->layer && j < object->end; j++)
            if (tree->data[j].op == CSG_LEAF && tree->data[j].leaf == hit->leaf)
                return csg_object_minuend(scene, object);
    }
    return NULL;
}

/* Lit colour, r g b a. */
static void shade(const struct job *job, const struct csg_hit *hit, float rgba[4])
{
    const struct csg_leaf *leaf = &job->scene->leaves[hit->leaf];
    const struct csg_leaf *minuend =
        job->params->cut_color == CSGCAST_CUT_MINUEND ? minuend_of(job->scene, hit) : NULL;
    csg_face_color(job->params->scheme, leaf, minuend, hit->layer, hit->cut, rgba);
    const double light = csg_light_factor(job->params->frustum, hit->normal);
    for (int i = 0; i < 3; i++)
        rgba[i] = (float)fmin(rgba[i] * light, 1);
}

static void blend(float *below, const float above[4])
{
    for (int i = 0; i < 3; i++)
        below[i] += above[3] * (above[i] - below[i]);
}

static void overlay(const struct job *job, uint8_t layer, const struct csg_ray *ray, double t,
                    struct csg_ray_scratch *scratch, bool *failed, float *rgba)
{
    struct csg_hit hit;
    float color[4];
    if (!csg_reference_trace(job->scene, layer, ray, scratch, &hit, failed))
        return;
    if (hit.t > t * (1 + 1e-6))
        return;
    shade(job, &hit, color);
    blend(rgba, color);
}

static double near_of(const struct csgcast_scene *scene, const struct csg_reference_params *params)
{
    const double *eye = params->frustum->eye;
    return params->frustum->orthographic ? -INFINITY : csg_eye_near(scene, csg_vec3_of(eye));
}

/* Behind a translucent surface the reference shows the background. *failed: out of memory. */
static void cast_pixel(const struct job *job, int x, int y, struct csg_ray_scratch *scratch,
                       bool *failed)
{
    const struct csgcast_image *image = job->image;
    struct csg_ray ray = ray_of_pixel(job->params, x, y);
    ray.tnear = fmax(ray.tnear, job->near);
    const size_t index = (size_t)y * (size_t)job->params->width + (size_t)x;
    struct csg_hit hit = {.t = INFINITY};
    const bool found =
        csg_reference_trace(job->scene, CSG_LAYER_MODEL, &ray, scratch, &hit, failed);
    if (image->z)
        image->z[index] = (float)hit.t;
    if (image->id)
        image->id[index] = found ? (float)hit.leaf : -1;
    if (image->normal) {
        image->normal[3 * index] = (float)hit.normal.x;
        image->normal[3 * index + 1] = (float)hit.normal.y;
        image->normal[3 * index + 2] = (float)hit.normal.z;
    }
    if (!image->rgba && !image->rgba8)
        return;
    float rgba[4];
    for (int i = 0; i < 3; i++)
        rgba[i] = job->params->scheme->background[i];
    rgba[3] = 1;
    if (found) {
        float color[4];
        shade(job, &hit, color);
        blend(rgba, color);
    }
    overlay(job, CSG_LAYER_BACKGROUND, &ray, hit.t, scratch, failed, rgba);
    overlay(job, CSG_LAYER_HIGHLIGHT, &ray, hit.t, scratch, failed, rgba);
    if (image->rgba)
        memcpy(image->rgba + 4 * index, rgba, sizeof rgba);
    if (image->rgba8)
        csg_color_bytes(image->rgba8 + 4 * index, rgba, 4);
}

static void cast_row(void *user, size_t task)
{
    struct job *job = user;
    const struct csg_reference_part *part = job->part;
    const int y = part->first_row + (int)task;
    struct csg_ray_scratch *scratch = csg_ray_scratch_create(job->bounds);
    bool failed = !scratch;
    for (int x = 0; x < job->params->width && !failed; x++)
        if (!part->wants || part->wants(part->user, x, y))
            cast_pixel(job, x, y, scratch, &failed);
    if (failed)
        atomic_store(&job->failed, true);
    csg_ray_scratch_destroy(scratch);
}

bool csg_reference_render(const struct csgcast_scene *scene,
                          const struct csg_reference_params *params,
                          const struct csg_reference_part *part, const struct csgcast_image *image)
{
    struct csg_tree_bounds bounds = {.nodes = {NULL}};
    struct job job = {.scene = scene, .params = params, .part = part, .image = image};
    job.bounds = part->culls ? &bounds : NULL;
    job.near = near_of(scene, params);
    const bool ok = !part->culls || csg_tree_bounds_init(&bounds, scene);
    if (ok)
        csg_parallel(params->num_threads, (size_t)part->num_rows, cast_row, &job);
    csg_tree_bounds_finish(&bounds);
    return ok && !atomic_load(&job.failed);
}
