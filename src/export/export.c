/* SPDX-License-Identifier: MIT */
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "common/destination.h"
#include "export/pov.h"

/* A format that scenes can be exported to. */
struct format {
    const char *name; /* the extension of its files */
    /* false: out of memory; what the file says of itself is looked at by the caller. */
    bool (*write)(struct csg_text *text, const struct csgcast_scene *scene,
                  const struct csgcast_view *view, const struct csg_colorscheme *scheme,
                  const struct csgcast_frustum *frustum);
};

static const struct format formats[] = {{"pov", csg_pov_write}};

#define NUM_FORMATS (sizeof formats / sizeof *formats)

const char *csgcast_export_format_name(size_t index)
{
    return index < NUM_FORMATS ? formats[index].name : NULL;
}

static const struct format *find_format(const char *path, const char *name,
                                        const struct csg_log *log)
{
    const char *slash = strrchr(path, '/');
    const char *dot = strrchr(slash ? slash : path, '.');
    const char *wanted = name ? name : dot ? dot + 1 : "";
    if (!name && !strcmp(path, "-"))
        return &formats[0];
    for (size_t i = 0; i < NUM_FORMATS; i++)
        if (!strcasecmp(wanted, formats[i].name))
            return &formats[i];
    csg_log_error(log, CSGCAST_MESSAGE_ARGUMENT,
                  "%s: scenes are exported for POV-Ray: the file's name must end with .pov, or the "
                  "format be given as pov",
                  path);
    return NULL;
}

struct job {
    const struct csgcast_scene *scene;
    const struct csgcast_view *view;
    const struct csg_colorscheme *scheme;
    struct csgcast_frustum frustum;
    const struct format *format;
};

static bool write_file(const struct job *job, struct csg_destination *to)
{
    struct csg_text text = {.file = fopen(to->temporary, "w")};
    if (!text.file)
        return csg_destination_fail(to, strerror(errno));
    const bool ok = job->format->write(&text, job->scene, job->view, job->scheme, &job->frustum);
    errno = 0;
    const bool failed = ferror(text.file) != 0;
    if (fclose(text.file) != 0 || failed)
        return csg_destination_fail(to, errno ? strerror(errno) : "cannot be written");
    return ok || csg_log_memory(to->log);
}

bool csgcast_export(const char *path, const struct csgcast_scene *scene,
                    const struct csgcast_view *view, const char *format)
{
    static const struct csgcast_view default_view;
    if (!scene)
        return false;
    struct job job = {.scene = scene, .view = view ? view : &default_view};
    const struct csg_log *log = &scene->log;
    if (!path || !path[0]) {
        csg_log_error(log, CSGCAST_MESSAGE_ARGUMENT, "an export needs a path");
        return false;
    }
    job.scheme = csg_colorscheme_find(job.view->colorscheme);
    job.format = find_format(path, format, log);
    if (!job.scheme)
        csg_log_error(log, CSGCAST_MESSAGE_ARGUMENT, "there is no colour scheme '%s'",
                      job.view->colorscheme);
    if (!job.scheme || !job.format || !csgcast_view_resolve(scene, job.view, &job.frustum))
        return false;
    struct csg_destination to = {.path = path, .log = log};
    const bool ok = csg_destination_open(&to, job.format->name) && write_file(&job, &to) &&
                    csg_destination_commit(&to);
    csg_destination_close(&to);
    return ok;
}
