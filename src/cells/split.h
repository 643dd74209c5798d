/* SPDX-License-Identifier: MIT */
#ifndef CSG_CELLS_SPLIT_H
#define CSG_CELLS_SPLIT_H

/* Where to cut a box: by the surface area heuristic (MacDonald and Booth 1990). */

#include "cells/leaf.h"

struct csg_split {
    int axis; /* 0, 1, 2 */
    double at;
    double cost; /* expected literals a ray of the box meets, cuts included */
};

/* Zero-initialise it. */
struct csg_splitter {
    const struct csg_cell_leaf *leaves;
    double margin; /* of the cells; cuts keep off what they cut at by twice that */
    CSG_ARRAY(struct csg_split_leaf {
        struct csg_box box; /* of what is in the box at hand */
        bool negated;
        bool is_box; /* it is all of its box */
    })
    inside;
};

/* The best cut of the box with that tree. false: none, or out of memory. */
bool csg_split_find(struct csg_splitter *splitter, const struct csg_box *box,
                    const struct csg_tree *tree, struct csg_split *split);

/* The box with one of its ends moved. */
struct csg_box csg_split_box(const struct csg_box *box, const struct csg_split *split, bool upper);

#endif
