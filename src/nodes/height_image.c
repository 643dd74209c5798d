/* SPDX-License-Identifier: MIT */
/* Images as heights, by libpng: read_png_or_dat and convert_image of OpenSCAD's surface.cc. */
#include <png.h>
#include <setjmp.h>
#include <stdlib.h>
#include <string.h>

#include "nodes/heights.h"

struct reader {
    const char *at, *end;
    png_structp png;
    png_infop info;
    jmp_buf failed;
};

/* ---- what libpng calls -------------------------------------------------------------------- */

static void stop(png_structp png, png_const_charp text)
{
    struct reader *reader = png_get_error_ptr(png);
    (void)text;
    longjmp(reader->failed, 1);
}

static void ignore(png_structp png, png_const_charp text)
{
    (void)png;
    (void)text;
}

static void get_bytes(png_structp png, png_bytep bytes, size_t size)
{
    struct reader *reader = png_get_io_ptr(png);
    if (size > (size_t)(reader->end - reader->at))
        png_error(png, "the file ends early");
    memcpy(bytes, reader->at, size);
    reader->at += size;
}

/* ---- reading ------------------------------------------------------------------------------ */

bool csg_heights_is_png(const struct csg_bytes *bytes)
{
    return bytes->num >= 8 && memcmp(bytes->data, "\x89PNG\r\n\x1a\n", 8) == 0;
}

/* The header's, which is the first thing behind the signature. */
static uint64_t count_pixels(const struct csg_bytes *bytes)
{
    uint64_t sides[2] = {0};
    for (size_t i = 16; i < 24 && i < bytes->num; i++)
        sides[(i - 16) / 4] = sides[(i - 16) / 4] << 8 | (unsigned char)bytes->data[i];
    return sides[0] * sides[1];
}

static bool add_pixels(struct csg_heights *heights, png_structp png, png_infop info, bool invert)
{
    const png_bytepp rows = png_get_rows(png, info);
    const size_t width = png_get_image_width(png, info), height = png_get_image_height(png, info);
    bool ok = true;
    heights->columns = width;
    for (size_t i = height; i-- > 0 && ok;) {
        for (size_t j = 0; j < width && ok; j++) {
            const png_byte *rgb = rows[i] + 3 * j;
            const double pixel = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
            const double z = 100.0 / 255 * (invert ? 1 - pixel : pixel);
            heights->floor = z - 1 < heights->floor ? z - 1 : heights->floor;
            ok = csg_array_push(&heights->values, z);
        }
        ok = ok && csg_array_push(&heights->rows, heights->values.num);
    }
    return ok;
}

/* Eight bits, colours: neither a palette nor gamma, and of 16 bits the upper half. */
static bool read_pixels(struct reader *reader)
{
    if (setjmp(reader->failed))
        return false;
    png_set_read_fn(reader->png, reader, get_bytes);
    png_read_png(reader->png, reader->info,
                 PNG_TRANSFORM_STRIP_16 | PNG_TRANSFORM_EXPAND | PNG_TRANSFORM_GRAY_TO_RGB |
                     PNG_TRANSFORM_STRIP_ALPHA,
                 NULL);
    return png_get_rowbytes(reader->png, reader->info) ==
           3 * (size_t)png_get_image_width(reader->png, reader->info);
}

enum csg_heights_result csg_heights_read_png(struct csg_heights *heights,
                                             const struct csg_bytes *bytes, bool invert)
{
    struct reader reader = {.at = bytes->data, .end = bytes->data + bytes->num};
    enum csg_heights_result result = CSG_HEIGHTS_NO_MEMORY;
    if (count_pixels(bytes) > CSG_HEIGHTS_MAX)
        return CSG_HEIGHTS_TOO_MANY;
    reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reader, stop, ignore);
    reader.info = reader.png ? png_create_info_struct(reader.png) : NULL;
    if (reader.info)
        result = read_pixels(&reader) ? CSG_HEIGHTS_DONE : CSG_HEIGHTS_BROKEN;
    if (result == CSG_HEIGHTS_DONE && !add_pixels(heights, reader.png, reader.info, invert))
        result = CSG_HEIGHTS_NO_MEMORY;
    png_destroy_read_struct(&reader.png, &reader.info, NULL);
    return result;
}
