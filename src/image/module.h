/* SPDX-License-Identifier: MIT */
#ifndef CSG_IMAGE_MODULE_H
#define CSG_IMAGE_MODULE_H

/*
 * The border between libcsgcast and csgcast-image.so, which wraps OpenImageIO. OpenImageIO brings
 * some 260 shared libraries that take a quarter of a second to load, so image.c loads the module
 * when the first image is written that is not a PNG (png.c).
 */

#include "csgcast/csgcast.h"

#ifdef __cplusplus
extern "C" {
#endif

/* One channel of the file: pixel i, row 0 on top, is first[i * stride]. */
struct csg_image_channel {
    const char *name; /* as in the file: "R", "N.X" */
    const float *first;
    size_t stride;        /* floats, or bytes */
    const uint8_t *bytes; /* PNG only: instead of first, the values 0 to 1 as 0 to 255; or NULL */
};

struct csg_image_file {
    const char *path;   /* written to, whatever its extension */
    const char *format; /* OpenImageIO's name or an extension: "png" */
    int width, height;
    int bits; /* 8, 16, or 32 for float: what the format must hold */
    const struct csg_image_channel *channels;
    int num_channels;
    const struct csgcast_metadata *metadata;
    size_t num_metadata;
};

struct csg_image_error {
    char text[512]; /* one sentence without file name and newline */
};

/* The module's one function, named with the version of this border. false: error is filled. */
#define CSG_IMAGE_MODULE_WRITE csg_image_module_write_2
#define CSG_IMAGE_MODULE_WRITE_NAME "csg_image_module_write_2"

typedef bool csg_image_module_write_fn(const struct csg_image_file *file,
                                       struct csg_image_error *error);

#ifdef __cplusplus
}
#endif

#endif
