/* SPDX-License-Identifier: MIT */

/* The report's page: what was measured, where it fails, and how to read it. */

#include "report.h"

#include <math.h>
#include <string.h>

/* A variant counts as failing in a sweep where this share of the covered pixels is wrong. */
#define FAILING_SHARE 1e-4

static const char *variant_label(const char *variant)
{
    return strcmp(variant, "auto") == 0 ? "csgcast" : variant;
}

static const char *label_of(const struct csg_report_item *item)
{
    return item->series == CSG_SERIES_REFERENCE  ? "reference (C, double)"
           : item->series != CSG_SERIES_VARIANT  ? item->name
           : strcmp(item->name, "auto") == 0     ? "**csgcast**"
           : strcmp(item->name, "textbook") == 0 ? "textbook"
           : strcmp(item->name, "double") == 0   ? "csgcast, double"
                                                 : item->name;
}

static void print_head(const struct csg_report *report, FILE *file)
{
    fprintf(file,
            "# Error against time\n\n"
            "How far a picture is from the exact solid, and what it costs: csgcast, and OpenSCAD's "
            "meshes drawn with OpenGL. Made by\n`csgcast report`%s, csgcast %s, %s, on %s; %s; "
            "%s.\nPictures of %d x %d pixels, OpenSCAD's default camera. `./run report DIR` makes "
            "this page anew from a fresh clone.\n\n",
            report->options->report.quick ? " --quick" : "", csgcast_version(), report->date,
            report->processor, report->renderer, report->openscad, report->size[0],
            report->size[1]);
    if (fmax(report->load[0], report->load[1]) > (double)report->num_processors)
        fprintf(file,
                "**The machine was busy**: %.0f to %.0f processes wanted its %ld processors "
                "meanwhile. Times are too long, all of them alike, but for chance:\nread them as "
                "ratios, and mind the bars.\n\n",
                fmin(report->load[0], report->load[1]), fmax(report->load[0], report->load[1]),
                report->num_processors);
}

static void print_reading(const struct csg_report *report, FILE *file)
{
    fputs(
        "## How to read it\n\n"
        "* **Error** is the distance to the picture that csgcast's reference draws of the same "
        "file: a ray caster in C, in double, with another\n  algorithm, itself checked in long "
        "double and by point membership (`tests/extreme`, `tests/coincidence`). *Wrong* pixels "
        "hit where there is\n  nothing, miss where there is something, or show another surface "
        "(more than a fifth of the scene's radius off). Of the others, *depth error*\n  is |z - "
        "z_reference| as a share of the scene's radius: the value that 99 % of the pixels do "
        "not exceed, and the largest. Depths are written\n  as float, which alone costs some "
        "10^-7. Zeroes lie on the lower edge of the plots.\n"
        "* **Time to the first image** is what a user waits for: the scene is read (a .scad "
        "through openscad), programs are compiled or the mesh is\n  made and uploaded, one frame "
        "is "
        "drawn and read back. **A later frame** is the same view once more: nothing is made anew. "
        "All frames are drawn\n  in turns, one of each and again; the bars go from the fastest to "
        "the "
        "slowest, the mark is the median. Both sides read depth and normals back.\n"
        "* **Meshes** are OpenSCAD's with `-D '$fn=N'`. *CGAL* is the kernel of the installed "
        "openscad, timed as a process; *Manifold* is OpenSCAD 2025's,\n  as WebAssembly in "
        "node, timed without the start of node; native code is faster. "
        "Solids with an explicit "
        "`$fn` of at\n  most 12 stay polygons on both sides.\n"
        "* **textbook** is the quadratic formula as textbooks have it, in world space and "
        "float32, in the same pipeline (`--variant=textbook`)\n"
        "  but for tiles: where csgcast cuts large objects into them, the textbook's time says "
        "what that gains, not what the arithmetic costs.",
        file);
    fputs(csg_report_variant(2)
              ? " **double** is\n  csgcast's own terms in double precision in the shader "
                "(`--variant=double`).\n\n"
              : "\n\n",
          file);
    if (!report->has_wasm)
        fputs("The Manifold kernel is not installed here and left out.\n\n", file);
    if (!report->has_gnuplot)
        fputs("gnuplot is not installed here: there are no plots.\n\n", file);
}

/* ---- scenes --------------------------------------------------------------------------------- */

static void print_item(const struct csg_report_item *item, FILE *file)
{
    const struct csg_picture_errors *e = &item->errors;
    if (item->note[0]) {
        fprintf(file, "| %s | %s | | | | | | | |\n", label_of(item), item->note);
        return;
    }
    fprintf(file, "| %s | ", label_of(item));
    if (item->num_triangles)
        fprintf(file, "%zu", item->num_triangles);
    fprintf(file, " | %.0f | %.0f | %.1f (%.1f to %.1f) | ", item->prepare_ms,
            item->prepare_ms + item->first_ms, item->frame.median, item->frame.min,
            item->frame.max);
    if (item->series == CSG_SERIES_REFERENCE)
        fprintf(file, "- | - | - | - |\n");
    else
        fprintf(file, "%zu | %.1e | %.1e | %.2g |\n", e->silhouette + e->other + e->nan,
                e->depth_p99, e->depth_max, e->normal_p99);
}

static const struct csg_report_item *find_item(const struct csg_report *report, const char *scene,
                                               const char *name)
{
    for (size_t i = 0; i < report->items.num; i++)
        if (strcmp(report->items.data[i].scene, scene) == 0 &&
            strcmp(report->items.data[i].name, name) == 0)
            return &report->items.data[i];
    return NULL;
}

/* The finest mesh of a series in the scene; NULL: none. */
static const struct csg_report_item *finest_mesh(const struct csg_report *report, const char *scene,
                                                 enum csg_series series)
{
    const struct csg_report_item *finest = NULL;
    for (size_t i = 0; i < report->items.num; i++) {
        const struct csg_report_item *item = &report->items.data[i];
        if (strcmp(item->scene, scene) == 0 && item->series == series && !item->note[0])
            finest = item;
    }
    return finest;
}

static void print_comparison(const struct csg_report_item *ours, const struct csg_report_item *mesh,
                             FILE *file)
{
    const double error = mesh->errors.depth_p99 / fmax(ours->errors.depth_p99, 1e-12);
    const double first = (mesh->prepare_ms + mesh->first_ms) / (ours->prepare_ms + ours->first_ms);
    const double frame = mesh->frame.median / ours->frame.median;
    fprintf(file,
            " The finest mesh here, %s: its depth error is %.2g times csgcast's, its first image "
            "comes after %.2g times as long, and a frame of it takes %.2g times csgcast's.",
            mesh->name, error, first, frame);
}

static void print_scene(const struct csg_report *report, const char *scene, FILE *file)
{
    const struct csg_report_item *ours = find_item(report, scene, "auto");
    fprintf(file, "### %s\n\n", scene);
    if (report->has_gnuplot)
        fprintf(file, "![error against time, %s](" CSG_REPORT_NAME "-%s.png)\n\n", scene, scene);
    fputs(
        "| | triangles | scene or mesh made, ms | first image, ms | later frame, ms | wrong pixels "
        "| depth error 99 % | max | normal 99 %, deg |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
        file);
    for (size_t i = 0; i < report->items.num; i++)
        if (strcmp(report->items.data[i].scene, scene) == 0)
            print_item(&report->items.data[i], file);
    if (!ours)
        return;
    fprintf(file, "\n%zu pixels are covered.", ours->errors.covered);
    const struct csg_report_item *mesh = finest_mesh(report, scene, CSG_SERIES_MANIFOLD);
    mesh = mesh ? mesh : finest_mesh(report, scene, CSG_SERIES_CGAL);
    if (mesh)
        print_comparison(ours, mesh, file);
    fputs("\n\n", file);
}

/* ---- sweeps --------------------------------------------------------------------------------- */

static const struct csg_sweep_item *find_sweep(const struct csg_report *report, const char *sweep,
                                               const char *variant, double value)
{
    for (size_t i = 0; i < report->sweeps.num; i++) {
        const struct csg_sweep_item *item = &report->sweeps.data[i];
        if (strcmp(item->sweep, sweep) == 0 && strcmp(item->variant, variant) == 0 &&
            item->value == value)
            return item;
    }
    return NULL;
}

static void print_sweep_row(const struct csg_report *report, const char *sweep, double value,
                            FILE *file)
{
    fprintf(file, "| %g |", value);
    for (size_t i = 0; csg_report_variant(i); i++) {
        const struct csg_sweep_item *item = find_sweep(report, sweep, csg_report_variant(i), value);
        if (item)
            fprintf(file, " %.2g | %.1e |", csg_picture_errors_wrong(&item->errors),
                    item->errors.depth_p999);
        else
            fputs(" | |", file);
    }
    fputc('\n', file);
}

/* From which value on a variant fails. */
static void print_failing(const struct csg_report *report, const struct csg_sweep_text *sweep,
                          const char *variant, FILE *file)
{
    for (size_t i = 0; i < report->sweeps.num; i++) {
        const struct csg_sweep_item *item = &report->sweeps.data[i];
        if (strcmp(item->sweep, sweep->name) != 0 || strcmp(item->variant, variant) != 0 ||
            csg_picture_errors_wrong(&item->errors) <= FAILING_SHARE)
            continue;
        fprintf(file, " %s from %g on.", variant_label(variant), item->value);
        return;
    }
    fprintf(file, " %s nowhere.", variant_label(variant));
}

static void print_sweep(const struct csg_report *report, const struct csg_sweep_text *sweep,
                        FILE *file)
{
    fprintf(file, "### %s\n\n%s.\n\n", sweep->parameter, sweep->about);
    if (report->has_gnuplot)
        fprintf(file, "![%s](" CSG_REPORT_NAME "-%s.png)\n\n", sweep->parameter, sweep->name);
    fprintf(file, "| %s |", sweep->parameter);
    for (size_t i = 0; csg_report_variant(i); i++)
        fprintf(file, " %s: wrong | depth 99.9 %% |", variant_label(csg_report_variant(i)));
    fputs("\n| --- |", file);
    for (size_t i = 0; csg_report_variant(i); i++)
        fputs(" --- | --- |", file);
    fputc('\n', file);
    for (size_t i = 0; i < report->sweeps.num; i++)
        if (strcmp(report->sweeps.data[i].sweep, sweep->name) == 0 &&
            strcmp(report->sweeps.data[i].variant, csg_report_variant(0)) == 0)
            print_sweep_row(report, sweep->name, report->sweeps.data[i].value, file);
    fprintf(file, "\nMore than %g of the covered pixels are wrong:", FAILING_SHARE);
    for (size_t i = 0; csg_report_variant(i); i++)
        print_failing(report, sweep, csg_report_variant(i), file);
    fputs("\n\n", file);
}

void csg_report_print_page(const struct csg_report *report, FILE *file)
{
    print_head(report, file);
    print_reading(report, file);
    fputs("## Scenes\n\n", file);
    for (size_t i = 0; i < report->scenes.num; i++)
        print_scene(report, report->scenes.data[i], file);
    fprintf(
        file,
        "A mesh's error falls with the square of `$fn` and its cost rises with it; the exact "
        "surface has no such knob. What dominates the first image of\ncsgcast is openscad, "
        "which reads the .scad, and the compiling of programs where the driver's cache does "
        "not know them; of a mesh, its Boolean\noperations. A finished mesh is cheap to draw: "
        "where a model never changes and its facets are fine enough, a mesh is the faster "
        "preview.\n\n"
        "## Numerical stability\n\n"
        "Each value is measured by %zu rays from random sides, the same for all variants. "
        "*Wrong*: hit or miss, or the visible solid, differs from the\nreference's, as a share of "
        "the pixels covered; a pixel whose ray passes an edge or a silhouette by less than float's "
        "rounding counts as well, so that a\nfew in 10^5 are the price of any float32 picture. "
        "*Depth*: relative to the distance, 99.9 %% of the pixels, the worst shot.\nFull suites, "
        "with bars: `tests/extreme` and [measured-numerics.md](measured-numerics.md).\n\n",
        report->sweep_rays);
    for (size_t i = 0; csg_report_sweep(i); i++)
        print_sweep(report, csg_report_sweep(i), file);
    fputs("The figures are in `" CSG_REPORT_NAME ".csv`, `" CSG_REPORT_NAME
          "-sweeps.csv` and `" CSG_REPORT_NAME ".json` beside the page that the command "
          "writes.\n",
          file);
}
