/* SPDX-License-Identifier: MIT */
#include "image/png.h"

#include <errno.h>
#include <png.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum {
    MAX_SIDE = 0x7fffffff, /* the format's; libpng's own default is a million pixels */
    MAX_KEYWORD = 79,      /* bytes, the format's */
};

struct writer {
    const struct csg_image_file *file;
    struct csg_image_error *error;
    FILE *to;
    png_structp png;
    png_infop info;
    png_bytep row;
    char *description;
    jmp_buf failed;
};

static bool fail(struct csg_image_error *error, const char *text)
{
    snprintf(error->text, sizeof error->text, "%s", text);
    return false;
}

/* ---- what libpng calls ---- */

static void stop(png_structp png, png_const_charp text)
{
    struct writer *writer = png_get_error_ptr(png);
    fail(writer->error, text);
    longjmp(writer->failed, 1);
}

static void ignore(png_structp png, png_const_charp text)
{
    (void)png;
    (void)text;
}

static void put_bytes(png_structp png, png_bytep bytes, size_t size)
{
    struct writer *writer = png_get_io_ptr(png);
    if (fwrite(bytes, 1, size, writer->to) != size)
        stop(png, strerror(errno));
}

static void put_nothing(png_structp png)
{
    (void)png; /* fclose flushes */
}

/* ---- texts ---- */

static bool has_entry(const struct csg_image_file *file, const char *name)
{
    for (size_t i = 0; i < file->num_metadata; i++)
        if (!strcasecmp(file->metadata[i].name, name))
            return true;
    return false;
}

/* The format's word for what other formats call by another name. */
static const char *find_keyword(const char *name)
{
    static const char *const words[][2] = {
        {"ImageDescription", "Description"}, {"DocumentName", "Title"}, {"Artist", "Author"}};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (!strcasecmp(name, words[i][0]))
            return words[i][1];
    return name;
}

static void put_text(struct writer *writer, const char *name, const char *value)
{
    char keyword[MAX_KEYWORD + 1], *text;
    snprintf(keyword, sizeof keyword, "%s", find_keyword(name));
    memcpy(&text, &value, sizeof text); /* png_text is for reading as well, so not const */
    png_set_text(
        writer->png, writer->info,
        &(png_text){.compression = PNG_TEXT_COMPRESSION_NONE, .key = keyword, .text = text}, 1);
}

/* All entries, a line each, as formats without names of one's own have them. NULL: no memory. */
static char *describe(const struct csg_image_file *file)
{
    size_t size = 1;
    for (size_t i = 0; i < file->num_metadata; i++)
        size += strlen(file->metadata[i].name) + strlen(file->metadata[i].value) + 3;
    char *text = malloc(size);
    size_t length = 0;
    for (size_t i = 0; text && i < file->num_metadata; i++)
        length += (size_t)snprintf(text + length, size - length, "%s: %s\n", file->metadata[i].name,
                                   file->metadata[i].value);
    return text;
}

static void put_texts(struct writer *writer)
{
    const struct csg_image_file *file = writer->file;
    if (!has_entry(file, "Software"))
        put_text(writer, "Software", "csgcast " CSGCAST_VERSION_STRING);
    for (size_t i = 0; i < file->num_metadata; i++)
        put_text(writer, file->metadata[i].name, file->metadata[i].value);
    if (file->num_metadata > 0 && !has_entry(file, "ImageDescription"))
        put_text(writer, "Description", writer->description);
}

/* ---- rows ---- */

/* Rounded to the nearest step; outside 0 to 1, NaN included, the nearest thing to it. */
static unsigned quantise(float value, float most)
{
    return (unsigned)((value > 0 ? value < 1 ? value : 1 : 0) * most + 0.5f);
}

/* 65535 is 257 times 255: the step of 16 bits that is nearest to a byte's value is that value. */
static void gather_bytes(const struct csg_image_file *file, size_t start, png_bytep row)
{
    const size_t width = (size_t)file->width, num = (size_t)file->num_channels;
    const size_t repeats = file->bits == 8 ? 1 : 2;
    for (size_t c = 0; c < num; c++) {
        const size_t stride = file->channels[c].stride;
        const uint8_t *from = file->channels[c].bytes + start * stride;
        for (size_t x = 0; x < width; x++)
            for (size_t i = 0; i < repeats; i++)
                row[repeats * (x * num + c) + i] = from[x * stride];
    }
}

static void gather_row(const struct csg_image_file *file, int y, png_bytep row)
{
    const size_t width = (size_t)file->width, num = (size_t)file->num_channels;
    if (file->channels[0].bytes) {
        gather_bytes(file, (size_t)y * width, row);
        return;
    }
    for (size_t c = 0; c < num; c++) {
        const size_t stride = file->channels[c].stride;
        const float *from = file->channels[c].first + (size_t)y * width * stride;
        if (file->bits == 8)
            for (size_t x = 0; x < width; x++)
                row[x * num + c] = (png_byte)quantise(from[x * stride], 255);
        else
            for (size_t x = 0; x < width; x++)
                png_save_uint_16(row + 2 * (x * num + c), quantise(from[x * stride], 65535));
    }
}

/* ---- the file ---- */

static void put_header(struct writer *writer)
{
    const struct csg_image_file *file = writer->file;
    png_set_user_limits(writer->png, MAX_SIDE, MAX_SIDE);
    png_set_IHDR(writer->png, writer->info, (png_uint_32)file->width, (png_uint_32)file->height,
                 file->bits, file->num_channels == 4 ? PNG_COLOR_TYPE_RGBA : PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(writer->png, writer->info, PNG_sRGB_INTENT_ABSOLUTE);
    png_set_filter(writer->png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
    put_texts(writer);
    png_write_info(writer->png, writer->info);
}

static bool encode(struct writer *writer)
{
    if (setjmp(writer->failed))
        return false;
    put_header(writer);
    for (int y = 0; y < writer->file->height; y++) {
        gather_row(writer->file, y, writer->row);
        png_write_row(writer->png, writer->row);
    }
    png_write_end(writer->png, NULL);
    return true;
}

static bool start(struct writer *writer)
{
    const struct csg_image_file *file = writer->file;
    writer->row = malloc((size_t)file->width * (size_t)file->num_channels * 2);
    writer->description = describe(file);
    writer->png = png_create_write_struct(PNG_LIBPNG_VER_STRING, writer, stop, ignore);
    writer->info = writer->png ? png_create_info_struct(writer->png) : NULL;
    if (!writer->row || !writer->description || !writer->info)
        return fail(writer->error, "out of memory");
    writer->to = fopen(file->path, "wb");
    if (!writer->to)
        return fail(writer->error, strerror(errno));
    png_set_write_fn(writer->png, writer, put_bytes, put_nothing);
    return true;
}

static bool finish(struct writer *writer)
{
    const bool is_closed = !writer->to || fclose(writer->to) == 0;
    if (!is_closed && !writer->error->text[0])
        fail(writer->error, strerror(errno));
    png_destroy_write_struct(&writer->png, &writer->info);
    free(writer->description);
    free(writer->row);
    return is_closed;
}

static bool check_file(const struct csg_image_file *file, struct csg_image_error *error)
{
    if (file->num_channels != 3 && file->num_channels != 4)
        return fail(error, "png holds colour only: Z, N and id need EXR or 32-bit TIFF");
    if (file->bits != 8 && file->bits != 16)
        return fail(error, "png does not hold 32 bits per channel: EXR and TIFF hold float");
    return true;
}

bool csg_png_write(const struct csg_image_file *file, struct csg_image_error *error)
{
    struct writer writer = {.file = file, .error = error};
    if (!check_file(file, error))
        return false;
    const bool is_encoded = start(&writer) && encode(&writer);
    return finish(&writer) && is_encoded;
}
