/* SPDX-License-Identifier: MIT */

/* From the targets to the caller's buffers: GL counts rows from the bottom, they from the top. */

#include "render/picture.h"

#include <string.h>

#ifndef GL_PACK_INVERT_MESA
#define GL_PACK_INVERT_MESA 0x8758 /* GL_MESA_pack_invert: rows from the top; not in all headers */
#endif

/* Memory that is used again is faster than memory that is new. */
#define MAX_PIXELS_AT_ONCE (1 << 15)

/* Some rows of a strip. */
struct rows {
    int first, num;
    float *pixels;
};

/* Reads one attachment. */
static void read_attachment(const struct csg_picture *picture, GLenum attachment, GLenum format,
                            const struct rows *rows)
{
    struct csg_gl *gl = picture->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, picture->renderer->targets.shade_fbo);
    gl->ReadBuffer(attachment);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl->ReadPixels(0, rows->first, picture->request->width, rows->num, format, GL_FLOAT,
                   rows->pixels);
}

/* The caller's row of a strip's row. */
static size_t image_row(const struct csg_picture *picture, int row)
{
    return (size_t)(picture->request->height - 1 - picture->first_row - row);
}

static void copy_color(const struct csg_picture *picture, const struct rows *rows)
{
    const size_t stride = 4 * (size_t)picture->request->width;
    const struct csgcast_image *image = picture->request->image;
    for (int row = 0; row < rows->num; row++) {
        const float *from = rows->pixels + (size_t)row * stride;
        const size_t to = image_row(picture, rows->first + row) * stride;
        if (image->rgba)
            memcpy(image->rgba + to, from, stride * sizeof *from);
        if (image->rgba8)
            csg_color_bytes(image->rgba8 + to, from, stride);
    }
}

static void copy_geometry(const struct csg_picture *picture, const struct rows *rows)
{
    const struct csgcast_image *image = picture->request->image;
    const size_t width = (size_t)picture->request->width;
    for (int row = 0; row < rows->num; row++) {
        const float *from = rows->pixels + (size_t)row * 4 * width;
        const size_t to = image_row(picture, rows->first + row) * width;
        for (size_t x = 0; x < width; x++, from += 4) {
            if (image->z)
                image->z[to + x] = from[3];
            if (image->normal)
                memcpy(image->normal + 3 * (to + x), from, 3 * sizeof *from);
        }
    }
}

static void copy_leaf(const struct csg_picture *picture, const struct rows *rows)
{
    const size_t width = (size_t)picture->request->width;
    for (int row = 0; row < rows->num; row++)
        memcpy(picture->request->image->id + image_row(picture, rows->first + row) * width,
               rows->pixels + (size_t)row * width, width * sizeof *rows->pixels);
}

static void turn_over(uint8_t *rows, size_t num_rows, size_t stride)
{
    for (size_t row = 0; row < num_rows / 2; row++) {
        uint8_t *a = rows + row * stride, *b = rows + (num_rows - 1 - row) * stride;
        for (size_t i = 0; i < stride; i++) {
            const uint8_t kept = a[i];
            a[i] = b[i];
            b[i] = kept;
        }
    }
}

/* Straight to the caller's rows. */
static void read_bytes(const struct csg_picture *picture)
{
    struct csg_gl *gl = picture->gl;
    const size_t stride = 4 * (size_t)picture->request->width;
    uint8_t *rows =
        picture->request->image->rgba8 + stride * image_row(picture, picture->num_rows - 1);
    gl->BindFramebuffer(GL_FRAMEBUFFER, picture->renderer->targets.bytes_fbo);
    gl->ReadBuffer(GL_COLOR_ATTACHMENT0);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 4);
    if (gl->has_pack_invert)
        gl->PixelStorei(GL_PACK_INVERT_MESA, GL_TRUE);
    gl->ReadPixels(0, 0, picture->request->width, picture->num_rows, GL_RGBA, GL_UNSIGNED_BYTE,
                   rows);
    if (gl->has_pack_invert)
        gl->PixelStorei(GL_PACK_INVERT_MESA, GL_FALSE);
    else
        turn_over(rows, (size_t)picture->num_rows, stride);
}

static void read_floats(const struct csg_picture *picture, const struct rows *rows)
{
    if (picture->request->image->rgba || picture->request->image->rgba8) {
        read_attachment(picture, GL_COLOR_ATTACHMENT0, GL_RGBA, rows);
        copy_color(picture, rows);
    }
    if (picture->want_geometry) {
        read_attachment(picture, GL_COLOR_ATTACHMENT1, GL_RGBA, rows);
        copy_geometry(picture, rows);
    }
    if (picture->want_leaf) {
        read_attachment(picture, GL_COLOR_ATTACHMENT2, GL_RED, rows);
        copy_leaf(picture, rows);
    }
}

int csg_picture_rows_at_once(const struct csg_picture *picture)
{
    const int most = MAX_PIXELS_AT_ONCE / picture->request->width;
    return most < 1 ? 1 : most < picture->num_rows ? most : picture->num_rows;
}

void csg_picture_read_strip(const struct csg_picture *picture, float *pixels)
{
    const int most = csg_picture_rows_at_once(picture);
    if (picture->bytes) {
        read_bytes(picture);
        return;
    }
    for (int row = 0; row < picture->num_rows; row += most) {
        const int left = picture->num_rows - row;
        read_floats(picture, &(struct rows){row, most < left ? most : left, pixels});
    }
}
