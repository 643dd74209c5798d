/* SPDX-License-Identifier: MIT */
#ifndef CSG_SCENE_READING_H
#define CSG_SCENE_READING_H

/* A node that becomes a part, read anew by itself once arguments in it have changed. */

#include "scene/edits.h"

struct csg_reading {
    uint32_t first, num_before;  /* the leaves that it has in the scene */
    struct csgcast_scene *scene; /* that it was read in, and there */
    struct csg_origins origins;
    uint32_t begin, num;         /* ... its leaves, */
    const struct csg_node *part; /* ... its tree; NULL: nothing is left of it */
    uint32_t part_begin, part_end;
    bool negated;  /* ... which is complemented */
    bool is_alike; /* the tree is the one that the scene has */
};

/* Reads the node of the patch's leaf, as it stands there by now. To be finished in either case.
 * false, with a message: it cannot be read, or memory is out. */
bool csg_reading_init(struct csg_reading *reading, const struct csgcast_scene *scene,
                      const struct csg_patch *patch);
void csg_reading_finish(struct csg_reading *reading);

/* Node i of the part for a tree where that stands at place and its first leaf is number first. It
 * is the same set wherever it stands; there it may be complemented. */
struct csg_node csg_reading_node(const struct csg_reading *reading, uint32_t i,
                                 const struct csg_part_place *place, uint32_t first);

/* Exchanges the leaves of these nodes by others, of another number, under other trees; leaves
 * behind them are renumbered. false, with a message and nothing changed: no memory. */
bool csg_edits_regrow(struct csgcast_scene *scene, struct csg_reading *readings, size_t num);

#endif
