/* SPDX-License-Identifier: MIT */
#ifndef CSG_SCENE_PARAMETERS_H
#define CSG_SCENE_PARAMETERS_H

/* The arguments of a node as an edit has them. */

#include "csg/scene.h"
#include "document/arguments.h"

struct csg_parameters {
    char file[48];            /* that messages name: "<edit of leaf 7>" */
    struct csg_report report; /* of messages about them, until they are finished */
    char *text;
    struct csg_arguments arguments;
};

/* Reads text, that of an edit of the leaf, as what stands between the parentheses of a node with
 * that name. false, after a message: it is no such thing, or memory is out. To be finished in
 * either case. */
bool csg_parameters_read(struct csg_parameters *parameters, const struct csgcast_scene *scene,
                         uint32_t leaf, const char *node, const char *text);

/* Whether there was no error. */
bool csg_parameters_finish(struct csg_parameters *parameters);

#endif
