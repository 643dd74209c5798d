/* SPDX-License-Identifier: MIT */
#include "nodes/drawings.h"

#include <stdlib.h>

#include "nodes/clip.h"
#include "nodes/figures.h"
#include "nodes/transforms.h"
#include "plane/convex.h"

/* A node whose children are being read. */
struct frame {
    uint32_t node, end; /* in the document */
    uint32_t draw;      /* in the drawing */
    struct csg_space space;
    struct csg_space own; /* clips: from the children's space to that around */
};

/* Time and memory of a sweep grow with the square of the corners in long figures. */
enum { max_swept_corners = 100000 };

struct reader {
    struct csg_walk *walk;
    struct csg_drawing *drawing;
    uint32_t first; /* counts, whatever its modifiers are */
    bool clips;     /* each node is evaluated in its own space, as in OpenSCAD */
    CSG_ARRAY(struct frame) frames;
};

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

/* What makes a new figure of what is in it does so before the nodes around it move that: sums are
 * about the origin, sizes along the axes, and offsets the same in all directions. */
static struct csg_space own_space(const struct csg_space *around)
{
    struct csg_space space = csg_space_world;
    space.in_boolean = around->in_boolean;
    return space;
}

bool csg_drawing_place(struct csg_walk *walk, struct csg_drawing *drawing, uint32_t draw,
                       const struct csg_space *space)
{
    const struct csg_log *log = &walk->builder->report->log;
    struct csg_map inverse;
    if (space->is_empty || !csg_map_invert(&space->map, &inverse)) {
        csg_drawing_cut(drawing, draw);
        return csg_drawing_open(drawing, CSG_DRAW_UNION) || csg_log_memory(log);
    }
    for (uint32_t i = draw; i < drawing->nodes.num; i++) {
        struct csg_draw_node *node = &drawing->nodes.data[i];
        if (node->op != CSG_DRAW_FIGURE)
            continue;
        struct csg_figure *figure = &drawing->figures.data[node->figure];
        const struct csg_box box = csg_figure_written(drawing, figure);
        figure->rounding += csg_space_rounding(space, &box) / csg_space_stretch(space);
    }
    return csg_drawing_map(drawing, draw, (uint32_t)drawing->nodes.num, &space->map,
                           csg_space_stretch(space)) ||
           csg_log_memory(log);
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
    frame.own = own_space(&frame.space);
    if (!enter_space(reader, node, reader->clips ? &frame.own : &frame.space))
        return false;
    const struct csg_node_ops *ops = csg_walk_ops(reader->walk, node);
    if (ops && ops->flatten)
        frame.space = own_space(&frame.space);
    return (csg_drawing_open(reader->drawing, op_of(meaning->role)) &&
            csg_array_push(&reader->frames, frame)) ||
           csg_walk_no_memory(reader->walk);
}

static bool is_mirrored(const struct csg_space *space)
{
    return csg_map_determinant(&space->map) < 0;
}

/* Several operands become one outline, then what the node maps is mapped. */
static bool clip_node(struct reader *reader, const struct frame *frame)
{
    const struct csg_draw_node *nodes = reader->drawing->nodes.data;
    const uint32_t first = frame->draw + 1, end = nodes[frame->draw].end;
    const bool has_several = first < end && nodes[first].end < end;
    if (has_several && !csg_clip_evaluate(reader->walk, reader->drawing, frame->draw))
        return false;
    if (reader->frames.num == 0 || !csg_walk_ops(reader->walk, frame->node)->enter)
        return true;
    return csg_drawing_place(reader->walk, reader->drawing, frame->draw, &frame->own) &&
           (!is_mirrored(&frame->own) ||
            csg_clip_evaluate(reader->walk, reader->drawing, frame->draw));
}

/* Nodes that make a new figure of what is in them do it when all of it is known. */
static bool close_node(struct reader *reader)
{
    const struct frame frame = reader->frames.data[--reader->frames.num];
    const struct csg_node_ops *ops = csg_walk_ops(reader->walk, frame.node);
    csg_drawing_close(reader->drawing, frame.draw);
    if (reader->clips && (reader->frames.num == 0 || !ops->flatten))
        return clip_node(reader, &frame);
    if (reader->frames.num == 0 || !ops->flatten)
        return csg_drawing_intersect(reader->drawing, frame.draw) ||
               csg_walk_no_memory(reader->walk);
    struct csg_args args;
    return csg_walk_args(reader->walk, frame.node, ops->name, ops->parameters, &args) &&
           ops->flatten(reader->walk, frame.node, &args, reader->drawing, frame.draw) &&
           csg_drawing_place(reader->walk, reader->drawing, frame.draw,
                             &reader->frames.data[reader->frames.num - 1].space);
}

/* Of a figure with more corners than are swept Clipper makes the outline, as in OpenSCAD. */
static bool wants_clip(struct reader *reader, size_t num_corners)
{
    return reader->clips || (num_corners > max_swept_corners && csg_clip_is_there(reader->walk));
}

/* What OpenSCAD makes without Clipper. */
static bool is_clean(const struct reader *reader, const struct csg_node_ops *ops, uint32_t draw)
{
    const struct csg_draw_node *node = &reader->drawing->nodes.data[draw];
    if (ops->figure == csg_figure_projection)
        return node->op == CSG_DRAW_FIGURE &&
               reader->drawing->figures.data[node->figure].is_outline;
    return ops->figure == csg_figure_square || ops->figure == csg_figure_circle;
}

static bool read_figure(struct reader *reader, uint32_t node)
{
    const struct csg_node_ops *ops = csg_walk_ops(reader->walk, node);
    const uint32_t draw = (uint32_t)reader->drawing->nodes.num;
    const size_t begin = reader->drawing->points.num;
    struct csg_args args;
    return csg_walk_args(reader->walk, node, ops->name, ops->parameters, &args) &&
           ops->figure(reader->walk, node, &args,
                       &reader->frames.data[reader->frames.num - 1].space, reader->drawing) &&
           (reader->drawing->nodes.num == draw || is_clean(reader, ops, draw) ||
            !wants_clip(reader, reader->drawing->points.num - begin) ||
            csg_clip_evaluate(reader->walk, reader->drawing, draw));
}

static bool visit(struct reader *reader, uint32_t node, uint32_t *next)
{
    const struct csg_parsed_node *parsed = csg_walk_node(reader->walk, node);
    const struct csg_meaning *meaning = &reader->walk->builder->meanings[node];
    const struct csg_node_ops *ops = csg_walk_ops(reader->walk, node);
    *next = parsed->end;
    if (node != reader->first && csg_is_left_out(reader->walk->builder, node))
        return !csg_is_empty_operand(reader->walk->builder, node) ||
               csg_drawing_open(reader->drawing, CSG_DRAW_UNION) ||
               csg_walk_no_memory(reader->walk);
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
    return csg_drawing_open(reader->drawing, CSG_DRAW_UNION) || csg_walk_no_memory(reader->walk);
}

/* The union of the nodes from first to the end of node. */
static bool read_from(struct csg_walk *walk, uint32_t node, uint32_t first, bool in_boolean,
                      struct csg_drawing *drawing)
{
    struct reader reader = {.walk = walk,
                            .drawing = drawing,
                            .first = first == node ? node : UINT32_MAX,
                            .clips = csg_clip_is_wanted(walk)};
    struct frame root = {node, csg_walk_node(walk, node)->end, 0, csg_space_world, csg_space_world};
    root.space.in_boolean = in_boolean;
    bool ok = (csg_drawing_open(drawing, CSG_DRAW_UNION) && csg_array_push(&reader.frames, root)) ||
              csg_walk_no_memory(reader.walk);
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
