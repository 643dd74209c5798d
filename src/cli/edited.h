/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_EDITED_H
#define CSG_CLI_EDITED_H

/* The leaf that `csgcast bench --edit` changes from frame to frame. */

#include <csgcast/csgcast.h>

#include "options.h"

struct csg_edited {
    size_t leaf;
    size_t node; /* of the leaf, whose parameters change: the first that has a number */
    enum csg_cli_edit what;
    double matrix[16]; /* as in the file */
    double step;       /* scene units */
    char *parameters;  /* as in the file */
};

/* false after a message: there is no such leaf. */
bool csg_edited_init(struct csg_edited *edited, const struct csg_cli_options *options,
                     struct csgcast_scene *scene);
void csg_edited_finish(struct csg_edited *edited);

/* Makes the frame's change, there and back, never the same twice. */
bool csg_edited_change(const struct csg_edited *edited, struct csgcast_scene *scene, int frame);

#endif
