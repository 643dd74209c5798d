/* SPDX-License-Identifier: MIT */
#include "scene/drawings.h"

#include <stdlib.h>

/* A node whose children are being read. */
struct frame {
    uint32_t node, end; /* in the document */
    uint32_t draw;      /* in the drawing */
    struct csg_space space;
};

struct reader {
    struct csg_walk *walk;
    struct csg_drawing *drawing;
    uint32_t first; /* counts, whatever its modifiers are */
    CSG_ARRAY(struct frame) frames;
};

static bool no_memory(const struct reader *reader)
{
    return csg_log_memory(&reader->walk->builder->report->log);
}

/* OpenSCAD takes of each map on the way what acts in the plane. */
static void flatten_space(struct csg_space *space)
{
    double(*m)[4] = space->map.m;
    m[0][2] = m[1][2] = m[2][0] = m[2][1] = m[2][3] = 0;
    m[2][2] = 1;
    for (int i = 0; i < 3; i++)
        space->error[2][i] = space->error[i][2] = 0;
    space->error[2][3] = 0;
}

static enum csg_draw_op op_of(uint8_t role)
{
    if (role == CSG_ROLE_DIFFERENCE)
        return CSG_DRAW_DIFFERENCE;
    return role == CSG_ROLE_INTERSECTION ? CSG_DRAW_INTERSECTION : CSG_DRAW_UNION;
}

/* What the node does to the space of its children. */
static bool enter_space(struct reader *reader, uint32_t node, struct csg_space *space)
{
    const struct csg_node_ops *ops = csg_walk_ops(reader->walk, node);
    struct csg_args args;
    if (!ops->enter)
        return true;
    if (!csg_walk_args(reader->walk, node, ops->name, ops->parameters, &args))
        return false;
    ops->enter(&args, space);
    flatten_space(space);
    return true;
}

static bool open_node(struct reader *reader, uint32_t node)
{
    const struct csg_meaning *meaning = &reader->walk->builder->meanings[node];
    struct frame frame = reader->frames.data[reader->frames.num - 1];
    frame.node = node;
    frame.end = csg_walk_node(reader->walk, node)->end;
    frame.draw = (uint32_t)reader->drawing->nodes.num;
    frame.space.in_boolean |=
        meaning->role == CSG_ROLE_DIFFERENCE || meaning->role == CSG_ROLE_INTERSECTION;
    if (!enter_space(reader, node, &frame.space))
        return false;
    return (csg_drawing_open(reader->drawing, op_of(meaning->role)) &&
            csg_array_push(&reader->frames, frame)) ||
           no_memory(reader);
}

/* Nodes that make a new figure of what is in them do it when all of it is known. */
static bool close_node(struct reader *reader)
{
    const struct frame frame = reader->frames.data[--reader->frames.num];
    const struct csg_node_ops *ops = csg_walk_ops(reader->walk, frame.node);
    csg_drawing_close(reader->drawing, frame.draw);
    if (reader->frames.num == 0 || !ops->flatten)
        return true;
    struct csg_args args;
    return csg_walk_args(reader->walk, frame.node, ops->name, ops->parameters, &args) &&
           ops->flatten(reader->walk, frame.node, &args, reader->drawing, frame.draw);
}

static bool read_figure(struct reader *reader, uint32_t node)
{
    const struct csg_node_ops *ops = csg_walk_ops(reader->walk, node);
    struct csg_args args;
    return csg_walk_args(reader->walk, node, ops->name, ops->parameters, &args) &&
           ops->figure(reader->walk, node, &args,
                       &reader->frames.data[reader->frames.num - 1].space, reader->drawing);
}

static bool visit(struct reader *reader, uint32_t node, uint32_t *next)
{
    const struct csg_parsed_node *parsed = csg_walk_node(reader->walk, node);
    const struct csg_meaning *meaning = &reader->walk->builder->meanings[node];
    const struct csg_node_ops *ops = csg_walk_ops(reader->walk, node);
    *next = parsed->end;
    if (node != reader->first && csg_is_left_out(reader->walk->builder, node))
        return true;
    if (meaning->role == CSG_ROLE_FIGURE && !parsed->malformed)
        return read_figure(reader, node);
    const bool is_flattening =
        ops && ops->flatten &&
        (meaning->role == CSG_ROLE_FLATTEN || meaning->role == CSG_ROLE_COMPOUND);
    if (!parsed->malformed && (csg_has_children(meaning) || is_flattening)) {
        *next = node + 1;
        return open_node(reader, node);
    }
    if (meaning->role == CSG_ROLE_COMPOUND)
        csg_walk_unsupported(reader->walk, node, "%s in two dimensions is not supported yet",
                             ops ? ops->name : "this node");
    return csg_drawing_open(reader->drawing, CSG_DRAW_UNION) || no_memory(reader);
}

/* The union of the nodes from first to the end of node. */
static bool read_from(struct csg_walk *walk, uint32_t node, uint32_t first, bool in_boolean,
                      struct csg_drawing *drawing)
{
    struct reader reader = {
        .walk = walk, .drawing = drawing, .first = first == node ? node : UINT32_MAX};
    struct frame root = {node, csg_walk_node(walk, node)->end, 0, csg_space_world};
    root.space.in_boolean = in_boolean;
    bool ok = (csg_drawing_open(drawing, CSG_DRAW_UNION) && csg_array_push(&reader.frames, root)) ||
              no_memory(&reader);
    for (uint32_t i = first; ok && i < root.end;) {
        while (ok && reader.frames.data[reader.frames.num - 1].end <= i)
            ok = close_node(&reader);
        ok = ok && visit(&reader, i, &i);
    }
    while (ok && reader.frames.num > 0)
        ok = close_node(&reader);
    free(reader.frames.data);
    return ok;
}

bool csg_drawing_read(struct csg_walk *walk, uint32_t node, bool in_boolean,
                      struct csg_drawing *drawing)
{
    return read_from(walk, node, node + 1, in_boolean, drawing);
}

bool csg_drawing_read_node(struct csg_walk *walk, uint32_t node, bool in_boolean,
                           struct csg_drawing *drawing)
{
    return read_from(walk, node, node, in_boolean, drawing);
}
