/* SPDX-License-Identifier: MIT */
#include "compare_view.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define DEFAULT_SIZE 384 /* pixels: four views in three columns make a picture of 1184 x 1632 */

/* What is a wrong depth: OpenSCAD writes STL in float and .csg with six digits, which nested maps
 * multiply. Relative to the distance, and to the largest coordinate across the surface. */
static const double depth_tolerance = 3e-5, rounding_tolerance = 2e-6;

/* Without --camera: the scene in view from above and below, in both projections. */
static const struct {
    const char *label;
    double rotate[3];
    enum csgcast_projection projection;
} default_views[CSG_COMPARE_MAX_VIEWS] = {
    {"default view", {55, 0, 25}, CSGCAST_PERSPECTIVE},
    {"from below", {125, 0, 205}, CSGCAST_PERSPECTIVE},
    {"left, orthographic", {70, 0, 290}, CSGCAST_ORTHOGRAPHIC},
    {"top, orthographic", {20, 10, 120}, CSGCAST_ORTHOGRAPHIC},
};

static const double default_fov = 22.5; /* degrees, as csgcast_camera's 0 */

/* Facets of a pentagon deviate by 36 degrees from the circle's normal. */
static const double same_surface_cosine = 0.7;

static struct csgcast_view view_of(const struct csg_compared *compared, int number,
                                   const char **label)
{
    struct csgcast_view view = compared->options->view;
    struct csgcast_camera *camera = &view.camera;
    view.width = view.width ? view.width : DEFAULT_SIZE;
    view.height = view.height ? view.height : DEFAULT_SIZE;
    *label = "view";
    if (compared->num_views == 1)
        return view;
    *label = default_views[number].label;
    camera->kind = CSGCAST_CAMERA_GIMBAL;
    memcpy(camera->rotate, default_views[number].rotate, sizeof camera->rotate);
    camera->distance = 1;
    camera->viewall = camera->autocenter = true;
    if (camera->projection == CSGCAST_PERSPECTIVE)
        camera->projection = default_views[number].projection;
    return view;
}

/* How far the exact surface is from the plane of the mesh's facet there. */
static double across(const struct csg_compared_view *view, const float *z_written, size_t i)
{
    const struct csg_mesh_view *mesh = &view->mesh;
    const struct csg_mesh_ray ray = csg_frustum_ray(&mesh->frustum, mesh->width, mesh->height,
                                                    (double)(i % (size_t)mesh->width) + 0.5,
                                                    (double)(i / (size_t)mesh->width) + 0.5);
    return fabs((double)view->z[i] - (double)z_written[i]) *
           fabs(csg_dot(mesh->hits[i].normal, ray.dir));
}

/* Whether both pictures show one place of one solid there, with and without facets. */
static bool is_same_surface(const struct csg_comparer *comparer,
                            const struct csg_compared_view *view,
                            const struct csgcast_image *written, size_t i)
{
    struct csgcast_scene_info a, b;
    const float *n = view->normal + 3 * i, *m = written->normal + 3 * i;
    csgcast_scene_get_info(comparer->scene, &a);
    csgcast_scene_get_info(comparer->written, &b);
    return isfinite(view->z[i]) && isfinite(written->z[i]) &&
           (a.num_leaves != b.num_leaves || (int)view->id[i] == (int)written->id[i]) &&
           (double)(n[0] * m[0] + n[1] * m[1] + n[2] * m[2]) > same_surface_cosine;
}

static void measure_facets(const struct csg_comparer *comparer, struct csg_compared_view *view,
                           const struct csgcast_image *written, const struct csg_comparison *judged)
{
    const size_t num = (size_t)view->mesh.width * (size_t)view->mesh.height;
    for (size_t i = 0; i < num; i++) {
        if (view->mesh.edges[i] || judged->verdicts[i] != CSG_VERDICT_SAME ||
            !is_same_surface(comparer, view, written, i))
            continue;
        view->facets = fmax(view->facets, across(view, written->z, i));
    }
}

static void take_wrong(struct csg_compared_view *view, const struct csg_comparison *judged)
{
    const size_t num = (size_t)view->mesh.width * (size_t)view->mesh.height;
    view->num_wrong = judged->num_off + judged->num_depth;
    for (size_t i = 0; i < num; i++)
        view->wrong[i] =
            judged->verdicts[i] == CSG_VERDICT_OFF || judged->verdicts[i] == CSG_VERDICT_DEPTH;
}

/* The same view with OpenSCAD's facets: what differs from the mesh there, no facet explains. */
static bool judge_written(const struct csg_comparer *comparer, const struct csgcast_view *view,
                          const struct csg_compare_tolerance *tolerance,
                          struct csg_compared_view *compared)
{
    const size_t num = (size_t)view->width * (size_t)view->height;
    const struct csgcast_image image = {.z = calloc(num, sizeof(float)),
                                        .normal = calloc(3 * num, sizeof(float)),
                                        .id = calloc(num, sizeof(float))};
    struct csg_comparison judged = {.verdicts = NULL};
    const bool ok = image.z && image.normal && image.id &&
                    csgcast_render(comparer->renderer, comparer->written, view, &image) &&
                    csg_compare(&compared->mesh, &image, tolerance, &judged);
    if (ok) {
        take_wrong(compared, &judged);
        measure_facets(comparer, compared, &image, &judged);
    }
    free(judged.verdicts);
    free(image.z);
    free(image.normal);
    free(image.id);
    return ok;
}

/* The same camera without a scene to look at: with and without facets a scene may have other
 * bounds. */
static struct csgcast_camera fixed_camera(const struct csgcast_camera *asked,
                                          const struct csgcast_frustum *frustum)
{
    struct csgcast_camera camera = *asked;
    const double fov = asked->fov > 0 ? asked->fov : default_fov;
    const double half = 0.5 * fov * 3.14159265358979323846 / 180;
    camera.viewall = camera.autocenter = false;
    camera.distance = frustum->orthographic ? frustum->half_height / tan(half) : 1;
    if (asked->kind == CSGCAST_CAMERA_DEFAULT) {
        camera.kind = CSGCAST_CAMERA_GIMBAL;
        memcpy(camera.rotate, default_views[0].rotate, sizeof camera.rotate);
    }
    for (int i = 0; i < 3; i++) {
        camera.eye[i] = frustum->eye[i];
        camera.center[i] = frustum->eye[i] + camera.distance * frustum->forward[i];
        camera.translate[i] = camera.center[i];
    }
    return camera;
}

bool csg_compare_view(const struct csg_comparer *comparer, struct csg_compared *all, int number)
{
    const struct csg_cli_options *options = all->options;
    const struct csg_log log = {options->scene.log, options->scene.log_user};
    struct csg_compared_view *compared = &all->views[number];
    struct csgcast_view asked = view_of(all, number, &compared->label);
    const size_t num = (size_t)asked.width * (size_t)asked.height;
    const struct csg_compare_tolerance tolerance = {
        .depth = depth_tolerance,
        .rounding = rounding_tolerance * comparer->reach,
        .sagitta = options->compare.sagitta,
    };
    struct csgcast_frustum frustum;
    compared->z = calloc(num, sizeof *compared->z);
    compared->normal = calloc(3 * num, sizeof *compared->normal);
    compared->id = calloc(num, sizeof *compared->id);
    compared->wrong = calloc(num, 1);
    if (!compared->z || !compared->normal || !compared->id || !compared->wrong)
        return csg_log_memory(&log);
    const struct csgcast_image image = {
        .z = compared->z, .normal = compared->normal, .id = compared->id};
    if (!csgcast_view_resolve(comparer->scene, &asked, &frustum))
        return false;
    asked.camera = fixed_camera(&asked.camera, &frustum);
    if (!csgcast_view_resolve(comparer->scene, &asked, &frustum) ||
        !csgcast_render(comparer->renderer, comparer->scene, &asked, &image))
        return false;
    if (!csg_mesh_view_init(&compared->mesh, comparer->caster, &frustum, asked.width,
                            asked.height) ||
        !csg_mesh_view_mark_edges(&compared->mesh, tolerance.sagitta) ||
        !csg_compare(&compared->mesh, &image, &tolerance, &compared->result))
        return csg_log_memory(&log);
    if (comparer->written)
        return judge_written(comparer, &asked, &tolerance, compared);
    take_wrong(compared, &compared->result);
    return true;
}

void csg_compared_view_finish(struct csg_compared_view *view)
{
    csg_mesh_view_finish(&view->mesh);
    free(view->result.verdicts);
    free(view->z);
    free(view->normal);
    free(view->id);
    free(view->wrong);
}
