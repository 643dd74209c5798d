/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_RESIZE_H
#define CSG_NODES_RESIZE_H

#include "solids/value.h"

/* The arguments of resize(newsize, auto). */
struct csg_resize {
    double newsize[3]; /* finite; 0 where nothing is asked for */
    bool automatic[3];
};

struct csg_resize csg_resize_read(const struct csg_args *args);

#endif
