/* SPDX-License-Identifier: MIT */
#include "crowd/sift.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "common/parallel.h"
#include "common/prefetch.h"
#include "crowd/occlusion.h"
#include "crowd/project.h"
#include "crowd/strips.h"
#include "crowd/tree_cast.h"
#include "csg/membership.h"

/* Fewer objects are drawn sooner than compared. */
enum { MIN_SIFTED = 256 };

/* Objects a task looks at. */
enum { CHUNK = 1024 };

/* So many objects' memory is on its way, and twice as many trees'. */
enum { PREFETCHED = 6 };

/* Where they cover fewer pixels on average than so many times those of the rectangle around all,
 * hardly any hides another. */
#define MIN_LAYERS 1.5

/* Larger ones are cut into tiles, and not cast here as well. */
enum { MAX_CAST_PIXELS = 1024 };

/* What a listed object is. GONE: shows nowhere. PLAIN: may be hidden, and SOLID: may hide others as
 * well. KEPT: drawn, whatever hides it. */
enum { GONE, PLAIN, SOLID, KEPT };

/* A listed object: see above, the pixels that its box covers, and a key before all of it. */
struct sifted {
    int16_t lo[2], hi[2];
    float key;
    uint8_t state;
    atomic_bool shows; /* in some strip */
};

/* What is to be known of so many of them: their keys, how many pixels they cover together, and the
 * rectangle around these. */
struct chunk {
    float lo, hi;
    size_t num_pixels;
    struct csg_pixels pixels;
};

struct sift {
    struct csg_frame *frame;
    const struct csgcast_scene *scene;
    const struct csg_relief *base;
    struct csg_camera camera;
    struct csg_relief relief;
    struct sifted *sifted; /* one a listed object */
    size_t num, num_chunks;
    struct chunk *chunks;
    bool casts; /* objects hide each other; else only the base hides them */
    struct csg_key_bins bins;
    uint32_t *ordered;                /* of each strip its objects, roughly the nearest first */
    size_t begin[CSG_NUM_STRIPS + 1]; /* of a strip in them */
};

static const struct csg_object *object_of(const struct sift *sift, size_t i)
{
    return &sift->scene->objects->data[sift->frame->listed.data[i]];
}

/* ---- where they are ----------------------------------------------------------------------- */

static bool is_wanted(const struct sifted *sifted)
{
    return sifted->state == PLAIN || sifted->state == SOLID;
}

static void look_at(const struct sift *sift, uint32_t index, struct sifted *out)
{
    const struct csg_object *object = &sift->scene->objects->data[index];
    const struct csg_screen *screen = &sift->frame->screen;
    const struct csg_box *box = &object->box;
    const struct csg_vec3 half = csg_scale(0.5, csg_sub(box->hi, box->lo));
    const double axes[9] = {half.x, 0, 0, 0, half.y, 0, 0, 0, half.z};
    const uint8_t cover = sift->scene->crowd->covers[index];
    struct csg_footprint print;
    double depth[2];
    out->state = KEPT;
    csg_depth_range(screen, box, depth);
    if (cover == CSG_COVER_GLASS || !csg_box_is_finite(box) ||
        (!screen->orthographic && !(depth[0] > 2 * screen->near)))
        return;
    const struct csg_seen_ball ball =
        csg_camera_see(&sift->camera, csg_box_middle(box), csg_length(half));
    out->state = GONE;
    if (!csg_outline_project(&sift->camera, CSG_OUTLINE_BOX, axes, &ball, &print))
        return;
    out->state = cover == CSG_COVER_HIDES ? SOLID : PLAIN;
    out->key = csg_occlusion_near(screen, depth[0]);
    memcpy(out->lo, print.lo, sizeof out->lo);
    memcpy(out->hi, print.hi, sizeof out->hi);
}

static void add_chunk(struct chunk *into, const struct chunk *chunk)
{
    into->lo = fminf(into->lo, chunk->lo);
    into->hi = fmaxf(into->hi, chunk->hi);
    into->num_pixels += chunk->num_pixels;
    for (int i = 0; i < 2; i++) {
        const int lo = chunk->pixels.lo[i], hi = chunk->pixels.hi[i];
        into->pixels.lo[i] = lo < into->pixels.lo[i] ? lo : into->pixels.lo[i];
        into->pixels.hi[i] = hi > into->pixels.hi[i] ? hi : into->pixels.hi[i];
    }
}

static const struct chunk no_chunk = {INFINITY, -INFINITY, 0, {{INT_MAX, INT_MAX}, {-1, -1}}};

static struct csg_pixels pixels_of(const struct sifted *sifted)
{
    return (struct csg_pixels){{sifted->lo[0], sifted->lo[1]}, {sifted->hi[0], sifted->hi[1]}};
}

static void look_at_chunk(void *user, size_t task)
{
    struct sift *sift = user;
    struct chunk all = no_chunk;
    for (size_t i = CHUNK * task; i < CHUNK * (task + 1) && i < sift->num; i++) {
        struct sifted *out = &sift->sifted[i];
        look_at(sift, sift->frame->listed.data[i], out);
        atomic_init(&out->shows, out->state == KEPT);
        if (!is_wanted(out))
            continue;
        struct chunk one = {out->key, out->key, 0, pixels_of(out)};
        one.num_pixels = csg_count_pixels(&one.pixels);
        add_chunk(&all, &one);
    }
    sift->chunks[task] = all;
}

/* Whether there is enough of them in the picture for many to be hidden. */
static bool find_range(struct sift *sift)
{
    struct chunk all = no_chunk;
    for (size_t i = 0; i < sift->num_chunks; i++)
        add_chunk(&all, &sift->chunks[i]);
    sift->bins = csg_key_bins(all.lo, all.hi);
    return all.num_pixels > 0 &&
           (double)all.num_pixels > MIN_LAYERS * (double)csg_count_pixels(&all.pixels);
}

/* ---- in which order ----------------------------------------------------------------------- */

/* From counts to places; returns their sum. */
static size_t add_up(size_t *counts, size_t num)
{
    size_t sum = 0;
    for (size_t i = 0; i < num; i++) {
        const size_t count = counts[i];
        counts[i] = sum;
        sum += count;
    }
    return sum;
}

static void sort_by_key(const struct sift *sift, uint32_t *sorted)
{
    size_t next[CSG_NUM_KEY_BINS] = {0};
    for (size_t i = 0; i < sift->num; i++)
        if (is_wanted(&sift->sifted[i]))
            next[csg_key_bin(&sift->bins, sift->sifted[i].key)]++;
    add_up(next, CSG_NUM_KEY_BINS);
    for (size_t i = 0; i < sift->num; i++)
        if (is_wanted(&sift->sifted[i]))
            sorted[next[csg_key_bin(&sift->bins, sift->sifted[i].key)]++] = (uint32_t)i;
}

/* How many there are, and in each strip. */
static size_t count_wanted(struct sift *sift, const uint8_t *strip_of)
{
    size_t num = 0;
    for (size_t i = 0; i < sift->num; i++) {
        const struct sifted *sifted = &sift->sifted[i];
        if (!is_wanted(sifted))
            continue;
        num++;
        for (int strip = strip_of[sifted->lo[1]]; strip <= strip_of[sifted->hi[1]]; strip++)
            sift->begin[strip]++;
    }
    return num;
}

static bool order(struct sift *sift)
{
    uint8_t *strip_of = csg_strips_of_rows(sift->relief.height);
    uint32_t *sorted = malloc((sift->num + 1) * sizeof *sorted);
    if (strip_of && sorted) {
        sort_by_key(sift, sorted);
        const size_t num = count_wanted(sift, strip_of);
        size_t next[CSG_NUM_STRIPS];
        sift->begin[CSG_NUM_STRIPS] = add_up(sift->begin, CSG_NUM_STRIPS);
        memcpy(next, sift->begin, sizeof next);
        sift->ordered = malloc((sift->begin[CSG_NUM_STRIPS] + 1) * sizeof *sift->ordered);
        for (size_t i = 0; i < num && sift->ordered; i++) {
            const struct sifted *sifted = &sift->sifted[sorted[i]];
            for (int strip = strip_of[sifted->lo[1]]; strip <= strip_of[sifted->hi[1]]; strip++)
                sift->ordered[next[strip]++] = sorted[i];
        }
    }
    free(strip_of);
    free(sorted);
    return sift->ordered != NULL;
}

/* ---- what hides them ---------------------------------------------------------------------- */

/* Whether the object may show at any of the pixels; notes what it hides there. */
static bool draw(const struct csg_relief *relief, const struct csg_tree_cast *tree,
                 const struct csg_pixels *pixels)
{
    bool shows = false;
    for (int y = pixels->lo[1]; y <= pixels->hi[1]; y++)
        for (int x = pixels->lo[0]; x <= pixels->hi[0]; x += CSG_CAST_LANES) {
            const int left = pixels->hi[0] - x + 1;
            shows |= csg_tree_cast_draw(tree, (float)(x + 0.5 - relief->at[0]),
                                        (float)(y + 0.5 - relief->at[1]),
                                        left < CSG_CAST_LANES ? left : CSG_CAST_LANES,
                                        relief->keys + (size_t)y * relief->stride + (size_t)x);
        }
    return shows;
}

/* The part of an object in a strip. Whether it may show there. */
static bool draw_object(const struct sift *sift, size_t i, const struct csg_pixels *pixels)
{
    const struct sifted *sifted = &sift->sifted[i];
    const struct csg_cast_rect rect = csg_relief_offsets(&sift->relief, pixels);
    struct csg_tree_cast tree;
    if (!csg_relief_may_show(&sift->relief, sifted->key, pixels))
        return false;
    const struct csg_pixels all = pixels_of(sifted);
    if (!sift->casts || sifted->state != SOLID || csg_count_pixels(&all) > MAX_CAST_PIXELS)
        return true;
    const double noise = csg_occlusion_noise(&sift->frame->screen, (double)sifted->key);
    return !csg_tree_cast_init(&tree, sift->frame, sift->scene, object_of(sift, i), &rect,
                               (float)noise) ||
           draw(&sift->relief, &tree, pixels);
}

/* Objects in the order of their keys lie all over memory. */
static void fetch_soon(const struct sift *sift, size_t i, size_t end)
{
    const struct csgcast_scene *scene = sift->scene;
    const struct csg_node *nodes = scene->trees[CSG_LAYER_MODEL].data;
    if (i + 2 * PREFETCHED < end)
        csg_prefetch(&nodes[object_of(sift, sift->ordered[i + 2 * PREFETCHED])->begin]);
    if (i + PREFETCHED >= end)
        return;
    const struct csg_object *object = object_of(sift, sift->ordered[i + PREFETCHED]);
    for (uint32_t j = object->begin; j < object->end && j < object->begin + 3; j++) {
        const uint32_t leaf = nodes[j].leaf;
        if (nodes[j].op != CSG_LEAF)
            continue;
        csg_prefetch(&scene->carriers->face_begin[leaf]);
        csg_prefetch(&scene->carriers->quadric_faces[leaf]);
        csg_prefetch(&scene->leaves[leaf].shape.quadric);
    }
}

static void draw_strip(void *user, size_t strip)
{
    struct sift *sift = user;
    const int begin = csg_strip_begin(sift->relief.height, strip),
              end = csg_strip_begin(sift->relief.height, strip + 1);
    csg_relief_clear(&sift->relief, sift->base, begin, end);
    for (size_t i = sift->begin[strip]; i < sift->begin[strip + 1]; i++) {
        struct sifted *sifted = &sift->sifted[sift->ordered[i]];
        fetch_soon(sift, i, sift->begin[strip + 1]);
        const struct csg_pixels pixels = {
            {sifted->lo[0], sifted->lo[1] > begin ? sifted->lo[1] : begin},
            {sifted->hi[0], sifted->hi[1] < end ? sifted->hi[1] : end - 1}};
        if (draw_object(sift, sift->ordered[i], &pixels))
            atomic_store_explicit(&sifted->shows, true, memory_order_relaxed);
    }
}

/* ---- all ---------------------------------------------------------------------------------- */

/* From within an object what shows is another matter. */
static bool is_inside_of_any(const struct sift *sift)
{
    const struct csg_screen *screen = &sift->frame->screen;
    for (size_t i = 0; i < sift->num; i++)
        if (sift->sifted[i].state == KEPT && object_of(sift, i)->layer == CSG_LAYER_MODEL &&
            csg_screen_eye_is_in(screen, &object_of(sift, i)->box) &&
            csg_object_is_near(sift->scene, object_of(sift, i), screen->origin, screen->near))
            return true;
    return false;
}

static void hide(struct sift *sift)
{
    csg_parallel(sift->frame->num_threads, CSG_NUM_STRIPS, draw_strip, sift);
    for (size_t i = 0; i < sift->num; i++)
        sift->sifted[i].state = sift->sifted[i].shows ? sift->sifted[i].state : GONE;
}

static void take_gone(struct sift *sift)
{
    uint32_t *listed = sift->frame->listed.data;
    size_t num = 0;
    for (size_t i = 0; i < sift->num; i++)
        if (sift->sifted[i].state != GONE)
            listed[num++] = listed[i];
    sift->frame->listed.num = num;
}

static bool run(struct sift *sift)
{
    const struct csg_frame *frame = sift->frame;
    csg_parallel(frame->num_threads, sift->num_chunks, look_at_chunk, sift);
    if (is_inside_of_any(sift))
        return true;
    sift->casts = find_range(sift);
    if (sift->casts || sift->base) {
        if (!csg_relief_init(&sift->relief, &frame->screen, frame->at, CSG_CAST_FRONT) ||
            !order(sift))
            return false;
        hide(sift);
    }
    take_gone(sift);
    return true;
}

bool csg_sift(struct csg_frame *frame, const struct csgcast_scene *scene,
              const struct csg_relief *base)
{
    struct sift sift = {.frame = frame,
                        .scene = scene,
                        .base = base,
                        .num = frame->listed.num,
                        .num_chunks = (frame->listed.num + CHUNK - 1) / CHUNK,
                        .camera = csg_camera_of(&frame->screen)};
    if (sift.num < MIN_SIFTED)
        return true;
    sift.sifted = malloc(sift.num * sizeof *sift.sifted);
    sift.chunks = malloc(sift.num_chunks * sizeof *sift.chunks);
    const bool ok = sift.sifted && sift.chunks && run(&sift);
    csg_relief_finish(&sift.relief);
    free(sift.sifted);
    free(sift.ordered);
    free(sift.chunks);
    return ok;
}
