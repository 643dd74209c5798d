/* SPDX-License-Identifier: MIT */
#include "tile/range.h"

/* Float rounding of the shader's evaluation, with room to spare: relative to its terms. */
#define FLOAT_MARGIN 1e-6

static struct csg_range affine(double c0, double cx, double cy, const struct csg_tile_box *tile)
{
    const double mid = c0 + cx * tile->center[0] + cy * tile->center[1];
    const double size = fabs(c0) + fabs(cx * tile->center[0]) + fabs(cy * tile->center[1]);
    const double spread = fabs(cx) * tile->half[0] + fabs(cy) * tile->half[1];
    const double reach = spread + FLOAT_MARGIN * (size + spread);
    return (struct csg_range){mid - reach, mid + reach};
}

struct csg_range csg_range_of_plane(const double texel[4], const struct csg_tile_box *tile)
{
    return affine(texel[0], texel[1], texel[2], tile);
}

/* Range of u (slope + curve u) over a range of u. */
static struct csg_range parabola(struct csg_range u, double slope, double curve)
{
    const double a = u.lo * (slope + curve * u.lo), b = u.hi * (slope + curve * u.hi);
    struct csg_range range = {csg_smaller(a, b), csg_larger(a, b)};
    const double top = curve != 0 ? -0.5 * slope / curve : u.lo;
    if (top > u.lo && top < u.hi) {
        const double extreme = top * (slope + curve * top);
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
    const struct csg_range x = affine(t[4], x1, y1, tile);
    const struct csg_range y = affine(t[8], -y1, x1, tile);
    const double curve = code & CSG_QUADRIC_X_MINUS ? -1 : code & CSG_QUADRIC_X_PLUS ? 1 : 0;
    const struct csg_range xx = parabola(x, t[9], curve);
    const struct csg_range yy = parabola(y, t[10], t[11]);
    const double c0 = t[7];
    const double margin = FLOAT_MARGIN * (fabs(c0) + csg_larger(fabs(xx.lo), fabs(xx.hi)) +
                                          csg_larger(fabs(yy.lo), fabs(yy.hi)));
    return (struct csg_range){c0 + xx.lo + yy.lo - margin, c0 + xx.hi + yy.hi + margin};
}

struct csg_quadric_range csg_range_of_quadric(const double *texels,
                                             const struct csg_tile_box *tile)
{
    const int code = (int)texels[3];
    const struct csg_range h = conic(texels, code, tile);
    const double most = sqrt(csg_larger(h.hi, 0)), least = sqrt(csg_larger(h.lo, 0));
    struct csg_quadric_range range = {.never = h.hi<0, .always = h.lo> 0, .region = code & 3};
    if (code & CSG_QUADRIC_STIFF) {
        range.first = range.second = (struct csg_range){-(double)CSG_KEY_MAX, (double)CSG_KEY_MAX};
        range.always = false;
        return range;
    }
    const struct csg_range m = affine(texels[0], texels[1], texels[2], tile);
    const double margin = FLOAT_MARGIN * (fabs(m.lo) + fabs(m.hi) + most);
    range.first = (struct csg_range){m.lo - most - margin, m.hi - least + margin};
    range.second = (struct csg_range){m.lo + least - margin, m.hi + most + margin};
    return range;
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

/* Narrows the leaf by its quadric; false where no ray of the tile is inside. */
static bool clip_quadric(struct csg_leaf_range *range, const struct csg_quadric_range *quadric)
{
    switch (quadric->region) {
    case CSG_QUADRIC_BETWEEN:
        later(&range->entry, quadric->first);
        sooner(&range->exit, quadric->second);
        range->solid &= quadric->always;
        return !quadric->never;
    case CSG_QUADRIC_BEFORE:
        sooner(&range->exit, quadric->first);
        return true;
    case CSG_QUADRIC_AFTER:
        later(&range->entry, quadric->second);
        return true;
    default:
        range->solid &= quadric->never;
        return true;
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
        return (struct csg_leaf_range){{far, far}, {-far, -far}, false};
    const struct csg_range range = {view->turns != 0 ? -far : keys[0],
                                    view->surface->open ? far : keys[1]};
    return (struct csg_leaf_range){range, range, false};
}

struct csg_leaf_range csg_range_of_leaf(const struct csg_terms *terms,
                                        const struct csg_leaf_terms *leaf,
                                        const struct csg_tile_box *tile, bool *planes,
                                        bool *quadric)
{
    const struct csg_range all = {-(double)CSG_KEY_MAX, -(double)CSG_KEY_MAX};
    const struct csg_range end = {(double)CSG_KEY_MAX, (double)CSG_KEY_MAX};
    struct csg_leaf_range range = {all, end, true};
    if (leaf->flags & CSG_RECORD_SURFACE)
        return surface_range(&terms->views.data[leaf->view], tile);
    const uint32_t num = leaf->num_entries + leaf->num_exits;
    for (uint32_t i = 0; i < num; i++) {
        const struct csg_range key = csg_range_of_plane(csg_terms_texel(terms, leaf, i), tile);
        if (i < leaf->num_entries)
            later(&range.entry, key);
        else
            sooner(&range.exit, key);
    }
    struct csg_quadric_range curved = {.region = CSG_QUADRIC_BETWEEN};
    const struct csg_leaf_range flat = range;
    if (leaf->flags & CSG_RECORD_QUADRIC) {
        curved = csg_range_of_quadric(csg_terms_texel(terms, leaf, num), tile);
        if (!clip_quadric(&range, &curved))
            range.exit.hi = -INFINITY;
    }
    range.solid &= range.entry.hi < range.exit.lo;
    if (!planes)
        return range;
    for (uint32_t i = 0; i < num; i++) {
        const struct csg_range key = csg_range_of_plane(csg_terms_texel(terms, leaf, i), tile);
        planes[i] = i < leaf->num_entries ? key.hi >= range.entry.lo : key.lo <= range.exit.hi;
    }
    *quadric = leaf->flags & CSG_RECORD_QUADRIC && matters(&flat, &curved);
    return range;
}
