/* SPDX-License-Identifier: MIT */
#ifndef CSG_PACK_SEEN_H
#define CSG_PACK_SEEN_H

/* What of an object's tree the picture can show, of a large object seen from near little, and
 * where. */

#include "csg/object.h"
#include "csg/tree.h"
#include "pack/screen.h"

/* Zero-initialise it. */
struct csg_seen {
    const struct csg_node *nodes; /* [begin, end): the object's own, or ... */
    uint32_t begin, end;          /* ... those of tree; none: nothing of it is seen */
    bool is_part;                 /* some leaves are left out */
    struct csg_tree tree;
    struct csg_tree_room room;
    uint8_t *known;                   /* enum csg_known, by leaf of the scene */
    CSG_ARRAY(struct csg_rect) rects; /* by node of what is seen */
};

/* Replaces what is seen by that of an object: all of it where that is small, or where much of it is
 * in the picture. false: out of memory. */
bool csg_seen_find(struct csg_seen *seen, const struct csgcast_scene *scene,
                   const struct csg_screen *screen, const struct csg_object *object);

/* All of the object. */
void csg_seen_all(struct csg_seen *seen, const struct csgcast_scene *scene,
                  const struct csg_object *object);

/* Narrows rect to what the Boolean leaves of the rectangles of the leaves that are seen, which are
 * some. false: out of memory. */
bool csg_seen_narrow(struct csg_seen *seen, const struct csgcast_scene *scene,
                     const struct csg_screen *screen, struct csg_rect *rect);

void csg_seen_finish(struct csg_seen *seen);

#endif
