/* SPDX-License-Identifier: MIT */
#include "plane/triangulate.h"

#include <stdlib.h>

#include "plane/bridges.h"

/* The corners of the ring that is cut by the cells of its box in which they are, about as many
 * cells as corners. */
struct grid {
    struct csg_vec2 lo, scale; /* cells a unit */
    uint32_t num[2];           /* cells along x and y */
    CSG_ARRAY(uint32_t) first; /* by cell, row by row: its first corner in the list, */
    CSG_ARRAY(uint32_t) list;  /* which has some that were cut lately */
};

struct triangulation {
    struct csg_corners corners;
    struct grid grid;
    struct csg_triangles *triangles;
};

static struct csg_corner *corner_of(const struct triangulation *t, uint32_t i)
{
    return &t->corners.list.data[i];
}

static long double turn_at(const struct triangulation *t, uint32_t i)
{
    const struct csg_corner *c = corner_of(t, i);
    return csg_turn(corner_of(t, c->before)->at, c->at, corner_of(t, c->after)->at);
}

/* ---- ears --------------------------------------------------------------------------------- */

/* The corners of the triangle, which turns to the left, and its edges count as inside. */
static bool is_in_triangle(struct csg_vec2 a, struct csg_vec2 b, struct csg_vec2 c,
                           struct csg_vec2 p)
{
    /* Beside its box, which is soon seen, it cannot be. */
    if ((p.x < a.x && p.x < b.x && p.x < c.x) || (p.x > a.x && p.x > b.x && p.x > c.x) ||
        (p.y < a.y && p.y < b.y && p.y < c.y) || (p.y > a.y && p.y > b.y && p.y > c.y))
        return false;
    return csg_turn(a, b, p) >= 0 && csg_turn(b, c, p) >= 0 && csg_turn(c, a, p) >= 0;
}

/* Whether the ring goes into the triangle's angle at a, between b and c, where its corner k is. */
static bool goes_into(const struct triangulation *t, uint32_t k, struct csg_vec2 a,
                      struct csg_vec2 b, struct csg_vec2 c)
{
    const struct csg_vec2 next = corner_of(t, corner_of(t, k)->after)->at;
    const struct csg_vec2 last = corner_of(t, corner_of(t, k)->before)->at;
    return (csg_turn(a, b, next) > 0 && csg_turn(a, next, c) > 0) ||
           (csg_turn(a, b, last) > 0 && csg_turn(a, last, c) > 0);
}

/* Whether corner k of the ring keeps the triangle from being an ear. */
static bool is_in_the_way(const struct triangulation *t, uint32_t k, struct csg_vec2 a,
                          struct csg_vec2 b, struct csg_vec2 c)
{
    const struct csg_vec2 p = corner_of(t, k)->at;
    if (csg_is_same_place(p, a))
        return goes_into(t, k, a, b, c);
    if (csg_is_same_place(p, b))
        return goes_into(t, k, b, c, a);
    if (csg_is_same_place(p, c))
        return goes_into(t, k, c, a, b);
    return is_in_triangle(a, b, c, p) && turn_at(t, k) <= 0;
}

static uint32_t column_of(const struct grid *grid, double x)
{
    return (uint32_t)fmin((x - grid->lo.x) * grid->scale.x, grid->num[0] - 1);
}

static uint32_t row_of(const struct grid *grid, double y)
{
    return (uint32_t)fmin((y - grid->lo.y) * grid->scale.y, grid->num[1] - 1);
}

static uint32_t *first_of(struct grid *grid, struct csg_vec2 p)
{
    return &grid->first.data[row_of(grid, p.y) * grid->num[0] + column_of(grid, p.x)];
}

/* Cells about as wide as high, for num corners between lo and hi. */
static bool shape_grid(struct grid *grid, struct csg_vec2 lo, struct csg_vec2 hi, uint32_t num)
{
    const double width = hi.x - lo.x, height = hi.y - lo.y;
    const double columns = sqrt(num * (width / height));
    grid->lo = lo;
    grid->num[0] = (uint32_t)fmax(fmin(columns, num), 1);
    grid->num[1] = num / grid->num[0] + 1;
    grid->scale.x = width > 0 ? grid->num[0] / width : 0;
    grid->scale.y = height > 0 ? grid->num[1] / height : 0;
    grid->first.num = grid->list.num = 0;
    bool ok = true;
    for (uint32_t i = 0; i < grid->num[0] * grid->num[1] + 1 && ok; i++)
        ok = csg_array_push(&grid->first, 0);
    for (uint32_t i = 0; i < num && ok; i++)
        ok = csg_array_push(&grid->list, 0);
    return ok;
}

/* Sorts the num corners of the ring into cells, so that an ear is compared with those beside it
 * only: a counting sort. */
static bool fill_grid(struct triangulation *t, uint32_t first, uint32_t num)
{
    struct grid *grid = &t->grid;
    struct csg_vec2 lo = {INFINITY, INFINITY}, hi = {-INFINITY, -INFINITY};
    uint32_t i = first;
    for (uint32_t k = 0; k < num; k++, i = corner_of(t, i)->after) {
        const struct csg_vec2 p = corner_of(t, i)->at;
        lo = (struct csg_vec2){fmin(lo.x, p.x), fmin(lo.y, p.y)};
        hi = (struct csg_vec2){fmax(hi.x, p.x), fmax(hi.y, p.y)};
    }
    if (!shape_grid(grid, lo, hi, num))
        return false;
    for (uint32_t k = 0; k < num; k++, i = corner_of(t, i)->after)
        ++*first_of(grid, corner_of(t, i)->at);
    for (size_t k = 1; k < grid->first.num; k++)
        grid->first.data[k] += grid->first.data[k - 1];
    for (uint32_t k = 0; k < num; k++, i = corner_of(t, i)->after)
        grid->list.data[--*first_of(grid, corner_of(t, i)->at)] = i;
    return true;
}

/* Whether a corner of the cells [begin, end), in one row, keeps the triangle at i from being an
 * ear. */
static bool is_row_in_the_way(const struct triangulation *t, uint32_t begin, uint32_t end,
                              uint32_t i)
{
    const struct csg_corner *b = corner_of(t, i);
    const struct csg_corner *a = corner_of(t, b->before), *c = corner_of(t, b->after);
    for (uint32_t k = t->grid.first.data[begin]; k < t->grid.first.data[end]; k++) {
        const uint32_t other = t->grid.list.data[k];
        const bool is_own = other == i || other == b->before || other == b->after;
        if (!is_own && !corner_of(t, other)->is_cut && is_in_the_way(t, other, a->at, b->at, c->at))
            return true;
    }
    return false;
}

static bool is_ear(const struct triangulation *t, uint32_t i)
{
    const struct csg_corner *b = corner_of(t, i);
    const struct csg_corner *a = corner_of(t, b->before), *c = corner_of(t, b->after);
    const long double angle = csg_turn(a->at, b->at, c->at);
    if (angle <= 0)
        return angle == 0; /* a corner that is straight or a spike goes at once */
    const struct grid *grid = &t->grid;
    const uint32_t begin = column_of(grid, fmin(fmin(a->at.x, b->at.x), c->at.x));
    const uint32_t end = column_of(grid, fmax(fmax(a->at.x, b->at.x), c->at.x)) + 1;
    const uint32_t top = row_of(grid, fmax(fmax(a->at.y, b->at.y), c->at.y));
    for (uint32_t row = row_of(grid, fmin(fmin(a->at.y, b->at.y), c->at.y)); row <= top; row++)
        if (is_row_in_the_way(t, row * grid->num[0] + begin, row * grid->num[0] + end, i))
            return false;
    return true;
}

static bool cut_corner(struct triangulation *t, uint32_t i)
{
    struct csg_corner *b = corner_of(t, i);
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

/* Rounds in which fewer than one corner in so many is cut are the last ones. */
#define SCARCE 16

/* A walk round a ring from ear to ear. */
struct walk {
    uint32_t at, num;    /* a corner of the ring, and how many there are */
    uint32_t tried;      /* since the last ear */
    uint32_t asked, cut; /* in this round, of which begun had as many corners as */
    uint32_t begun;
    bool is_scarce; /* ears are */
};

/*
 * Rounder triangles come of it where no two neighbours are ears in one round. But in a strip that
 * winds about, only its two ends have ears in the end, and each of them would take a round: there
 * the walk stays where it cut, as an ear makes no other corners than its neighbours ears.
 */
static bool cut_ear(struct triangulation *t, struct walk *walk)
{
    const struct csg_corner b = *corner_of(t, walk->at);
    const bool ok = cut_corner(t, walk->at);
    walk->at = walk->is_scarce ? b.before : corner_of(t, b.after)->after;
    walk->num--;
    walk->cut++;
    walk->tried = 0;
    return ok;
}

static void begin_round(struct walk *walk)
{
    walk->is_scarce = walk->is_scarce || walk->cut < walk->begun / SCARCE;
    walk->begun = walk->num;
    walk->asked = walk->cut = 0;
}

/* A ring without ears, which rounding may leave, is cut anywhere: the triangles still close it. */
static bool is_cut_next(const struct triangulation *t, const struct walk *walk)
{
    return walk->num == 3 || is_ear(t, walk->at) || walk->tried > 2 * walk->num ||
           (walk->tried > walk->num && turn_at(t, walk->at) > 0);
}

static bool cut_ring(struct triangulation *t, uint32_t first)
{
    const uint32_t num = count_ring(t, first);
    struct walk walk = {.at = first, .num = num, .begun = num};
    bool ok = fill_grid(t, first, num);
    while (walk.num > 2 && ok) {
        if (t->grid.list.num >= 2 * (size_t)walk.num && !fill_grid(t, walk.at, walk.num))
            return false;
        if (++walk.asked > walk.begun)
            begin_round(&walk);
        if (is_cut_next(t, &walk)) {
            ok = cut_ear(t, &walk);
        } else {
            walk.tried++;
            walk.at = corner_of(t, walk.at)->after;
        }
    }
    corner_of(t, walk.at)->is_cut = corner_of(t, corner_of(t, walk.at)->after)->is_cut = true;
    return ok;
}

bool csg_figure_triangulate(const struct csg_drawing *drawing, const struct csg_figure *figure,
                            struct csg_triangles *triangles)
{
    struct triangulation t = {.triangles = triangles};
    bool ok = csg_corners_of_figure(drawing, figure, &t.corners);
    for (uint32_t i = 0; i < t.corners.list.num && ok; i++)
        if (!corner_of(&t, i)->is_cut)
            ok = cut_ring(&t, i);
    free(t.corners.list.data);
    free(t.grid.first.data);
    free(t.grid.list.data);
    return ok;
}
