/* SPDX-License-Identifier: MIT */
#ifndef CSG_SHARPNESS_RECALL_H
#define CSG_SHARPNESS_RECALL_H

/*
 * What was found of an object's planes, block by block in their order. An edit moves few planes:
 * where a block's and those that they are compared with are the same, to the last bit, as when
 * planes were last looked at, of whatever object, so is what is found of them.
 */

#include "sharpness/flats.h"

struct csg_recall_block {
    struct csg_sharpness sharp;
    bool stale;
};

struct csg_recall_leaf {
    uint32_t leaf;
    struct csg_box box;
};

/* Zero-initialise it. */
struct csg_recall {
    bool holds;                                /* what follows is of one object, all of it */
    CSG_ARRAY(struct csg_flat) flats;          /* sorted */
    CSG_ARRAY(struct csg_recall_leaf) leaves;  /* in the order of the tree */
    CSG_ARRAY(struct csg_recall_block) blocks; /* of flats */
    struct csg_ball ball;
    size_t num_leaves; /* of the object that is looked at, so far */
};

/* Those of leaves that have another place than they had, in marks by leaf. */
#define CSG_RECALL_MOVED 128

/* Of each leaf of an object, in the order of the tree; num_leaves is 0 before the first. false: out
 * of memory, here and below. */
bool csg_recall_add_leaf(struct csg_recall *recall, const struct csgcast_scene *scene,
                         uint32_t leaf, uint8_t *marks);

/* Then finds which blocks of its planes, which are sorted, are stale. */
bool csg_recall_compare(struct csg_recall *recall, const struct csg_flats *flats,
                        const uint8_t *marks, const struct csg_ball *ball);

size_t csg_recall_count_stale(const struct csg_recall *recall);

/* Finds anew what the stale ones have of the blocks from begin to end. */
void csg_recall_renew(struct csg_recall *recall, const struct csg_flats *flats,
                      const struct csgcast_scene *scene, size_t begin, size_t end);

void csg_recall_finish(struct csg_recall *recall);

#endif
