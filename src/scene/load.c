/* SPDX-License-Identifier: MIT */
#include "scene/load.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/clock.h"
#include "common/file.h"
#include "common/join.h"
#include "nodes/build.h"
#include "nodes/handoff.h"
#include "openscad/openscad.h"
#include "openscad/plain_text.h"
#include "prepare/scene.h"
#include "scene/edits.h"

static const struct csgcast_scene_params default_params;

/* Subtrees handed to openscad may turn out to be in others that need it as well. */
enum { max_rounds = 16 };

/* One scene from the nodes. NULL: memory is out, a message was given. */
static struct csgcast_scene *build(const struct csg_build_source *source,
                                   struct csg_handoff *handoff)
{
    struct csgcast_scene *scene = csg_scene_create(&source->report->to, source->report->file);
    if (scene && csg_build(scene, source, handoff))
        return scene;
    csgcast_scene_destroy(scene);
    return NULL;
}

static struct csgcast_scene *fail(struct csgcast_scene *scene)
{
    csgcast_scene_destroy(scene);
    return NULL;
}

/* Builds until nothing more is wanted from openscad; what earlier rounds said no longer holds. */
static struct csgcast_scene *build_all(const struct csg_build_source *source,
                                       struct csg_handoff *handoff)
{
    struct csg_report *report = source->report;
    for (int round = 0;; round++) {
        csg_report_hold(report);
        struct csgcast_scene *scene = build(source, round < max_rounds ? handoff : NULL);
        if (!scene || report->num[CSGCAST_LOG_ERROR] > 0 || !csg_handoff_is_wanted(handoff)) {
            csg_report_release(report);
            return scene && csg_handoff_note(handoff, scene) ? scene : fail(scene);
        }
        csg_report_drop(report);
        csgcast_scene_destroy(scene);
        if (source->origins)
            csg_origins_finish(source->origins);
        if (!csg_handoff_run(handoff, report))
            return NULL;
    }
}

struct csgcast_scene *csg_scene_read_nodes(const struct csg_build_source *source)
{
    struct csg_handoff handoff;
    csg_handoff_init(&handoff, source->params, source->document);
    struct csgcast_scene *scene = build_all(source, &handoff);
    csg_handoff_finish(&handoff);
    return scene;
}

/* document is finished by the caller. */
static struct csgcast_scene *read_document(const char *text, size_t size,
                                           const struct csgcast_scene_params *params,
                                           struct csg_origins *origins,
                                           struct csg_document *document, struct csg_report *report)
{
    const struct csg_build_source source = {
        .document = document, .params = params, .origins = origins, .report = report};
    struct csgcast_scene *scene = NULL;
    if (csg_document_parse(document, size > 0 ? text : "", size, params->num_threads, report))
        scene = csg_scene_read_nodes(&source);
    if (scene)
        scene->info.num_rounded = document->num_rounded;
    return scene;
}

static struct csgcast_scene *read_text(const char *text, size_t size,
                                       const struct csgcast_scene_params *params,
                                       struct csg_origins *origins, struct csg_document *document)
{
    const struct csg_log log = {params->log, params->log_user};
    struct csg_report report;
    csg_report_init(&report, &log, params->name ? params->name : "<memory>");
    struct csgcast_scene *scene = read_document(text, size, params, origins, document, &report);
    if (csg_report_finish(&report))
        return scene;
    csgcast_scene_destroy(scene);
    return NULL;
}

struct csgcast_scene *csg_scene_read(const char *text, size_t size,
                                     const struct csgcast_scene_params *params)
{
    struct csg_document document = {0};
    struct csgcast_scene *scene =
        read_text(text, size, params ? params : &default_params, NULL, &document);
    csg_document_finish(&document);
    return scene;
}

static void say_nothing(void *user, enum csgcast_log_level level, enum csgcast_message id,
                        const char *text)
{
    (void)user, (void)level, (void)id, (void)text;
}

struct csgcast_scene *csg_scene_reread(const struct csgcast_scene *scene,
                                       struct csg_origins *origins, struct csg_document *document)
{
    struct csgcast_scene_params quiet = scene->source->params;
    quiet.log = say_nothing;
    return read_text(scene->source->text, scene->source->size, &quiet, origins, document);
}

void csgcast_scene_destroy(struct csgcast_scene *scene)
{
    if (!scene)
        return;
    csg_edits_destroy(scene->edits);
    csg_source_destroy(scene->source);
    csg_scene_destroy(scene);
}

/* What is kept of the text, which is taken over. NULL: out of memory. */
static struct csg_source *keep_source(char *text, size_t size,
                                      const struct csgcast_scene_params *params)
{
    if (!params->fixed)
        return csg_source_create(text, size, params);
    free(text);
    return csg_source_create(NULL, 0, params);
}

/* The same as csgcast_scene_parse, but that text is taken over. */
static struct csgcast_scene *parse_own(char *text, size_t size,
                                       const struct csgcast_scene_params *params)
{
    struct csgcast_scene *scene = csg_scene_read(text, size, params);
    if (!scene) {
        free(text);
        return NULL;
    }
    scene->keeps_structure = !params->fixed;
    scene->source = keep_source(text, size, params);
    if (scene->source ? csg_scene_finish(scene, NULL) : csg_log_memory(&scene->log))
        return scene;
    csgcast_scene_destroy(scene);
    return NULL;
}

bool csg_scene_check(const struct csgcast_scene_params *params, const struct csg_log *log)
{
    const char *wrong = NULL;
    if ((unsigned)params->facets > CSGCAST_FACETS_AS_WRITTEN)
        wrong = "there is no such way to read facets";
    else if ((!params->fonts && params->num_fonts) || (!params->defines && params->num_defines))
        wrong = "there are no fonts or defines for their number";
    if (wrong)
        csg_log_error(log, CSGCAST_MESSAGE_ARGUMENT, "%s", wrong);
    return !wrong;
}

struct csgcast_scene *csgcast_scene_parse(const char *text, size_t size,
                                          const struct csgcast_scene_params *params)
{
    const struct csgcast_scene_params *used = params ? params : &default_params;
    const struct csg_log log = {used->log, used->log_user};
    if (!csg_scene_check(used, &log))
        return NULL;
    if (!text && size > 0) {
        csg_log_error(&log, CSGCAST_MESSAGE_ARGUMENT, "a scene needs a text");
        return NULL;
    }
    char *copy = malloc(size + 1);
    if (!copy) {
        csg_log_memory(&log);
        return NULL;
    }
    if (size)
        memcpy(copy, text, size);
    return parse_own(copy, size, used);
}

static struct csgcast_scene *load_csg(const char *path, const struct csgcast_scene_params *params,
                                      const struct csg_log *log)
{
    struct csgcast_scene_params named = *params;
    struct csg_bytes text;
    if (!csg_file_read(path, &text, log))
        return NULL;
    if (!named.name)
        named.name = strcmp(path, "-") == 0 ? "<stdin>" : path;
    if (!csg_plain_text_check(named.name, &text, log)) {
        free(text.data);
        return NULL;
    }
    return parse_own(text.data, text.num, &named);
}

/* Messages about the flattened text say so: its lines are not those of the .scad file. */
struct csgcast_scene *csg_scene_of_frame(const struct csg_flattened *flattened, size_t frame,
                                         const char *path,
                                         const struct csgcast_scene_params *params)
{
    const struct csg_log log = {params->log, params->log_user};
    struct csgcast_scene_params named = *params;
    struct csgcast_scene *scene = NULL;
    struct csg_bytes text;
    char *name = csg_join(params->name ? params->name : path, " (flattened by openscad)");
    named.name = name;
    named.fonts = (const char *const *)flattened->fonts.data;
    named.num_fonts = flattened->fonts.num;
    if (!name)
        csg_log_memory(&log);
    else if (csg_flattened_read(flattened, frame, &log, &text))
        scene = parse_own(text.data, text.num, &named);
    if (scene)
        scene->camera = csg_flattened_camera(flattened, frame);
    free(name);
    return scene;
}

static struct csgcast_scene *load_scad(const char *path, const struct csgcast_scene_params *params,
                                       const struct csg_log *log)
{
    struct csg_flattened flattened = {0};
    struct csgcast_scene *scene = NULL;
    if (csg_openscad_flatten(path, params, 0, log, &flattened))
        scene = csg_scene_of_frame(&flattened, 0, path, params);
    csg_flattened_finish(&flattened);
    return scene;
}

static struct csgcast_scene *load(const char *path, const struct csgcast_scene_params *params,
                                  const struct csg_log *log)
{
    const double start = csg_clock_ms();
    struct csgcast_scene *scene =
        csg_path_ends(path, ".scad") ? load_scad(path, params, log) : load_csg(path, params, log);
    if (scene)
        scene->load_ms = csg_clock_ms() - start - scene->csg_ms;
    return scene;
}

static char *directory_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    const size_t length = slash && slash > path ? (size_t)(slash - path) : 1;
    char *directory = malloc(length + 1);
    if (directory)
        snprintf(directory, length + 1, "%s", slash ? path : ".");
    return directory;
}

bool csg_scene_place(struct csgcast_scene_params *params, const char *path, char **own)
{
    *own = params->directory ? NULL : directory_of(path);
    if (*own)
        params->directory = *own;
    return params->directory != NULL;
}

struct csgcast_scene *csgcast_scene_load(const char *path,
                                         const struct csgcast_scene_params *params)
{
    struct csgcast_scene_params placed = params ? *params : default_params;
    const struct csg_log log = {placed.log, placed.log_user};
    char *own;
    if (!path) {
        csg_log_error(&log, CSGCAST_MESSAGE_ARGUMENT, "a scene needs a path");
        return NULL;
    }
    if (!csg_scene_check(&placed, &log))
        return NULL;
    if (!csg_scene_place(&placed, path, &own)) {
        csg_log_memory(&log);
        return NULL;
    }
    struct csgcast_scene *scene = load(path, &placed, &log);
    free(own);
    return scene;
}
