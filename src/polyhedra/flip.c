/* SPDX-License-Identifier: MIT */
/*
 * Edges between triangles, flipped as libtess2 does it in OpenSCAD 2021.01: from a stack, with its
 * tolerance and its order, which decide where several ways are as good.
 */
#include <stdlib.h>

#include "polyhedra/cut.h"

/* Angles that face an edge may be so much above 180 degrees, in radians. */
#define TOLERANCE 0.01
#define PI 3.14159265358979323846264338327950288

enum { none = -1 };

/* Half of an edge: the k-th of triangle f is 3 f + k, next to each other counter-clockwise. */
struct half {
    uint32_t origin;
    int twin;   /* none: on the outline */
    bool waits; /* on the stack, itself or its twin */
};

struct flipper {
    const float (*points)[2];
    struct half *halves;
    int num;
    int *stack;
    int height;
};

static int next(int half)
{
    return half % 3 == 2 ? half - 2 : half + 1;
}

static int previous(int half)
{
    return half % 3 == 0 ? half + 2 : half - 1;
}

/* ---- neighbours --------------------------------------------------------------------------- */

struct edge {
    uint32_t lo, hi;
    int half;
};

static int compare_edges(const void *a, const void *b)
{
    const struct edge *p = a, *q = b;
    if (p->lo != q->lo)
        return p->lo < q->lo ? -1 : 1;
    if (p->hi != q->hi)
        return p->hi < q->hi ? -1 : 1;
    return p->half - q->half;
}

static bool find_twins(struct flipper *flipper)
{
    struct half *halves = flipper->halves;
    struct edge *edges = malloc((size_t)flipper->num * sizeof *edges);
    for (int i = 0; i < flipper->num && edges; i++) {
        const uint32_t a = halves[i].origin, b = halves[next(i)].origin;
        edges[i] = (struct edge){a < b ? a : b, a < b ? b : a, i};
    }
    if (edges)
        qsort(edges, (size_t)flipper->num, sizeof *edges, compare_edges);
    for (int i = 0; i + 1 < flipper->num && edges; i++)
        if (edges[i].lo == edges[i + 1].lo && edges[i].hi == edges[i + 1].hi) {
            halves[edges[i].half].twin = edges[i + 1].half;
            halves[edges[i + 1].half].twin = edges[i].half;
        }
    free(edges);
    return edges != NULL;
}

/* ---- flipping ----------------------------------------------------------------------------- */

static double angle(const float a[2], const float corner[2], const float b[2])
{
    const float p[2] = {b[0] - corner[0], b[1] - corner[1]};
    const float q[2] = {a[0] - corner[0], a[1] - corner[1]};
    const double lengths =
        sqrt((double)(p[0] * p[0] + p[1] * p[1])) * sqrt((double)(q[0] * q[0] + q[1] * q[1]));
    const float length = (float)lengths;
    float cosine = p[0] * q[0] + p[1] * q[1];
    if (length > 0)
        cosine /= length;
    return (double)(float)acos((double)fminf(fmaxf(cosine, -1), 1));
}

/* The angle that faces the half's edge. */
static double facing_angle(const struct flipper *flipper, int half)
{
    const struct half *halves = flipper->halves;
    return angle(flipper->points[halves[next(half)].origin],
                 flipper->points[halves[previous(half)].origin],
                 flipper->points[halves[half].origin]);
}

static bool is_delaunay(const struct flipper *flipper, int half)
{
    const double sum =
        facing_angle(flipper, half) + facing_angle(flipper, flipper->halves[half].twin);
    return (double)(float)sum < PI + TOLERANCE;
}

static void push(struct flipper *flipper, int half)
{
    struct half *halves = flipper->halves;
    if (halves[half].waits || halves[half].twin == none)
        return;
    halves[half].waits = halves[halves[half].twin].waits = true;
    flipper->stack[flipper->height++] = half;
}

/* Puts what is at from there, with its twin's and the stack's word for it. */
static void place(struct flipper *flipper, int to, const struct half *half)
{
    flipper->halves[to] = *half;
    if (half->twin != none)
        flipper->halves[half->twin].twin = to;
}

/* The edge turns to the other two corners: of a, a+, a- and b, b+, b- become a, a-, b+ and b, b-,
 * a+. */
static void flip(struct flipper *flipper, int a)
{
    struct half *halves = flipper->halves;
    const int b = halves[a].twin;
    const int from[4] = {previous(a), next(b), previous(b), next(a)};
    const int to[4] = {next(a), previous(a), next(b), previous(b)};
    const struct half moved[4] = {halves[from[0]], halves[from[1]], halves[from[2]],
                                  halves[from[3]]};
    halves[a].origin = moved[2].origin;
    halves[b].origin = moved[0].origin;
    for (int i = 0; i < 4; i++)
        place(flipper, to[i], &moved[i]);
    for (int i = 0; i < flipper->height; i++) {
        int *waiting = &flipper->stack[i];
        for (int k = 0; k < 4; k++)
            if (*waiting == from[k]) {
                *waiting = to[k];
                break;
            }
    }
}

/* Of the four edges around, three are looked at again. */
static void flip_all(struct flipper *flipper)
{
    struct half *halves = flipper->halves;
    /* It ends by itself, but for rounding of degenerate triangles. */
    for (double turns = 100 + 10.0 * flipper->num * flipper->num; flipper->height > 0 && turns > 0;
         turns--) {
        const int half = flipper->stack[--flipper->height];
        const int twin = halves[half].twin;
        halves[half].waits = halves[twin].waits = false;
        if (is_delaunay(flipper, half))
            continue;
        flip(flipper, half);
        push(flipper, next(half));
        push(flipper, previous(half));
        push(flipper, next(twin));
    }
}

bool csg_flip_edges(const float (*points)[2], uint32_t (*triangles)[3], size_t num)
{
    struct flipper flipper = {.points = points, .num = (int)(3 * num)};
    flipper.halves = malloc(3 * num * sizeof *flipper.halves);
    flipper.stack = malloc(3 * num * sizeof *flipper.stack);
    bool ok = num < 1 || (flipper.halves && flipper.stack);
    for (int i = 0; i < flipper.num && ok; i++)
        flipper.halves[i] = (struct half){triangles[i / 3][i % 3], none, false};
    ok = ok && (num < 2 || find_twins(&flipper));
    for (int i = 0; i < flipper.num && ok; i++)
        push(&flipper, i);
    if (ok)
        flip_all(&flipper);
    for (int i = 0; i < flipper.num && ok; i++)
        triangles[i / 3][i % 3] = flipper.halves[i].origin;
    free(flipper.halves);
    free(flipper.stack);
    return ok;
}
