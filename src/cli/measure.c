/* SPDX-License-Identifier: MIT */
#include "measure.h"

#include "antialias.h"
#include "edited.h"
#include "messages.h"
#include "picture.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "common/clock.h"
#include "common/order.h"

#define DEGREE (3.14159265358979323846 / 180)

static struct csg_spread spread_of(double *values, size_t num)
{
    qsort(values, num, sizeof *values, csg_compare_doubles);
    const double median = num % 2 ? values[num / 2] : 0.5 * (values[num / 2 - 1] + values[num / 2]);
    return (struct csg_spread){median, values[0], values[num - 1]};
}

/* ---- what changes from frame to frame -------------------------------------------------------- */

/* The camera turned about the z axis through what it looks at. */
static void turn_camera(struct csgcast_camera *camera, double degrees)
{
    if (camera->kind == CSGCAST_CAMERA_VECTOR) {
        const double x = camera->eye[0] - camera->center[0], y = camera->eye[1] - camera->center[1];
        const double c = cos(degrees * DEGREE), s = sin(degrees * DEGREE);
        camera->eye[0] = camera->center[0] + c * x - s * y;
        camera->eye[1] = camera->center[1] + s * x + c * y;
        return;
    }
    if (camera->kind == CSGCAST_CAMERA_DEFAULT) {
        camera->kind = CSGCAST_CAMERA_GIMBAL;
        camera->rotate[0] = 55;
        camera->rotate[2] = 25;
        camera->distance = 1; /* viewall finds it */
        camera->viewall = camera->autocenter = true;
    }
    camera->rotate[2] += degrees;
}

/* ---- the frames ------------------------------------------------------------------------------ */

struct run {
    const struct csg_cli_options *options;
    const char *input;
    struct csgcast_scene *scene;
    struct csgcast_renderer *renderer;
    struct csgcast_view view; /* of all rays */
    struct csgcast_image image;
    struct csg_edited edited;
    struct csg_frame_times *times; /* num_frames */
    struct csg_measurement *result;
};

static bool is_verbose(const struct run *run)
{
    return !run->options->quiet && isatty(STDERR_FILENO);
}

static bool draw(struct run *run)
{
    const bool good = csgcast_render(run->renderer, run->scene, &run->view, &run->image);
    if (good)
        csg_antialias_reduce(&run->image, run->result->width, run->result->height,
                             run->options->antialias);
    csgcast_renderer_get_stats(run->renderer, &run->result->stats);
    run->result->compile_ms += run->result->stats.compile_ms;
    return good;
}

static struct csg_frame_times stages_of(const struct csgcast_stats *stats)
{
    return (struct csg_frame_times){.cpu = stats->cpu_ms,
                                    .csg = stats->csg_ms,
                                    .tile = stats->tile_ms,
                                    .pack = stats->pack_ms,
                                    .upload = stats->upload_ms,
                                    .draw = stats->draw_ms,
                                    .read = stats->read_ms};
}

static bool draw_first(struct run *run)
{
    struct csgcast_scene_params params = run->options->scene;
    params.fixed = !run->options->edit;
    const double begun = csg_clock_ms();
    run->scene = csgcast_scene_load(run->input, &params);
    run->result->load_ms = csg_clock_ms() - begun;
    run->renderer = run->scene ? csgcast_renderer_create(&run->options->renderer) : NULL;
    if (!run->renderer || !draw(run))
        return false;
    run->result->first_image_ms = csg_clock_ms() - begun;
    run->result->first = stages_of(&run->result->stats);
    run->result->first_programs = run->result->stats.programs;
    return true;
}

static bool draw_frame(struct run *run, int frame)
{
    const double begun = csg_clock_ms(), worked = csg_clock_work_ms();
    if (run->options->orbit)
        turn_camera(&run->view.camera, 360.0 / run->result->num_frames);
    if (run->options->edit && !csg_edited_change(&run->edited, run->scene, frame))
        return false;
    const double edited = csg_clock_ms();
    if (!draw(run))
        return false;
    struct csg_frame_times *times = &run->times[frame];
    *times = stages_of(&run->result->stats);
    times->frame = csg_clock_ms() - begun;
    times->work = csg_clock_work_ms() - worked;
    times->edit = run->options->edit ? edited - begun : 0;
    times->csg = run->options->edit ? times->csg : 0;
    if (is_verbose(run))
        fprintf(stderr, "\r%s: frame %d of %d \r", run->input, frame + 1, run->result->num_frames);
    return true;
}

/* Of one member of all times; offset: where it is in them. */
static struct csg_spread spread_at(const struct run *run, size_t offset, double *room)
{
    const size_t num = (size_t)run->result->num_frames;
    for (size_t i = 0; i < num; i++)
        memcpy(&room[i], (const char *)&run->times[i] + offset, sizeof *room);
    return spread_of(room, num);
}

static bool find_spreads(const struct run *run)
{
    struct csg_measurement *result = run->result;
    double *room = malloc((size_t)result->num_frames * sizeof *room);
    if (!room)
        return csg_cli_error("out of memory"), false;
    for (size_t at = 0; at < sizeof result->medians; at += sizeof(double)) {
        const double median = spread_at(run, at, room).median;
        memcpy((char *)&result->medians + at, &median, sizeof median);
    }
    result->frame_ms = spread_at(run, offsetof(struct csg_frame_times, frame), room);
    free(room);
    return true;
}

static bool draw_frames(struct run *run)
{
    if (run->options->edit && !csg_edited_init(&run->edited, run->options, run->scene))
        return false;
    bool good = true;
    for (int frame = 0; frame < run->result->num_frames && good; frame++)
        good = draw_frame(run, frame);
    if (is_verbose(run))
        fprintf(stderr, "\033[K");
    return good && find_spreads(run);
}

/* Colours as the bytes of a PNG, unless a file of other bits or channels is meant. */
static bool allocate(struct run *run)
{
    const struct csgcast_write_params *write = &run->options->write;
    const bool bytes = !csg_picture_has_aov(write) && write->bits <= 8;
    run->times = calloc((size_t)run->result->num_frames, sizeof *run->times);
    if (!run->times)
        return csg_cli_error("out of memory"), false;
    return csg_picture_allocate(&run->image, &run->view, write, bytes);
}

static bool measure(struct run *run)
{
    const struct csgcast_view view = run->view;
    if (!csg_antialias_view(&view, run->options->antialias, &run->view) || !allocate(run) ||
        !draw_first(run) || !draw_frames(run))
        return false;
    run->result->num_leaves = csgcast_scene_num_leaves(run->scene);
    snprintf(run->result->renderer, sizeof run->result->renderer, "%s",
             csgcast_renderer_name(run->renderer));
    return true;
}

bool csg_measure(const struct csg_cli_options *options, const char *input,
                 struct csg_measurement *result)
{
    struct run run = {.options = options, .input = input, .view = options->view, .result = result};
    run.view.width = run.view.width ? run.view.width : CSG_PICTURE_SIZE;
    run.view.height = run.view.height ? run.view.height : CSG_PICTURE_SIZE;
    *result = (struct csg_measurement){
        .width = run.view.width, .height = run.view.height, .num_frames = options->num_frames};
    const bool good = measure(&run);
    csg_edited_finish(&run.edited);
    csgcast_renderer_destroy(run.renderer);
    csgcast_scene_destroy(run.scene);
    csg_picture_free(&run.image);
    free(run.times);
    return good;
}
