/* SPDX-License-Identifier: MIT */
#include "pack/bands.h"

#include <stdlib.h>

#include "pack/terms.h"

/* Of a plane that moves by all that the stack is deep, or more, within so many pixels, pixels can
 * not tell where in it rays meet it. */
#define STEEP_PIXELS 1e-4

/* Share of the largest key by which pixels' centres lie beside such a plane, at least: more than
 * the rounding of float. */
#define BESIDE_STEEP 1e-5

/* Where a frustum ends, a circle about the axis. */
struct rim {
    double z, r;
    uint32_t level; /* those on one plane have one */
    uint32_t ring;
    bool inner, above; /* of which frustum, and whether that lies above */
};

struct builder {
    struct csg_bands *bands;
    const struct csg_terms *terms;
    const struct csg_stacks *stacks;
    uint32_t stack;
    double keys[2]; /* between which the stack's rings are */
    CSG_ARRAY(struct rim) rims;
    CSG_ARRAY(uint32_t) circles; /* four a ring: outer low and high, inner low and high */
};

static const struct csg_shape *shape_of(const struct builder *builder, uint32_t leaf)
{
    return &builder->terms->scene->leaves[leaf].shape;
}

static const struct csg_ring *ring_of(const struct builder *builder, uint32_t ring)
{
    return &builder->stacks->rings
                .data[builder->stacks->list.data[builder->stack].first_ring + ring];
}

static uint32_t leaf_of(const struct builder *builder, const struct rim *rim)
{
    const struct csg_ring *ring = ring_of(builder, rim->ring);
    return rim->inner ? ring->inner : ring->outer;
}

/* ---- circles ------------------------------------------------------------------------------ */

static int compare_heights(const void *a, const void *b)
{
    const struct rim *x = a, *y = b;
    return x->z < y->z ? -1 : x->z > y->z;
}

static int compare_rims(const void *a, const void *b)
{
    const struct rim *x = a, *y = b;
    if (x->level != y->level)
        return x->level < y->level ? -1 : 1;
    if (x->r != y->r)
        return x->r < y->r ? -1 : 1;
    return x->ring < y->ring ? -1 : x->ring > y->ring;
}

static bool add_rims(struct builder *builder, uint32_t ring, uint32_t leaf, bool inner)
{
    if (leaf == CSG_NO_LEAF)
        return true;
    const struct csg_shape *shape = shape_of(builder, leaf);
    const struct rim low = {shape->bounds.lo.z, shape->radii[0], 0, ring, inner, true};
    const struct rim high = {shape->bounds.hi.z, shape->radii[1], 0, ring, inner, false};
    return csg_array_push(&builder->rims, low) && csg_array_push(&builder->rims, high);
}

static uint32_t plane_carrier(const struct builder *builder, uint32_t leaf, bool low)
{
    const struct csg_carriers *carriers = builder->terms->scene->carriers;
    return carriers->faces[carriers->face_begin[leaf] + (low ? 0 : 1)].carrier;
}

/* Between planes that coincide there is nothing. */
static bool is_flat(const struct builder *builder, const struct csg_ring *ring)
{
    return plane_carrier(builder, ring->outer, true) == plane_carrier(builder, ring->outer, false);
}

static void sort_rims(struct builder *builder)
{
    struct rim *rims = builder->rims.data;
    qsort(rims, builder->rims.num, sizeof *rims, compare_heights);
    for (size_t i = 1; i < builder->rims.num; i++) {
        const struct rim *a = &rims[i - 1], *b = &rims[i];
        const bool same = a->z == b->z || plane_carrier(builder, leaf_of(builder, a), a->above) ==
                                              plane_carrier(builder, leaf_of(builder, b), b->above);
        rims[i].level = rims[i - 1].level + !same;
    }
    qsort(rims, builder->rims.num, sizeof *rims, compare_rims);
}

/* The plane in which a frustum ends, as a texel of the record, and the face that lies in it. */
static const double *plane_of(const struct builder *builder, uint32_t leaf, bool low, uint8_t *face)
{
    const struct csg_leaf_terms *terms = csg_terms_of(builder->terms, leaf);
    const int number = CSG_NORMAL_TERMS + (low ? 0 : 1);
    const double *first = csg_terms_texel(builder->terms, terms, 0);
    *face = (uint8_t)number;
    return (int)fabs(first[3]) == number + 1 ? first : first + 4;
}

/* Of the frusta that end in a circle a cylinder is the one that other solids fit into. */
static bool is_cylinder(const struct builder *builder, const struct rim *rim)
{
    return shape_of(builder, leaf_of(builder, rim))->quadric.diag[2] == 0;
}

/*
 * A plane along which rays run: where they meet it is beyond all that is in view, before or behind,
 * by the side of it that they are on. The shader must not find it in between where a pixel's centre
 * is in the plane.
 */
static bool is_steep(const struct builder *builder, const double plane[4])
{
    const struct csg_screen *screen = &builder->terms->frame->screen;
    const double span = fabs(builder->keys[1] - builder->keys[0]);
    return fabs(plane[1]) + fabs(plane[2]) > span / STEEP_PIXELS ||
           fabs(plane[0]) + fabs(plane[1]) * screen->width + fabs(plane[2]) * screen->height >
               0.5 * CSG_PLANE_KEY_MAX;
}

static void put_plane(const struct builder *builder, const double from[4], double to[4])
{
    const struct csg_screen *screen = &builder->terms->frame->screen;
    const double size =
        fabs(from[0]) + fabs(from[1]) * screen->width + fabs(from[2]) * screen->height;
    /* What is right before the eye is not before the point where rays start. */
    const double start = screen->near > 0 ? fabs(csg_screen_key(screen, screen->near)) : 0;
    const bool steep = is_steep(builder, from) && size > start;
    for (int i = 0; i < 3; i++)
        to[i] = steep ? from[i] * (CSG_PLANE_KEY_MAX / size) : from[i];
    to[0] += steep ? BESIDE_STEEP * CSG_PLANE_KEY_MAX : 0;
    to[3] = from[3];
}

/* Rays along the circle's plane pass as the eye lies to it, or as they run. */
static void make_constant(struct csg_circle *circle, const double *quadric)
{
    const bool inside = ((int)quadric[3] & 3) != CSG_QUADRIC_BETWEEN;
    *circle = (struct csg_circle){{inside ? -1 : 1, 0, 0, 0, 0, 0}};
}

static bool add_circle(struct builder *builder, const struct rim *rim)
{
    const struct csg_terms *terms = builder->terms;
    const struct csg_carriers *carriers = terms->scene->carriers;
    const uint32_t leaf = leaf_of(builder, rim);
    const struct csg_face face = carriers->quadric_faces[leaf];
    struct csg_circle circle;
    uint8_t unused;
    const double *plane = plane_of(builder, leaf, rim->above, &unused);
    if (is_steep(builder, plane))
        make_constant(&circle, csg_terms_texel(terms, csg_terms_of(terms, leaf), 2));
    else
        csg_screen_section(&terms->frame->screen, terms->frame->at,
                           csg_carrier_quadric(terms->scene, carriers, face.carrier), face.flipped,
                           plane, circle.conic);
    return csg_array_push(&builder->bands->circles, circle);
}

static uint32_t *circle_of(struct builder *builder, const struct rim *rim)
{
    return &builder->circles.data[4 * rim->ring + (rim->inner ? 2 : 0) + (rim->above ? 0 : 1)];
}

/* Rims at one place, [begin, end), are one circle. */
static bool join_rims(struct builder *builder, size_t begin, size_t end)
{
    const struct rim *rims = builder->rims.data, *best = &rims[begin];
    uint32_t circle = 0;
    for (size_t i = begin; i < end; i++)
        if (is_cylinder(builder, &rims[i]) && !is_cylinder(builder, best))
            best = &rims[i];
    if (best->r > 0) {
        circle = (uint32_t)builder->bands->circles.num;
        if (!add_circle(builder, best))
            return false;
    }
    for (size_t i = begin; i < end; i++)
        *circle_of(builder, &rims[i]) = circle;
    return true;
}

/* ---- flat bands --------------------------------------------------------------------------- */

/* The rings just below and above a level, at some distance from the axis. */
struct around {
    uint32_t ring[2];
    bool is_in[2];
};

static void pass_rim(struct around *around, const struct rim *rim, bool has_width)
{
    const int side = rim->above;
    if (!has_width)
        return;
    if (rim->inner) {
        around->ring[side] = rim->ring;
        around->is_in[side] = true;
    } else if (around->ring[side] == rim->ring) {
        around->is_in[side] = false;
    }
}

static bool has_width(const struct builder *builder, const struct rim *rim)
{
    const struct csg_ring *ring = ring_of(builder, rim->ring);
    const int end = rim->above ? 0 : 1;
    const double outer = shape_of(builder, ring->outer)->radii[end];
    return outer > (ring->inner == CSG_NO_LEAF ? 0 : shape_of(builder, ring->inner)->radii[end]);
}

/* Between two circles of a level, where there is a ring on one side of it only. */
static bool add_flat(struct builder *builder, const struct around *around, uint32_t from,
                     uint32_t to)
{
    if (around->is_in[0] == around->is_in[1])
        return true;
    const int side = around->is_in[1];
    const uint32_t leaf = ring_of(builder, around->ring[side])->outer;
    struct csg_band band = {
        .stack = builder->stack, .leaf = leaf, .circles = {from, to}, .flat = true};
    const double *plane = plane_of(builder, leaf, side == 1, &band.face);
    put_plane(builder, plane, band.planes[0]);
    return csg_array_push(&builder->bands->bands, band);
}

/* Discs without a hole begin at the axis, which no rim says. */
static void start_level(const struct builder *builder, size_t begin, size_t end,
                        struct around *around)
{
    *around = (struct around){{CSG_NO_LEAF, CSG_NO_LEAF}, {false, false}};
    for (size_t i = begin; i < end; i++) {
        const struct rim *rim = &builder->rims.data[i];
        if (rim->inner || ring_of(builder, rim->ring)->inner != CSG_NO_LEAF || rim->r <= 0)
            continue;
        around->ring[rim->above] = rim->ring;
        around->is_in[rim->above] = true;
    }
}

/* The rims of one level, [begin, end). */
static bool add_level(struct builder *builder, size_t begin, size_t end)
{
    struct around around;
    uint32_t from = 0;
    bool ok = true;
    start_level(builder, begin, end, &around);
    for (size_t i = begin, next; i < end && ok; i = next) {
        const struct rim *rims = builder->rims.data;
        for (next = i; next < end && rims[next].r == rims[i].r; next++)
            continue;
        ok = join_rims(builder, i, next);
        const uint32_t to = *circle_of(builder, &rims[i]);
        ok = ok && (to == from || add_flat(builder, &around, from, to));
        for (size_t j = i; j < next; j++)
            pass_rim(&around, &rims[j], has_width(builder, &rims[j]));
        from = to;
    }
    return ok;
}

/* ---- bands of cones ----------------------------------------------------------------------- */

static void set_end(const struct builder *builder, struct csg_band *band, int end,
                    const double *plane, uint32_t circle)
{
    put_plane(builder, plane, band->planes[end]);
    band->circles[end] = circle;
}

/* Rays along both planes may be said to enter by both: that they leave by one is as true. */
static void turn_plane(double plane[4])
{
    for (int i = 0; i < 4; i++)
        plane[i] = -plane[i];
}

static bool add_curved(struct builder *builder, uint32_t ring, uint32_t leaf, bool inner)
{
    if (leaf == CSG_NO_LEAF)
        return true;
    const struct csg_leaf_terms *terms = csg_terms_of(builder->terms, leaf);
    const uint32_t *circles = &builder->circles.data[4 * ring + (inner ? 2 : 0)];
    struct csg_band band = {.stack = builder->stack, .leaf = leaf, .inner = inner};
    uint8_t unused;
    const double *low = plane_of(builder, leaf, true, &unused);
    const double *high = plane_of(builder, leaf, false, &unused);
    const bool upwards = low[3] > 0;
    set_end(builder, &band, upwards ? 0 : 1, low, circles[0]);
    set_end(builder, &band, upwards ? 1 : 0, high, circles[1]);
    if (terms->num_entries == 2)
        turn_plane(band.planes[1]);
    if (terms->num_entries == 0) {
        const double *quadric = csg_terms_texel(builder->terms, terms, 2);
        const bool inside = ((int)quadric[3] & 3) == CSG_QUADRIC_BEFORE;
        band.code = (uint8_t)(CSG_BAND_WITHIN | (inside ? CSG_BAND_INSIDE : 0));
    }
    return csg_array_push(&builder->bands->bands, band);
}

static bool starts_within(const struct csg_band *band)
{
    return band->code == (CSG_BAND_WITHIN | CSG_BAND_INSIDE);
}

/* Both frusta of a ring; rays start in it where they start in the outer one only. */
static bool add_ring(struct builder *builder, uint32_t ring, bool *starts)
{
    const struct csg_ring leaves = *ring_of(builder, ring);
    const size_t first = builder->bands->bands.num;
    if (!add_curved(builder, ring, leaves.outer, false) ||
        !add_curved(builder, ring, leaves.inner, true))
        return false;
    const struct csg_band *bands = builder->bands->bands.data + first;
    *starts |=
        starts_within(&bands[0]) && (leaves.inner == CSG_NO_LEAF || !starts_within(&bands[1]));
    return true;
}

/* Nearer than a fifth of the far end counts as that. */
static void find_keys(struct builder *builder)
{
    const struct csg_screen *screen = &builder->terms->frame->screen;
    const struct csgcast_scene *scene = builder->terms->scene;
    struct csg_box box = csg_box_empty;
    double range[2];
    for (uint32_t i = 0; i < builder->stacks->list.data[builder->stack].num_rings; i++) {
        const struct csg_box ring = scene->leaves[ring_of(builder, i)->outer].box;
        box = csg_box_union(&box, &ring);
    }
    csg_depth_range(screen, &box, range);
    range[0] = screen->orthographic ? range[0] : fmax(range[0], 0.2 * range[1]);
    for (int i = 0; i < 2; i++)
        builder->keys[i] = csg_screen_key(screen, range[i]);
}

static bool add_stack(struct builder *builder)
{
    const uint32_t num = builder->stacks->list.data[builder->stack].num_rings;
    bool ok = true, starts = false;
    builder->rims.num = builder->circles.num = 0;
    find_keys(builder);
    for (uint32_t i = 0; i < num && ok; i++)
        ok = is_flat(builder, ring_of(builder, i)) ||
             (add_rims(builder, i, ring_of(builder, i)->outer, false) &&
              add_rims(builder, i, ring_of(builder, i)->inner, true));
    ok = ok && csg_array_reserve(&builder->circles, 4 * (size_t)num);
    if (ok && builder->rims.num)
        sort_rims(builder);
    for (size_t i = 0, next; i < builder->rims.num && ok; i = next) {
        const struct rim *rims = builder->rims.data;
        for (next = i; next < builder->rims.num && rims[next].level == rims[i].level; next++)
            continue;
        ok = add_level(builder, i, next);
    }
    for (uint32_t i = 0; i < num && ok; i++)
        ok = is_flat(builder, ring_of(builder, i)) || add_ring(builder, i, &starts);
    return ok && csg_array_push(&builder->bands->starts, starts);
}

bool csg_bands_fill(struct csg_bands *bands, const struct csg_terms *terms,
                    const struct csg_stacks *stacks)
{
    const struct csg_circle none = {{1, 0, 0, 0, 0, 0}};
    struct builder builder = {.bands = bands, .terms = terms, .stacks = stacks};
    bands->circles.num = bands->bands.num = bands->starts.num = 0;
    bool ok = csg_array_push(&bands->circles, none);
    for (; builder.stack < stacks->list.num && ok; builder.stack++)
        ok = add_stack(&builder);
    free(builder.rims.data);
    free(builder.circles.data);
    return ok;
}

void csg_bands_finish(struct csg_bands *bands)
{
    free(bands->circles.data);
    free(bands->bands.data);
    free(bands->starts.data);
    *bands = (struct csg_bands){0};
}
