/* SPDX-License-Identifier: MIT */
#include "sharpness/flats.h"

#include <stdlib.h>

/* Heights that are compared side by side, which compilers make vectors of. */
#define NUM_LANES 8

bool csg_flats_add(struct csg_flats *flats, const struct csg_plane *plane, uint32_t carrier,
                   uint32_t leaf, bool turned)
{
    const struct csg_vec3 n = plane->normal;
    const bool turns = n.x != 0 ? n.x < 0 : n.y != 0 ? n.y < 0 : n.z < 0;
    const double s = turns ? -1 : 1;
    return csg_array_push(
        &flats->all,
        ((struct csg_flat){.normal = csg_scale(s, n),
                           .height = s * plane->offset,
                           .place = fabs(csg_dot(n, csg_vec3(0.54, 0.32, 0.78))),
                           .other_place = fabs(csg_dot(n, csg_vec3(0.81, -0.43, -0.39))),
                           .carrier = carrier,
                           .leaf = leaf,
                           .turned = turned != turns}));
}

static bool sort_keys(struct csg_flats *flats)
{
    flats->keys.list.num = 0;
    for (uint32_t i = 0; i < flats->all.num; i++)
        if (!csg_array_push(&flats->keys.list,
                            ((struct csg_key){csg_key_of(flats->all.data[i].place), i})))
            return false;
    return csg_keys_sort(&flats->keys);
}

bool csg_flats_sort(struct csg_flats *flats, struct csg_vec3 center)
{
    const size_t num = flats->all.num;
    flats->sorted.num = flats->sides[0].num = flats->sides[1].num = flats->other_places.num = 0;
    if (!sort_keys(flats) || !csg_array_reserve(&flats->sorted, num) ||
        !csg_array_reserve(&flats->other_places, num) ||
        !csg_array_reserve(&flats->sides[0], num) || !csg_array_reserve(&flats->sides[1], num))
        return false;
    for (size_t i = 0; i < num; i++) {
        struct csg_flat *flat = &flats->sorted.data[i];
        *flat = flats->all.data[flats->keys.list.data[i].index];
        flat->height -= csg_dot(flat->normal, center);
        flats->other_places.data[i] = flat->other_place;
        flats->sides[flat->turned].data[i] = flat->height;
        flats->sides[!flat->turned].data[i] = INFINITY;
    }
    return true;
}

/* How far two leaves' boxes are apart, along an axis; 0: they have a point in common. */
static double boxes_apart(const struct csg_box *both)
{
    const struct csg_vec3 gap = csg_sub(both->lo, both->hi);
    return fmax(fmax(gap.x, gap.y), fmax(gap.z, 0));
}

/* Where faces of both leaves can be: what their boxes have in common, if the ball is not smaller. */
static struct csg_ball common_ball(const struct csg_box *both, const struct csg_ball *ball)
{
    const double radius = 0.5 * csg_length(csg_sub(both->hi, both->lo));
    return boxes_apart(both) == 0 && radius < ball->radius
               ? (struct csg_ball){csg_box_middle(both), radius}
               : *ball;
}

/*
 * Over a ball around the center, aligned planes at the angle a are between d - a r and d + a r
 * apart, with d their distance in the middle: they meet there, or leave a gap. Only where their
 * solids lie on different sides is that a wedge or a wall; else it is an edge so flat that either
 * side of it will do. Faces are no nearer than their leaves' boxes.
 */
static void note_pair(struct csg_sharpness *sharp, const struct csgcast_scene *scene,
                      const struct csg_flat *a, const struct csg_flat *b,
                      const struct csg_ball *ball, double noise)
{
    const bool same = csg_dot(a->normal, b->normal) >= 0;
    const double s = same ? 1 : -1;
    if (a->carrier == b->carrier || same == (a->turned == b->turned))
        return;
    const struct csg_vec3 turn = csg_sub(a->normal, csg_scale(s, b->normal));
    const double angle = csg_length(turn);
    if (angle > CSG_FINE_MAX_ANGLE)
        return;
    const struct csg_box both =
        csg_box_intersection(&scene->leaves[a->leaf].box, &scene->leaves[b->leaf].box);
    const struct csg_ball common = common_ball(&both, ball);
    const double apart =
        fabs(a->height - s * b->height - csg_dot(turn, csg_sub(common.center, ball->center)));
    const double gap = fmax(apart - angle * common.radius, boxes_apart(&both));
    if (gap <= 0 && angle > CSG_FINE_NOISE)
        csg_sharpness_note(sharp, CSG_FINE_ANGLE, angle, b->leaf);
    else if (gap <= ball->radius && gap > noise)
        csg_sharpness_note(sharp, CSG_FINE_GAP, gap, b->leaf);
}

/* The least distance of the heights from own, of those above noise. */
static double nearest(const double *heights, size_t num, double own, double noise)
{
    double least[NUM_LANES], result = INFINITY;
    size_t i = 0;
    for (size_t lane = 0; lane < NUM_LANES; lane++)
        least[lane] = INFINITY;
    for (; i + NUM_LANES <= num; i += NUM_LANES)
        for (size_t lane = 0; lane < NUM_LANES; lane++) {
            const double apart = fabs(heights[i + lane] - own);
            const double counts = apart > noise ? apart : INFINITY;
            least[lane] = counts < least[lane] ? counts : least[lane];
        }
    for (size_t lane = 0; lane < NUM_LANES; lane++)
        result = csg_least(result, least[lane]);
    for (; i < num; i++) {
        const double apart = fabs(heights[i] - own);
        result = apart > noise ? csg_least(result, apart) : result;
    }
    return result;
}

/* The plane i and those behind it up to end, which have its normal to the last bit, as in most
 * models most of the neighbours have: what note_pair finds, but no angle is asked. */
static void note_parallel(struct csg_sharpness *sharp, const struct csgcast_scene *scene,
                          const struct csg_flats *flats, size_t i, size_t end, double radius,
                          double noise)
{
    const struct csg_flat *own = &flats->sorted.data[i];
    const double *others = flats->sides[!own->turned].data;
    const double apart = nearest(others + i + 1, end - i - 1, own->height, noise);
    if (apart > radius || !(apart < sharp->least[CSG_FINE_GAP]))
        return;
    for (size_t j = i + 1; j < end; j++) {
        const double gap = fabs(others[j] - own->height);
        if (!(gap > noise && gap < sharp->least[CSG_FINE_GAP]))
            continue;
        const uint32_t leaf = flats->sorted.data[j].leaf;
        const struct csg_box both =
            csg_box_intersection(&scene->leaves[own->leaf].box, &scene->leaves[leaf].box);
        csg_sharpness_note(sharp, CSG_FINE_GAP, fmax(gap, boxes_apart(&both)), leaf);
    }
}

static bool is_parallel(const struct csg_flat *a, const struct csg_flat *b)
{
    return a->normal.x == b->normal.x && a->normal.y == b->normal.y && a->normal.z == b->normal.z;
}

void csg_flats_note(const struct csg_flats *flats, const struct csgcast_scene *scene, size_t begin,
                    size_t end, const struct csg_ball *ball, struct csg_sharpness *sharp)
{
    const double noise = CSG_FINE_NOISE * (csg_length(ball->center) + ball->radius);
    const size_t num = flats->all.num;
    const struct csg_flat *sorted = flats->sorted.data;
    for (size_t i = begin, line = 0; i < end; i++) {
        const size_t last = num - i < CSG_FINE_NEIGHBOURS ? num : i + CSG_FINE_NEIGHBOURS;
        for (line = line > i ? line : i + 1; line < last && is_parallel(&sorted[i], &sorted[line]);)
            line++;
        note_parallel(sharp, scene, flats, i, line, ball->radius, noise);
        for (size_t j = line; j < last; j++) {
            if (fabs(flats->other_places.data[j] - sorted[i].other_place) >= 2 * CSG_FINE_MAX_ANGLE)
                continue;
            if (sorted[j].place - sorted[i].place >= 2 * CSG_FINE_MAX_ANGLE)
                break;
            note_pair(sharp, scene, &sorted[i], &sorted[j], ball, noise);
        }
    }
}

void csg_flats_finish(struct csg_flats *flats)
{
    free(flats->all.data);
    free(flats->keys.list.data);
    free(flats->keys.room.data);
    free(flats->sorted.data);
    free(flats->other_places.data);
    free(flats->sides[0].data);
    free(flats->sides[1].data);
}
