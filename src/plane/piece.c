/* SPDX-License-Identifier: MIT */
#include "plane/piece.h"

#include <stdlib.h>

/*
 * Spans are stacked to pieces from below: a span continues the piece below it when it begins where
 * that one ends, from corner to corner, and the sides do not turn inwards.
 */

/* A piece that grows. */
struct stack {
    CSG_ARRAY(uint32_t) left, right; /* edges from below; those of a span once more where it ends */
    uint32_t begin, end;             /* levels */
    double low[2], high[2];          /* x of its bottom and its top */
};

struct cutter {
    struct csg_sweep sweep;
    struct csg_pieces *pieces;
    CSG_ARRAY(struct stack) below; /* pieces that end at the level at hand */
    CSG_ARRAY(struct stack) above; /* those that reach beyond it */
    double noise;
};

/* Sides that turn inwards by less are straight: x per y. */
#define STRAIGHT 1e-12

void csg_pieces_finish(struct csg_pieces *pieces)
{
    free(pieces->pieces.data);
    free(pieces->lines.data);
    free(pieces->corners.data);
    *pieces = (struct csg_pieces){0};
}

/* The line through an edge with the inside to its right (its x grows), or to its left. */
static struct csg_line edge_line(const struct csg_sweep_edge *edge, bool inside_right)
{
    const double x = edge->high.x - edge->low.x, y = edge->high.y - edge->low.y;
    const double length = hypot(x, y), sign = inside_right ? -1 : 1;
    const struct csg_vec2 normal = {sign * (y / length), sign * (-x / length)};
    const double offset = normal.x * (0.5 * (edge->low.x + edge->high.x)) +
                          normal.y * (0.5 * (edge->low.y + edge->high.y));
    return (struct csg_line){normal, offset};
}

/* ---- stacks ------------------------------------------------------------------------------- */

static void finish_stack(struct stack *stack)
{
    free(stack->left.data);
    free(stack->right.data);
}

static double slope(const struct csg_sweep_edge *edge)
{
    return (edge->high.x - edge->low.x) / (edge->high.y - edge->low.y);
}

/* Whether the side may go on with edge: sign is 1 on the left, where slopes may only grow. */
static bool is_convex(const struct cutter *cutter, uint32_t from, uint32_t to, double sign)
{
    if (from == to)
        return true;
    const double a = slope(&cutter->sweep.edges.data[from]);
    const double b = slope(&cutter->sweep.edges.data[to]);
    return sign * (b - a) >= -STRAIGHT * (1 + fabs(a));
}

static bool continues(const struct cutter *cutter, const struct stack *stack,
                      const struct csg_sweep_span *span)
{
    const struct csg_sweep *sweep = &cutter->sweep;
    return stack->end == span->level &&
           fabs(csg_sweep_x(sweep, span->left, span->level) - stack->high[0]) <= cutter->noise &&
           fabs(csg_sweep_x(sweep, span->right, span->level) - stack->high[1]) <= cutter->noise &&
           is_convex(cutter, stack->left.data[stack->left.num - 1], span->left, 1) &&
           is_convex(cutter, stack->right.data[stack->right.num - 1], span->right, -1);
}

static bool extend(struct cutter *cutter, struct stack *stack, const struct csg_sweep_span *span)
{
    const struct csg_sweep *sweep = &cutter->sweep;
    if (!csg_array_push(&stack->left, span->left) || !csg_array_push(&stack->right, span->right))
        return false;
    stack->end = span->level + 1;
    stack->high[0] = csg_sweep_x(sweep, span->left, stack->end);
    stack->high[1] = csg_sweep_x(sweep, span->right, stack->end);
    return true;
}

/* ---- pieces ------------------------------------------------------------------------------- */

static bool add_side(struct cutter *cutter, const struct stack *stack, bool is_left)
{
    const uint32_t *edges = is_left ? stack->left.data : stack->right.data;
    const size_t num = is_left ? stack->left.num : stack->right.num;
    for (size_t i = 0; i < num; i++) {
        const uint32_t level = stack->begin + (uint32_t)i;
        const struct csg_vec2 corner = {csg_sweep_x(&cutter->sweep, edges[i], level),
                                        cutter->sweep.levels.data[level]};
        const bool is_new = i == 0 || edges[i] != edges[i - 1];
        if (is_new && (!csg_array_push(&cutter->pieces->corners, corner) ||
                       !csg_array_push(&cutter->pieces->lines,
                                       edge_line(&cutter->sweep.edges.data[edges[i]], is_left))))
            return false;
    }
    const struct csg_vec2 top = {stack->high[is_left ? 0 : 1],
                                 cutter->sweep.levels.data[stack->end]};
    return csg_array_push(&cutter->pieces->corners, top);
}

/* Bottom and top have lines of their own unless they are points. */
static bool add_ends(struct cutter *cutter, const struct stack *stack)
{
    const double *levels = cutter->sweep.levels.data;
    const struct csg_line bottom = {{0, -1}, -levels[stack->begin]};
    const struct csg_line top = {{0, 1}, levels[stack->end]};
    if (stack->low[1] - stack->low[0] > cutter->noise &&
        !csg_array_push(&cutter->pieces->lines, bottom))
        return false;
    return stack->high[1] - stack->high[0] <= cutter->noise ||
           csg_array_push(&cutter->pieces->lines, top);
}

static bool emit(struct cutter *cutter, struct stack *stack)
{
    struct csg_pieces *pieces = cutter->pieces;
    struct csg_piece piece = {.first_line = (uint32_t)pieces->lines.num,
                              .first_corner = (uint32_t)pieces->corners.num};
    if (!add_side(cutter, stack, true) || !add_side(cutter, stack, false) ||
        !add_ends(cutter, stack))
        return false;
    piece.num_lines = (uint32_t)pieces->lines.num - piece.first_line;
    piece.num_corners = (uint32_t)pieces->corners.num - piece.first_corner;
    finish_stack(stack);
    *stack = (struct stack){0};
    return csg_array_push(&pieces->pieces, piece);
}

static bool emit_below(struct cutter *cutter)
{
    bool ok = true;
    for (size_t i = 0; i < cutter->below.num; i++) {
        if (ok && cutter->below.data[i].left.num)
            ok = emit(cutter, &cutter->below.data[i]);
        finish_stack(&cutter->below.data[i]);
    }
    cutter->below.num = 0;
    return ok;
}

/* Spans and stacks are both in the order of x; first is the first stack that may still match. */
static bool place_span(struct cutter *cutter, const struct csg_sweep_span *span, size_t *first)
{
    const double x = csg_sweep_x(&cutter->sweep, span->left, span->level);
    struct stack stack = {.begin = span->level, .end = span->level};
    while (*first < cutter->below.num && cutter->below.data[*first].high[0] < x - cutter->noise)
        (*first)++;
    size_t i = *first;
    while (i < cutter->below.num && cutter->below.data[i].high[0] <= x + cutter->noise &&
           !(cutter->below.data[i].left.num && continues(cutter, &cutter->below.data[i], span)))
        i++;
    if (i < cutter->below.num && cutter->below.data[i].high[0] <= x + cutter->noise) {
        stack = cutter->below.data[i];
        cutter->below.data[i].left.num = 0;
        cutter->below.data[i].left.data = NULL;
        cutter->below.data[i].right.data = NULL;
    } else {
        stack.low[0] = x;
        stack.low[1] = csg_sweep_x(&cutter->sweep, span->right, span->level);
    }
    if (extend(cutter, &stack, span) && csg_array_push(&cutter->above, stack))
        return true;
    finish_stack(&stack);
    return false;
}

static void swap_stacks(struct cutter *cutter)
{
    struct stack *data = cutter->below.data;
    const size_t num = cutter->below.num, capacity = cutter->below.capacity;
    cutter->below.data = cutter->above.data;
    cutter->below.num = cutter->above.num;
    cutter->below.capacity = cutter->above.capacity;
    cutter->above.data = data;
    cutter->above.num = num;
    cutter->above.capacity = capacity;
}

static bool stack_spans(struct cutter *cutter)
{
    const struct csg_sweep_span *spans = cutter->sweep.spans.data;
    const size_t num = cutter->sweep.spans.num;
    bool ok = true;
    for (size_t i = 0; i < num && ok;) {
        const uint32_t level = spans[i].level;
        size_t first = 0;
        for (; i < num && ok && spans[i].level == level; i++)
            ok = place_span(cutter, &spans[i], &first);
        ok = emit_below(cutter) && ok;
        swap_stacks(cutter);
    }
    ok = emit_below(cutter) && ok;
    swap_stacks(cutter);
    return emit_below(cutter) && ok;
}

enum csg_sweep_result csg_pieces_cut(struct csg_pieces *pieces, const struct csg_drawing *drawing,
                                     uint32_t node)
{
    struct cutter cutter = {.pieces = pieces};
    enum csg_sweep_result result = csg_sweep(&cutter.sweep, drawing, node);
    cutter.noise = 4 * CSG_SWEEP_NOISE * cutter.sweep.size;
    if (result == CSG_SWEEP_DONE && !stack_spans(&cutter))
        result = CSG_SWEEP_NO_MEMORY;
    csg_sweep_finish(&cutter.sweep);
    free(cutter.below.data);
    free(cutter.above.data);
    return result;
}
