/* SPDX-License-Identifier: MIT */
#include "sharpness/wall.h"

#include <stdlib.h>

#include "sharpness/curvature.h"

/* What pack/precision.h asks for in float, about, as shares of what is seen. */
#define FINE_HEIGHT 1e-5
#define FINE_CURVATURE 1e-4

/* Walls are looked for up to this share of the profile: float holds them in any view. */
#define MAX_WALL 1e-2

/* Places on each side from which it is measured, and the shortest distance that is not rounding, as
 * a share of the profile. */
#define NUM_PLACES 3
#define NOISE 1e-11

/* A side of the profile: of a ring's frusta, or what is left of a level. */
struct side {
    double r[2], z[2];
};

struct wall {
    const struct csgcast_scene *scene;
    const struct csg_ring *rings;
    uint32_t num;
    CSG_ARRAY(struct side) sides; /* by their lower ends, once all are there */
};

/* Where a ring begins or ends. */
struct end {
    double z, outer, inner;
    uint32_t ring;
    bool low;
};

static const struct csg_shape *shape_of(const struct wall *wall, uint32_t leaf)
{
    return &wall->scene->leaves[leaf].shape;
}

static struct end end_of(const struct wall *wall, uint32_t ring, bool low)
{
    const struct csg_ring *leaves = &wall->rings[ring];
    const struct csg_shape *outer = shape_of(wall, leaves->outer);
    const int i = low ? 0 : 1;
    return (struct end){low ? outer->bounds.lo.z : outer->bounds.hi.z, outer->radii[i],
                        leaves->inner == CSG_NO_LEAF ? 0 : shape_of(wall, leaves->inner)->radii[i],
                        ring, low};
}

static int compare_ends(const void *a, const void *b)
{
    const struct end *x = a, *y = b;
    if (x->z != y->z)
        return x->z < y->z ? -1 : 1;
    if (x->inner != y->inner)
        return x->inner < y->inner ? -1 : 1;
    return x->outer < y->outer ? -1 : x->outer > y->outer;
}

static void mark(const struct wall *wall, const struct end *end, uint8_t *marks)
{
    const uint8_t covered = end->low ? CSG_WALL_LOW : CSG_WALL_HIGH;
    const struct csg_ring *ring = &wall->rings[end->ring];
    marks[ring->outer] |= covered;
    if (ring->inner != CSG_NO_LEAF)
        marks[ring->inner] |= covered;
}

/* Ends at one place, of a ring below and one above, cover each other; the others are sides. */
static bool pair_ends(struct wall *wall, uint8_t *marks)
{
    const size_t num = 2 * (size_t)wall->num;
    struct end *ends = malloc(num * sizeof *ends);
    bool ok = ends != NULL;
    for (uint32_t i = 0; i < wall->num && ok; i++) {
        ends[2 * i] = end_of(wall, i, true);
        ends[2 * i + 1] = end_of(wall, i, false);
    }
    if (ok)
        qsort(ends, num, sizeof *ends, compare_ends);
    for (size_t i = 0; i < num && ok; i++) {
        const struct end *a = &ends[i];
        if (i + 1 < num && compare_ends(a, a + 1) == 0 && a->low != a[1].low) {
            mark(wall, a, marks);
            mark(wall, a + 1, marks);
            i++;
        } else if (a->outer > a->inner) {
            ok = csg_array_push(&wall->sides, ((struct side){{a->inner, a->outer}, {a->z, a->z}}));
        }
    }
    free(ends);
    return ok;
}

static bool add_sides(struct wall *wall, uint8_t *marks)
{
    bool ok = true;
    for (uint32_t i = 0; i < wall->num && ok; i++) {
        const uint32_t leaves[2] = {wall->rings[i].outer, wall->rings[i].inner};
        for (int j = 0; j < 2 && ok; j++) {
            if (leaves[j] == CSG_NO_LEAF)
                continue;
            const struct csg_shape *shape = shape_of(wall, leaves[j]);
            marks[leaves[j]] |= CSG_WALL_RING;
            ok = csg_array_push(&wall->sides,
                                ((struct side){{shape->radii[0], shape->radii[1]},
                                               {shape->bounds.lo.z, shape->bounds.hi.z}}));
        }
    }
    return ok;
}

/* A place on a side, and the direction along it. */
struct place {
    double r, z, dr, dz;
};

static struct place place_on(const struct side *side, int i)
{
    const double dr = side->r[1] - side->r[0], dz = side->z[1] - side->z[0];
    const double length = hypot(dr, dz), t = (i + 0.5) / NUM_PLACES;
    return (struct place){side->r[0] + t * dr, side->z[0] + t * dz, dr / length, dz / length};
}

/* The distance, above noise, from a place to a side, straight across, either way. */
static double distance_to(const struct side *side, const struct place *place, double noise)
{
    const double r0 = side->r[0] - place->r, z0 = side->z[0] - place->z;
    const double r1 = side->r[1] - place->r, z1 = side->z[1] - place->z;
    const double a = r0 * place->dr + z0 * place->dz, b = r1 * place->dr + z1 * place->dz;
    if ((a > 0) == (b > 0))
        return INFINITY;
    const double at = a / (a - b);
    const double r = r0 + at * (r1 - r0), z = z0 + at * (z1 - z0);
    const double d = fabs(r * place->dz - z * place->dr);
    return d > noise ? d : INFINITY;
}

static int compare_sides(const void *a, const void *b)
{
    const struct side *x = a, *y = b;
    return x->z[0] < y->z[0] ? -1 : x->z[0] > y->z[0];
}

/* The least distance from a place on a side to others, if less than that. Only sides that are no
 * further up or down are asked; tops: the highest end of each side and those before it. */
static double least_from(const struct wall *wall, const double *tops, size_t own,
                         const struct place *place, double noise, double least)
{
    const struct side *sides = wall->sides.data;
    for (size_t i = own + 1; i < wall->sides.num && sides[i].z[0] <= place->z + least; i++)
        least = fmin(least, distance_to(&sides[i], place, noise));
    for (size_t i = own; i-- > 0 && tops[i] >= place->z - least;)
        least = fmin(least, distance_to(&sides[i], place, noise));
    return least;
}

/* No more than the largest that is looked for. false: out of memory. */
static bool find_least(struct wall *wall, double *least)
{
    struct side *sides = wall->sides.data;
    const size_t num = wall->sides.num;
    double *tops = malloc((num + 1) * sizeof *tops), size = 0;
    if (!tops)
        return false;
    qsort(sides, num, sizeof *sides, compare_sides);
    for (size_t i = 0; i < num; i++) {
        size = fmax(size, fmax(fmax(sides[i].r[0], sides[i].r[1]), fabs(sides[i].z[0])));
        tops[i] = i ? fmax(tops[i - 1], sides[i].z[1]) : sides[i].z[1];
    }
    *least = MAX_WALL * size;
    for (size_t i = 0; i < num; i++)
        for (int j = 0; j < NUM_PLACES; j++) {
            const struct place place = place_on(&sides[i], j);
            *least = least_from(wall, tops, i, &place, NOISE * size, *least);
        }
    free(tops);
    return true;
}

double csg_wall_curvature(const struct csg_shape *shape)
{
    const double r = fmax(shape->radii[0], shape->radii[1]);
    const double dr = shape->radii[1] - shape->radii[0];
    const double dz = shape->bounds.hi.z - shape->bounds.lo.z;
    struct csg_map inverse;
    return csg_map_invert(&shape->frame, &inverse)
               ? r * (hypot(dr, dz) / dz) / csg_map_stretch(&inverse)
               : INFINITY;
}

bool csg_wall_is_fine(const struct csg_leaf *leaf, double size)
{
    const struct csg_box *box = &leaf->box, *bounds = &leaf->shape.bounds;
    struct csg_map inverse;
    if (!csg_map_invert(&leaf->shape.frame, &inverse))
        return false;
    const double height = (bounds->hi.z - bounds->lo.z) / csg_map_stretch(&inverse);
    const double own = csg_length(csg_sub(box->hi, box->lo));
    return height < FINE_HEIGHT * size ||
           csg_curvature(&leaf->shape.quadric, own) < FINE_CURVATURE * size;
}

bool csg_wall_measure(const struct csgcast_scene *scene, const struct csg_stacks *stacks,
                      const struct csg_stack *stack, uint8_t *marks, double *least)
{
    struct wall wall = {
        .scene = scene, .rings = stacks->rings.data + stack->first_ring, .num = stack->num_rings};
    struct csg_map inverse;
    *least = INFINITY;
    if (!csg_map_invert(&scene->leaves[wall.rings[0].outer].shape.frame, &inverse))
        return true;
    const bool ok = add_sides(&wall, marks) && pair_ends(&wall, marks) && find_least(&wall, least);
    *least /= csg_map_stretch(&inverse);
    free(wall.sides.data);
    return ok;
}
