/* SPDX-License-Identifier: MIT */

/* csgcast render: scene in, image file out. */

#include "antialias.h"
#include "commands.h"
#include "ending.h"
#include "messages.h"
#include "options.h"
#include "output.h"
#include "picture.h"
#include "stats.h"

#include "common/file.h"
#include "common/heap.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#define COMPILED_MS 10 /* what the driver finds in its cache takes one or two */

static bool is_png(const char *output, const char *format)
{
    if (format)
        return !strcasecmp(format, "png");
    return !strcmp(output, "-") || csg_path_ends(output, ".png");
}

/* Whether the file is sure to hold 8 bits a channel: these are cheaper to draw than floats. */
static bool holds_bytes(const char *output, const struct csgcast_write_params *write)
{
    return !csg_picture_has_aov(write) &&
           (write->bits == 8 || (write->bits == 0 && is_png(output, write->format)));
}

/* ---- what the file says about itself ------------------------------------------------------- */

struct metadata_texts {
    char software[64], eye[96], right[96], up[96], forward[96], extent[96];
};

static void print_vector(char text[96], const double v[3])
{
    snprintf(text, 96, "%.17g,%.17g,%.17g", v[0], v[1], v[2]);
}

/* The resolved camera, with all digits: another program can cast the same rays. */
static void print_frustum(struct metadata_texts *texts, const struct csgcast_frustum *frustum)
{
    print_vector(texts->eye, frustum->eye);
    print_vector(texts->right, frustum->right);
    print_vector(texts->up, frustum->up);
    print_vector(texts->forward, frustum->forward);
    snprintf(texts->extent, sizeof texts->extent, "%.17g,%.17g", frustum->half_width,
             frustum->half_height);
}

static bool write_image(const char *path, const struct csg_cli_options *options,
                        const struct csgcast_view *view, const struct csgcast_image *image,
                        const struct csgcast_frustum *frustum)
{
    struct metadata_texts texts;
    snprintf(texts.software, sizeof texts.software, "csgcast %s", csgcast_version());
    print_frustum(&texts, frustum);
    const struct csgcast_metadata metadata[] = {
        {"Software", texts.software},
        {"csgcast:version", csgcast_version()},
        {"csgcast:scene", options->input},
        {"csgcast:facets", options->facets},
        {"csgcast:camera", options->camera ? options->camera : "default"},
        {"csgcast:projection", frustum->orthographic ? "orthographic" : "perspective"},
        {"csgcast:eye", texts.eye},
        {"csgcast:right", texts.right},
        {"csgcast:up", texts.up},
        {"csgcast:forward", texts.forward},
        {"csgcast:half_extent", texts.extent},
    };
    struct csgcast_write_params params = options->write;
    params.metadata = metadata;
    params.num_metadata = sizeof metadata / sizeof *metadata;
    return csgcast_image_write(path, view->width, view->height, image, &params);
}

/* ---- a scene and its picture ---------------------------------------------------------------- */

/* A scene that is loaded, and the renderer that has been starting meanwhile. */
struct drawing {
    const struct csg_cli_options *options;
    const struct csgcast_scene *scene;
    struct csgcast_renderer *renderer;
};

/* Someone at a terminal has waited for the driver's compiler, and need not the next time. */
static void tell_compiled(const struct csg_cli_options *options, const struct csgcast_stats *stats)
{
    if (stats->compile_ms > COMPILED_MS && !options->quiet && isatty(STDERR_FILENO))
        fprintf(stderr,
                "csgcast: the driver had programs to compile; `csgcast warm` has it compile "
                "and keep those of most scenes\n");
}

static bool render_image(const struct drawing *drawing, const struct csgcast_view *view,
                         const struct csgcast_image *image)
{
    struct csgcast_stats stats;
    if (!csgcast_render(drawing->renderer, drawing->scene, view, image))
        return false;
    csgcast_renderer_get_stats(drawing->renderer, &stats);
    tell_compiled(drawing->options, &stats);
    if (drawing->options->stats)
        csg_cli_print_stats(stderr, csgcast_renderer_name(drawing->renderer), &stats);
    return true;
}

static enum csg_cli_exit render_scene(const struct drawing *drawing, const char *output)
{
    const struct csg_cli_options *options = drawing->options;
    struct csgcast_view view = options->view, fine;
    struct csgcast_image image;
    struct csgcast_frustum frustum;
    enum csg_cli_exit result = CSG_EXIT_FAILED;
    view.variant = view.variant ? view.variant : "shared"; /* compiling pays for many pictures */
    view.width = view.width ? view.width : CSG_PICTURE_SIZE;
    view.height = view.height ? view.height : CSG_PICTURE_SIZE;
    if (!csgcast_view_resolve(drawing->scene, &view, &frustum) ||
        !csg_antialias_view(&view, options->antialias, &fine) ||
        !csg_picture_allocate(&image, &fine, &options->write, holds_bytes(output, &options->write)))
        return CSG_EXIT_FAILED;
    if (render_image(drawing, &fine, &image)) {
        csg_antialias_reduce(&image, view.width, view.height, options->antialias);
        result =
            write_image(output, options, &view, &image, &frustum) ? CSG_EXIT_OK : CSG_EXIT_OUTPUT;
    }
    csg_picture_free(&image);
    return result;
}

/* ---- animations ----------------------------------------------------------------------------- */

/* "dir/a.png" gives "dir/a00007.png", as openscad --animate names it; NULL: out of memory. */
static char *frame_path(const char *output, int frame)
{
    const char *slash = strrchr(output, '/'), *dot = strrchr(output, '.');
    const size_t length = strlen(output);
    const size_t stem =
        dot && (!slash || dot > slash + 1) && dot > output ? (size_t)(dot - output) : length;
    char *path = malloc(length + 12);
    if (path)
        snprintf(path, length + 12, "%.*s%05d%s", (int)stem, output, frame, output + stem);
    return path;
}

static enum csg_cli_exit render_frame(const struct csg_cli_options *options, const char *output,
                                      const struct csgcast_animation *animation, int frame,
                                      struct csgcast_renderer *renderer)
{
    char *path = frame_path(output, frame);
    struct csgcast_scene *scene = path ? csgcast_animation_scene(animation, frame) : NULL;
    const struct drawing drawing = {options, scene, renderer};
    const enum csg_cli_exit result = scene ? render_scene(&drawing, path) : CSG_EXIT_FAILED;
    if (!path)
        csg_cli_error("out of memory");
    csgcast_scene_destroy(scene);
    free(path);
    return result;
}

static void tell_progress(const struct csg_cli_options *options, int frame)
{
    if (!options->quiet && isatty(STDERR_FILENO))
        fprintf(stderr, "\rcsgcast: frame %d of %d%s", frame, options->num_animated,
                frame == options->num_animated ? "\n" : "");
}

static enum csg_cli_exit render_animation(const struct csg_cli_options *options, const char *output,
                                          struct csgcast_renderer *renderer)
{
    struct csgcast_animation *animation =
        csgcast_animation_load(options->input, options->num_animated, &options->scene);
    enum csg_cli_exit result = animation ? CSG_EXIT_OK : CSG_EXIT_FAILED;
    for (int i = 0; i < options->num_animated && result == CSG_EXIT_OK; i++) {
        tell_progress(options, i + 1);
        result = render_frame(options, output, animation, i, renderer);
    }
    csgcast_animation_destroy(animation);
    return result;
}

/* What scenes are drawn with. */
struct batch {
    struct csgcast_renderer *renderer; /* made when the first one has an image to go to */
    bool ends;                         /* with this picture the process ends */
};

static bool can_animate(const struct csg_cli_options *options, const char *output)
{
    if (!csg_path_ends(options->input, ".scad"))
        csg_cli_error("--animate needs a .scad file: %s has no $t", options->input);
    else if (!strcmp(output, "-"))
        csg_cli_error("--animate writes a file for each frame, not to standard output");
    else
        return true;
    return false;
}

/* ---- the command ---------------------------------------------------------------------------- */

/* A picture of the background alone may be what a misspelt file or a wrong -D gives. */
static void warn_empty(const struct csg_cli_options *options, const struct csgcast_scene *scene)
{
    struct csgcast_scene_info info;
    csgcast_scene_get_info(scene, &info);
    if (info.num_leaves == 0 && !options->quiet)
        csg_cli_warning("%s: nothing to draw", options->input);
}

static enum csg_cli_exit render_still(const struct csg_cli_options *options, const char *output,
                                      const struct batch *batch)
{
    struct csgcast_scene *scene = csgcast_scene_load(options->input, &options->scene);
    const struct drawing drawing = {options, scene, batch->renderer};
    const enum csg_cli_exit result = scene ? render_scene(&drawing, output) : CSG_EXIT_FAILED;
    if (scene)
        warn_empty(options, scene);
    if (batch->ends && result == CSG_EXIT_OK)
        csg_ending_now((int)result);
    csgcast_scene_destroy(scene);
    return result;
}

static bool start_renderer(const struct csg_cli_options *options, struct batch *batch)
{
    struct csgcast_renderer_params params = options->renderer;
    params.background = true;
    if (!batch->renderer)
        batch->renderer = csgcast_renderer_create(&params);
    return batch->renderer != NULL;
}

static enum csg_cli_exit run_to(const struct csg_cli_options *options, const char *output,
                                void *user)
{
    struct batch *batch = user;
    if (options->num_animated > 0 && !can_animate(options, output))
        return CSG_EXIT_USAGE;
    if (!is_png(output, options->write.format)) /* libpng is there */
        csgcast_image_preload();
    if (!start_renderer(options, batch))
        return CSG_EXIT_FAILED;
    return options->num_animated > 0 ? render_animation(options, output, batch->renderer)
                                     : render_still(options, output, batch);
}

/* The first failure is what is told; the others are drawn all the same. */
static enum csg_cli_exit run(const struct csg_cli_options *options)
{
    struct batch batch = {.renderer = NULL};
    enum csg_cli_exit first = CSG_EXIT_OK;
    if (!csg_cli_check_outputs(options, "png") || !csg_picture_is_possible(options))
        return CSG_EXIT_USAGE;
    csg_heap_begin();
    for (size_t i = 0; i < options->num_inputs; i++) {
        struct csg_cli_options one = *options;
        one.input = options->inputs[i];
        batch.ends = i + 1 == options->num_inputs && first == CSG_EXIT_OK &&
                     options->renderer.backend != CSGCAST_BACKEND_REFERENCE;
        const enum csg_cli_exit result = csg_cli_with_output(&one, "png", run_to, &batch);
        first = first == CSG_EXIT_OK ? result : first;
    }
    csgcast_renderer_destroy(batch.renderer);
    return first;
}

const struct csg_cli_command csg_command_render = {
    .name = "render",
    .bit = CSG_COMMAND_RENDER,
    .summary = "draw a scene into an image file",
    .usage = "FILE... [-o IMAGE] [OPTION...]",
    .text =
        "Draws .csg files, or .scad files by way of the installed openscad. FILE - is .csg text\n"
        "on standard input. Several files become an image each. The options are OpenSCAD's\n"
        "where it has one.\n",
    .many = true,
    .tail = "  csgcast render part.scad -o part.png\n"
            "  csgcast render part.scad -o part.png --imgsize=1024,768 --projection=o\n"
            "  csgcast render part.csg -o part.png --camera=0,0,0,55,0,25,140\n"
            "  csgcast render part.scad -D 'width=30' -o wide.png\n"
            "  csgcast render part.scad -p part.json -P large -o large.png\n"
            "  csgcast render engine.scad --animate=60 -o frame.png\n"
            "  csgcast render *.scad --imgsize=256,256 --antialias=3\n"
            "  csgcast render part.csg -o part.exr --aov=Z,N,id\n"
            "  openscad -o - --export-format csg part.scad | csgcast render - -o - > part.png\n",
    .run = run,
};
