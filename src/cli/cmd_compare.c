/* SPDX-License-Identifier: MIT */

/* csgcast compare: csgcast's surface against a mesh of the same scene, ray by ray. */

#include "commands.h"
#include "compare.h"
#include "compare_mesh.h"
#include "messages.h"

#include <limits.h>
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

struct run {
    const struct csg_cli_options *options;
    struct csgcast_scene_params params; /* with $preview = false */
    const char **defines;
    struct csg_log log;
    char *text; /* of standard input; text_size bytes */
    size_t text_size;
    struct csgcast_scene *scene, *written; /* written: with OpenSCAD's facets, NULL: not needed */
    struct csgcast_renderer *renderer;
    struct csg_mesh_source source;
    struct csg_caster *caster;
    struct csg_compared compared;
};

/* ---- the scene ------------------------------------------------------------------------------ */

/* As OpenSCAD exports it. */
static bool set_params(struct run *run)
{
    const struct csgcast_scene_params *given = &run->options->scene;
    run->params = *given;
    run->defines = calloc(given->num_defines + 1, sizeof *run->defines);
    if (!run->defines)
        return csg_log_memory(&run->log);
    for (size_t i = 0; i < given->num_defines; i++)
        run->defines[i] = given->defines[i];
    run->defines[given->num_defines] = "$preview=false";
    run->params.defines = run->defines;
    run->params.num_defines = given->num_defines + 1;
    return true;
}

/* Standard input can be read once only, and the scene is wanted twice. */
static bool read_standard_input(struct run *run)
{
    char bytes[65536];
    size_t num;
    while ((num = fread(bytes, 1, sizeof bytes, stdin)) > 0) {
        char *text = realloc(run->text, run->text_size + num);
        if (!text)
            return csg_log_memory(&run->log);
        memcpy(text + run->text_size, bytes, num);
        run->text = text;
        run->text_size += num;
    }
    return true;
}

static struct csgcast_scene *load(struct run *run, struct csgcast_scene_params params)
{
    if (strcmp(run->options->input, "-") != 0)
        return csgcast_scene_load(run->options->input, &params);
    params.name = "<stdin>";
    return csgcast_scene_parse(run->text ? run->text : "", run->text_size, &params);
}

static bool load_scenes(struct run *run)
{
    if (strcmp(run->options->input, "-") == 0 && !read_standard_input(run))
        return false;
    run->scene = load(run, run->params);
    if (!run->scene)
        return false;
    struct csgcast_scene_info info;
    csgcast_scene_get_info(run->scene, &info);
    run->compared.sagitta = info.sagitta;
    run->compared.by_facets = run->options->compare.sagitta == 0;
    if (!run->compared.by_facets || run->params.facets == CSGCAST_FACETS_AS_WRITTEN)
        return true;
    struct csgcast_scene_params params = run->params;
    bool quiet = true; /* its warnings were given already */
    params.facets = CSGCAST_FACETS_AS_WRITTEN;
    params.log_user = &quiet;
    run->written = load(run, params);
    return run->written != NULL;
}

static bool load_mesh(struct run *run)
{
    struct csg_compare_module module;
    run->source =
        (struct csg_mesh_source){.options = run->options, .params = &run->params, .log = run->log};
    if (!csg_compare_module_load(&module, &run->log) ||
        !csg_mesh_source_read(&run->source, &module))
        return false;
    run->compared.mesh_name = run->source.name;
    run->compared.mesh_seconds = run->source.seconds;
    if (run->source.soup.num_triangles)
        run->compared.radius =
            0.5 * csg_length(csg_sub(run->source.soup.bounds.hi, run->source.soup.bounds.lo));
    if (!(run->compared.radius > 0))
        run->compared.radius = 1;
    run->compared.num_triangles = run->source.soup.num_triangles;
    run->caster = module.caster_create(&run->source.soup, &run->log);
    return run->caster != NULL;
}

/* ---- the views ------------------------------------------------------------------------------ */

static double largest_coordinate(const struct csg_box *box)
{
    double largest = 0;
    for (int i = 0; i < 8 && !csg_box_is_empty(box); i++) {
        const struct csg_vec3 p = csg_box_corner(box, i);
        largest = fmax(largest, fmax(fabs(p.x), fmax(fabs(p.y), fabs(p.z))));
    }
    return largest;
}

static struct csgcast_view view_of(const struct run *run, int number, const char **label)
{
    struct csgcast_view view = run->options->view;
    struct csgcast_camera *camera = &view.camera;
    view.width = view.width ? view.width : DEFAULT_SIZE;
    view.height = view.height ? view.height : DEFAULT_SIZE;
    *label = "view";
    if (run->compared.num_views == 1)
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
static bool is_same_surface(const struct run *run, const struct csg_compared_view *view,
                            const struct csgcast_image *written, size_t i)
{
    struct csgcast_scene_info a, b;
    const float *n = view->normal + 3 * i, *m = written->normal + 3 * i;
    csgcast_scene_get_info(run->scene, &a);
    csgcast_scene_get_info(run->written, &b);
    return isfinite(view->z[i]) && isfinite(written->z[i]) &&
           (a.num_leaves != b.num_leaves || (int)view->id[i] == (int)written->id[i]) &&
           (double)(n[0] * m[0] + n[1] * m[1] + n[2] * m[2]) > same_surface_cosine;
}

static void measure_facets(const struct run *run, struct csg_compared_view *view,
                           const struct csgcast_image *written, const struct csg_comparison *judged)
{
    const size_t num = (size_t)view->mesh.width * (size_t)view->mesh.height;
    for (size_t i = 0; i < num; i++) {
        if (view->mesh.edges[i] || judged->verdicts[i] != CSG_VERDICT_SAME ||
            !is_same_surface(run, view, written, i))
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
static bool judge_written(struct run *run, const struct csgcast_view *view,
                          const struct csg_compare_tolerance *tolerance,
                          struct csg_compared_view *compared)
{
    const size_t num = (size_t)view->width * (size_t)view->height;
    const struct csgcast_image image = {.z = calloc(num, sizeof(float)),
                                        .normal = calloc(3 * num, sizeof(float)),
                                        .id = calloc(num, sizeof(float))};
    struct csg_comparison judged = {.verdicts = NULL};
    const bool ok = image.z && image.normal && image.id &&
                    csgcast_render(run->renderer, run->written, view, &image) &&
                    csg_compare(&compared->mesh, &image, tolerance, &judged);
    if (ok) {
        take_wrong(compared, &judged);
        measure_facets(run, compared, &image, &judged);
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

static bool compare_view(struct run *run, int number)
{
    struct csg_compared_view *compared = &run->compared.views[number];
    struct csgcast_view asked = view_of(run, number, &compared->label);
    const size_t num = (size_t)asked.width * (size_t)asked.height;
    const struct csg_compare_tolerance tolerance = {
        .depth = depth_tolerance,
        .rounding = rounding_tolerance * largest_coordinate(&run->source.soup.bounds),
        .sagitta = run->options->compare.sagitta};
    struct csgcast_frustum frustum;
    compared->z = calloc(num, sizeof *compared->z);
    compared->normal = calloc(3 * num, sizeof *compared->normal);
    compared->id = calloc(num, sizeof *compared->id);
    compared->wrong = calloc(num, 1);
    if (!compared->z || !compared->normal || !compared->id || !compared->wrong)
        return csg_log_memory(&run->log);
    const struct csgcast_image image = {
        .z = compared->z, .normal = compared->normal, .id = compared->id};
    if (!csgcast_view_resolve(run->scene, &asked, &frustum))
        return false;
    asked.camera = fixed_camera(&asked.camera, &frustum);
    if (!csgcast_view_resolve(run->scene, &asked, &frustum) ||
        !csgcast_render(run->renderer, run->scene, &asked, &image))
        return false;
    if (!csg_mesh_view_init(&compared->mesh, run->caster, &frustum, asked.width, asked.height) ||
        !csg_mesh_view_mark_edges(&compared->mesh, tolerance.sagitta) ||
        !csg_compare(&compared->mesh, &image, &tolerance, &compared->result))
        return csg_log_memory(&run->log);
    if (run->written)
        return judge_written(run, &asked, &tolerance, compared);
    take_wrong(compared, &compared->result);
    return true;
}

/* ---- all together --------------------------------------------------------------------------- */

/* "dir/part.scad" gives "part.compare.png". */
static void default_picture(const char *input, char path[NAME_MAX + 32])
{
    const char *slash = strrchr(input, '/');
    const char *name = slash ? slash + 1 : input;
    const char *dot = strrchr(name, '.');
    const int length = (int)(dot && dot != name ? (size_t)(dot - name) : strlen(name));
    if (strcmp(input, "-") == 0)
        snprintf(path, NAME_MAX + 32, "scene.compare.png");
    else
        snprintf(path, NAME_MAX + 32, "%.*s.compare.png", length < NAME_MAX ? length : NAME_MAX,
                 name);
}

static bool write_pictures(const struct csg_compared *compared)
{
    const struct csg_cli_options *options = compared->options;
    const struct csg_compare_options *compare = &options->compare;
    char named[NAME_MAX + 32];
    const char *all = options->output;
    bool ok = true;
    default_picture(options->input, named);
    if (!all && !compare->side_by_side && !compare->difference && !compare->no_picture)
        all = named;
    if (all)
        ok = csg_compare_write_sheet(compared, CSG_SHEET_SIDE_BY_SIDE | CSG_SHEET_DIFFERENCE, all);
    if (compare->side_by_side)
        ok &= csg_compare_write_sheet(compared, CSG_SHEET_SIDE_BY_SIDE, compare->side_by_side);
    if (compare->difference)
        ok &= csg_compare_write_sheet(compared, CSG_SHEET_DIFFERENCE, compare->difference);
    return ok;
}

static enum csg_cli_exit tell(const struct csg_compared *compared)
{
    struct csg_threshold thresholds[CSG_NUM_THRESHOLDS];
    bool within = true;
    if (compared->options->json)
        csg_compare_print_json(compared);
    else
        csg_compare_print(compared);
    csg_compare_thresholds(compared, thresholds);
    for (int i = 0; i < CSG_NUM_THRESHOLDS; i++)
        within = within &&
                 (!csg_threshold_is_judged(&thresholds[i]) || csg_threshold_holds(&thresholds[i]));
    if (fflush(stdout) || ferror(stdout)) {
        csg_cli_error("cannot write to standard output");
        return CSG_EXIT_USAGE;
    }
    return within ? CSG_EXIT_OK : CSG_EXIT_BEYOND;
}

static bool compare_views(struct run *run)
{
    const struct csgcast_camera *camera = &run->options->view.camera;
    run->compared.num_views =
        run->options->camera || camera->viewall || camera->autocenter ? 1 : CSG_COMPARE_MAX_VIEWS;
    run->renderer = csgcast_renderer_create(&run->options->renderer);
    bool ok = run->renderer != NULL;
    for (int i = 0; i < run->compared.num_views && ok; i++)
        ok = compare_view(run, i);
    if (ok)
        csg_compared_sum_up(&run->compared);
    return ok;
}

static void finish(struct run *run)
{
    for (int i = 0; i < CSG_COMPARE_MAX_VIEWS; i++) {
        struct csg_compared_view *view = &run->compared.views[i];
        csg_mesh_view_finish(&view->mesh);
        free(view->result.verdicts);
        free(view->z);
        free(view->normal);
        free(view->id);
        free(view->wrong);
    }
    csg_caster_destroy(run->caster);
    csg_soup_finish(&run->source.soup);
    csgcast_renderer_destroy(run->renderer);
    csgcast_scene_destroy(run->scene);
    csgcast_scene_destroy(run->written);
    free(run->defines);
    free(run->text);
}

static enum csg_cli_exit run_compare(const struct csg_cli_options *options)
{
    struct run *run = calloc(1, sizeof *run);
    enum csg_cli_exit result = CSG_EXIT_USAGE;
    if (!run) {
        csg_cli_error("out of memory");
        return result;
    }
    run->options = run->compared.options = options;
    run->log = (struct csg_log){options->scene.log, options->scene.log_user};
    if (set_params(run) && load_scenes(run) && load_mesh(run) && compare_views(run) &&
        write_pictures(&run->compared))
        result = tell(&run->compared);
    finish(run);
    free(run);
    return result;
}

const struct csg_cli_command csg_command_compare = {
    .name = "compare",
    .bit = CSG_COMMAND_COMPARE,
    .summary = "compare the exact surface with a mesh, ray by ray",
    .usage = "FILE [--mesh=MESH] [OPTION...]",
    .text =
        "Draws a scene and casts the same rays, in double precision, at a mesh of it: the one "
        "that\n"
        "openscad exports, or a file. Prints how well the silhouettes agree, how far depths and\n"
        "normals are apart and where, and what OpenSCAD's facets explain of that; writes a "
        "picture\n"
        "of both and of the difference. Without --camera four views are compared.\n"
        "\n"
        "A pixel is wrong where csgcast, drawing OpenSCAD's facets, does not show the mesh's "
        "surface\n"
        "(to 3e-5 of the distance) and no edge passes through the pixel. $preview is false.\n",
    .tail = "  csgcast compare part.scad\n"
            "  csgcast compare part.scad --facets=as-written --json --no-picture\n"
            "  csgcast compare part.csg --mesh=part.3mf --sagitta=0.02 -o part-difference.png\n"
            "  csgcast compare part.scad --camera=0,0,0,55,0,25,140 --imgsize=1024,1024\n"
            "  csgcast compare part.scad --min-iou=0.999 --max-depth-p99=0.05 || echo 'beyond'\n",
    .exits = "  0  all thresholds hold\n"
             "  1  some threshold does not hold\n"
             "  2  the command line makes no sense, or something failed\n",
    .run = run_compare,
};
