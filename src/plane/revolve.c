/* SPDX-License-Identifier: MIT */
#include "plane/revolve.h"

#include <stdlib.h>

#include "csg/stack.h"
#include "plane/prism.h"
#include "solids/facets.h"

/* Between two edges of the profile and two levels. */
struct trapezoid {
    uint32_t left, right; /* edges */
    uint32_t begin, end;  /* levels */
};

/* Part of the turn, at most 180 degrees or all of it. */
struct sector {
    double from, to; /* degrees, from < to */
    bool all_round;
    int num; /* segments */
};

struct lathe {
    struct csg_part *part;
    const struct csg_profile *profile;
    const struct csg_turn *turn;
    double rounding;
    double flip;            /* degrees: 180 for a profile left of the axis */
    struct csg_box written; /* of all sectors at radius 1 */
    CSG_ARRAY(struct sector) sectors;
    CSG_ARRAY(struct trapezoid) trapezoids;
};

/* A profile that turns inwards by less is straight: radius per height. */
#define STRAIGHT 1e-9

/* ---- the profile -------------------------------------------------------------------------- */

/* Trapezoids that end at the top of a slab, in the order of x. */
struct tops {
    CSG_ARRAY(size_t) list;
    size_t num_passed; /* while those of the slab above are looked for */
};

/* The one that the span goes on; the number of trapezoids: there is none. */
static size_t find_below(const struct lathe *lathe, struct tops *below,
                         const struct csg_sweep_span *span)
{
    for (size_t i = below->num_passed; i < below->list.num; i++) {
        const struct trapezoid *old = &lathe->trapezoids.data[below->list.data[i]];
        if (old->end != span->level || old->left != span->left || old->right != span->right)
            continue;
        below->num_passed = i + 1;
        return below->list.data[i];
    }
    return lathe->trapezoids.num;
}

/* Joins the spans of neighbouring slabs that lie between the same edges. Both are in the order of
 * x, so the trapezoids of the slab below are looked through only once. */
static bool find_trapezoids(struct lathe *lathe)
{
    const struct csg_sweep *sweep = &lathe->profile->sweep;
    struct tops below = {.num_passed = 0}, above = {.num_passed = 0};
    bool ok = true;
    for (size_t i = 0; i < sweep->spans.num && ok; i++) {
        const struct csg_sweep_span *span = &sweep->spans.data[i];
        if (i > 0 && span[-1].level != span->level) {
            const struct tops old = below;
            below = above;
            above = old;
            below.num_passed = above.list.num = 0;
        }
        const size_t at = find_below(lathe, &below, span);
        if (at < lathe->trapezoids.num)
            lathe->trapezoids.data[at].end = span->level + 1;
        else
            ok = csg_array_push(
                &lathe->trapezoids,
                ((struct trapezoid){span->left, span->right, span->level, span->level + 1}));
        ok = ok && csg_array_push(&above.list, at);
    }
    free(below.list.data);
    free(above.list.data);
    return ok;
}

/* ---- the turn ----------------------------------------------------------------------------- */

/* Cuts the turn into sectors, at segments where it is facetted. */
static bool find_sectors(struct lathe *lathe)
{
    const struct csg_turn *turn = lathe->turn;
    const double start = turn->start + lathe->flip;
    const double from = turn->angle < 0 ? start + turn->angle : start;
    const double size = fabs(turn->angle);
    const int per_sector =
        turn->facetted ? (int)fmin(floor(180 / (size / turn->num) + 1e-9), turn->num) : turn->num;
    bool ok = true;
    if (size >= 360)
        return csg_array_push(&lathe->sectors,
                              ((struct sector){start, start + 360, true, turn->num}));
    if (!turn->facetted) {
        for (double at = 0; at < size && ok; at += 180)
            ok = csg_array_push(
                &lathe->sectors,
                ((struct sector){from + at, from + fmin(at + 180, size), false, turn->num}));
        return ok;
    }
    for (int i = 0; i < turn->num && per_sector > 0 && ok; i += per_sector) {
        const int num = turn->num - i < per_sector ? turn->num - i : per_sector;
        ok = csg_array_push(&lathe->sectors,
                            ((struct sector){from + size * i / turn->num,
                                             from + size * (i + num) / turn->num, false, num}));
    }
    return ok;
}

static struct csg_vec2 direction(double degrees)
{
    return (struct csg_vec2){csg_cos_degrees(degrees), csg_sin_degrees(degrees)};
}

static struct csg_vec2 sector_direction(const struct sector *sector, int i)
{
    return direction(sector->from + (sector->to - sector->from) * i / sector->num);
}

/* The planes through the axis. For a half turn they are the same one. */
static bool add_wedge(struct csg_shape *shape, const struct sector *sector)
{
    const struct csg_vec2 from = direction(sector->from), to = direction(sector->to);
    if (sector->all_round)
        return true;
    return csg_shape_add_plane(shape, csg_vec3(from.y, -from.x, 0), 0) &&
           (sector->to - sector->from >= 180 ||
            csg_shape_add_plane(shape, csg_vec3(-to.y, to.x, 0), 0));
}

/* The box of a unit disc's sector: its ends, its centre and where it crosses the axes. */
static struct csg_box sector_box(const struct sector *sector)
{
    struct csg_box box = csg_box_empty;
    const struct csg_vec2 from = direction(sector->from), to = direction(sector->to);
    csg_box_extend(&box, csg_vec3(from.x, from.y, 0));
    csg_box_extend(&box, csg_vec3(to.x, to.y, 0));
    csg_box_extend(&box, csg_vec3(0, 0, 0));
    for (double at = 90 * ceil(sector->from / 90); at < sector->to; at += 90)
        csg_box_extend(&box, csg_vec3(direction(at).x, direction(at).y, 0));
    return box;
}

static struct csg_box written_box(const struct sector *sector)
{
    struct csg_box box = csg_box_empty;
    for (int i = 0; i <= sector->num; i++) {
        const struct csg_vec2 d = sector_direction(sector, i);
        csg_box_extend(&box, csg_vec3(d.x, d.y, 0));
    }
    return box;
}

/*
 * The facet between the directions a and b: its normal m in the plane is across b - a, and its
 * distance from the axis is k = m.a times the radius r(z) = r0 + g (z - z0), g = (r1 - r0) /
 * (z1 - z0):   m.x x + m.y y - k g z <= k (r0 - g z0).
 */
static bool add_facets(struct csg_shape *shape, const struct sector *sector,
                       const struct csg_lift *radius)
{
    const double g = (radius->s1 - radius->s0) / (radius->z1 - radius->z0);
    bool ok = true;
    for (int i = 0; i < sector->num && ok; i++) {
        const struct csg_vec2 a = sector_direction(sector, i);
        const struct csg_vec2 b = sector_direction(sector, i + 1);
        const double length = hypot(b.x - a.x, b.y - a.y);
        const struct csg_vec2 m = {(b.y - a.y) / length, -(b.x - a.x) / length};
        const double k = m.x * a.x + m.y * a.y;
        ok = csg_shape_add_plane(shape, csg_vec3(m.x, m.y, -k * g),
                                 k * (radius->s0 - g * radius->z0));
    }
    return ok;
}

/* ---- solids ------------------------------------------------------------------------------- */

/* What is within a radius that depends linearly on z. */
static bool add_frustum(struct lathe *lathe, const struct sector *sector,
                        const struct csg_lift *radius, bool negated)
{
    const double largest = fmax(radius->s0, radius->s1);
    const struct csg_map disc = csg_map_scaling(csg_vec3(largest, largest, 1));
    const struct csg_lift lift = {radius->z0, radius->s0 / largest, radius->z1,
                                  radius->s1 / largest};
    struct csg_shape shape = {.frame = csg_map_identity, .rounding = lathe->rounding};
    const struct csg_box section = sector_box(sector);
    bool ok;
    if (lathe->turn->facetted) {
        shape.convex = shape.facetted = true;
        ok = csg_lift_add_caps(radius, &shape) && add_facets(&shape, sector, radius);
    } else {
        ok = csg_disc_fill(&shape, &disc, &lift);
        shape.sagitta =
            csg_facets_sagitta(360 * lathe->turn->num / fabs(lathe->turn->angle), largest);
        shape.radii[0] = sector->all_round ? radius->s0 : 0;
        shape.radii[1] = sector->all_round ? radius->s1 : 0;
    }
    if (!ok || !add_wedge(&shape, sector)) {
        csg_shape_finish(&shape);
        return false;
    }
    shape.bounds = csg_lift_box(radius, &section);
    shape.written = csg_lift_box(radius, &lathe->written);
    return csg_part_add(lathe->part, &shape, negated);
}

static double radius_at(const struct lathe *lathe, uint32_t edge, uint32_t level)
{
    const double x = fabs(csg_sweep_x(&lathe->profile->sweep, edge, level));
    return x <= lathe->profile->snap ? 0 : x;
}

static struct csg_lift lift_of(const struct lathe *lathe, const struct trapezoid *trapezoid,
                               uint32_t edge)
{
    const double *levels = lathe->profile->sweep.levels.data;
    return (struct csg_lift){levels[trapezoid->begin], radius_at(lathe, edge, trapezoid->begin),
                             levels[trapezoid->end], radius_at(lathe, edge, trapezoid->end)};
}

static struct csg_lift outer_lift(const struct lathe *lathe, const struct trapezoid *trapezoid)
{
    return lift_of(lathe, trapezoid, lathe->flip > 0 ? trapezoid->left : trapezoid->right);
}

static struct csg_lift inner_lift(const struct lathe *lathe, const struct trapezoid *trapezoid)
{
    return lift_of(lathe, trapezoid, lathe->flip > 0 ? trapezoid->right : trapezoid->left);
}

/* The outer edge's frustum without the inner one's. */
static bool add_ring(struct lathe *lathe, const struct sector *sector,
                     const struct trapezoid *trapezoid)
{
    const struct csg_lift out = outer_lift(lathe, trapezoid), in = inner_lift(lathe, trapezoid);
    if (out.s0 <= 0 && out.s1 <= 0)
        return true;
    if (!csg_part_open(lathe->part, true) || !add_frustum(lathe, sector, &out, false) ||
        ((in.s0 > 0 || in.s1 > 0) && !add_frustum(lathe, sector, &in, true)))
        return false;
    csg_part_close(lathe->part);
    return true;
}

static bool add_sector(struct lathe *lathe, const struct sector *sector)
{
    bool ok = true;
    for (size_t i = 0; i < lathe->trapezoids.num && ok && !lathe->part->is_too_large; i++)
        ok = add_ring(lathe, sector, &lathe->trapezoids.data[i]);
    return ok;
}

static bool add_sectors(struct lathe *lathe)
{
    bool ok = csg_part_open(lathe->part, false);
    for (size_t i = 0; i < lathe->sectors.num && ok; i++) {
        lathe->written = written_box(&lathe->sectors.data[i]);
        ok = add_sector(lathe, &lathe->sectors.data[i]);
    }
    if (ok)
        csg_part_close(lathe->part);
    return ok;
}

/* ---- convex turns --------------------------------------------------------------------------- */

/* Of a profile that is stacked on the axis: its radius never grows faster than below. */
static bool is_convex(const struct lathe *lathe)
{
    const struct trapezoid *trapezoids = lathe->trapezoids.data;
    double slope = INFINITY, radius = 0;
    for (size_t i = 0; i < lathe->trapezoids.num; i++) {
        const struct csg_lift out = outer_lift(lathe, &trapezoids[i]);
        const struct csg_lift in = inner_lift(lathe, &trapezoids[i]);
        const double next = (out.s1 - out.s0) / (out.z1 - out.z0);
        const bool goes_on = i == 0 || (trapezoids[i].begin == trapezoids[i - 1].end &&
                                        fabs(out.s0 - radius) <= lathe->profile->snap);
        if (in.s0 > 0 || in.s1 > 0 || !goes_on || next > slope + STRAIGHT * (1 + fabs(next)))
            return false;
        slope = next;
        radius = out.s1;
    }
    return true;
}

/* All facets together. */
static bool add_convex(struct lathe *lathe, const struct sector *sector)
{
    const double *levels = lathe->profile->sweep.levels.data;
    const size_t num = lathe->trapezoids.num;
    struct csg_lift all = {levels[lathe->trapezoids.data[0].begin], 0,
                           levels[lathe->trapezoids.data[num - 1].end], 0};
    struct csg_shape shape = {.frame = csg_map_identity, .rounding = lathe->rounding};
    const struct csg_box section = sector_box(sector);
    bool ok = csg_part_open(lathe->part, false) && csg_lift_add_caps(&all, &shape);
    shape.convex = shape.facetted = true;
    for (size_t i = 0; i < num && ok; i++) {
        const struct csg_lift out = outer_lift(lathe, &lathe->trapezoids.data[i]);
        all.s0 = all.s1 = fmax(all.s0, fmax(out.s0, out.s1));
        ok = add_facets(&shape, sector, &out);
    }
    lathe->written = written_box(sector);
    shape.bounds = csg_lift_box(&all, &section);
    shape.written = csg_lift_box(&all, &lathe->written);
    if (!ok)
        csg_shape_finish(&shape);
    ok = ok && csg_part_add(lathe->part, &shape, false);
    if (ok)
        csg_part_close(lathe->part);
    return ok;
}

/* ---- turns ---------------------------------------------------------------------------------- */

/* The planes of a sector alone. Its box is that of what it cuts: outside of it there are no rings,
 * so that nobody asks. */
static bool add_sector_planes(struct lathe *lathe, const struct sector *sector, bool negated)
{
    const struct csg_profile *profile = lathe->profile;
    const double radius = fmax(profile->hi, -profile->lo);
    const struct csg_sweep *sweep = &profile->sweep;
    const struct csg_lift all = {sweep->levels.data[0], radius,
                                 sweep->levels.data[sweep->levels.num - 1], radius};
    const struct csg_box section = sector_box(sector);
    struct csg_shape shape = {.frame = csg_map_identity, .rounding = lathe->rounding};
    shape.convex = true;
    shape.bounds = csg_lift_box(&all, &section);
    shape.written = csg_box_empty;
    if (add_wedge(&shape, sector))
        return csg_part_add(lathe->part, &shape, negated);
    csg_shape_finish(&shape);
    return false;
}

/* The rings of the whole turn, which become one leaf (csg/stack.h), cut by at most a half turn. */
static bool add_cut_turn(struct lathe *lathe)
{
    const struct sector first = lathe->sectors.data[0];
    const struct sector last = lathe->sectors.data[lathe->sectors.num - 1];
    const struct sector whole = {first.from, first.from + 360, true, first.num};
    const struct sector rest = {last.to, first.from + 360, false, 1};
    const bool is_large = lathe->sectors.num > 1;
    lathe->written = csg_box_empty;
    for (size_t i = 0; i < lathe->sectors.num; i++) {
        const struct csg_box box = written_box(&lathe->sectors.data[i]);
        lathe->written = csg_box_union(&lathe->written, &box);
    }
    if (!csg_part_open(lathe->part, true) || !csg_part_open(lathe->part, false) ||
        !add_sector(lathe, &whole))
        return false;
    csg_part_close(lathe->part);
    if (!add_sector_planes(lathe, is_large ? &rest : &first, is_large))
        return false;
    csg_part_close(lathe->part);
    return true;
}

static bool add_turn(struct lathe *lathe)
{
    const bool is_cut = lathe->sectors.num > 0 && !lathe->sectors.data[0].all_round;
    const bool is_whole = lathe->sectors.num == 1 && lathe->sectors.data[0].all_round;
    if (lathe->turn->facetted && is_whole && lathe->trapezoids.num > 1 && is_convex(lathe))
        return add_convex(lathe, &lathe->sectors.data[0]);
    return is_cut && !lathe->turn->facetted && lathe->trapezoids.num >= CSG_STACK_MIN_RINGS
               ? add_cut_turn(lathe)
               : add_sectors(lathe);
}

bool csg_revolve(struct csg_part *part, const struct csg_profile *profile,
                 const struct csg_turn *turn, double rounding)
{
    struct lathe lathe = {.part = part,
                          .profile = profile,
                          .turn = turn,
                          .rounding = rounding,
                          .flip = profile->hi > profile->snap ? 0 : 180};
    const bool ok = find_trapezoids(&lathe) && find_sectors(&lathe) && add_turn(&lathe);
    free(lathe.sectors.data);
    free(lathe.trapezoids.data);
    return ok;
}
