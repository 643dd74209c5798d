/* SPDX-License-Identifier: MIT */

/* The report's pictures, by gnuplot. */

#include "messages.h"
#include "process.h"
#include "report.h"

#include <limits.h>
#include <math.h>
#include <string.h>

/* Zeroes have no place on a logarithmic scale: they are drawn at these. */
#define LEAST_ERROR 1e-9
#define LEAST_SHARE 1e-7

static const char head[] =
    "set terminal pngcairo size 1000,430 font 'sans,10' background '#ffffff'\n"
    "set output '%s/" CSG_REPORT_NAME "-%s.png'\n"
    "set logscale xy\n"
    "set format '10^{%%T}'\n"
    "set grid lc rgb '#dddddd'\n"
    "set border lc rgb '#444444'\n"
    "set tics nomirror\n"
    "set multiplot layout 1,2 title '%s' noenhanced\n";

/* The same colour and mark for the same thing in every picture. */
static const char *style_of(const char *name)
{
    static const struct {
        const char *name, *style;
    } styles[] = {{"auto", "lc rgb '#1b6ca8' pt 7 ps 1.5 lw 2"},
                  {"textbook", "lc rgb '#c0392b' pt 9 ps 1.6 lw 2"},
                  {"double", "lc rgb '#5b3f99' pt 5 ps 1.4 lw 2"},
                  {"CGAL", "lc rgb '#777777' pt 4 ps 1.2 lw 1.5"},
                  {"Manifold", "lc rgb '#2e8b57' pt 6 ps 1.2 lw 1.5"}};
    for (size_t i = 0; i < sizeof styles / sizeof *styles; i++)
        if (strcmp(styles[i].name, name) == 0)
            return styles[i].style;
    return "lw 2";
}

static const char *title_of(const char *variant)
{
    return strcmp(variant, "auto") == 0       ? "csgcast"
           : strcmp(variant, "textbook") == 0 ? "textbook quadratic in float"
           : strcmp(variant, "double") == 0   ? "csgcast, double in the shader"
                                              : variant;
}

/* ---- error against time --------------------------------------------------------------------- */

static bool is_drawn(const struct csg_report_item *item, const char *scene)
{
    return strcmp(item->scene, scene) == 0 && !item->note[0] && item->frame.num > 0 &&
           item->series != CSG_SERIES_REFERENCE;
}

/* A data block: first image, median, min, max, depth error, $fn. */
static size_t print_block(const struct csg_report *report, FILE *file, const char *scene,
                          const char *block, enum csg_series series, const char *name)
{
    size_t num = 0;
    fprintf(file, "$%s << EOD\n", block);
    for (size_t i = 0; i < report->items.num; i++) {
        const struct csg_report_item *item = &report->items.data[i];
        if (!is_drawn(item, scene) || item->series != series || (name && strcmp(item->name, name)))
            continue;
        fprintf(file, "%g %g %g %g %g \"%d\"\n", item->prepare_ms + item->first_ms,
                item->frame.median, item->frame.min, item->frame.max,
                fmax(item->errors.depth_p99, LEAST_ERROR), item->fn);
        num++;
    }
    fprintf(file, "EOD\n");
    return num;
}

static void print_panel(FILE *file, bool frames, const bool has[2], size_t num_variants)
{
    static const char *const series[] = {"CGAL", "Manifold"};
    const char *x = frames ? "2" : "1";
    bool first = true;
    fprintf(file, "set xlabel '%s'\n",
            frames ? "ms for a later frame (bars: fastest and slowest)"
                   : "ms from the file to the first image");
    fprintf(file, "plot ");
    for (int i = 0; i < 2; i++) {
        if (!has[i])
            continue;
        fprintf(file, "%s$%s using %s:5 with linespoints %s title 'mesh by %s, $fn at the mark'",
                first ? "" : ", ", series[i], x, style_of(series[i]), series[i]);
        fprintf(file, ", $%s using %s:5:6 with labels offset 0,0.8 font ',8' notitle", series[i],
                x);
        if (frames)
            fprintf(file, ", $%s using 2:5:3:4 with xerrorbars %s notitle", series[i],
                    style_of(series[i]));
        first = false;
    }
    for (size_t i = 0; i < num_variants; i++) {
        const char *variant = csg_report_variant(i);
        if (frames)
            fprintf(file, "%s$%s using 2:5:3:4 with xerrorbars %s title '%s'", first ? "" : ", ",
                    variant, style_of(variant), title_of(variant));
        else
            fprintf(file, "%s$%s using 1:5 with points %s title '%s'", first ? "" : ", ", variant,
                    style_of(variant), title_of(variant));
        first = false;
    }
    fputc('\n', file);
}

static void print_scene(const struct csg_report *report, FILE *file, const char *scene)
{
    bool has[2];
    size_t num = 0;
    fprintf(file, head, report->folder, scene, scene);
    has[0] = print_block(report, file, scene, "CGAL", CSG_SERIES_CGAL, NULL) > 0;
    has[1] = print_block(report, file, scene, "Manifold", CSG_SERIES_MANIFOLD, NULL) > 0;
    for (; csg_report_variant(num); num++)
        print_block(report, file, scene, csg_report_variant(num), CSG_SERIES_VARIANT,
                    csg_report_variant(num));
    fprintf(file,
            "set ylabel 'depth error, 99 %% of pixels / radius of the scene'\n"
            "set yrange [%g:1]\nset key bottom left font ',9' box lc rgb '#bbbbbb' opaque\n",
            LEAST_ERROR);
    print_panel(file, false, has, num);
    fprintf(file, "unset key\n");
    print_panel(file, true, has, num);
    fprintf(file, "unset multiplot\nreset\n");
}

/* ---- sweeps --------------------------------------------------------------------------------- */

static void print_sweep_block(const struct csg_report *report, FILE *file, const char *sweep,
                              const char *variant)
{
    fprintf(file, "$%s << EOD\n", variant);
    for (size_t i = 0; i < report->sweeps.num; i++) {
        const struct csg_sweep_item *item = &report->sweeps.data[i];
        if (strcmp(item->sweep, sweep) == 0 && strcmp(item->variant, variant) == 0)
            fprintf(file, "%g %g %g\n", item->value,
                    fmax(csg_picture_errors_wrong(&item->errors), LEAST_SHARE),
                    fmax(item->errors.depth_p999, LEAST_ERROR));
    }
    fprintf(file, "EOD\n");
}

static void print_sweep(const struct csg_report *report, FILE *file,
                        const struct csg_sweep_text *sweep)
{
    size_t num = 0;
    fprintf(file, head, report->folder, sweep->name, sweep->parameter);
    for (; csg_report_variant(num); num++)
        print_sweep_block(report, file, sweep->name, csg_report_variant(num));
    for (int panel = 0; panel < 2; panel++) {
        fprintf(file, "set xlabel '%s'\nset ylabel '%s'\nset yrange [%g:%g]\n", sweep->parameter,
                panel ? "depth error, 99.9 % of pixels / distance" : "wrong pixels, share",
                panel ? LEAST_ERROR : LEAST_SHARE, panel ? 1.0 : 1.5);
        fprintf(file, panel ? "set key bottom left font ',9' box lc rgb '#bbbbbb' opaque\n"
                            : "unset key\n");
        fprintf(file, "plot ");
        for (size_t i = 0; i < num; i++)
            fprintf(file, "%s$%s using 1:%d with linespoints %s title '%s'", i ? ", " : "",
                    csg_report_variant(i), panel + 2, style_of(csg_report_variant(i)),
                    title_of(csg_report_variant(i)));
        fputc('\n', file);
    }
    fprintf(file, "unset multiplot\nreset\n");
}

/* ---- gnuplot -------------------------------------------------------------------------------- */

static bool print_script(const struct csg_report *report, const char *path)
{
    FILE *file = fopen(path, "w");
    if (!file)
        return false;
    for (size_t i = 0; i < report->scenes.num; i++)
        print_scene(report, file, report->scenes.data[i]);
    for (size_t i = 0; csg_report_sweep(i); i++)
        print_sweep(report, file, csg_report_sweep(i));
    const bool ok = !ferror(file);
    return fclose(file) == 0 && ok;
}

static void show_log(const char *path)
{
    char line[512];
    FILE *file = fopen(path, "r");
    while (file && fgets(line, sizeof line, file))
        fprintf(stderr, "csgcast: gnuplot: %s", line);
    if (file)
        fclose(file);
}

bool csg_report_plot(const struct csg_report *report)
{
    struct csg_folder folder = {0};
    char script[PATH_MAX], log[PATH_MAX];
    const char *argv[] = {"gnuplot", script, NULL};
    csg_report_progress(report, "plots");
    if (!csg_process_make_folder(&folder))
        return false;
    snprintf(script, sizeof script, "%s/plot.gp", folder.path);
    snprintf(log, sizeof log, "%s/log", folder.path);
    const bool ok = print_script(report, script) &&
                    csg_process_run(argv, log, 120, 0, NULL) == CSG_PROCESS_DONE;
    if (!ok) {
        show_log(log);
        csg_cli_error("gnuplot does not draw the plots");
    }
    csg_folder_remove(&folder);
    return ok;
}
