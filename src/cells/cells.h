/* SPDX-License-Identifier: MIT */
#ifndef CSG_CELLS_CELLS_H
#define CSG_CELLS_CELLS_H

/*
 * Large objects cut into cells: boxes in space, each with the part of the tree that matters in it.
 * A ray walks from cell to cell (shaders/csg/walk.glsl), so it meets only what is near it. Cells
 * depend on the scene alone, not on the view.
 */

#include <stdint.h>

#include "csg/object.h"

/* Faces that a record of a cell names, 8 bits each, counted from 1. */
#define CSG_CELL_FACES 4
#define CSG_CELL_FACE_BITS 8

/* Flags of a record are below this; above them is the fourth face. */
#define CSG_CELL_FLAGS 1024

struct csg_kept;

struct csg_cells {
    struct csg_box box; /* the root; larger than the object by margin at least */
    double margin;      /* a cell's tree holds that far around it, in scene units */
    /*
     * Texels, four floats each; all places count from the first one, which is the root.
     *     split   three places across an axis, from the box's center, CSG_CELL_NOWHERE where there
     *             are fewer; place of the first child, a multiple of 4, + axis
     *     cell    first record, end of the records, 0, 3
     *     record  three faces, flags and the fourth face, place of the leaf's terms, leaf
     * The children of a split, one more than it has places, follow one another.
     */
    CSG_ARRAY(float) texels;
    uint64_t hash;         /* of the texels */
    size_t depth;          /* of splits */
    bool bunched;          /* cells hold bunches, see cells/bunch.h, instead of records */
    bool nested;           /* some cell's tree is no chain: its program needs a stack */
    struct csg_kept *kept; /* of a scene that is edited: what the next cells may have of these */
};

#define CSG_CELL_NOWHERE 1e20f

/* All places in the texture are floats. */
#define CSG_CELLS_MAX_TEXELS ((size_t)1 << 24)

/* The cells of an object that can be cut so, made by that many threads (csg_parallel). before:
 * parts of earlier ones, which may be taken, NULL: none. NULL: out of memory, or they do not fit
 * their texture.
 */
struct csg_cells *csg_cells_create(const struct csgcast_scene *scene,
                                   const struct csg_object *object, struct csg_kept *before,
                                   int num_threads);
void csg_cells_destroy(struct csg_cells *cells);

/* What making them costs at most, in tests of a solid at a pixel in tiles. */
double csg_cells_cost(const struct csgcast_scene *scene, const struct csg_object *object);

/* Whether an object can be cut into cells: bounded, without surfaces of triangles, its leaves of at
 * most 255 faces. */
bool csg_cells_can_hold(const struct csgcast_scene *scene, const struct csg_object *object);

#endif
