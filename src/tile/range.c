/* SPDX-License-Identifier: MIT */
#include "tile/range.h"

#include "common/wide.h"

const struct csg_leaf_range csg_leaf_nowhere = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};

struct csg_tile_box csg_tile_box(const double center[2], const double half[2])
{
    struct csg_tile_box box;
    for (int i = 0; i < 2; i++) {
        box.center[i] = center[i];
        box.half[i] = half[i];
        box.reach[i] = half[i] + CSG_FLOAT_MARGIN * (fabs(center[i]) + half[i]);
    }
    return box;
}

void csg_tile_boxes_set(struct csg_tile_boxes *boxes, int lane, const struct csg_tile_box *box)
{
    for (int i = 0; i < 2; i++) {
        boxes->center[i][lane] = box->center[i];
        boxes->reach[i][lane] = box->reach[i];
    }
}

/* ---- in num lanes ---- */

/* Twin of csg_range_of_affine. */
PART void affine(int num, double c0, double cx, double cy, const struct csg_tile_boxes *tiles,
                 struct csg_ranges *range)
{
    const double ax = fabs(cx), ay = fabs(cy), margin = CSG_FLOAT_MARGIN * fabs(c0);
    for (int i = 0; i < num; i++) {
        const double mid = c0 + cx * tiles->center[0][i] + cy * tiles->center[1][i];
        const double reach = ax * tiles->reach[0][i] + ay * tiles->reach[1][i] + margin;
        range->lo[i] = mid - reach;
        range->hi[i] = mid + reach;
    }
}

/* Of u (slope + curve u), for a range of u. */
PART void parabola(int num, const struct csg_ranges *u, double slope, double curve,
                   struct csg_ranges *range)
{
    /* Without a curve it rises or falls everywhere, and this is not looked at. */
    const double top = -0.5 * slope / curve, extreme = top * (slope + curve * top);
    for (int i = 0; i < num; i++) {
        const double a = u->lo[i] * (slope + curve * u->lo[i]);
        const double b = u->hi[i] * (slope + curve * u->hi[i]);
        const bool turns = (slope + 2 * curve * u->lo[i] > 0) != (slope + 2 * curve * u->hi[i] > 0);
        const double lo = csg_smaller(a, b), hi = csg_larger(a, b);
        range->lo[i] = turns && extreme < lo ? extreme : lo;
        range->hi[i] = turns && extreme > hi ? extreme : hi;
    }
}

/* The conic h, or S where the quadric is stiff; texels as shaders/solids/quadric.glsl reads them.
 */
PART void conic(int num, const double *t, const struct csg_tile_boxes *tiles,
                struct csg_ranges *range)
{
    const int code = (int)t[3];
    const double curve = code & CSG_QUADRIC_X_MINUS ? -1 : code & CSG_QUADRIC_X_PLUS ? 1 : 0;
    const double x1 = t[5], y1 = t[6], c0 = t[7];
    struct csg_ranges x, y, xx, yy;
    affine(num, t[4], x1, y1, tiles, &x);
    affine(num, t[8], -y1, x1, tiles, &y);
    parabola(num, &x, t[9], curve, &xx);
    parabola(num, &y, t[10], t[11], &yy);
    for (int i = 0; i < num; i++) {
        const double margin =
            CSG_FLOAT_MARGIN * (fabs(c0) + csg_larger(fabs(xx.lo[i]), fabs(xx.hi[i])) +
                                csg_larger(fabs(yy.lo[i]), fabs(yy.hi[i])));
        range->lo[i] = c0 + xx.lo[i] + yy.lo[i] - margin;
        range->hi[i] = c0 + xx.hi[i] + yy.hi[i] + margin;
    }
}

/* The crossings where the conic h has that range. */
PART void crossings(int num, const double *t, const struct csg_tile_boxes *tiles,
                    const struct csg_ranges *h, struct csg_ranges *first, struct csg_ranges *second)
{
    struct csg_ranges m;
    affine(num, t[0], t[1], t[2], tiles, &m);
    for (int i = 0; i < num; i++) {
        const double most = sqrt(csg_larger(h->hi[i], 0)), least = sqrt(csg_larger(h->lo[i], 0));
        const double margin = CSG_FLOAT_MARGIN * (fabs(m.lo[i]) + fabs(m.hi[i]) + most);
        first->lo[i] = m.lo[i] - most - margin;
        first->hi[i] = m.hi[i] - least + margin;
        second->lo[i] = m.lo[i] + least - margin;
        second->hi[i] = m.hi[i] + most + margin;
    }
}

PART void quadric(int num, const double *texels, const struct csg_tile_boxes *tiles,
                  struct csg_leaf_ranges *ranges)
{
    ranges->code = (int)texels[3];
    conic(num, texels, tiles, &ranges->conic);
    if (!(ranges->code & CSG_QUADRIC_STIFF)) {
        crossings(num, texels, tiles, &ranges->conic, &ranges->first, &ranges->second);
        return;
    }
    for (int i = 0; i < num; i++) { /* they may be anywhere */
        ranges->first.lo[i] = ranges->second.lo[i] = -(double)CSG_KEY_MAX;
        ranges->first.hi[i] = ranges->second.hi[i] = (double)CSG_KEY_MAX;
    }
}

PART void enter_later(int num, const struct csg_ranges *key, struct csg_leaf_ranges *ranges)
{
    for (int i = 0; i < num; i++) {
        ranges->entry.lo[i] = csg_larger(ranges->entry.lo[i], key->lo[i]);
        ranges->entry.hi[i] = csg_larger(ranges->entry.hi[i], key->hi[i]);
    }
}

PART void leave_sooner(int num, const struct csg_ranges *key, struct csg_leaf_ranges *ranges)
{
    for (int i = 0; i < num; i++) {
        ranges->exit.lo[i] = csg_smaller(ranges->exit.lo[i], key->lo[i]);
        ranges->exit.hi[i] = csg_smaller(ranges->exit.hi[i], key->hi[i]);
    }
}

PART void start(int num, struct csg_leaf_ranges *ranges)
{
    for (int i = 0; i < num; i++) {
        ranges->entry.lo[i] = ranges->entry.hi[i] = -(double)CSG_KEY_MAX;
        ranges->exit.lo[i] = ranges->exit.hi[i] = (double)CSG_KEY_MAX;
    }
}

PART void clip_planes(int num, const double *texels, uint32_t num_entries, uint32_t num_exits,
                      const struct csg_tile_boxes *tiles, struct csg_leaf_ranges *ranges)
{
    struct csg_ranges key;
    for (uint32_t i = 0; i < num_entries; i++, texels += 4) {
        affine(num, texels[0], texels[1], texels[2], tiles, &key);
        enter_later(num, &key, ranges);
    }
    for (uint32_t i = 0; i < num_exits; i++, texels += 4) {
        affine(num, texels[0], texels[1], texels[2], tiles, &key);
        leave_sooner(num, &key, ranges);
    }
}

/* Where some rays may not be inside of the quadric, the leaf is not solid. */
PART void open_where(int num, bool wanted, struct csg_leaf_ranges *ranges)
{
    const bool stiff = ranges->code & CSG_QUADRIC_STIFF;
    for (int i = 0; i < num; i++) {
        const bool all = wanted ? ranges->conic.lo[i] > 0 && !stiff : ranges->conic.hi[i] < 0;
        ranges->entry.hi[i] = all ? ranges->entry.hi[i] : INFINITY;
        ranges->exit.lo[i] = all ? ranges->exit.lo[i] : -INFINITY;
    }
}

/* Where no ray is inside of it, the leaf is nowhere. */
PART void drop_where_missed(int num, struct csg_leaf_ranges *ranges)
{
    for (int i = 0; i < num; i++) {
        const bool missed = ranges->conic.hi[i] < 0;
        ranges->entry.lo[i] = missed ? INFINITY : ranges->entry.lo[i];
        ranges->exit.hi[i] = missed ? -INFINITY : ranges->exit.hi[i];
    }
}

/* The rays may be inside of it. */
PART void clip_quadric(int num, struct csg_leaf_ranges *ranges)
{
    switch (ranges->code & 3) {
    case CSG_QUADRIC_BETWEEN:
        enter_later(num, &ranges->first, ranges);
        leave_sooner(num, &ranges->second, ranges);
        open_where(num, true, ranges);
        drop_where_missed(num, ranges);
        break;
    case CSG_QUADRIC_BEFORE:
        leave_sooner(num, &ranges->first, ranges);
        break;
    case CSG_QUADRIC_AFTER:
        enter_later(num, &ranges->second, ranges);
        break;
    default:
        open_where(num, false, ranges);
    }
}

WIDE void all_of_leaf(const double *texels, uint32_t num_entries, uint32_t num_exits,
                      bool has_quadric, const struct csg_tile_boxes *tiles,
                      struct csg_leaf_ranges *ranges)
{
    start(CSG_TILE_LANES, ranges);
    clip_planes(CSG_TILE_LANES, texels, num_entries, num_exits, tiles, ranges);
    ranges->code = -1;
    if (!has_quadric)
        return;
    quadric(CSG_TILE_LANES, texels + 4 * (size_t)(num_entries + num_exits), tiles, ranges);
    clip_quadric(CSG_TILE_LANES, ranges);
}

void csg_ranges_of_leaf(const struct csg_terms *terms, const struct csg_leaf_terms *leaf,
                        const struct csg_tile_boxes *tiles, struct csg_leaf_ranges *ranges)
{
    all_of_leaf(csg_terms_texel(terms, leaf, 0), leaf->num_entries, leaf->num_exits,
                leaf->flags & CSG_RECORD_QUADRIC, tiles, ranges);
}

/* ---- in one of them ---- */

static struct csg_quadric_range quadric_in(const struct csg_leaf_ranges *ranges, int lane)
{
    return (struct csg_quadric_range){
        .first = csg_range_in_lane(&ranges->first, lane),
        .second = csg_range_in_lane(&ranges->second, lane),
        .never = ranges->conic.hi[lane] < 0,
        .always = !(ranges->code & CSG_QUADRIC_STIFF) && ranges->conic.lo[lane] > 0,
        .region = ranges->code & 3,
    };
}

struct csg_quadric_range csg_range_of_quadric(const double *texels, const struct csg_tile_box *tile)
{
    struct csg_leaf_ranges ranges;
    struct csg_tile_boxes tiles;
    csg_tile_boxes_set(&tiles, 0, tile);
    quadric(1, texels, &tiles, &ranges);
    return quadric_in(&ranges, 0);
}

/* Open surfaces may have no end. */
struct csg_leaf_range csg_range_of_surface(const struct csg_surface_view *view,
                                           const struct csg_tile_box *tile)
{
    const double far = (double)CSG_KEY_MAX;
    struct csg_view_rect rect;
    double keys[2];
    for (int i = 0; i < 2; i++) {
        rect.lo[i] = tile->center[i] - tile->half[i];
        rect.hi[i] = tile->center[i] + tile->half[i];
    }
    const bool met = csg_surface_view_range(view, &rect, keys);
    if (!met && view->turns != 0)
        return (struct csg_leaf_range){{-far, -far}, {far, far}};
    if (!met)
        return csg_leaf_nowhere;
    const struct csg_range range = {view->turns != 0 ? -far : keys[0],
                                    view->surface->open ? far : keys[1]};
    return (struct csg_leaf_range){range, range};
}

bool csg_range_has_quadric(const struct csg_leaf_ranges *ranges, int lane,
                           const struct csg_leaf_range *range)
{
    if (ranges->code < 0)
        return false;
    const struct csg_quadric_range quadric = quadric_in(ranges, lane);
    if (quadric.region != CSG_QUADRIC_BETWEEN || !quadric.always)
        return !(quadric.region == CSG_QUADRIC_OUTSIDE && quadric.never);
    return !(quadric.first.hi < range->entry.lo && quadric.second.lo > range->exit.hi);
}

void csg_range_filter_planes(const struct csg_terms *terms, const struct csg_leaf_terms *leaf,
                             const struct csg_leaf_range *range, const struct csg_tile_box *tile,
                             bool *planes)
{
    const uint32_t num = leaf->num_entries + leaf->num_exits;
    for (uint32_t i = 0; i < num; i++) {
        const struct csg_range key = csg_range_of_plane(csg_terms_texel(terms, leaf, i), tile);
        const bool is_entry = i < leaf->num_entries;
        planes[i] = is_entry ? key.hi >= range->entry.lo : key.lo <= range->exit.hi;
    }
}
