/* SPDX-License-Identifier: MIT */

/* csgcast info: what a scene needs, and what is left out. */

#include "commands.h"
#include "json.h"
#include "messages.h"
#include "options.h"
#include "stats.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FRAME_SIZE 64        /* pixels: enough to choose the variants and to fill the texture */
#define STATS_FRAME_SIZE 512 /* where its cost is asked for as well */

/* Everything there is to tell about one scene. */
struct report {
    struct csgcast_scene_info scene;
    bool has_bounds;
    double lo[3], hi[3];
    bool has_frame;
    char renderer[256];
    struct csgcast_stats frame;
};

/* The numbers of struct csgcast_scene_info, in the order in which they are printed. */
struct count_row {
    const char *key, *label;
    size_t offset;
};

#define COUNT(key, label)                                                                          \
    {                                                                                              \
#key, label, offsetof(struct csgcast_scene_info, num_##key)                                \
    }

static const struct count_row count_rows[] = {
    COUNT(leaves, "leaves"),
    COUNT(objects, "objects"),
    COUNT(nodes, "Boolean nodes"),
    {"depth", "depth", offsetof(struct csgcast_scene_info, depth)},
    COUNT(planes, "planes"),
    COUNT(quadrics, "quadrics"),
    COUNT(shared, "shared faces"),
    {"max_crossings", "crossings at most", offsetof(struct csgcast_scene_info, max_crossings)},
    COUNT(exact, "exact"),
    COUNT(facetted, "facetted"),
    COUNT(triangles, "triangles"),
    COUNT(handed_off, "by openscad"),
    COUNT(rounded, "rounded numbers"),
    COUNT(highlighted, "highlighted (#)"),
    COUNT(background, "background (%)"),
    COUNT(dropped, "left out"),
};

#define NUM_COUNT_ROWS (sizeof count_rows / sizeof *count_rows)

static size_t get_count(const struct report *report, const struct count_row *row)
{
    const char *base = (const char *)&report->scene;
    return *(const size_t *)(const void *)(base + row->offset);
}

/* ---- for people ----------------------------------------------------------------------------- */

static const char *const way_names[] = {
    [CSGCAST_WAY_EXACT] = "exact",
    [CSGCAST_WAY_FACETTED] = "facetted",
    [CSGCAST_WAY_MESH] = "mesh",
    [CSGCAST_WAY_OPENSCAD] = "openscad",
};

static void print_ways(const struct report *report, const char *input)
{
    for (size_t i = 0; i < report->scene.num_ways; i++) {
        const struct csgcast_scene_way *way = &report->scene.ways[i];
        printf("%-18s %zu %s%s, %s%s:%u:%u%s%s", way_names[way->way], way->num_nodes, way->name,
               way->num_leaves > way->num_nodes ? " (of several leaves)" : "",
               way->num_nodes > 1 ? "first " : "", input, way->line, way->column,
               way->reason ? ": " : "", way->reason ? way->reason : "");
        if (way->way == CSGCAST_WAY_OPENSCAD)
            printf(" (%.1f s%s)", way->seconds, way->cached ? ", from the cache" : "");
        printf("\n");
    }
}

static void print_text(const struct report *report, const char *input, bool stats)
{
    printf("kinds              ");
    for (size_t i = 0; i < report->scene.num_kinds; i++)
        printf("%s%s %zu", i ? ", " : "", report->scene.kinds[i].name,
               report->scene.kinds[i].count);
    printf("%s\n", report->scene.num_kinds ? "" : "none");
    for (size_t i = 0; i < NUM_COUNT_ROWS; i++)
        printf("%-18s %zu\n", count_rows[i].label, get_count(report, &count_rows[i]));
    print_ways(report, input);
    if (report->scene.sagitta > 0)
        printf("sagitta            %.3g: so far may OpenSCAD's facets be from the exact solids\n",
               report->scene.sagitta);
    if (report->has_bounds)
        printf("bounds             %g %g %g to %g %g %g\n", report->lo[0], report->lo[1],
               report->lo[2], report->hi[0], report->hi[1], report->hi[2]);
    else
        printf("bounds             empty\n");
    if (report->has_frame && stats)
        csg_cli_print_stats(stdout, report->renderer, &report->frame);
    else if (report->has_frame)
        printf("renderer           %s\nvariants           %s\nprograms           %zu\n"
               "texture bytes      %zu\n",
               report->renderer, report->frame.variants, report->frame.programs,
               report->frame.texture_bytes);
    if (report->has_frame)
        csg_cli_print_numerics(stdout, &report->frame);
}

/* ---- for machines --------------------------------------------------------------------------- */

static void print_frame_json(struct csg_json *json, const struct report *report, bool stats)
{
    csg_json_string(json, "renderer", report->renderer);
    csg_json_string(json, "variants", report->frame.variants);
    csg_json_string(json, "numerics", report->frame.numerics);
    if (stats) {
        csg_cli_print_stats_json(json, &report->frame);
        return;
    }
    csg_json_size(json, "programs", report->frame.programs);
    csg_json_size(json, "texture_bytes", report->frame.texture_bytes);
}

static void print_ways_json(struct csg_json *json, const struct report *report)
{
    csg_json_list_open(json, "ways");
    for (size_t i = 0; i < report->scene.num_ways; i++) {
        const struct csgcast_scene_way *way = &report->scene.ways[i];
        csg_json_open(json, NULL);
        csg_json_string(json, "way", way_names[way->way]);
        csg_json_string(json, "name", way->name);
        csg_json_size(json, "nodes", way->num_nodes);
        csg_json_size(json, "leaves", way->num_leaves);
        csg_json_size(json, "line", way->line);
        csg_json_size(json, "column", way->column);
        if (way->reason)
            csg_json_string(json, "reason", way->reason);
        if (way->way == CSGCAST_WAY_OPENSCAD) {
            csg_json_number(json, "seconds", way->seconds);
            csg_json_bool(json, "cached", way->cached);
        }
        csg_json_close(json);
    }
    csg_json_list_close(json);
}

static void print_json(const struct report *report, const char *input, bool stats)
{
    struct csg_json json = {.file = stdout};
    csg_json_open(&json, NULL);
    csg_json_string(&json, "scene", input);
    csg_json_string(&json, "version", csgcast_version());
    csg_json_open(&json, "kinds");
    for (size_t i = 0; i < report->scene.num_kinds; i++)
        csg_json_size(&json, report->scene.kinds[i].name, report->scene.kinds[i].count);
    csg_json_close(&json);
    for (size_t i = 0; i < NUM_COUNT_ROWS; i++)
        csg_json_size(&json, count_rows[i].key, get_count(report, &count_rows[i]));
    print_ways_json(&json, report);
    csg_json_number(&json, "sagitta", report->scene.sagitta);
    if (report->has_bounds) {
        csg_json_vector(&json, "lo", report->lo);
        csg_json_vector(&json, "hi", report->hi);
    }
    if (report->has_frame)
        print_frame_json(&json, report, stats);
    csg_json_close(&json);
}

/* ---- the command ---------------------------------------------------------------------------- */

/* Once more with the leaves, which tell the kinds apart. Not at once: where leaves are asked for,
 * more objects may be drawn in double. */
static bool count_kinds(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                        const struct csgcast_view *view, float *id, struct csgcast_stats *stats)
{
    const struct csgcast_image image = {.id = id};
    struct csgcast_stats again;
    if (!csgcast_render(renderer, scene, view, &image))
        return false;
    csgcast_renderer_get_stats(renderer, &again);
    stats->num_single_kinds = again.num_single_kinds;
    memcpy(stats->single_kinds, again.single_kinds, sizeof stats->single_kinds);
    return true;
}

/* The first picture takes few programs, and later ones compile them one by one: what is told is how
 * those are drawn that compile no more. */
static bool draw_settled(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                         const struct csgcast_view *view, const struct csgcast_image *image,
                         struct csgcast_stats *stats)
{
    double compile_ms = 0;
    size_t programs;
    do {
        programs = stats->programs;
        if (!csgcast_render(renderer, scene, view, image))
            return false;
        csgcast_renderer_get_stats(renderer, stats);
        compile_ms += stats->compile_ms;
    } while (stats->programs > programs);
    stats->compile_ms = compile_ms;
    return true;
}

/* Draws a small frame, since the variants and the texture depend on the view. */
static bool render_frame(const struct csg_cli_options *options, const struct csgcast_scene *scene,
                         struct report *report)
{
    struct csgcast_view view = options->view;
    const int size = options->stats ? STATS_FRAME_SIZE : FRAME_SIZE;
    const size_t num = (size_t)size * (size_t)size;
    float *rgba = malloc(5 * num * sizeof *rgba);
    const struct csgcast_image image = {.rgba = rgba, .z = rgba + 4 * num};
    view.width = view.height = size;
    if (!rgba) {
        csg_cli_error("out of memory");
        return false;
    }
    struct csgcast_renderer *renderer = csgcast_renderer_create(&options->renderer);
    report->has_frame = renderer && draw_settled(renderer, scene, &view, &image, &report->frame);
    if (report->has_frame)
        snprintf(report->renderer, sizeof report->renderer, "%s", csgcast_renderer_name(renderer));
    if (report->has_frame && options->stats)
        report->has_frame = count_kinds(renderer, scene, &view, rgba, &report->frame);
    csgcast_renderer_destroy(renderer);
    free(rgba);
    return report->has_frame;
}

static enum csg_cli_exit run(const struct csg_cli_options *options)
{
    struct report report = {.has_bounds = false};
    enum csg_cli_exit result = CSG_EXIT_OK;
    struct csgcast_scene *scene = csgcast_scene_load(options->input, &options->scene);
    if (!scene)
        return CSG_EXIT_FAILED;
    csgcast_scene_get_info(scene, &report.scene);
    report.has_bounds = csgcast_scene_get_bounds(scene, report.lo, report.hi);
    if (!options->no_gl && !render_frame(options, scene, &report))
        result = CSG_EXIT_FAILED;
    if (options->json)
        print_json(&report, options->input, options->stats);
    else
        print_text(&report, options->input, options->stats);
    csgcast_scene_destroy(scene);
    return csg_cli_end_output(result, CSG_EXIT_OUTPUT);
}

const struct csg_cli_command csg_command_info = {
    .name = "info",
    .bit = CSG_COMMAND_INFO,
    .summary = "tell what a scene needs and what is left out",
    .usage = "FILE [OPTION...]",
    .text = "Counts the solids of a scene by kind, its Boolean nodes, distinct surfaces and the\n"
            "crossings that a ray can have, and draws a small frame to tell which variants\n"
            "resolve it and how large its float texture is. FILE - is standard input.\n",
    .tail = "  csgcast info part.scad\n"
            "  csgcast info part.csg --json --no-gl\n",
    .run = run,
};
