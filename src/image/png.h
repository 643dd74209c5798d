/* SPDX-License-Identifier: MIT */
#ifndef CSG_IMAGE_PNG_H
#define CSG_IMAGE_PNG_H

/*
 * PNG straight through libpng. It is the default format, and libpng loads in a millisecond, where
 * OpenImageIO takes longer than a picture. What is in the file is what OpenImageIO would write:
 * the same samples, the same texts, the colour space sRGB, rows unfiltered, zlib's default level.
 */

#include "image/module.h"

/* Writes R G B, or R G B A, of 8 or 16 bits to file->path. false: error is filled. Any thread. */
bool csg_png_write(const struct csg_image_file *file, struct csg_image_error *error);

#endif
