/* SPDX-License-Identifier: MIT */
#include "tile/bands.h"

#include <string.h>

#include "pack/record.h"

/* Rounding of the shader's conics, with room to spare: relative to their terms. */
#define FLOAT_MARGIN 4e-6

/* Where the rays of a tile pass a circle. */
enum side { OUTSIDE, INSIDE, EITHER };

/* A conic counted from the tile's middle. */
static void move_conic(const double from[6], const struct csg_tile_box *tile, double to[6])
{
    const double x = tile->center[0], y = tile->center[1];
    to[0] = from[0] + x * (from[1] + x * from[3] + y * from[4]) + y * (from[2] + y * from[5]);
    to[1] = from[1] + 2 * x * from[3] + y * from[4];
    to[2] = from[2] + x * from[4] + 2 * y * from[5];
    for (int i = 3; i < 6; i++)
        to[i] = from[i];
}

static enum side side_of(const struct csg_bands *bands, uint32_t circle,
                         const struct csg_tile_box *tile)
{
    double c[6];
    if (circle == 0)
        return OUTSIDE;
    move_conic(bands->circles.data[circle].conic, tile, c);
    const double x = tile->half[0], y = tile->half[1];
    const double reach = x * fabs(c[1]) + y * fabs(c[2]) + x * x * fabs(c[3]) + x * y * fabs(c[4]) +
                         y * y * fabs(c[5]);
    const double least = reach + FLOAT_MARGIN * (fabs(c[0]) + reach);
    return c[0] > least ? OUTSIDE : c[0] < -least ? INSIDE : EITHER;
}

static const struct csg_bands *bands_of(const struct csg_terms *terms)
{
    return &terms->bands;
}

static const double *quadric_of(const struct csg_terms *terms, const struct csg_band *band)
{
    return csg_terms_texel(terms, csg_terms_of(terms, band->leaf), 2);
}

/* Whether rays that pass outside of both its circles may meet the band between them. */
static bool may_bulge(const struct csg_band *band, const struct csg_quadric_range *quadric,
                      const double *texels, const struct csg_tile_box *tile)
{
    if (quadric->region != CSG_QUADRIC_BETWEEN || quadric->never)
        return false;
    if ((int)texels[3] & CSG_QUADRIC_STIFF)
        return true;
    /* The middle of the two crossings lies between the planes: differences of affine terms. */
    for (int i = 0; i < 2; i++) {
        const bool enters = i == 0 && !(band->code & CSG_BAND_WITHIN);
        const double sign = enters ? 1 : -1;
        double term[4] = {0};
        for (int j = 0; j < 3; j++)
            term[j] = sign * (texels[j] - band->planes[i][j]);
        if (csg_range_of_plane(term, tile).hi < 0)
            return false;
    }
    return true;
}

/* Whether rays of the tile may cross the band; keys: where. */
static bool may_meet(const struct csg_terms *terms, const struct csg_band *band,
                     const struct csg_tile_box *tile, struct csg_range *keys)
{
    const struct csg_bands *bands = bands_of(terms);
    const bool within = band->code & CSG_BAND_WITHIN;
    const enum side first = side_of(bands, band->circles[0], tile);
    const enum side second = side_of(bands, band->circles[1], tile);
    const enum side start = !within ? first : band->code & CSG_BAND_INSIDE ? INSIDE : OUTSIDE;
    const bool same = first == second && first == start && first != EITHER;
    *keys = csg_range_of_plane(band->planes[0], tile);
    if (band->flat)
        return first != second || first == EITHER;
    if (same && first == INSIDE)
        return false;
    const double *texels = quadric_of(terms, band);
    const struct csg_quadric_range quadric = csg_range_of_quadric(texels, tile);
    if (same && !may_bulge(band, &quadric, texels, tile))
        return false;
    const struct csg_range other = csg_range_of_plane(band->planes[1], tile);
    const double lo = within ? -(double)CSG_KEY_MAX : keys->lo;
    const double hi = within ? fmin(keys->hi, other.hi) : other.hi;
    const bool between = quadric.region == CSG_QUADRIC_BETWEEN;
    *keys = (struct csg_range){between ? fmax(lo, fmin(quadric.first.lo, hi)) : lo,
                               between ? fmin(hi, fmax(quadric.second.hi, lo)) : hi};
    return true;
}

bool csg_band_list_fill(struct csg_band_list *list, const struct csg_terms *terms)
{
    list->num = 0;
    if (!csg_array_reserve(list, bands_of(terms)->bands.num))
        return false;
    for (uint32_t i = 0; i < bands_of(terms)->bands.num; i++)
        list->data[list->num++] = i;
    return true;
}

bool csg_band_list_copy(const struct csg_band_list *list, struct csg_band_list *copy)
{
    if (!csg_array_reserve(copy, list->num))
        return false;
    if (list->num)
        memcpy(copy->data, list->data, list->num * sizeof *copy->data);
    copy->num = list->num;
    return true;
}

static void start_ranges(const struct csg_bands *bands, struct csg_leaf_range *ranges)
{
    const double far = (double)CSG_KEY_MAX;
    for (size_t i = 0; i < bands->starts.num; i++)
        ranges[i] = (struct csg_leaf_range){{far, far}, {-far, -far}};
}

/* Rays that meet nothing are inside all the way, or nowhere; rays that do, anywhere between. */
static void finish_ranges(const struct csg_bands *bands, struct csg_leaf_range *ranges)
{
    const double far = (double)CSG_KEY_MAX;
    for (size_t i = 0; i < bands->starts.num; i++) {
        const bool starts = bands->starts.data[i];
        struct csg_range range = {ranges[i].entry.lo, ranges[i].exit.hi};
        if (range.lo > range.hi && starts)
            ranges[i] = (struct csg_leaf_range){{-far, -far}, {far, far}};
        if (range.lo > range.hi)
            continue;
        range.lo = starts ? -far : range.lo;
        ranges[i] = (struct csg_leaf_range){range, range};
    }
}

void csg_band_list_narrow(struct csg_band_list *list, const struct csg_terms *terms,
                          const struct csg_tile_box *tile, struct csg_leaf_range *ranges)
{
    const struct csg_bands *bands = bands_of(terms);
    size_t num = 0;
    start_ranges(bands, ranges);
    for (size_t i = 0; i < list->num; i++) {
        const struct csg_band *band = &bands->bands.data[list->data[i]];
        struct csg_range keys;
        if (!may_meet(terms, band, tile, &keys))
            continue;
        struct csg_leaf_range *range = &ranges[band->stack];
        range->entry.lo = fmin(range->entry.lo, keys.lo);
        range->exit.hi = fmax(range->exit.hi, keys.hi);
        list->data[num++] = list->data[i];
    }
    list->num = num;
    finish_ranges(bands, ranges);
}

/* How many of them are of that stack. */
static size_t count_bands(const struct csg_band_list *list, const struct csg_terms *terms,
                          uint32_t stack)
{
    size_t num = 0;
    for (size_t i = 0; i < list->num; i++)
        num += bands_of(terms)->bands.data[list->data[i]].stack == stack;
    return num;
}

/* ---- records ------------------------------------------------------------------------------ */

/* Any factor above 0 will do: that which makes it about 1 over the tile. */
static void put_conic(const struct csg_bands *bands, uint32_t circle,
                      const struct csg_tile_box *tile, double to[6])
{
    double c[6];
    move_conic(bands->circles.data[circle].conic, tile, c);
    const double x = tile->half[0] + 1, y = tile->half[1] + 1;
    const double size = fabs(c[0]) + x * fabs(c[1]) + y * fabs(c[2]) + x * x * fabs(c[3]) +
                        x * y * fabs(c[4]) + y * y * fabs(c[5]);
    for (int i = 0; i < 6; i++)
        to[i] = size > 0 ? c[i] / size : 0;
}

static float *put_band(const struct csg_terms *terms, const struct csg_band *band,
                       const struct csg_tile_box *tile, float *to)
{
    const struct csg_bands *bands = bands_of(terms);
    to[0] = (float)band->code;
    to[1] = (float)csg_terms_of(terms, band->leaf)->attributes;
    to[2] = (float)band->face;
    to[3] = band->inner;
    to += 4;
    double conics[4 * CSG_BAND_CONICS];
    put_conic(bands, band->circles[0], tile, conics);
    put_conic(bands, band->circles[1], tile, conics + 6);
    for (int i = 0; i < CSG_BAND_CONICS; i++)
        to = csg_record_put_term(terms, conics + (size_t)4 * (size_t)i, to);
    to = csg_record_put_term(terms, band->planes[0], to);
    if (band->flat)
        return to;
    to = csg_record_put_term(terms, band->planes[1], to);
    for (int i = 0; i < (terms->stiff ? CSG_QUADRIC_TEXELS : 3); i++)
        to = csg_record_put_term(terms, quadric_of(terms, band) + (size_t)4 * (size_t)i, to);
    return to;
}

bool csg_band_list_put(const struct csg_band_list *list, struct csg_terms *terms,
                       const struct csg_step *step, const struct csg_tile_box *tile)
{
    const struct csg_bands *bands = bands_of(terms);
    const uint32_t stack = step->leaf - (uint32_t)terms->scene->num_leaves;
    const size_t num = count_bands(list, terms, stack);
    const size_t most = 1 + (size_t)2 * (CSG_BAND_CONICS + 2 + CSG_QUADRIC_TEXELS);
    float *header = csg_frame_add_texels(terms->frame, CSG_BAND_FIRST + num * most);
    size_t num_flat = 0;
    if (!header)
        return false;
    float *end = header + (size_t)4 * CSG_BAND_FIRST;
    for (size_t i = 0; i < 2 * list->num; i++) {
        const struct csg_band *band = &bands->bands.data[list->data[i % list->num]];
        if (band->stack != stack || band->flat != (i < list->num))
            continue;
        num_flat += band->flat;
        end = put_band(terms, band, tile, end);
    }
    header[0] = (float)((end - header) / 4 - 1);
    header[2] = (float)step->flags;
    float *place = header + 4 * CSG_BAND_PLACE, *start = header + 4 * CSG_BAND_START;
    place[0] = (float)tile->center[0];
    place[1] = (float)tile->center[1];
    start[0] = bands->starts.data[stack];
    start[1] = (float)(2 * num - num_flat);
    start[2] = (float)num_flat;
    start[3] = (float)num;
    terms->frame->texels.num = (size_t)(end - terms->frame->texels.data);
    return true;
}
