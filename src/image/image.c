/* SPDX-License-Identifier: MIT */

#include <ctype.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common/destination.h"
#include "common/module.h"
#include "image/module.h"
#include "image/png.h"

#define MODULE_NAME "csgcast-image.so"

enum {
    MAX_FORMAT = 16,  /* characters of an extension, with its end */
    MAX_CHANNELS = 9, /* R G B A Z N.X N.Y N.Z id */
};

/* ---- the module ---- */

/* NULL: it is not there. */
static csg_image_module_write_fn *find_write(void)
{
    csg_image_module_write_fn *write_file = NULL;
    void *const address =
        csg_module_symbol(MODULE_NAME, "CSGCAST_IMAGE_MODULE", CSG_IMAGE_MODULE_WRITE_NAME);
    memcpy(&write_file, &address, sizeof write_file);
    return write_file;
}

static bool write_with_module(const struct csg_image_file *file, struct csg_image_error *error)
{
    csg_image_module_write_fn *const write_file = find_write();
    if (write_file)
        return write_file(file, error);
    const char *reason = dlerror();
    snprintf(error->text, sizeof error->text,
             "cannot load " MODULE_NAME " (%.300s); install libopenimageio2.4 and csgcast, or "
             "set CSGCAST_IMAGE_MODULE",
             reason ? reason : "it is neither beside the library nor where modules belong");
    return false;
}

/* ---- loading ahead ---- */

#if defined(__GLIBC__)

/*
 * What C++ compilers call for a thread_local destructor; C has no name for it. exit runs these of
 * its thread before all exit handlers. That is the one moment to wait for the loading thread: once
 * the handlers of half-loaded libraries run while others are still being set up, the process dies.
 */
extern int __cxa_thread_atexit_impl(void (*function)(void *), void *argument, void *library);
extern void *__dso_handle;

struct preload {
    pthread_t thread;
    pid_t process; /* a child made by fork has no such thread */
};

static void finish_preload(void *argument)
{
    struct preload *preload = argument;
    if (preload->process == getpid())
        pthread_join(preload->thread, NULL);
    free(preload);
}

/* Needs no result: dlopen makes csgcast_image_write wait for this one, or finds it done. */
static void *run_preload(void *unused)
{
    find_write();
    return unused;
}

static void start_preload(void)
{
    sigset_t all, previous;
    struct preload *preload = malloc(sizeof *preload);
    if (!preload)
        return;
    preload->process = getpid();
    sigfillset(&all); /* the program's signals are no business of this thread */
    pthread_sigmask(SIG_SETMASK, &all, &previous);
    if (pthread_create(&preload->thread, NULL, run_preload, NULL) == 0)
        __cxa_thread_atexit_impl(finish_preload, preload, &__dso_handle);
    else
        free(preload);
    pthread_sigmask(SIG_SETMASK, &previous, NULL);
}

void csgcast_image_preload(void)
{
    static pthread_once_t once = PTHREAD_ONCE_INIT; /* the module is the process's as well */
    pthread_once(&once, start_preload);
}

#else

void csgcast_image_preload(void)
{
}

#endif

/* ---- what is written ---- */

static bool fail_argument(const struct csg_log *log, const char *path, const char *reason)
{
    csg_log_error(log, CSGCAST_MESSAGE_ARGUMENT, "%s: %s", path, reason);
    return false;
}

/* format gets the lower-case extension of the path, or the one that params asks for. */
static bool find_format(const char *path, const struct csgcast_write_params *params,
                        const struct csg_log *log, char format[MAX_FORMAT])
{
    const char *slash = strrchr(path, '/');
    const char *name = slash ? slash + 1 : path;
    const char *dot = strrchr(name, '.');
    const char *from = params->format ? params->format : dot ? dot + 1 : "";
    if (!params->format && !strcmp(path, "-"))
        from = "png";
    size_t length = 0;
    for (; from[length] && length < MAX_FORMAT - 1 && isalnum((unsigned char)from[length]);
         length++)
        format[length] = (char)tolower((unsigned char)from[length]);
    format[length] = '\0';
    return (length > 0 && !from[length]) ||
           fail_argument(log, path, "the name's extension must tell the format: .png, .exr, ...");
}

static bool is_one_of(const char *format, const char *const *names)
{
    while (*names && strcmp(format, *names))
        names++;
    return *names != NULL;
}

static bool is_exr(const char *format)
{
    static const char *const names[] = {"exr", "openexr", "sxr", "mxr", NULL};
    return is_one_of(format, names);
}

static bool is_png(const char *format)
{
    return !strcmp(format, "png");
}

static bool is_float_format(const char *format)
{
    static const char *const names[] = {"hdr", "rgbe", "pfm", NULL};
    return is_exr(format) || is_one_of(format, names);
}

static bool has_aov(const struct csgcast_write_params *params)
{
    return params->write_z || params->write_normal || params->write_id;
}

static bool find_bits(const char *path, const char *format,
                      const struct csgcast_write_params *params, const struct csg_log *log,
                      int *bits)
{
    const int asked = params->bits;
    *bits = asked ? asked : is_float_format(format) || has_aov(params) ? 32 : 8;
    if (asked && asked != 8 && asked != 16 && asked != 32)
        return fail_argument(log, path, "bits per channel are 8, 16 or 32");
    if (is_exr(format) && *bits != 32)
        return fail_argument(log, path, "EXR is written with 32 bits per channel, as float");
    if (has_aov(params) && *bits != 32)
        return fail_argument(log, path, "Z, N and id need float: EXR or 32-bit TIFF");
    return true;
}

static bool check_arguments(const char *path, int width, int height,
                            const struct csgcast_image *image,
                            const struct csgcast_write_params *params, const struct csg_log *log)
{
    if (!path || !path[0])
        return fail_argument(log, "image", "it needs a path");
    if (!image || width < 1 || height < 1)
        return fail_argument(log, path, "an image needs a width and a height");
    if ((params->write_z && !image->z) || (params->write_normal && !image->normal) ||
        (params->write_id && !image->id))
        return fail_argument(log, path, "a channel to be written has not been rendered");
    if (!image->rgba && !image->rgba8 && !has_aov(params))
        return fail_argument(log, path, "there is no channel to write");
    for (size_t i = 0; i < params->num_metadata; i++)
        if (!params->metadata[i].name || !params->metadata[i].name[0] || !params->metadata[i].value)
            return fail_argument(log, path, "metadata needs a name and a value");
    return true;
}

static bool is_opaque(const struct csgcast_image *image, size_t num_pixels)
{
    for (size_t i = 0; i < num_pixels; i++)
        if (image->rgba ? image->rgba[4 * i + 3] != 1 : image->rgba8[4 * i + 3] != 255)
            return false;
    return true;
}

/* channels gets num entries that lie side by side in values; returns the count so far. */
static int add_channels(struct csg_image_channel *channels, int num_before,
                        const char *const *names, int num, const float *values, size_t stride)
{
    for (int i = 0; i < num; i++)
        channels[num_before + i] =
            (struct csg_image_channel){.name = names[i], .first = values + i, .stride = stride};
    return num_before + num;
}

static void add_bytes(struct csg_image_channel channels[4], const char *const *names, int num,
                      const uint8_t *bytes)
{
    for (int i = 0; i < num; i++)
        channels[i] = (struct csg_image_channel){.name = names[i], .bytes = bytes + i, .stride = 4};
}

/* Without transparency there is no A, as in OpenSCAD's pictures, but EXR, for tools, has it. */
static int list_channels(const struct csgcast_image *image, size_t num_pixels, const char *format,
                         const struct csgcast_write_params *params,
                         struct csg_image_channel channels[MAX_CHANNELS])
{
    static const char *const color[] = {"R", "G", "B", "A"}, *const z[] = {"Z"},
                             *const normal[] = {"N.X", "N.Y", "N.Z"}, *const id[] = {"id"};
    const bool keeps_alpha = is_exr(format) || has_aov(params);
    int num = 0;
    if (image->rgba || image->rgba8)
        num = keeps_alpha || !is_opaque(image, num_pixels) ? 4 : 3;
    if (image->rgba)
        add_channels(channels, 0, color, num, image->rgba, 4);
    else if (image->rgba8)
        add_bytes(channels, color, num, image->rgba8);
    if (params->write_z)
        num = add_channels(channels, num, z, 1, image->z, 1);
    if (params->write_normal)
        num = add_channels(channels, num, normal, 3, image->normal, 3);
    if (params->write_id)
        num = add_channels(channels, num, id, 1, image->id, 1);
    return num;
}

/* Encoding takes longer than drawing: a second or more from about these pixels on. */
static void tell_large(const struct csg_destination *to, const struct csg_image_file *file)
{
    const double many_pixels = 16e6;
    if ((double)file->width * file->height >= many_pixels)
        csg_log_print(to->log, CSGCAST_LOG_INFO, CSGCAST_MESSAGE_PROGRESS,
                      "%s: writing %d x %d pixels", to->path, file->width, file->height);
}

static bool write_to(struct csg_destination *to, struct csg_image_file *file)
{
    struct csg_image_error error = {{0}};
    if (!csg_destination_open(to, file->format))
        return false;
    tell_large(to, file);
    file->path = to->temporary;
    if (is_png(file->format) ? csg_png_write(file, &error) : write_with_module(file, &error))
        return csg_destination_commit(to);
    csg_log_error(to->log, CSGCAST_MESSAGE_IMAGE, "%s: %s", to->path, error.text);
    return false;
}

/* OpenImageIO is given floats: the bytes of rgba8 come back from them as they were. */
static float *expand_bytes(const uint8_t *bytes, size_t num)
{
    float *values = malloc(num * sizeof *values);
    for (size_t i = 0; values && i < num; i++)
        values[i] = (float)bytes[i] / 255;
    return values;
}

static bool write_image(const char *path, const char *format, int width, int height,
                        const struct csgcast_image *image,
                        const struct csgcast_write_params *params, const struct csg_log *log)
{
    struct csg_image_channel channels[MAX_CHANNELS];
    struct csg_image_file file = {.format = format,
                                  .width = width,
                                  .height = height,
                                  .channels = channels,
                                  .metadata = params->metadata,
                                  .num_metadata = params->num_metadata};
    if (!find_bits(path, format, params, log, &file.bits))
        return false;
    file.num_channels =
        list_channels(image, (size_t)width * (size_t)height, format, params, channels);
    struct csg_destination to = {.path = path, .log = log};
    const bool ok = write_to(&to, &file);
    csg_destination_close(&to);
    return ok;
}

bool csgcast_image_write(const char *path, int width, int height, const struct csgcast_image *image,
                         const struct csgcast_write_params *params)
{
    static const struct csgcast_write_params defaults;
    params = params ? params : &defaults;
    const struct csg_log log = {params->log, params->log_user};
    char format[MAX_FORMAT];
    if (!check_arguments(path, width, height, image, params, &log) ||
        !find_format(path, params, &log, format))
        return false;
    if (image->rgba || !image->rgba8 || is_png(format))
        return write_image(path, format, width, height, image, params, &log);
    struct csgcast_image expanded = *image;
    expanded.rgba = expand_bytes(image->rgba8, 4 * (size_t)width * (size_t)height);
    const bool ok = expanded.rgba
                        ? write_image(path, format, width, height, &expanded, params, &log)
                        : csg_log_memory(&log);
    free(expanded.rgba);
    return ok;
}
