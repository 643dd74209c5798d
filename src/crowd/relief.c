/* SPDX-License-Identifier: MIT */
#include "crowd/relief.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "common/layout.glsl"

/* Looking at all of a square costs about as much as drawing so many pixels. */
enum { PIXELS_PER_LOOK = CSG_RELIEF_SQUARE * CSG_RELIEF_SQUARE / 2 };

static size_t squares_of(int pixels)
{
    return (size_t)((pixels + CSG_RELIEF_SQUARE - 1) / CSG_RELIEF_SQUARE);
}

bool csg_relief_init(struct csg_relief *relief, const struct csg_screen *screen,
                     struct csg_pixel at, enum csg_cast_side side)
{
    *relief = (struct csg_relief){.side = side,
                                  .at = {at.x, at.y},
                                  .width = screen->width,
                                  .height = screen->height,
                                  .stride = (size_t)screen->width + CSG_CAST_LANES,
                                  .num_squares_x = squares_of(screen->width),
                                  .num_squares_y = squares_of(screen->height)};
    const size_t num_keys = relief->stride * (size_t)relief->height;
    const size_t num_squares = relief->num_squares_x * relief->num_squares_y;
    relief->keys = malloc((num_keys + 1) * sizeof *relief->keys);
    relief->squares = malloc((num_squares + 1) * sizeof *relief->squares);
    return relief->keys && relief->squares;
}

void csg_relief_clear(const struct csg_relief *relief, const struct csg_relief *base, int begin,
                      int end)
{
    const size_t first = (size_t)begin * relief->stride, last = (size_t)end * relief->stride;
    const size_t first_square = (size_t)begin / CSG_RELIEF_SQUARE * relief->num_squares_x;
    const size_t last_square = squares_of(end) * relief->num_squares_x;
    const struct csg_square empty = {.far = CSG_KEY_MAX, .tilted_far = CSG_KEY_MAX};
    for (size_t i = first; i < last; i++)
        relief->keys[i] = base ? base->keys[i] : CSG_KEY_MAX;
    for (size_t i = first_square; i < last_square; i++)
        relief->squares[i] = base ? base->squares[i] : empty;
}

void csg_relief_finish(struct csg_relief *relief)
{
    free(relief->keys);
    free(relief->squares);
}

struct csg_cast_rect csg_relief_offsets(const struct csg_relief *relief,
                                        const struct csg_pixels *pixels)
{
    struct csg_cast_rect rect;
    for (int i = 0; i < 2; i++) {
        rect.lo[i] = (float)(pixels->lo[i] + 0.5 - relief->at[i]);
        rect.hi[i] = (float)(pixels->hi[i] + 0.5 - relief->at[i]);
    }
    return rect;
}

/* ---- squares ---- */

static int smaller(int a, int b)
{
    return a < b ? a : b;
}

static float *keys_at(const struct csg_relief *relief, int x, int y)
{
    return relief->keys + (size_t)y * relief->stride + (size_t)x;
}

/* Fewer are compared one by one sooner than by squares. */
enum { MIN_PIXELS = 8 * CSG_RELIEF_SQUARE * CSG_RELIEF_SQUARE };

/* The part of some pixels that lies in one square, and that square; of few pixels all, and NULL. */
struct part {
    struct csg_pixels pixels;
    struct csg_square *square;
};

static bool are_few(const struct csg_pixels *pixels)
{
    return (pixels->hi[0] - pixels->lo[0] + 1) * (pixels->hi[1] - pixels->lo[1] + 1) < MIN_PIXELS;
}

static bool start_square(const struct csg_relief *relief, const struct csg_pixels *all,
                         struct part *part)
{
    if (all->lo[0] > all->hi[0] || all->lo[1] > all->hi[1])
        return false;
    part->pixels = *all;
    part->pixels.hi[0] = all->lo[0] | (CSG_RELIEF_SQUARE - 1);
    part->pixels.hi[1] = all->lo[1] | (CSG_RELIEF_SQUARE - 1);
    for (int i = 0; i < 2; i++)
        part->pixels.hi[i] = smaller(part->pixels.hi[i], all->hi[i]);
    part->square = &relief->squares[(size_t)all->lo[1] / CSG_RELIEF_SQUARE * relief->num_squares_x +
                                    (size_t)all->lo[0] / CSG_RELIEF_SQUARE];
    return true;
}

/* The first part; then its successors from left to right, row by row. */
static bool start(const struct csg_relief *relief, const struct csg_pixels *all, struct part *part)
{
    if (!are_few(all))
        return start_square(relief, all, part);
    *part = (struct part){.pixels = *all};
    return all->lo[0] <= all->hi[0] && all->lo[1] <= all->hi[1];
}

static bool next(const struct csg_relief *relief, const struct csg_pixels *all, struct part *part)
{
    struct csg_pixels rest = *all;
    if (!part->square)
        return false;
    rest.lo[1] = part->pixels.lo[1];
    rest.lo[0] = part->pixels.hi[0] + 1;
    if (rest.lo[0] > all->hi[0]) {
        rest.lo[0] = all->lo[0];
        rest.lo[1] = part->pixels.hi[1] + 1;
    }
    return start_square(relief, &rest, part);
}

/* All of the square. */
static struct csg_pixels pixels_around(const struct csg_relief *relief,
                                       const struct csg_pixels *part)
{
    const int size[2] = {relief->width, relief->height};
    struct csg_pixels all;
    for (int i = 0; i < 2; i++) {
        all.lo[i] = part->lo[i] & ~(CSG_RELIEF_SQUARE - 1);
        all.hi[i] = smaller(all.lo[i] + CSG_RELIEF_SQUARE, size[i]) - 1;
    }
    return all;
}

/* Between the corners. */
static struct csg_tilt tilt_of(const struct csg_relief *relief, const struct csg_pixels *all)
{
    const float *low = keys_at(relief, 0, all->lo[1]), *high = keys_at(relief, 0, all->hi[1]);
    const int x0 = all->lo[0], x1 = all->hi[0];
    const struct csg_cast_rect rect = csg_relief_offsets(relief, all);
    const float width = rect.hi[0] - rect.lo[0] + 1, height = rect.hi[1] - rect.lo[1] + 1;
    return (struct csg_tilt){{0.5f * (low[x1] - low[x0] + high[x1] - high[x0]) / width,
                              0.5f * (high[x0] - low[x0] + high[x1] - low[x1]) / height},
                             {rect.lo[0], rect.lo[1]}};
}

/* Of keys less tilt; NULL: of the keys. */
static float farthest(const struct csg_relief *relief, const struct csg_pixels *all,
                      const struct csg_tilt *tilt)
{
    const float slope = tilt ? tilt->slope[0] : 0;
    const int width = all->hi[0] - all->lo[0] + 1;
    float far[CSG_RELIEF_SQUARE]; /* of columns, for the compiler to make vectors of */
    for (int x = 0; x < CSG_RELIEF_SQUARE; x++)
        far[x] = -CSG_KEY_MAX;
    for (int y = all->lo[1]; y <= all->hi[1]; y++) {
        const float *row = keys_at(relief, all->lo[0], y);
        const float base = tilt ? tilt->slope[1] * (float)(y - all->lo[1]) : 0;
        for (int x = 0; x < width; x++) {
            const float key = row[x] - (base + slope * (float)x);
            far[x] = key > far[x] ? key : far[x];
        }
    }
    for (int x = 1; x < width; x++)
        far[0] = far[x] > far[0] ? far[x] : far[0];
    return far[0];
}

static void look_at(const struct csg_relief *relief, const struct part *part)
{
    const struct csg_pixels all = pixels_around(relief, &part->pixels);
    struct csg_square square = {.far = farthest(relief, &all, NULL), .tilted_far = CSG_KEY_MAX};
    if (square.far < CSG_KEY_MAX) {
        square.tilt = tilt_of(relief, &all);
        square.tilted_far = farthest(relief, &all, &square.tilt);
    }
    *part->square = square;
}

static void note(const struct csg_relief *relief, const struct part *part)
{
    const struct csg_pixels *p = &part->pixels;
    if (!part->square)
        return;
    part->square->news += csg_count_pixels(p);
    if (part->square->news >= PIXELS_PER_LOOK)
        look_at(relief, part);
}

/* Small parts are compared pixel by pixel at no more cost. */
static bool is_hidden(const struct csg_relief *relief, const struct csg_cast *cast,
                      const struct part *part)
{
    const struct csg_pixels *p = &part->pixels;
    if (!part->square || p->hi[1] - p->lo[1] < 2 || part->square->far >= CSG_KEY_MAX)
        return false;
    const struct csg_tilt level = {{0, 0}, {0, 0}};
    const struct csg_cast_rect rect = csg_relief_offsets(relief, p);
    return csg_cast_near(cast, relief->side, &rect, &level) > part->square->far ||
           csg_cast_near(cast, relief->side, &rect, &part->square->tilt) > part->square->tilted_far;
}

/* ---- pixels, as many as there are lanes ---- */

static int lanes_left(const struct csg_pixels *pixels, int x)
{
    const int left = pixels->hi[0] - x + 1;
    return left < CSG_CAST_LANES ? left : CSG_CAST_LANES;
}

static bool any_behind(const struct csg_relief *relief, float key, const struct csg_pixels *pixels)
{
    for (int y = pixels->lo[1]; y <= pixels->hi[1]; y++)
        for (int x = pixels->lo[0]; x <= pixels->hi[0]; x += CSG_CAST_LANES)
            if (csg_cast_any_behind(key, lanes_left(pixels, x), keys_at(relief, x, y)))
                return true;
    return false;
}

bool csg_relief_may_show(const struct csg_relief *relief, float key,
                         const struct csg_pixels *pixels)
{
    struct part part;
    for (bool more = start(relief, pixels, &part); more; more = next(relief, pixels, &part))
        if ((!part.square || part.square->far >= key) && any_behind(relief, key, &part.pixels))
            return true;
    return false;
}

/* Whether anything is hidden now that was not. */
static bool draw_part(const struct csg_relief *relief, const struct csg_cast *cast,
                      const struct csg_pixels *pixels)
{
    bool changed = false;
    const struct csg_cast_rect rect = csg_relief_offsets(relief, pixels);
    for (int y = pixels->lo[1]; y <= pixels->hi[1]; y++)
        for (int x = pixels->lo[0]; x <= pixels->hi[0]; x += CSG_CAST_LANES)
            changed |= csg_cast_draw(cast, relief->side, rect.lo[0] + (float)(x - pixels->lo[0]),
                                     rect.lo[1] + (float)(y - pixels->lo[1]), lanes_left(pixels, x),
                                     keys_at(relief, x, y));
    return changed;
}

/* Whether it may show. */
static bool contend_part(const struct csg_relief *relief, const struct csg_cast *cast, uint32_t who,
                         const struct csg_pixels *pixels)
{
    bool shows = false;
    const struct csg_cast_rect rect = csg_relief_offsets(relief, pixels);
    for (int y = pixels->lo[1]; y <= pixels->hi[1]; y++)
        for (int x = pixels->lo[0]; x <= pixels->hi[0]; x += CSG_CAST_LANES)
            shows |= csg_owners_contend(relief->owners, cast, who, x, y,
                                        rect.lo[0] + (float)(x - pixels->lo[0]),
                                        rect.lo[1] + (float)(y - pixels->lo[1]),
                                        lanes_left(pixels, x), keys_at(relief, x, y));
    return shows;
}

static int lowest(unsigned set)
{
    int i = 0;
    while (!(set >> i & 1))
        i++;
    return i;
}

static int highest(unsigned set)
{
    int i = 0;
    while (set >> i > 1)
        i++;
    return i;
}

/* Widens shown by the pixels at which it may show, of all or of the contested ones. */
static void find_shown(const struct csg_relief *relief, const struct csg_cast *cast, bool contested,
                       const struct csg_pixels *pixels, struct csg_pixels *shown)
{
    const struct csg_cast_rect rect = csg_relief_offsets(relief, pixels);
    for (int y = pixels->lo[1]; y <= pixels->hi[1]; y++)
        for (int x = pixels->lo[0]; x <= pixels->hi[0]; x += CSG_CAST_LANES) {
            const int num = lanes_left(pixels, x);
            unsigned shows = contested ? csg_owners_contested(relief->owners, x, y, num) : ~0u;
            if (shows)
                shows &= csg_cast_shows(cast, relief->side, rect.lo[0] + (float)(x - pixels->lo[0]),
                                        rect.lo[1] + (float)(y - pixels->lo[1]), num,
                                        keys_at(relief, x, y));
            if (!shows)
                continue;
            const int lo = x + lowest(shows), hi = x + highest(shows);
            shown->lo[0] = lo < shown->lo[0] ? lo : shown->lo[0];
            shown->hi[0] = hi > shown->hi[0] ? hi : shown->hi[0];
            shown->lo[1] = y < shown->lo[1] ? y : shown->lo[1];
            shown->hi[1] = y > shown->hi[1] ? y : shown->hi[1];
        }
}

static const struct csg_pixels no_pixels = {{INT_MAX, INT_MAX}, {-1, -1}};

bool csg_relief_draw(struct csg_relief *relief, const struct csg_cast *cast, uint32_t who,
                     const struct csg_pixels *pixels)
{
    struct part part;
    bool shows = false;
    const bool contends = relief->owners && who != CSG_NOBODY;
    for (bool more = start(relief, pixels, &part); more; more = next(relief, pixels, &part)) {
        if (is_hidden(relief, cast, &part))
            continue;
        const bool changed = contends ? contend_part(relief, cast, who, &part.pixels)
                                      : draw_part(relief, cast, &part.pixels);
        if (changed) {
            note(relief, &part);
            shows = true;
        } else if (contends) {
            continue;
        } else if (!part.square) {
            shows = true; /* whether it does is found out once, by csg_relief_narrow */
        } else if (!shows) {
            struct csg_pixels shown = no_pixels;
            find_shown(relief, cast, false, &part.pixels, &shown);
            shows = shown.hi[1] >= 0;
        }
    }
    return shows;
}

bool csg_relief_narrow(const struct csg_relief *relief, const struct csg_cast *cast, bool contested,
                       struct csg_pixels *pixels)
{
    struct csg_pixels shown = no_pixels;
    struct part part;
    for (bool more = start(relief, pixels, &part); more; more = next(relief, pixels, &part))
        if (!is_hidden(relief, cast, &part))
            find_shown(relief, cast, contested, &part.pixels, &shown);
    *pixels = shown;
    return shown.hi[1] >= 0;
}
