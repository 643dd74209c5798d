/* SPDX-License-Identifier: MIT */
#include "plane/bridges.h"

#include <search.h>
#include <stdlib.h>

/* No corner. */
#define NONE UINT32_MAX

/* A corner that the line meets. */
struct event {
    struct csg_vec2 at;
    uint32_t corner;
    bool is_hole; /* the first one of a hole */
};

/* From a contour's corner to the next one, or a place that is looked for. */
struct edge {
    struct csg_vec2 a, b;
    uint32_t corner;        /* that begins it; of a place NONE */
    uint32_t before, after; /* that one's neighbours in the contour */
    uint32_t helper;        /* the last corner that the line met in the gap above it */
    uint32_t *below;        /* of a place: the edge found below it so far; else NULL */
};

struct sweep {
    struct csg_corners *corners;
    CSG_ARRAY(struct event) events;
    CSG_ARRAY(struct edge) edges; /* by the corner that begins it */
    void *cut; /* those that the line cuts and that have the inside above them, upwards: a tree of
                * <search.h> */
};

static struct csg_corner *corner_of(const struct sweep *sweep, uint32_t i)
{
    return &sweep->corners->list.data[i];
}

/* From left to right, and upwards where x is the same. */
static bool is_met_before(struct csg_vec2 a, struct csg_vec2 b)
{
    return a.x != b.x ? a.x < b.x : a.y < b.y;
}

/* ---- contours ----------------------------------------------------------------------------- */

static bool add_contour(struct sweep *sweep, const struct csg_drawing *drawing,
                        const struct csg_contour *contour, size_t *num_holes)
{
    const uint32_t num = contour->end - contour->begin;
    const uint32_t first = (uint32_t)sweep->corners->list.num;
    double area = 0;
    uint32_t leftmost = first;
    for (uint32_t i = 0; i < num; i++) {
        const struct csg_vec2 at = drawing->points.data[contour->begin + i];
        const struct csg_vec2 next = drawing->points.data[contour->begin + (i + 1) % num];
        const uint32_t before = first + (i + num - 1) % num, after = first + (i + 1) % num;
        const struct csg_corner corner = {at,   contour->begin + i, before, after, NONE, false,
                                          false};
        const struct edge edge = {at, next, first + i, before, after, first + i, NULL};
        const struct event event = {at, first + i, false};
        if (!csg_array_push(&sweep->corners->list, corner) ||
            !csg_array_push(&sweep->edges, edge) || !csg_array_push(&sweep->events, event))
            return false;
        if (is_met_before(at, corner_of(sweep, leftmost)->at))
            leftmost = first + i;
        area += at.x * next.y - next.x * at.y;
    }
    const bool is_hole = !(area > 0);
    for (uint32_t i = first; i < first + num; i++)
        corner_of(sweep, i)->is_joined = !is_hole;
    sweep->events.data[leftmost].is_hole = is_hole;
    *num_holes += is_hole;
    return true;
}

static int compare_events(const void *a, const void *b)
{
    const struct event *x = a, *y = b;
    return is_met_before(x->at, y->at) ? -1 : is_met_before(y->at, x->at);
}

/* ---- the edges that the line cuts ---------------------------------------------------------- */

/* Whether other is above edge, which the line does not meet later. */
static bool is_below(const struct edge *edge, const struct edge *other)
{
    long double turn = csg_turn(edge->a, edge->b, other->a);
    if (turn == 0)
        turn = csg_turn(edge->a, edge->b, other->b);
    return turn != 0 ? turn > 0 : edge->corner < other->corner;
}

static int compare_edges(const void *key, const void *item)
{
    const struct edge *edge = key, *other = item;
    if (edge->corner == other->corner)
        return 0;
    if (is_met_before(edge->a, other->a) ? is_below(edge, other) : !is_below(other, edge))
        return -1;
    if (edge->below)
        *edge->below = other->corner;
    return 1;
}

/* The nearest edge below the place; NULL: none. */
static struct edge *edge_below(const struct sweep *sweep, struct csg_vec2 at)
{
    uint32_t below = NONE;
    const struct edge place = {.a = at, .b = at, .corner = NONE, .below = &below};
    tfind(&place, &sweep->cut, compare_edges);
    return below == NONE ? NULL : &sweep->edges.data[below];
}

static bool begin_edge(struct sweep *sweep, uint32_t i)
{
    struct edge *edge = &sweep->edges.data[i];
    return !is_met_before(edge->a, edge->b) || tsearch(edge, &sweep->cut, compare_edges);
}

static void end_edge(struct sweep *sweep, uint32_t i)
{
    const struct edge *edge = &sweep->edges.data[i];
    if (is_met_before(edge->a, edge->b))
        tdelete(edge, &sweep->cut, compare_edges);
}

/* The corner of the contour next to i, forwards or back, that is not at its place; i: none is. */
static uint32_t neighbour(const struct sweep *sweep, uint32_t i, bool forwards)
{
    const struct edge *edges = sweep->edges.data;
    uint32_t k = i;
    do
        k = forwards ? edges[k].after : edges[k].before;
    while (k != i && csg_is_same_place(edges[k].a, edges[i].a));
    return k;
}

/* Whether the inside is right below the corner. */
static bool is_above_inside(const struct sweep *sweep, uint32_t i)
{
    const struct edge *edges = sweep->edges.data;
    const struct csg_vec2 at = edges[i].a;
    const struct csg_vec2 before = edges[neighbour(sweep, i, false)].a;
    const struct csg_vec2 after = edges[neighbour(sweep, i, true)].a;
    const bool comes = is_met_before(before, at), goes = is_met_before(at, after);
    return comes == goes ? !comes : csg_turn(before, at, after) < 0;
}

/* ---- bridges ------------------------------------------------------------------------------ */

/* Whether b lies in the sector of the inside at corner i, as seen from there. */
static bool is_in_sector(const struct sweep *sweep, uint32_t i, struct csg_vec2 b)
{
    const struct csg_corner *c = corner_of(sweep, i);
    const struct csg_vec2 before = corner_of(sweep, c->before)->at;
    const struct csg_vec2 after = corner_of(sweep, c->after)->at;
    if (csg_turn(before, c->at, after) >= 0)
        return csg_turn(c->at, b, before) >= 0 && csg_turn(c->at, after, b) >= 0;
    return !(csg_turn(c->at, b, after) > 0 && csg_turn(c->at, before, b) > 0);
}

/* Which of a contour's corner and its twins has b in its sector; NONE: none. */
static uint32_t twin_towards(const struct sweep *sweep, uint32_t i, struct csg_vec2 b)
{
    while (i != NONE && !is_in_sector(sweep, i, b))
        i = corner_of(sweep, i)->twin;
    return i;
}

/* A corner, of the events that are at the hole's first corner, that has the hole in its sector. */
static uint32_t find_touching(const struct sweep *sweep, const struct event *events, size_t num,
                              uint32_t hole)
{
    const struct csg_vec2 next = sweep->edges.data[neighbour(sweep, hole, true)].a;
    uint32_t touching = NONE;
    for (size_t i = 0; i < num && touching == NONE; i++)
        if (corner_of(sweep, events[i].corner)->is_joined)
            touching = twin_towards(sweep, events[i].corner, next);
    return touching;
}

/* The last corner that the line met in the gap in which it meets a hole; all of the gap that is to
 * the left of the line sees it. NONE where rounding has put the hole outside. */
static uint32_t find_helper(const struct sweep *sweep, uint32_t hole)
{
    const struct csg_vec2 at = corner_of(sweep, hole)->at;
    const struct edge *below = edge_below(sweep, at);
    if (!below)
        return NONE;
    const uint32_t towards = twin_towards(sweep, below->helper, at);
    return towards == NONE ? below->helper : towards;
}

/* Cuts both rings open at a and b and joins the ends. */
static bool join_rings(struct sweep *sweep, uint32_t a, uint32_t b)
{
    const uint32_t a2 = (uint32_t)sweep->corners->list.num, b2 = a2 + 1;
    if (!csg_array_reserve(&sweep->corners->list, 2))
        return false;
    sweep->corners->list.num += 2;
    struct csg_corner *at_a = corner_of(sweep, a), *at_b = corner_of(sweep, b);
    *corner_of(sweep, a2) = *at_a;
    *corner_of(sweep, b2) = *at_b;
    corner_of(sweep, at_a->after)->before = a2;
    corner_of(sweep, at_b->before)->after = b2;
    corner_of(sweep, a2)->before = b2;
    corner_of(sweep, b2)->after = a2;
    at_a->after = b;
    at_b->before = a;
    at_a->twin = a2;
    at_b->twin = b2;
    return true;
}

static bool join_hole(struct sweep *sweep, const struct event *events, size_t num, uint32_t hole)
{
    const uint32_t touching = find_touching(sweep, events, num, hole);
    const uint32_t bridge = touching == NONE ? find_helper(sweep, hole) : touching;
    for (uint32_t k = hole; !corner_of(sweep, k)->is_joined; k = corner_of(sweep, k)->after)
        corner_of(sweep, k)->is_joined = true;
    return bridge == NONE || join_rings(sweep, bridge, hole);
}

/* The line meets num corners at one place. */
static bool meet(struct sweep *sweep, const struct event *events, size_t num)
{
    bool ok = true;
    for (size_t i = 0; i < num; i++)
        end_edge(sweep, sweep->edges.data[events[i].corner].before);
    for (size_t i = 0; i < num && ok; i++)
        ok = !events[i].is_hole || join_hole(sweep, events, num, events[i].corner);
    for (size_t i = 0; i < num; i++) {
        const uint32_t corner = events[i].corner;
        struct edge *below =
            is_above_inside(sweep, corner) ? edge_below(sweep, events[i].at) : NULL;
        if (below)
            below->helper = corner;
    }
    for (size_t i = 0; i < num && ok; i++)
        ok = begin_edge(sweep, events[i].corner);
    return ok;
}

static bool join_holes(struct sweep *sweep)
{
    const struct event *events = sweep->events.data;
    const size_t num = sweep->events.num;
    bool ok = true;
    qsort(sweep->events.data, num, sizeof *events, compare_events);
    for (size_t i = 0, end; i < num && ok; i = end) {
        for (end = i + 1; end < num && csg_is_same_place(events[end].at, events[i].at);)
            end++;
        ok = meet(sweep, events + i, end - i);
    }
    while (sweep->cut) /* not empty where memory is out */
        tdelete(*(struct edge *const *)sweep->cut, &sweep->cut, compare_edges);
    return ok;
}

bool csg_corners_of_figure(const struct csg_drawing *drawing, const struct csg_figure *figure,
                           struct csg_corners *corners)
{
    struct sweep sweep = {.corners = corners};
    size_t num_holes = 0;
    bool ok = true;
    for (uint32_t i = figure->begin; i < figure->end && ok; i++)
        if (drawing->contours.data[i].end - drawing->contours.data[i].begin >= 3)
            ok = add_contour(&sweep, drawing, &drawing->contours.data[i], &num_holes);
    if (num_holes > 0)
        ok = ok && join_holes(&sweep);
    free(sweep.events.data);
    free(sweep.edges.data);
    return ok;
}
