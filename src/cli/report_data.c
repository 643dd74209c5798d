/* SPDX-License-Identifier: MIT */

/* The report's figures for programs: CSV and JSON. */

#include "json.h"
#include "report.h"

#include <math.h>

static const char *const series_names[] = {"csgcast", "reference", "CGAL", "Manifold"};

/* ---- CSV ------------------------------------------------------------------------------------ */

void csg_report_print_csv(const struct csg_report *report, FILE *file)
{
    fputs("scene,item,series,fn,triangles,prepare_ms,first_ms,frame_median_ms,frame_min_ms,"
          "frame_max_ms,frames,covered_pixels,silhouette_pixels,other_surface_pixels,"
          "nan_pixels,depth_mean,depth_p99,depth_p999,depth_max,normal_p99_degrees,note\n",
          file);
    for (size_t i = 0; i < report->items.num; i++) {
        const struct csg_report_item *item = &report->items.data[i];
        const struct csg_picture_errors *e = &item->errors;
        fprintf(file, "\"%s\",\"%s\",%s,%d,%zu,%.6g,%.6g,%.6g,%.6g,%.6g,%d,", item->scene,
                item->name, series_names[item->series], item->fn, item->num_triangles,
                item->prepare_ms, item->first_ms, item->frame.median, item->frame.min,
                item->frame.max, item->frame.num);
        fprintf(file, "%zu,%zu,%zu,%zu,%.6g,%.6g,%.6g,%.6g,%.6g,\"%s\"\n", e->covered,
                e->silhouette, e->other, e->nan, e->depth_mean, e->depth_p99, e->depth_p999,
                e->depth_max, e->normal_p99, item->note);
    }
}

void csg_report_print_sweeps_csv(const struct csg_report *report, FILE *file)
{
    fputs("sweep,value,variant,rays,covered_pixels,silhouette_pixels,other_surface_pixels,"
          "nan_pixels,depth_p99,depth_p999,depth_max,normal_p999_degrees\n",
          file);
    for (size_t i = 0; i < report->sweeps.num; i++) {
        const struct csg_sweep_item *item = &report->sweeps.data[i];
        const struct csg_picture_errors *e = &item->errors;
        fprintf(file, "%s,%g,%s,%zu,%zu,%zu,%zu,%zu,%.6g,%.6g,%.6g,%.6g\n", item->sweep,
                item->value, item->variant, e->pixels, e->covered, e->silhouette, e->other, e->nan,
                e->depth_p99, e->depth_p999, e->depth_max, e->normal_p999);
    }
}

/* ---- JSON ----------------------------------------------------------------------------------- */

static void json_errors(struct csg_json *json, const struct csg_picture_errors *errors)
{
    csg_json_open(json, "errors");
    csg_json_size(json, "pixels", errors->pixels);
    csg_json_size(json, "covered", errors->covered);
    csg_json_size(json, "silhouette", errors->silhouette);
    csg_json_size(json, "other_surface", errors->other);
    csg_json_size(json, "nan", errors->nan);
    csg_json_number(json, "depth_mean", errors->depth_mean);
    csg_json_number(json, "depth_p99", errors->depth_p99);
    csg_json_number(json, "depth_p999", errors->depth_p999);
    csg_json_number(json, "depth_max", errors->depth_max);
    csg_json_number(json, "normal_p99", errors->normal_p99);
    csg_json_number(json, "normal_p999", errors->normal_p999);
    csg_json_close(json);
}

static void json_item(struct csg_json *json, const struct csg_report_item *item)
{
    csg_json_open(json, NULL);
    csg_json_string(json, "scene", item->scene);
    csg_json_string(json, "item", item->name);
    csg_json_string(json, "series", series_names[item->series]);
    csg_json_size(json, "fn", (size_t)item->fn);
    csg_json_size(json, "triangles", item->num_triangles);
    csg_json_number(json, "prepare_ms", item->prepare_ms);
    csg_json_number(json, "first_ms", item->first_ms);
    csg_json_open(json, "frame_ms");
    csg_json_number(json, "median", item->frame.median);
    csg_json_number(json, "min", item->frame.min);
    csg_json_number(json, "max", item->frame.max);
    csg_json_size(json, "frames", (size_t)item->frame.num);
    csg_json_close(json);
    json_errors(json, &item->errors);
    csg_json_string(json, "note", item->note);
    csg_json_close(json);
}

static void json_sweep(struct csg_json *json, const struct csg_sweep_item *item)
{
    csg_json_open(json, NULL);
    csg_json_string(json, "sweep", item->sweep);
    csg_json_number(json, "value", item->value);
    csg_json_string(json, "variant", item->variant);
    json_errors(json, &item->errors);
    csg_json_close(json);
}

void csg_report_print_json(const struct csg_report *report, FILE *file)
{
    struct csg_json json = {.file = file};
    csg_json_open(&json, NULL);
    csg_json_string(&json, "version", csgcast_version());
    csg_json_string(&json, "date", report->date);
    csg_json_string(&json, "processor", report->processor);
    csg_json_string(&json, "renderer", report->renderer);
    csg_json_string(&json, "openscad", report->openscad);
    csg_json_size(&json, "width", (size_t)report->size[0]);
    csg_json_size(&json, "height", (size_t)report->size[1]);
    csg_json_bool(&json, "quick", report->options->report.quick);
    csg_json_number(&json, "load_begin", report->load[0]);
    csg_json_number(&json, "load_end", report->load[1]);
    csg_json_number(&json, "limit_seconds", report->options->report.limit);
    csg_json_list_open(&json, "items");
    for (size_t i = 0; i < report->items.num; i++)
        json_item(&json, &report->items.data[i]);
    csg_json_list_close(&json);
    csg_json_list_open(&json, "sweeps");
    for (size_t i = 0; i < report->sweeps.num; i++)
        json_sweep(&json, &report->sweeps.data[i]);
    csg_json_list_close(&json);
    csg_json_close(&json);
}
