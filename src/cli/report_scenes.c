/* SPDX-License-Identifier: MIT */

/* Error against time for one scene: csgcast's variants, and meshes by $fn, drawn in turns. */

#include "common/clock.h"
#include "common/file.h"
#include "common/order.h"
#include "messages.h"
#include "process.h"
#include "report.h"
#include "report/raster.h"
#include "report_meshes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A later frame is drawn so often; items above SLOW_MS a frame only once. */
#define NUM_FRAMES 15
#define NUM_FRAMES_QUICK 5
#define SLOW_MS 2000

static const int fns[] = {8, 16, 32, 64, 128, 256, 512};
static const int quick_fns[] = {8, 32, 128};

/* What is drawn again and again. */
struct drawer {
    struct csg_report_item item;
    struct csgcast_renderer *renderer; /* or */
    struct csg_raster_mesh mesh;       /* of the bench's raster */
    bool is_mesh;
    double times[NUM_FRAMES];
};

struct bench {
    struct csg_report *report;
    const char *path, *name;
    struct csgcast_scene *scene;
    struct csgcast_view view;
    struct csgcast_frustum frustum;
    double radius, load_ms;
    size_t num_pixels;
    struct csgcast_image expected, got;
    struct csg_raster *raster;
    CSG_ARRAY(struct drawer) drawers;
};

static bool make_image(struct csgcast_image *image, size_t num)
{
    image->z = malloc(num * sizeof *image->z);
    image->normal = malloc(3 * num * sizeof *image->normal);
    return image->z && image->normal;
}

static void free_image(struct csgcast_image *image)
{
    free(image->z);
    free(image->normal);
}

static bool draw(struct bench *bench, struct drawer *drawer)
{
    struct csgcast_view view = bench->view;
    if (drawer->is_mesh)
        return csg_raster_draw(bench->raster, &drawer->mesh, &bench->frustum, view.width,
                               view.height, &bench->got);
    if (drawer->item.series == CSG_SERIES_VARIANT)
        view.variant = drawer->item.name;
    return csgcast_render(drawer->renderer, bench->scene, &view, &bench->got);
}

static bool judge(struct bench *bench, struct drawer *drawer)
{
    return csg_picture_errors(&bench->got, &bench->expected, bench->num_pixels, bench->radius,
                              &drawer->item.errors);
}

static struct drawer *add_drawer(struct bench *bench, enum csg_series series, const char *name)
{
    struct drawer drawer = {.item = {.scene = bench->name, .series = series}};
    snprintf(drawer.item.name, sizeof drawer.item.name, "%s", name);
    return csg_array_push(&bench->drawers, drawer) ? &bench->drawers.data[bench->drawers.num - 1]
                                                   : NULL;
}

/* ---- csgcast -------------------------------------------------------------------------------- */

/* The reference comes first: it is what the others are judged by. */
static bool add_reference(struct bench *bench)
{
    struct csgcast_renderer_params params = bench->report->options->renderer;
    struct drawer *drawer = add_drawer(bench, CSG_SERIES_REFERENCE, "reference");
    const double begun = csg_clock_ms();
    params.backend = CSGCAST_BACKEND_REFERENCE;
    if (!drawer)
        return false;
    drawer->item.prepare_ms = bench->load_ms;
    drawer->renderer = csgcast_renderer_create(&params);
    if (!drawer->renderer || !draw(bench, drawer))
        return false;
    drawer->item.first_ms = csg_clock_ms() - begun;
    memcpy(bench->expected.z, bench->got.z, bench->num_pixels * sizeof(float));
    memcpy(bench->expected.normal, bench->got.normal, 3 * bench->num_pixels * sizeof(float));
    return judge(bench, drawer);
}

static bool add_variant(struct bench *bench, const char *variant)
{
    struct drawer *drawer = add_drawer(bench, CSG_SERIES_VARIANT, variant);
    const double begun = csg_clock_ms();
    if (!drawer)
        return false;
    drawer->item.prepare_ms = bench->load_ms;
    drawer->renderer = csgcast_renderer_create(&bench->report->options->renderer);
    if (!drawer->renderer || !draw(bench, drawer))
        return false;
    drawer->item.first_ms = csg_clock_ms() - begun;
    struct csgcast_stats stats;
    csgcast_renderer_get_stats(drawer->renderer, &stats);
    if (strcmp(variant, csg_report_variant(0)) != 0 && !strstr(stats.variants, variant))
        snprintf(drawer->item.note, sizeof drawer->item.note, "does not draw this scene");
    return judge(bench, drawer);
}

/* ---- meshes --------------------------------------------------------------------------------- */

/* false: larger meshes of the series need not be tried. */
static bool add_mesh(struct bench *bench, enum csg_series series, int fn)
{
    char name[48];
    snprintf(name, sizeof name, "%s $fn=%d", series == CSG_SERIES_CGAL ? "CGAL" : "Manifold", fn);
    csg_report_progress(bench->report, "%s: %s", bench->name, name);
    struct drawer *drawer = add_drawer(bench, series, name);
    struct csg_soup soup = {0};
    if (!drawer)
        return false;
    drawer->item.fn = fn;
    if (!csg_report_make_mesh(bench->report, bench->path, &drawer->item, &soup))
        return false;
    drawer->is_mesh = true;
    drawer->item.num_triangles = soup.num_triangles;
    const double begun = csg_clock_ms();
    const bool ok = csg_raster_upload(bench->raster, &soup, &drawer->mesh) && draw(bench, drawer);
    drawer->item.first_ms = csg_clock_ms() - begun;
    csg_soup_finish(&soup);
    if (!ok || !judge(bench, drawer))
        snprintf(drawer->item.note, sizeof drawer->item.note, "cannot be drawn");
    return ok;
}

static void add_meshes(struct bench *bench, enum csg_series series)
{
    const bool quick = bench->report->options->report.quick;
    const int *numbers = quick ? quick_fns : fns;
    const int num = (int)(quick ? sizeof quick_fns / sizeof *quick_fns : sizeof fns / sizeof *fns);
    for (int i = 0; i < num; i++)
        if (!add_mesh(bench, series, numbers[i]))
            return;
}

/* ---- frames --------------------------------------------------------------------------------- */

static bool time_frame(struct bench *bench, struct drawer *drawer)
{
    struct csg_report_times *frame = &drawer->item.frame;
    const double begun = csg_clock_ms();
    if (!draw(bench, drawer))
        return false;
    drawer->times[frame->num++] = csg_clock_ms() - begun;
    return true;
}

/* One frame of each, and again, so that whatever else the machine does hits all of them. */
static bool time_frames(struct bench *bench)
{
    const int num = bench->report->options->report.quick ? NUM_FRAMES_QUICK : NUM_FRAMES;
    bool ok = true;
    csg_report_progress(bench->report, "%s: frames in turns", bench->name);
    for (int round = 0; round < num; round++)
        for (size_t i = 0; i < bench->drawers.num && ok; i++) {
            struct drawer *drawer = &bench->drawers.data[i];
            if (!drawer->item.note[0] && (round == 0 || drawer->times[0] < SLOW_MS))
                ok = time_frame(bench, drawer);
        }
    for (size_t i = 0; i < bench->drawers.num; i++) {
        struct drawer *drawer = &bench->drawers.data[i];
        struct csg_report_times *frame = &drawer->item.frame;
        if (!frame->num)
            continue;
        qsort(drawer->times, (size_t)frame->num, sizeof *drawer->times, csg_compare_doubles);
        frame->median = drawer->times[frame->num / 2];
        frame->min = drawer->times[0];
        frame->max = drawer->times[frame->num - 1];
    }
    return ok;
}

/* ---- the scene ------------------------------------------------------------------------------ */

static bool open_scene(struct bench *bench)
{
    const struct csg_report *report = bench->report;
    const double begun = csg_clock_ms();
    double lo[3], hi[3], sum = 0;
    csg_report_progress(report, "%s", bench->name);
    bench->scene = csgcast_scene_load(bench->path, &report->options->scene);
    bench->load_ms = csg_clock_ms() - begun;
    if (!bench->scene || !csgcast_scene_get_bounds(bench->scene, lo, hi) ||
        !csgcast_view_resolve(bench->scene, &bench->view, &bench->frustum))
        return false;
    for (int i = 0; i < 3; i++)
        sum += (hi[i] - lo[i]) * (hi[i] - lo[i]);
    bench->radius = isfinite(sum) && sum > 0 ? 0.5 * sqrt(sum) : 1;
    bench->num_pixels = (size_t)bench->view.width * (size_t)bench->view.height;
    const struct csg_log log = {report->options->scene.log, report->options->scene.log_user};
    bench->raster = csg_raster_create(report->options->renderer.backend, &log);
    return bench->raster && make_image(&bench->expected, bench->num_pixels) &&
           make_image(&bench->got, bench->num_pixels);
}

static void close_scene(struct bench *bench)
{
    for (size_t i = 0; i < bench->drawers.num; i++) {
        struct drawer *drawer = &bench->drawers.data[i];
        csgcast_renderer_destroy(drawer->renderer);
        if (drawer->is_mesh)
            csg_raster_delete(bench->raster, &drawer->mesh);
    }
    free(bench->drawers.data);
    csg_raster_destroy(bench->raster);
    free_image(&bench->expected);
    free_image(&bench->got);
    csgcast_scene_destroy(bench->scene);
}

static bool measure(struct bench *bench)
{
    if (!open_scene(bench) || !add_reference(bench))
        return false;
    for (size_t i = 0; csg_report_variant(i); i++)
        if (!add_variant(bench, csg_report_variant(i)))
            return false;
    if (csg_path_ends(bench->path, ".scad")) { /* .csg text has its facets' numbers written in */
        add_meshes(bench, CSG_SERIES_CGAL);
        if (bench->report->has_wasm)
            add_meshes(bench, CSG_SERIES_MANIFOLD);
    }
    return time_frames(bench);
}

static char *name_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    const char *name = slash ? slash + 1 : path, *dot = strrchr(name, '.');
    const size_t length = dot && dot != name ? (size_t)(dot - name) : strlen(name);
    char *copy = calloc(length + 1, 1);
    if (copy)
        memcpy(copy, name, length);
    return copy;
}

bool csg_report_measure_scene(struct csg_report *report, const char *path)
{
    struct bench bench = {.report = report, .path = path, .name = name_of(path)};
    bench.view = report->options->view;
    bench.view.width = report->size[0];
    bench.view.height = report->size[1];
    bool ok = bench.name && csg_array_push(&report->scenes, (char *)bench.name);
    ok = ok && measure(&bench);
    for (size_t i = 0; i < bench.drawers.num && ok; i++)
        ok = csg_array_push(&report->items, bench.drawers.data[i].item);
    if (!ok)
        csg_cli_error("%s cannot be measured", path);
    close_scene(&bench);
    return ok;
}
