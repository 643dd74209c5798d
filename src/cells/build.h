/* SPDX-License-Identifier: MIT */
#ifndef CSG_CELLS_BUILD_H
#define CSG_CELLS_BUILD_H

/* The binary tree of cuts that cells come from, and the cells' records. */

#include "cells/bunch.h"
#include "cells/leaf.h"
#include "cells/split.h"
#include "csg/program.h"

enum { CSG_BRANCH_CELL = 3, CSG_BRANCH_OPEN = 4 };

/* A node: cut along an axis, a cell, or still to be cut. */
struct csg_branch {
    uint8_t kind; /* axis, or CSG_BRANCH_... */
    double at;    /* of a cut */
    /* of a cut: its lower part, the upper one follows; of a cell: its records [first, end), in
     * texels; open: number of its work */
    uint32_t first, end;
};

/* A box that may be cut, with what is left of the tree in it. */
struct csg_work {
    struct csg_box box;
    struct csg_tree tree;
    double cost; /* literals that rays through it meet, in proportion */
    uint32_t branch;
    uint32_t depth;
};

/* Zero-initialise it, and give it what is above branches. */
struct csg_cell_builder {
    const struct csgcast_scene *scene;
    const uint32_t *places; /* of the leaves' terms, by leaf */
    const struct csg_cell_leaf *leaves;
    double margin;
    bool bunched;
    size_t max_branches;
    CSG_ARRAY(struct csg_branch) branches; /* 0: the root */
    CSG_ARRAY(float) records;
    struct csg_bunches bunches;      /* ... in their place, where bunched */
    CSG_ARRAY(struct csg_work) work; /* a heap, the costliest first */
    struct csg_splitter splitter;
    struct csg_program program;
    struct csg_program_room program_room;
    struct csg_tree_room room; /* its tree: what is left in the box at hand */
    uint8_t *known;
    bool nested; /* see csg_cells */
    bool failed; /* out of memory */
};

/* Cuts what costs most until num works wait, none is left, or there are max_branches. */
void csg_cell_builder_cut(struct csg_cell_builder *builder, size_t num);

/* Makes cells of the works that are left. */
void csg_cell_builder_close(struct csg_cell_builder *builder);

/* Adds work, for a new root. */
void csg_cell_builder_start(struct csg_cell_builder *builder, const struct csg_box *box,
                            const struct csg_tree *tree, uint32_t depth);

void csg_cell_builder_finish(struct csg_cell_builder *builder);

#endif
