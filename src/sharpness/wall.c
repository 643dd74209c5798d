/* SPDX-License-Identifier: MIT */
#include "sharpness/wall.h"

#include <stdlib.h>

/* Larger profiles are measured as rings: time grows with the square. */
#define MAX_RINGS 1500

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
    CSG_ARRAY(struct side) sides;
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

/* The least distance, above noise, from a place to another side, straight across, both ways. */
static double distance_from(const struct wall *wall, const struct place *place, size_t own,
                            double noise)
{
    double least = INFINITY;
    for (size_t i = 0; i < wall->sides.num; i++) {
        const struct side *side = &wall->sides.data[i];
        const double r0 = side->r[0] - place->r, z0 = side->z[0] - place->z;
        const double r1 = side->r[1] - place->r, z1 = side->z[1] - place->z;
        const double a = r0 * place->dr + z0 * place->dz, b = r1 * place->dr + z1 * place->dz;
        if ((a > 0) == (b > 0) || i == own)
            continue;
        const double at = a / (a - b);
        const double r = r0 + at * (r1 - r0), z = z0 + at * (z1 - z0);
        const double d = fabs(r * place->dz - z * place->dr);
        least = d > noise && d < least ? d : least;
    }
    return least;
}

static double least_distance(const struct wall *wall)
{
    const struct side *sides = wall->sides.data;
    double least = INFINITY, size = 0;
    for (size_t i = 0; i < wall->sides.num; i++)
        size = fmax(size, fmax(fmax(sides[i].r[0], sides[i].r[1]), fabs(sides[i].z[0])));
    for (size_t i = 0; i < wall->sides.num; i++)
        for (int j = 0; j < NUM_PLACES; j++) {
            const struct place place = place_on(&sides[i], j);
            least = fmin(least, distance_from(wall, &place, i, NOISE * size));
        }
    return least;
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

bool csg_wall_measure(const struct csgcast_scene *scene, const struct csg_stacks *stacks,
                      const struct csg_stack *stack, uint8_t *marks, double *least)
{
    struct wall wall = {
        .scene = scene, .rings = stacks->rings.data + stack->first_ring, .num = stack->num_rings};
    struct csg_map inverse;
    *least = INFINITY;
    if (stack->num_rings > MAX_RINGS ||
        !csg_map_invert(&scene->leaves[wall.rings[0].outer].shape.frame, &inverse))
        return true;
    const bool ok = add_sides(&wall, marks) && pair_ends(&wall, marks);
    if (ok)
        *least = least_distance(&wall) / csg_map_stretch(&inverse);
    free(wall.sides.data);
    return ok;
}
