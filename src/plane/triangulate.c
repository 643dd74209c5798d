/* SPDX-License-Identifier: MIT */
#include "plane/triangulate.h"

#include <stdlib.h>

/* A corner of a ring. A bridge to a hole has its two corners twice. */
struct corner {
    struct csg_vec2 at;
    uint32_t point; /* of the drawing */
    uint32_t before, after;
    bool is_joined; /* to an outer contour, or part of one */
    bool is_cut;    /* not in a ring any more */
};

/* A contour by its leftmost corner. */
struct hole {
    uint32_t leftmost;
    double x, y;
};

/* A corner of the ring that is cut, by its place along the longer side of the ring's box. */
struct place {
    double at;
    uint32_t corner;
};

struct triangulation {
    CSG_ARRAY(struct corner) corners;
    CSG_ARRAY(struct hole) holes;
    CSG_ARRAY(struct place) places; /* sorted; with those that were cut lately */
    bool upright;                   /* places are along y */
    struct csg_triangles *triangles;
};

static bool is_same(struct csg_vec2 a, struct csg_vec2 b)
{
    return a.x == b.x && a.y == b.y;
}

/* Above 0 where a, b, c turn to the left. The differences are as good as exact in long double. */
static long double turn(struct csg_vec2 a, struct csg_vec2 b, struct csg_vec2 c)
{
    return ((long double)b.x - a.x) * ((long double)c.y - a.y) -
           ((long double)b.y - a.y) * ((long double)c.x - a.x);
}

/* The corners of the triangle, which turns to the left, and its edges count as inside. */
static bool is_in_triangle(struct csg_vec2 a, struct csg_vec2 b, struct csg_vec2 c,
                           struct csg_vec2 p)
{
    /* Beside its box, which is soon seen, it cannot be. */
    if ((p.x < a.x && p.x < b.x && p.x < c.x) || (p.x > a.x && p.x > b.x && p.x > c.x) ||
        (p.y < a.y && p.y < b.y && p.y < c.y) || (p.y > a.y && p.y > b.y && p.y > c.y))
        return false;
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

static struct corner *corner_of(const struct triangulation *t, uint32_t i)
{
    return &t->corners.data[i];
}

static long double turn_at(const struct triangulation *t, uint32_t i)
{
    const struct corner *c = corner_of(t, i);
    return turn(corner_of(t, c->before)->at, c->at, corner_of(t, c->after)->at);
}

/* ---- rings -------------------------------------------------------------------------------- */

static bool add_ring(struct triangulation *t, const struct csg_drawing *drawing,
                     const struct csg_contour *contour)
{
    const uint32_t num = contour->end - contour->begin, first = (uint32_t)t->corners.num;
    struct hole hole = {first, INFINITY, 0};
    double area = 0;
    for (uint32_t i = 0; i < num; i++) {
        const struct csg_vec2 at = drawing->points.data[contour->begin + i];
        const struct csg_vec2 next = drawing->points.data[contour->begin + (i + 1) % num];
        const struct corner corner = {.at = at,
                                      .point = contour->begin + i,
                                      .before = first + (i + num - 1) % num,
                                      .after = first + (i + 1) % num};
        if (!csg_array_push(&t->corners, corner))
            return false;
        if (at.x < hole.x || (at.x == hole.x && at.y < hole.y))
            hole = (struct hole){first + i, at.x, at.y};
        area += at.x * next.y - next.x * at.y;
    }
    for (uint32_t i = first; i < t->corners.num && area > 0; i++)
        corner_of(t, i)->is_joined = true;
    return area > 0 || csg_array_push(&t->holes, hole);
}

static int compare_holes(const void *a, const void *b)
{
    const struct hole *x = a, *y = b;
    if (x->x != y->x)
        return x->x < y->x ? -1 : 1;
    return x->y < y->y ? -1 : x->y > y->y;
}

/* The corner that begins the nearest edge to the left of the leftmost corner of a hole, among the
 * rings it may be joined to; UINT32_MAX where there is none. hit: where. */
static uint32_t find_edge(const struct triangulation *t, uint32_t hole, struct csg_vec2 *hit)
{
    const struct csg_vec2 p = corner_of(t, hole)->at;
    uint32_t best = UINT32_MAX;
    hit->x = -INFINITY;
    hit->y = p.y;
    for (uint32_t i = 0; i < t->corners.num; i++) {
        const struct csg_vec2 a = corner_of(t, i)->at, b = corner_of(t, corner_of(t, i)->after)->at;
        /* The inside is to the left of an edge that goes down, where p looks at it. */
        if (!corner_of(t, i)->is_joined || !(a.y >= p.y && b.y <= p.y && a.y != b.y))
            continue;
        const double x = a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y);
        if (x <= p.x && x > hit->x) {
            hit->x = x;
            best = i;
        }
    }
    return best;
}

/* Whether b lies in the sector of the inside at corner i, as seen from there. */
static bool is_in_sector(const struct triangulation *t, uint32_t i, struct csg_vec2 b)
{
    const struct corner *c = corner_of(t, i);
    const struct csg_vec2 before = corner_of(t, c->before)->at, after = corner_of(t, c->after)->at;
    if (turn(before, c->at, after) >= 0)
        return turn(c->at, b, before) >= 0 && turn(c->at, after, b) >= 0;
    return !(turn(c->at, b, after) > 0 && turn(c->at, before, b) > 0);
}

/* A corner at the very place of a hole's leftmost one that has the hole in its sector. */
static uint32_t find_touching(const struct triangulation *t, uint32_t hole)
{
    const struct csg_vec2 next = corner_of(t, corner_of(t, hole)->after)->at;
    for (uint32_t i = 0; i < t->corners.num; i++)
        if (corner_of(t, i)->is_joined && is_same(corner_of(t, i)->at, corner_of(t, hole)->at) &&
            is_in_sector(t, i, next))
            return i;
    return UINT32_MAX;
}

/*
 * A corner that the leftmost corner of a hole sees: the left end of the nearest edge, or else the
 * corner in the triangle between them that is seen under the least angle. All of it is left of the
 * hole, none of whose corners can be in the way (Eberly, Triangulation by ear clipping, 2002).
 */
static uint32_t find_bridge(const struct triangulation *t, uint32_t hole)
{
    const struct csg_vec2 p = corner_of(t, hole)->at;
    struct csg_vec2 hit;
    const uint32_t edge = find_edge(t, hole, &hit);
    if (edge == UINT32_MAX)
        return edge;
    const uint32_t other = corner_of(t, edge)->after;
    uint32_t best = corner_of(t, edge)->at.x < corner_of(t, other)->at.x ? edge : other;
    const struct csg_vec2 end = corner_of(t, best)->at;
    double slope = INFINITY, near = -INFINITY;
    for (uint32_t i = 0; i < t->corners.num; i++) {
        const struct csg_vec2 q = corner_of(t, i)->at;
        const bool is_in =
            end.y < p.y ? is_in_triangle(p, hit, end, q) : is_in_triangle(p, end, hit, q);
        if (!corner_of(t, i)->is_joined || !is_in || q.x >= p.x || !is_in_sector(t, i, p))
            continue;
        const double angle = fabs(p.y - q.y) / (p.x - q.x);
        if (angle < slope || (angle == slope && q.x > near)) {
            slope = angle;
            near = q.x;
            best = i;
        }
    }
    return best;
}

/* Cuts both rings open at a and b and joins the ends. */
static bool join_rings(struct triangulation *t, uint32_t a, uint32_t b)
{
    const uint32_t a2 = (uint32_t)t->corners.num, b2 = a2 + 1;
    if (!csg_array_push(&t->corners, *corner_of(t, a)) ||
        !csg_array_push(&t->corners, *corner_of(t, b)))
        return false;
    const uint32_t a_after = corner_of(t, a)->after, b_before = corner_of(t, b)->before;
    corner_of(t, a)->after = b;
    corner_of(t, b)->before = a;
    corner_of(t, a2)->after = a_after;
    corner_of(t, a_after)->before = a2;
    corner_of(t, b2)->after = a2;
    corner_of(t, a2)->before = b2;
    corner_of(t, b2)->before = b_before;
    corner_of(t, b_before)->after = b2;
    return true;
}

/* A hole sees only what is left of it, so those further left are joined first. */
static bool join_holes(struct triangulation *t)
{
    bool ok = true;
    if (t->holes.num)
        qsort(t->holes.data, t->holes.num, sizeof *t->holes.data, compare_holes);
    for (size_t i = 0; i < t->holes.num && ok; i++) {
        const uint32_t hole = t->holes.data[i].leftmost, touching = find_touching(t, hole);
        const uint32_t bridge = touching == UINT32_MAX ? find_bridge(t, hole) : touching;
        for (uint32_t k = hole; !corner_of(t, k)->is_joined; k = corner_of(t, k)->after)
            corner_of(t, k)->is_joined = true;
        ok = bridge == UINT32_MAX || join_rings(t, bridge, hole);
    }
    return ok;
}

/* ---- ears --------------------------------------------------------------------------------- */

/* Whether the ring goes into the triangle's angle at a, between b and c, where its corner k is. */
static bool goes_into(const struct triangulation *t, uint32_t k, struct csg_vec2 a,
                      struct csg_vec2 b, struct csg_vec2 c)
{
    const struct csg_vec2 next = corner_of(t, corner_of(t, k)->after)->at;
    const struct csg_vec2 last = corner_of(t, corner_of(t, k)->before)->at;
    return (turn(a, b, next) > 0 && turn(a, next, c) > 0) ||
           (turn(a, b, last) > 0 && turn(a, last, c) > 0);
}

/* Whether corner k of the ring keeps the triangle from being an ear. */
static bool is_in_the_way(const struct triangulation *t, uint32_t k, struct csg_vec2 a,
                          struct csg_vec2 b, struct csg_vec2 c)
{
    const struct csg_vec2 p = corner_of(t, k)->at;
    if (is_same(p, a))
        return goes_into(t, k, a, b, c);
    if (is_same(p, b))
        return goes_into(t, k, b, c, a);
    if (is_same(p, c))
        return goes_into(t, k, c, a, b);
    return is_in_triangle(a, b, c, p) && turn_at(t, k) <= 0;
}

static double place_of(const struct triangulation *t, struct csg_vec2 p)
{
    return t->upright ? p.y : p.x;
}

static int compare_places(const void *a, const void *b)
{
    const struct place *x = a, *y = b;
    if (x->at != y->at)
        return x->at < y->at ? -1 : 1;
    return x->corner < y->corner ? -1 : x->corner > y->corner;
}

/* Sorts the corners of the ring, so that an ear is compared with those beside it only. */
static bool fill_places(struct triangulation *t, uint32_t first)
{
    double lo[2] = {INFINITY, INFINITY}, hi[2] = {-INFINITY, -INFINITY};
    uint32_t i = first;
    t->places.num = 0;
    do {
        const struct csg_vec2 p = corner_of(t, i)->at;
        lo[0] = fmin(lo[0], p.x);
        hi[0] = fmax(hi[0], p.x);
        lo[1] = fmin(lo[1], p.y);
        hi[1] = fmax(hi[1], p.y);
        if (!csg_array_push(&t->places, ((struct place){0, i})))
            return false;
        i = corner_of(t, i)->after;
    } while (i != first);
    t->upright = hi[1] - lo[1] > hi[0] - lo[0];
    for (size_t k = 0; k < t->places.num; k++)
        t->places.data[k].at = place_of(t, corner_of(t, t->places.data[k].corner)->at);
    qsort(t->places.data, t->places.num, sizeof *t->places.data, compare_places);
    return true;
}

/* Leaves out the corners that were cut, once they are the most. */
static void drop_cut_places(struct triangulation *t, uint32_t left)
{
    size_t num = 0;
    if (t->places.num < 2 * (size_t)left)
        return;
    for (size_t i = 0; i < t->places.num; i++)
        if (!corner_of(t, t->places.data[i].corner)->is_cut)
            t->places.data[num++] = t->places.data[i];
    t->places.num = num;
}

/* The first place at or after `at`. */
static size_t find_place(const struct triangulation *t, double at)
{
    size_t lo = 0, hi = t->places.num;
    while (lo < hi) {
        const size_t middle = lo + (hi - lo) / 2;
        if (t->places.data[middle].at < at)
            lo = middle + 1;
        else
            hi = middle;
    }
    return lo;
}

static bool is_ear(const struct triangulation *t, uint32_t i)
{
    const struct corner *b = corner_of(t, i);
    const struct corner *a = corner_of(t, b->before), *c = corner_of(t, b->after);
    const long double angle = turn(a->at, b->at, c->at);
    if (angle <= 0)
        return angle == 0; /* a corner that is straight or a spike goes at once */
    const double x = place_of(t, a->at), y = place_of(t, b->at), z = place_of(t, c->at);
    const double end = fmax(fmax(x, y), z);
    for (size_t k = find_place(t, fmin(fmin(x, y), z)); k < t->places.num; k++) {
        const struct place *place = &t->places.data[k];
        if (place->at > end)
            break;
        const bool is_own =
            place->corner == i || place->corner == b->before || place->corner == b->after;
        if (!is_own && !corner_of(t, place->corner)->is_cut &&
            is_in_the_way(t, place->corner, a->at, b->at, c->at))
            return false;
    }
    return true;
}

static bool cut_corner(struct triangulation *t, uint32_t i)
{
    struct corner *b = corner_of(t, i);
    const uint32_t points[3] = {corner_of(t, b->before)->point, b->point,
                                corner_of(t, b->after)->point};
    corner_of(t, b->before)->after = b->after;
    corner_of(t, b->after)->before = b->before;
    b->is_cut = true;
    for (int k = 0; k < 3; k++)
        if (!csg_array_push(&t->triangles->corners, points[k]))
            return false;
    return true;
}

static uint32_t count_ring(const struct triangulation *t, uint32_t first)
{
    uint32_t num = 0, i = first;
    do {
        num++;
        i = corner_of(t, i)->after;
    } while (i != first);
    return num;
}

/* A ring without ears, which rounding may leave, is cut anywhere: the triangles still close it. */
static bool cut_ring(struct triangulation *t, uint32_t first)
{
    uint32_t num = count_ring(t, first), i = first, tried = 0;
    bool ok = fill_places(t, first);
    while (num > 2 && ok) {
        drop_cut_places(t, num);
        const uint32_t after = corner_of(t, i)->after;
        if (num == 3 || is_ear(t, i) || tried > 2 * num || (tried > num && turn_at(t, i) > 0)) {
            ok = cut_corner(t, i);
            num--;
            tried = 0;
            i = corner_of(t, after)->after; /* not its neighbour: rounder triangles */
        } else {
            tried++;
            i = after;
        }
    }
    corner_of(t, i)->is_cut = corner_of(t, corner_of(t, i)->after)->is_cut = true;
    return ok;
}

bool csg_figure_triangulate(const struct csg_drawing *drawing, const struct csg_figure *figure,
                            struct csg_triangles *triangles)
{
    struct triangulation t = {.triangles = triangles};
    bool ok = true;
    for (uint32_t i = figure->begin; i < figure->end && ok; i++)
        if (drawing->contours.data[i].end - drawing->contours.data[i].begin >= 3)
            ok = add_ring(&t, drawing, &drawing->contours.data[i]);
    ok = ok && join_holes(&t);
    for (uint32_t i = 0; i < t.corners.num && ok; i++)
        if (!corner_of(&t, i)->is_cut)
            ok = cut_ring(&t, i);
    free(t.corners.data);
    free(t.holes.data);
    free(t.places.data);
    return ok;
}
