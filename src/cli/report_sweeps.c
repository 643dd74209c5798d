/* SPDX-License-Identifier: MIT */

/*
 * Scenes with one parameter that goes where float32 breaks ray casters, from many sides, judged by
 * the reference. tests/extreme has more of them and judges the reference itself, in long double.
 */

#include "common/random.h"
#include "messages.h"
#include "report.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

/* A text, and the camera that looks at it. */
struct shot {
    char text[1024];
    struct csgcast_view view;
};

/* The eye at distance from the origin, anywhere; reach: half of what the picture holds there. */
static void look(struct shot *shot, uint64_t *dice, double distance, double reach)
{
    struct csgcast_camera *camera = &shot->view.camera;
    const double z = csg_random_between(dice, -0.95, 0.95),
                 turn = csg_random_between(dice, 0, 2 * PI);
    const double flat = sqrt(1 - z * z);
    camera->kind = CSGCAST_CAMERA_VECTOR;
    camera->eye[0] = distance * flat * cos(turn);
    camera->eye[1] = distance * flat * sin(turn);
    camera->eye[2] = distance * z;
    camera->fov = 2 * atan(reach / distance) * 180 / PI;
}

static void make_distance(struct shot *shot, uint64_t *dice, double value)
{
    snprintf(shot->text, sizeof shot->text,
             "rotate([%.17g, %.17g, %.17g]) difference() {\n"
             "  union() { cylinder(h = 12, r1 = 7, r2 = 4, center = true); sphere(r = 6);\n"
             "    cube([16, 5, 7], center = true); }\n"
             "  translate([3, 1, 2]) sphere(r = 4);\n"
             "  cylinder(h = 30, r = 2, center = true);\n}\n",
             csg_random_between(dice, 0, 360), csg_random_between(dice, 0, 360),
             csg_random_between(dice, 0, 360));
    look(shot, dice, 10 * value, 10);
}

/* A needle or a disc of half length 10, seen whole or so near that its thickness shows. */
static void make_aspect(struct shot *shot, uint64_t *dice, double value)
{
    static const char *const kinds[] = {"sphere(r = 10)", "cylinder(h = 20, r = 10, center = true)",
                                        "cylinder(h = 20, r1 = 10, r2 = 0, center = true)"};
    const double thin = 1 / value;
    const bool needle = csg_random_between(dice, 0, 1) < 0.5,
               near = csg_random_between(dice, 0, 1) < 0.5;
    const char *kind = kinds[(int)csg_random_between(dice, 0, 3)];
    snprintf(shot->text, sizeof shot->text,
             "rotate([%.17g, %.17g, %.17g]) scale([%.17g, %.17g, %.17g]) %s;\n",
             csg_random_between(dice, 0, 360), csg_random_between(dice, 0, 360),
             csg_random_between(dice, 0, 360), needle ? thin : 1, needle ? thin : 1,
             needle ? 1 : thin, kind);
    look(shot, dice, 40, near ? 12 * thin : 11);
}

/* A hollow ball with a wall of that part of its radius, cut open. The hollow is off the middle by
 * a third of the wall, so that no rounding is the same on both sides of it. */
static void make_shell(struct shot *shot, uint64_t *dice, double value)
{
    snprintf(shot->text, sizeof shot->text,
             "rotate([%.17g, %.17g, %.17g]) difference() {\n  sphere(r = 10);\n"
             "  translate([%.17g, %.17g, %.17g]) sphere(r = %.17g);\n"
             "  translate([5, 5, 5]) cube(20);\n  translate([-14, -14, -14]) cube(12);\n}\n",
             csg_random_between(dice, 0, 360), csg_random_between(dice, 0, 360),
             csg_random_between(dice, 0, 360), csg_random_between(dice, -2, 2) * value,
             csg_random_between(dice, -2, 2) * value, csg_random_between(dice, -2, 2) * value,
             10 * (1 - value));
    look(shot, dice, 40, 11);
}

struct sweep {
    struct csg_sweep_text text;
    double values[8];
    int num;
    void (*make)(struct shot *shot, uint64_t *dice, double value);
};

static const struct sweep sweeps[] = {
    {{"distance", "distance / radius",
      "A part of cones, balls and boxes from ever further away, always as large in the picture"},
     {2, 10, 1e2, 1e3, 1e4, 1e5, 1e6},
     7,
     make_distance},
    {{"aspect", "length / thickness",
      "Needles and discs, ellipsoids, cylinders and cones, seen whole and so near that the "
      "thickness shows"},
     {1, 10, 1e2, 1e3, 1e4, 1e5, 1e6},
     7,
     make_aspect},
    {{"thickness", "wall / radius",
      "A hollow ball with an ever thinner wall, cut open, the hollow a little off the middle"},
     {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6},
     6,
     make_shell},
};

enum { NUM_SWEEPS = sizeof sweeps / sizeof *sweeps };

const struct csg_sweep_text *csg_report_sweep(size_t index)
{
    return index < NUM_SWEEPS ? &sweeps[index].text : NULL;
}

struct pictures {
    struct csgcast_renderer *renderer, *reference;
    struct csgcast_image expected, got;
    size_t num_pixels;
};

static bool make_image(struct csgcast_image *image, size_t num)
{
    image->z = malloc(num * sizeof *image->z);
    image->normal = malloc(3 * num * sizeof *image->normal);
    image->id = malloc(num * sizeof *image->id);
    return image->z && image->normal && image->id;
}

static void free_image(struct csgcast_image *image)
{
    free(image->z);
    free(image->normal);
    free(image->id);
}

/* Adds one variant's errors in one shot to the item; the last one wins at a NaN. */
static bool add_shot(struct pictures *pictures, const struct csgcast_scene *scene,
                     struct csgcast_view *view, struct csg_sweep_item *item)
{
    struct csg_picture_errors errors;
    view->variant = item->variant;
    if (!csgcast_render(pictures->renderer, scene, view, &pictures->got) ||
        !csg_picture_errors(&pictures->got, &pictures->expected, pictures->num_pixels, 0, &errors))
        return false;
    csg_picture_errors_add(&item->errors, &errors);
    return true;
}

static bool run_shot(const struct csg_report *report, struct pictures *pictures,
                     const struct shot *shot, struct csg_sweep_item *items, size_t num_items)
{
    struct csgcast_scene_params params = report->options->scene;
    struct csgcast_view view = shot->view;
    params.name = "<sweep>";
    params.num_defines = 0;
    struct csgcast_scene *scene = csgcast_scene_parse(shot->text, strlen(shot->text), &params);
    bool ok = scene && csgcast_render(pictures->reference, scene, &view, &pictures->expected);
    for (size_t i = 0; i < num_items && ok; i++)
        ok = add_shot(pictures, scene, &view, &items[i]);
    csgcast_scene_destroy(scene);
    return ok;
}

/* All variants see the same shots. */
static bool run_value(struct csg_report *report, struct pictures *pictures,
                      const struct sweep *sweep, double value, int num_shots, int size)
{
    const size_t first = report->sweeps.num;
    uint64_t dice = (uint64_t)(sweep - sweeps) + 1;
    bool ok = true;
    for (size_t i = 0; csg_report_variant(i); i++) {
        const struct csg_sweep_item item = {
            .sweep = sweep->text.name, .variant = csg_report_variant(i), .value = value};
        if (!csg_array_push(&report->sweeps, item))
            return false;
    }
    for (int i = 0; i < num_shots && ok; i++) {
        struct shot shot = {.view = {.width = size, .height = size}};
        sweep->make(&shot, &dice, value);
        ok = run_shot(report, pictures, &shot, report->sweeps.data + first,
                      report->sweeps.num - first);
    }
    return ok;
}

bool csg_report_measure_sweeps(struct csg_report *report)
{
    const bool quick = report->options->report.quick;
    const int wanted = quick ? 64 : 128, num_shots = quick ? 4 : 12;
    const int size = report->size[0] < wanted ? report->size[0] : wanted;
    const struct csgcast_renderer_params *params = &report->options->renderer;
    const struct csgcast_renderer_params reference = {
        .backend = CSGCAST_BACKEND_REFERENCE, .log = params->log, .log_user = params->log_user};
    struct pictures pictures = {.renderer = csgcast_renderer_create(params),
                                .reference = csgcast_renderer_create(&reference),
                                .num_pixels = (size_t)size * (size_t)size};
    bool ok = pictures.renderer && pictures.reference &&
              make_image(&pictures.expected, pictures.num_pixels) &&
              make_image(&pictures.got, pictures.num_pixels);
    report->sweep_rays = pictures.num_pixels * (size_t)num_shots;
    for (int i = 0; i < NUM_SWEEPS; i++)
        for (int j = 0; j < sweeps[i].num && ok; j++) {
            csg_report_progress(report, "sweep %s = %g", sweeps[i].text.parameter,
                                sweeps[i].values[j]);
            ok = run_value(report, &pictures, &sweeps[i], sweeps[i].values[j], num_shots, size);
        }
    if (!ok)
        csg_cli_error("the sweeps cannot be measured");
    free_image(&pictures.expected);
    free_image(&pictures.got);
    csgcast_renderer_destroy(pictures.renderer);
    csgcast_renderer_destroy(pictures.reference);
    return ok;
}
