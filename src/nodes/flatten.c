/* SPDX-License-Identifier: MIT */
#include "nodes/flatten.h"

#include "nodes/clip.h"
#include "nodes/resize.h"
#include "plane/hull.h"
#include "plane/minkowski.h"
#include "plane/offset.h"
#include "plane/resize.h"
#include "solids/facets.h"

/* Arcs of offsets with more segments than that are refused: nobody can tell them apart. */
enum { max_segments = 65536 };

static bool leave_empty(struct csg_walk *walk, struct csg_drawing *drawing, uint32_t draw)
{
    csg_drawing_cut(drawing, draw);
    return csg_drawing_open(drawing, CSG_DRAW_UNION) || csg_walk_no_memory(walk);
}

/* What is too large is left out, with a message. */
static bool finish(struct csg_walk *walk, uint32_t node, struct csg_drawing *drawing, uint32_t draw,
                   enum csg_sweep_result result)
{
    if (result == CSG_SWEEP_DONE)
        return true;
    if (result == CSG_SWEEP_NO_MEMORY)
        return csg_walk_no_memory(walk);
    csg_walk_unsupported(walk, node, "%s: the drawing in it has too many corners",
                         csg_walk_ops(walk, node)->name);
    return leave_empty(walk, drawing, draw);
}

bool csg_flatten_hull(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                      struct csg_drawing *drawing, uint32_t draw)
{
    (void)args;
    return finish(walk, node, drawing, draw, csg_drawing_hull(drawing, draw));
}

/* r rounds the corners; delta mitres them, or with chamfer cuts them. Neither: r = 1; not
 * finite: nothing, both as in OpenSCAD. */
bool csg_flatten_offset(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                        struct csg_drawing *drawing, uint32_t draw)
{
    const struct csg_value *r = csg_args_find(args, "r"), *delta = csg_args_find(args, "delta");
    const struct csg_facets facets = csg_args_facets(args);
    const bool is_round =
        (r && r->type == CSG_VALUE_NUMBER) || !(delta && delta->type == CSG_VALUE_NUMBER);
    struct csg_offset offset = {.join = CSG_JOIN_ROUND, .exact = !csg_facets_wanted(args, &facets)};
    offset.distance = csg_args_number(args, is_round ? "r" : "delta", 1, NULL);
    if (!is_round)
        offset.join = csg_args_bool(args, "chamfer") ? CSG_JOIN_SQUARE : CSG_JOIN_MITER;
    if (!isfinite(offset.distance))
        return leave_empty(walk, drawing, draw);
    const int num = csg_facets_count(&facets, fabs(offset.distance));
    offset.num = num < max_segments ? num : max_segments;
    bool taken = false;
    if (csg_clip_is_wanted(walk) && !csg_clip_offset(walk, drawing, draw, &offset, &taken))
        return false;
    return taken || finish(walk, node, drawing, draw, csg_drawing_offset(drawing, draw, &offset));
}

bool csg_flatten_minkowski(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                           struct csg_drawing *drawing, uint32_t draw)
{
    (void)args;
    return finish(walk, node, drawing, draw, csg_drawing_minkowski(drawing, draw));
}

bool csg_flatten_resize(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                        struct csg_drawing *drawing, uint32_t draw)
{
    const struct csg_resize resize = csg_resize_read(args);
    return finish(walk, node, drawing, draw,
                  csg_drawing_resize(drawing, draw, resize.newsize, resize.automatic));
}

bool csg_flatten_fill(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                      struct csg_drawing *drawing, uint32_t draw)
{
    (void)args;
    return finish(walk, node, drawing, draw, csg_drawing_fill(drawing, draw));
}
