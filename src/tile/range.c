/* SPDX-License-Identifier: MIT */
#include "tile/range.h"

const struct csg_leaf_range csg_leaf_nowhere = {
    {INFINITY, INFINITY}, {-INFINITY, -INFINITY}, false};

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

/* Range of u (slope + curve u) over a range of u. */
static inline struct csg_range parabola(struct csg_range u, double slope, double curve)
{
    const double a = u.lo * (slope + curve * u.lo), b = u.hi * (slope + curve * u.hi);
    struct csg_range range = {csg_smaller(a, b), csg_larger(a, b)};
    const double rise = slope + 2 * curve * u.lo, fall = slope + 2 * curve * u.hi;
    if ((rise > 0) != (fall > 0)) {
        const double top = -0.5 * slope / curve, extreme = top * (slope + curve * top);
        range.lo = csg_smaller(range.lo, extreme);
        range.hi = csg_larger(range.hi, extreme);
    }
    return range;
}

/* The conic h, or S where the quadric is stiff; texels as shaders/solids/quadric.glsl reads them.
 */
static struct csg_range conic(const double *t, int code, const struct csg_tile_box *tile)
{
    const double x1 = t[5], y1 = t[6];
    const struct csg_range x = csg_range_of_affine(t[4], x1, y1, tile);
    const struct csg_range y = csg_range_of_affine(t[8], -y1, x1, tile);
    const double curve = code & CSG_QUADRIC_X_MINUS ? -1 : code & CSG_QUADRIC_X_PLUS ? 1 : 0;
    const struct csg_range xx = parabola(x, t[9], curve);
    const struct csg_range yy = parabola(y, t[10], t[11]);
    const double c0 = t[7];
    const double margin = CSG_FLOAT_MARGIN * (fabs(c0) + csg_larger(fabs(xx.lo), fabs(xx.hi)) +
                                              csg_larger(fabs(yy.lo), fabs(yy.hi)));
    return (struct csg_range){c0 + xx.lo + yy.lo - margin, c0 + xx.hi + yy.hi + margin};
}

/* The crossings where the conic has that range. */
static struct csg_quadric_range crossings(const double *texels, struct csg_range h,
                                          const struct csg_tile_box *tile)
{
    const int code = (int)texels[3];
    const double most = sqrt(csg_larger(h.hi, 0)), least = sqrt(csg_larger(h.lo, 0));
    struct csg_quadric_range range = {.never = h.hi<0, .always = h.lo> 0, .region = code & 3};
    if (code & CSG_QUADRIC_STIFF) {
        range.first = range.second = (struct csg_range){-(double)CSG_KEY_MAX, (double)CSG_KEY_MAX};
        range.always = false;
        return range;
    }
    const struct csg_range m = csg_range_of_affine(texels[0], texels[1], texels[2], tile);
    const double margin = CSG_FLOAT_MARGIN * (fabs(m.lo) + fabs(m.hi) + most);
    range.first = (struct csg_range){m.lo - most - margin, m.hi - least + margin};
    range.second = (struct csg_range){m.lo + least - margin, m.hi + most + margin};
    return range;
}

struct csg_quadric_range csg_range_of_quadric(const double *texels, const struct csg_tile_box *tile)
{
    return crossings(texels, conic(texels, (int)texels[3], tile), tile);
}

static void later(struct csg_range *a, struct csg_range b)
{
    a->lo = csg_larger(a->lo, b.lo);
    a->hi = csg_larger(a->hi, b.hi);
}

static void sooner(struct csg_range *a, struct csg_range b)
{
    a->lo = csg_smaller(a->lo, b.lo);
    a->hi = csg_smaller(a->hi, b.hi);
}

/* Narrows the leaf by its quadric, which rays of the tile may be inside of. */
static void clip_quadric(struct csg_leaf_range *range, const struct csg_quadric_range *quadric)
{
    switch (quadric->region) {
    case CSG_QUADRIC_BETWEEN:
        later(&range->entry, quadric->first);
        sooner(&range->exit, quadric->second);
        range->solid &= quadric->always;
        break;
    case CSG_QUADRIC_BEFORE:
        sooner(&range->exit, quadric->first);
        break;
    case CSG_QUADRIC_AFTER:
        later(&range->entry, quadric->second);
        break;
    default:
        range->solid &= quadric->never;
    }
}

static bool matters(const struct csg_leaf_range *range, const struct csg_quadric_range *quadric)
{
    if (quadric->region != CSG_QUADRIC_BETWEEN || !quadric->always)
        return !(quadric->region == CSG_QUADRIC_OUTSIDE && quadric->never);
    return !(quadric->first.hi < range->entry.lo && quadric->second.lo > range->exit.hi);
}

/* Open surfaces may have no end. */
static struct csg_leaf_range surface_range(const struct csg_surface_view *view,
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
        return (struct csg_leaf_range){{-far, -far}, {far, far}, true};
    if (!met)
        return csg_leaf_nowhere;
    const struct csg_range range = {view->turns != 0 ? -far : keys[0],
                                    view->surface->open ? far : keys[1]};
    return (struct csg_leaf_range){range, range, false};
}

static struct csg_leaf_range flat_range(const struct csg_terms *terms,
                                        const struct csg_leaf_terms *leaf,
                                        const struct csg_tile_box *tile)
{
    const double far = (double)CSG_KEY_MAX;
    struct csg_leaf_range range = {{-far, -far}, {far, far}, true};
    const double *texel = csg_terms_texel(terms, leaf, 0);
    for (uint32_t i = 0; i < leaf->num_entries; i++, texel += 4)
        later(&range.entry, csg_range_of_plane(texel, tile));
    for (uint32_t i = 0; i < leaf->num_exits; i++, texel += 4)
        sooner(&range.exit, csg_range_of_plane(texel, tile));
    range.solid = range.entry.hi < range.exit.lo;
    return range;
}

struct csg_leaf_range csg_range_of_leaf(const struct csg_terms *terms,
                                        const struct csg_leaf_terms *leaf,
                                        const struct csg_tile_box *tile)
{
    if (leaf->flags & CSG_RECORD_SURFACE)
        return surface_range(&terms->views.data[leaf->view], tile);
    if (!(leaf->flags & CSG_RECORD_QUADRIC))
        return flat_range(terms, leaf, tile);
    const double *texels = csg_terms_texel(terms, leaf, leaf->num_entries + leaf->num_exits);
    const int code = (int)texels[3];
    const struct csg_range h = conic(texels, code, tile);
    if (h.hi < 0 && (code & 3) == CSG_QUADRIC_BETWEEN)
        return csg_leaf_nowhere;
    const struct csg_quadric_range curved = crossings(texels, h, tile);
    struct csg_leaf_range range = flat_range(terms, leaf, tile);
    clip_quadric(&range, &curved);
    range.solid &= range.entry.hi < range.exit.lo;
    return range;
}

bool csg_range_filter(const struct csg_terms *terms, const struct csg_leaf_terms *leaf,
                      const struct csg_leaf_range *range, const struct csg_tile_box *tile,
                      bool *planes)
{
    const uint32_t num = leaf->num_entries + leaf->num_exits;
    for (uint32_t i = 0; i < num; i++) {
        const struct csg_range key = csg_range_of_plane(csg_terms_texel(terms, leaf, i), tile);
        const bool is_entry = i < leaf->num_entries;
        planes[i] = is_entry ? key.hi >= range->entry.lo : key.lo <= range->exit.hi;
    }
    if (!(leaf->flags & CSG_RECORD_QUADRIC))
        return false;
    const struct csg_quadric_range curved =
        csg_range_of_quadric(csg_terms_texel(terms, leaf, num), tile);
    return matters(range, &curved);
}
