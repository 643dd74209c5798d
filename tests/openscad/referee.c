/* SPDX-License-Identifier: MIT */

/*
 *     referee [option...] SCENE MESH.stl
 *     referee --converge [option...] SCENE COARSE.stl FINE.stl FINER.stl ...
 *
 * Casts the rays of csgcast's pixels at the mesh that OpenSCAD made of the same scene and compares
 * hits, depths and normals. Prints one line per view; exits with 0 when all are within the limits,
 * 1 when one is not (its pictures are then in the working directory), 2 on bad input.
 *
 *   --facets=as-written|exact|auto  --backend=auto|egl|osmesa|reference  --variant=NAME
 *   --imgsize=W,H                   --name=NAME of the case
 *   --views=N --seed=S              N random views (4), perspective and orthographic in turn
 *   --camera=... --projection=p|o   one view as in OpenSCAD's command line instead
 *   --sagitta=S   exact facets: the true surface is within S scene units of the mesh
 *   --depth=E     allowed relative error of depth, 1e-5 (more only where a surface seen edge-on
 *                 is as far off along its normal as six digits in a .csg may put it)
 *   --depth-of-radius=E   instead: E of the radius of the scene's box
 *   --normal=A    allowed angle of normals in degrees for 99.9 % of the pixels, 0.1 (as-written)
 *   --edge=P      part of the edge pixels that may mismatch, 0.02; exact facets: any
 *   --thin=P      part of the hits that may need a look 1/50 pixel aside, 0.002
 *   --off=N       mismatches off the edges that are allowed, 0
 *   --render      for .scad: $preview is false, as where OpenSCAD exports a mesh
 *   --converge    each mesh has twice the fragments of the one before: the distance to csgcast's
 *                 surface must shrink fourfold; --sagitta is that of the first mesh
 */

#include "camera.h"
#include "evidence.h"
#include "options.h"

#include <stdio.h>
#include <stdlib.h>

/* How close to 4 the shrinking must be; the last steps meet the noise of float32. */
static const double min_shrinking = 3.5, max_shrinking = 4.5;
static const double max_frustum_error = 1e-9;

/* A few halves of the sixth digit, as maps nest: of the largest coordinate. */
static const double csg_rounding = 2e-6;

struct session {
    const struct options *options;
    struct csgcast_scene *scene;
    struct csgcast_renderer *renderer;
    struct csg_box bounds; /* of the first mesh */
    size_t num_pixels;
    float *z, *normal;
};

static bool session_init(struct session *session, const struct options *options)
{
    static const char *const defines[] = {"$preview=false"};
    const struct csgcast_scene_params scene_params = {
        .facets = options->facets, .defines = defines, .num_defines = options->render};
    const struct csgcast_renderer_params renderer_params = {.backend = options->backend};
    const size_t num_pixels = (size_t)options->view.width * (size_t)options->view.height;
    *session = (struct session){
        .options = options,
        .scene = csgcast_scene_load(options->scene, &scene_params),
        .renderer = csgcast_renderer_create(&renderer_params),
        .num_pixels = num_pixels,
        .z = calloc(num_pixels, sizeof *session->z),
        .normal = calloc(num_pixels * 3, sizeof *session->normal),
    };
    return session->scene && session->renderer && session->z && session->normal;
}

static void session_finish(struct session *session)
{
    csgcast_scene_destroy(session->scene);
    csgcast_renderer_destroy(session->renderer);
    free(session->z);
    free(session->normal);
}

static struct csgcast_view session_view(const struct session *session, unsigned number)
{
    struct csgcast_view view = session->options->view;
    if (!session->options->has_camera)
        view.camera = camera_random(session->options->seed + number, &session->bounds);
    return view;
}

static unsigned session_num_views(const struct session *session)
{
    return session->options->has_camera ? 1 : session->options->views;
}

static double max_difference(const double *a, const double *b, int num)
{
    double max = 0;
    for (int i = 0; i < num; i++)
        max = fmax(max, fabs(a[i] - b[i]));
    return max;
}

/* csgcast's frustum against the referee's own; eye and size relative to the view's distance. */
static bool check_frustum(const struct session *session, const struct csgcast_view *view,
                          const struct csgcast_frustum *ours)
{
    struct csgcast_frustum theirs;
    if (!csgcast_view_resolve(session->scene, view, &theirs))
        return false;
    const double scale = fmax(csg_length(csg_vec3(ours->eye[0], ours->eye[1], ours->eye[2])), 1);
    double error = max_difference(ours->eye, theirs.eye, 3) / scale;
    error = fmax(error, max_difference(ours->right, theirs.right, 3));
    error = fmax(error, max_difference(ours->up, theirs.up, 3));
    error = fmax(error, max_difference(ours->forward, theirs.forward, 3));
    error = fmax(error, fabs(theirs.half_height / ours->half_height - 1));
    error = fmax(error, fabs(theirs.half_width / ours->half_width - 1));
    if (error > max_frustum_error || ours->orthographic != theirs.orthographic) {
        printf("    csgcast_view_resolve is off by %g\n", error);
        return false;
    }
    return true;
}

static bool within_limits(const struct options *options, const struct csg_comparison *result)
{
    const bool exact = options->sagitta > 0;
    const double edge_limit = exact ? INFINITY : options->edge * (double)result->num_edges + 1;
    const double thin_limit = options->thin * (double)result->num_hits + 1;
    return result->num_off + result->num_depth <= options->off &&
           (double)result->num_edge_mismatches <= edge_limit &&
           (double)result->num_thin <= thin_limit &&
           (exact || result->normal.p999 <= options->normal);
}

static double radius_of(const struct csg_box *box)
{
    return csg_box_is_empty(box) ? 0 : csg_length(csg_sub(box->hi, box->lo)) / 2;
}

static void print_result(const struct session *session, const struct csgcast_view *view,
                         unsigned number, const struct csg_comparison *result, bool ok)
{
    printf("%s %s view %u %s: hits %zu edge %zu/%zu thin %zu off %zu depth %zu"
           " | dz/z max %.2g p99.9 %.2g | normal max %.2g p99.9 %.2g deg",
           ok ? "ok  " : "FAIL", session->options->name, session->options->seed + number,
           view->camera.projection == CSGCAST_ORTHOGRAPHIC ? "ortho" : "persp", result->num_hits,
           result->num_edge_mismatches, result->num_edges, result->num_thin, result->num_off,
           result->num_depth, result->relative.max, result->relative.p999, result->normal.max,
           result->normal.p999);
    if (session->options->depth_of_radius > 0)
        printf(" | dz/r %.2g", result->depth.max / radius_of(&session->bounds));
    if (session->options->sagitta > 0)
        printf(" | offset max %.3g rms %.3g of %.3g", result->offset.max, result->rms_offset,
               session->options->sagitta);
    printf("\n");
}

static double largest_coordinate(const struct csg_box *box)
{
    const double x = fmax(fabs(box->lo.x), fabs(box->hi.x));
    const double y = fmax(fabs(box->lo.y), fabs(box->hi.y));
    const double z = fmax(fabs(box->lo.z), fabs(box->hi.z));
    return csg_box_is_empty(box) ? 0 : fmax(x, fmax(y, z));
}

/* Traces the mesh, renders the scene and compares. The caller frees result->verdicts. */
static bool compare_view(const struct session *session, struct csg_caster *caster,
                         const struct csgcast_view *view, struct csg_mesh_view *reference,
                         struct csg_comparison *result)
{
    const struct options *options = session->options;
    const struct csgcast_image image = {.z = session->z, .normal = session->normal};
    const struct csgcast_frustum frustum = camera_frustum(view, &session->bounds);
    const struct csg_compare_tolerance tolerance = {
        .depth = options->depth,
        .rounding = csg_rounding * largest_coordinate(&session->bounds),
        .sagitta = options->sagitta,
        .absolute = options->depth_of_radius * radius_of(&session->bounds),
    };
    if (!check_frustum(session, view, &frustum) ||
        !csg_mesh_view_init(reference, caster, &frustum, view->width, view->height))
        return false;
    return csg_mesh_view_mark_edges(reference, options->sagitta) &&
           csgcast_render(session->renderer, session->scene, view, &image) &&
           csg_compare(reference, &image, &tolerance, result);
}

static bool referee_view(const struct session *session, struct csg_caster *caster, unsigned number)
{
    const struct csgcast_image image = {.z = session->z, .normal = session->normal};
    const struct csgcast_view view = session_view(session, number);
    struct csg_mesh_view reference = {0};
    struct csg_comparison result = {0};
    bool ok = false;
    if (compare_view(session, caster, &view, &reference, &result)) {
        char stem[256];
        ok = within_limits(session->options, &result);
        print_result(session, &view, number, &result, ok);
        snprintf(stem, sizeof stem, "%s-%u", session->options->name,
                 session->options->seed + number);
        if (!ok) {
            evidence_print(&reference, &image, &result);
            evidence_write(stem, &reference, &image, &result);
        }
    } else {
        printf("FAIL %s view %u\n", session->options->name, session->options->seed + number);
    }
    free(result.verdicts);
    csg_mesh_view_finish(&reference);
    return ok;
}

static struct csg_caster *load_caster(const char *path, struct csg_box *bounds)
{
    static const struct csg_log log;
    struct csg_soup mesh;
    if (!csg_soup_read(path, &mesh, &log))
        return NULL;
    struct csg_caster *caster = csg_caster_create(&mesh, &log);
    *bounds = mesh.bounds;
    csg_soup_finish(&mesh);
    return caster;
}

static bool referee_views(struct session *session)
{
    bool ok = true;
    struct csg_caster *caster = load_caster(session->options->meshes[0], &session->bounds);
    if (!caster)
        return false;
    for (unsigned i = 0; i < session_num_views(session); i++)
        ok = referee_view(session, caster, i) && ok;
    csg_caster_destroy(caster);
    return ok;
}

/* The root of the mean squared distance between the mesh and csgcast's surface; NAN on failure. */
static double rms_of_mesh(struct session *session, int index)
{
    double sum = 0;
    size_t num = 0;
    struct csg_box bounds;
    struct csg_caster *caster = load_caster(session->options->meshes[index], &bounds);
    if (!caster)
        return NAN;
    if (index == 0)
        session->bounds = bounds; /* the same cameras for all meshes */
    for (unsigned i = 0; i < session_num_views(session); i++) {
        const struct csgcast_view view = session_view(session, i);
        struct csg_mesh_view reference = {0};
        struct csg_comparison result = {0};
        const bool ok = compare_view(session, caster, &view, &reference, &result);
        sum += ok ? result.rms_offset * result.rms_offset * (double)result.num_compared : NAN;
        num += result.num_compared;
        free(result.verdicts);
        csg_mesh_view_finish(&reference);
    }
    csg_caster_destroy(caster);
    return num > 0 ? sqrt(sum / (double)num) : NAN;
}

static bool referee_convergence(struct session *session)
{
    bool ok = true;
    double before = rms_of_mesh(session, 0);
    printf("     %s: rms %.4g", session->options->name, before);
    for (int i = 1; i < session->options->num_meshes; i++) {
        const double rms = rms_of_mesh(session, i);
        const double shrinking = before / rms;
        ok = ok && shrinking >= min_shrinking && shrinking <= max_shrinking;
        printf(", %.4g (1/%.2f)", rms, shrinking);
        before = rms;
    }
    printf("%s\n", ok ? " ok" : " FAIL: not fourfold");
    return ok;
}

int main(int argc, char **argv)
{
    struct options options;
    struct session session = {0};
    if (!options_parse(argc, argv, &options))
        return 2;
    if (!session_init(&session, &options)) {
        fprintf(stderr, "referee: cannot load %s or create a renderer\n", options.scene);
        session_finish(&session);
        return 2;
    }
    const bool ok = options.converge ? referee_convergence(&session) : referee_views(&session);
    session_finish(&session);
    return ok ? 0 : 1;
}
