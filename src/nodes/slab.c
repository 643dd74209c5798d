/* SPDX-License-Identifier: MIT */
/*
 * A scene that is only a drawing: OpenSCAD's preview shows each figure as a slab of height 1 about
 * z = 0, moved by all of the maps around it, and frames it as if it were flat.
 */
#include "nodes/compounds.h"
#include "nodes/drawings.h"
#include "plane/extrude.h"

bool csg_compound_slab(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                       bool in_boolean, struct csg_part *part)
{
    static const struct csg_lift lift = {.z0 = -0.5, .s0 = 1, .z1 = 0.5, .s1 = 1};
    struct csg_drawing drawing = {0};
    bool too_large = false;
    (void)args;
    bool ok = csg_drawing_read_node(walk, node, in_boolean, &drawing);
    if (ok &&
        !csg_extrude(part, &drawing, &lift, csg_walk_max_pieces(walk, in_boolean), &too_large))
        ok = too_large || csg_walk_no_memory(walk);
    part->is_too_large |= too_large;
    for (size_t i = 0; i < part->shapes.num; i++)
        part->shapes.data[i].written.lo.z = part->shapes.data[i].written.hi.z = 0;
    csg_drawing_finish(&drawing);
    return ok;
}
