/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_PICTURE_H
#define CSG_CLI_PICTURE_H

/* The picture in memory: what of it the options ask for. */

#include "options.h"

#define CSG_PICTURE_SIZE 512 /* pixels, as csgcast_view's 0 */

/* Whether distances, normals or owners are asked for. */
bool csg_picture_has_aov(const struct csgcast_write_params *write);

/* Whether the options go together; false after a message. */
bool csg_picture_is_possible(const struct csg_cli_options *options);

/* bytes: colours as bytes. false after a message. */
bool csg_picture_allocate(struct csgcast_image *image, const struct csgcast_view *view,
                          const struct csgcast_write_params *write, bool bytes);

void csg_picture_free(struct csgcast_image *image);

#endif
