/* SPDX-License-Identifier: MIT */

/* csgcast compare: csgcast's surface against a mesh of the same scene, ray by ray. */

#include "commands.h"
#include "compare_mesh.h"
#include "compare_view.h"
#include "messages.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct run {
    const struct csg_cli_options *options;
    struct csgcast_scene_params params; /* with $preview = false */
    const char **defines;
    struct csg_log log;
    char *text; /* of standard input; text_size bytes */
    size_t text_size;
    struct csg_mesh_source source;
    struct csg_comparer comparer;
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
    run->comparer.scene = load(run, run->params);
    if (!run->comparer.scene)
        return false;
    struct csgcast_scene_info info;
    csgcast_scene_get_info(run->comparer.scene, &info);
    run->compared.sagitta = info.sagitta;
    run->compared.by_facets = run->options->compare.sagitta == 0;
    if (!run->compared.by_facets || run->params.facets == CSGCAST_FACETS_AS_WRITTEN)
        return true;
    struct csgcast_scene_params params = run->params;
    bool quiet = true; /* its warnings were given already */
    params.facets = CSGCAST_FACETS_AS_WRITTEN;
    params.log_user = &quiet;
    run->comparer.written = load(run, params);
    return run->comparer.written != NULL;
}

static double largest_coordinate(const struct csg_box *box)
{
    double largest = 0;
    for (int i = 0; i < 8 && !csg_box_is_empty(box); i++) {
        const struct csg_vec3 p = csg_box_corner(box, i);
        largest = fmax(largest, csg_vec3_largest(p));
    }
    return largest;
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
    run->comparer.reach = largest_coordinate(&run->source.soup.bounds);
    run->compared.num_triangles = run->source.soup.num_triangles;
    run->comparer.caster = module.caster_create(&run->source.soup, &run->log);
    return run->comparer.caster != NULL;
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
    return csg_cli_end_output(within ? CSG_EXIT_OK : CSG_EXIT_BEYOND, CSG_EXIT_USAGE);
}

static bool compare_views(struct run *run)
{
    const struct csgcast_camera *camera = &run->options->view.camera;
    run->compared.num_views =
        run->options->camera || camera->viewall || camera->autocenter ? 1 : CSG_COMPARE_MAX_VIEWS;
    run->comparer.renderer = csgcast_renderer_create(&run->options->renderer);
    bool ok = run->comparer.renderer != NULL;
    for (int i = 0; i < run->compared.num_views && ok; i++)
        ok = csg_compare_view(&run->comparer, &run->compared, i);
    if (ok)
        csg_compared_sum_up(&run->compared);
    return ok;
}

static void finish(struct run *run)
{
    for (int i = 0; i < CSG_COMPARE_MAX_VIEWS; i++)
        csg_compared_view_finish(&run->compared.views[i]);
    csg_caster_destroy(run->comparer.caster);
    csg_soup_finish(&run->source.soup);
    csgcast_renderer_destroy(run->comparer.renderer);
    csgcast_scene_destroy(run->comparer.scene);
    csgcast_scene_destroy(run->comparer.written);
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
    .text = "Draws a scene and casts the same rays, in double precision, at a mesh of it: the one\n"
            "that openscad exports, or a file. Prints how well the silhouettes agree, how far\n"
            "depths and normals are apart and where, and what OpenSCAD's facets explain of that;\n"
            "writes a picture of both and of the difference. Without --camera four views are\n"
            "compared.\n"
            "\n"
            "A pixel is wrong where csgcast, drawing OpenSCAD's facets, does not show the mesh's\n"
            "surface (to 3e-5 of the distance) and no edge passes through the pixel. $preview is\n"
            "false.\n",
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
