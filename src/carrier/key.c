/* SPDX-License-Identifier: MIT */
#include "carrier/key.h"

#include "carrier/grid.h"
#include "common/hash.h"

/* Neighbours are looked at where they are as near as this, in cells: coincident faces differ by
 * less, so that most of the time one cell of two does. Of the widest cells of directions the nearer
 * one always. */
#define NEAR 0.25
#define ALWAYS 0.5

/* Normals are rounded to less. */
#define LEAST_TURN 1e-12

/* Places of quadrics are counted in parts of a cell; a part more for their rounding. */
#define PARTS 64
#define NEAR_PARTS 17

/* Those of quadrics are followed by those of their forms, those of normals by widths. */
enum { KEY_PARALLEL, KEY_QUADRIC, KEY_NORMAL = 128 };

/* Faces that turn by more than WIDEST_TURN, to the power of two, are of width 0; each further one
 * is narrower by that many octaves. */
enum { WIDEST_TURN = -7, WIDTH_OCTAVES = 3 };

/* Quadrics are told apart by their distances from three points, in radii of the scene from its
 * center, that have no model's symmetry. */
static const struct csg_vec3 probes[3] = {
    {0.3719, 0.2113, 0.5931}, {-0.5623, 0.4417, 0.1279}, {0.2371, -0.6127, -0.3343}};

int csg_carrier_width(const struct csg_carrier_spread *spread)
{
    const double turn = fmin(fmax(spread->turn, LEAST_TURN), 1);
    const int octaves = WIDEST_TURN - ilogb(turn);
    const int width = octaves > 0 ? 1 + (octaves - 1) / WIDTH_OCTAVES : 0;
    return width < CSG_MAX_WIDTHS ? width : CSG_MAX_WIDTHS - 1;
}

static struct csg_carrier_cells cells_of(const struct csg_carrier_spread *spread, double radius)
{
    const double direction = fmax(spread->turn, LEAST_TURN) / NEAR;
    return (struct csg_carrier_cells){.spread = *spread,
                                      .offset = fmax(8 * spread->slack, 2e-9 * radius),
                                      .direction = fmin(direction, CSG_DIRECTION_CELL),
                                      .near_direction =
                                          direction > CSG_DIRECTION_CELL ? ALWAYS : NEAR};
}

struct csg_carrier_space csg_carrier_space(struct csg_vec3 center, double radius,
                                           const struct csg_carrier_reach *reach,
                                           const struct csg_carrier_spread spreads[CSG_MAX_WIDTHS])
{
    struct csg_carrier_space space = {.center = center,
                                      .radius = radius,
                                      .cell = fmax(8 * reach->slack, 2e-9 * radius),
                                      .fine = fmax(4 * reach->tolerance, 1e-12 * radius)};
    for (int i = 0; i < CSG_MAX_WIDTHS; i++)
        if (spreads[i].turn > 0)
            space.widths[space.num_widths++] = cells_of(&spreads[i], radius);
    for (int i = 0; i < 3; i++)
        space.probes[i] = csg_add(center, csg_scale(radius, probes[i]));
    return space;
}

int csg_carrier_narrowest(const struct csg_carrier_space *space,
                          const struct csg_carrier_spread *spread)
{
    int width = space->num_widths - 1;
    while (width > 0 && !csg_carrier_has_spread(&space->widths[width], spread))
        width--;
    return width;
}

/* ---- coordinates, in cells ---------------------------------------------------------------- */

static double offset_of(const struct csg_carrier_space *space, const struct csg_plane *plane)
{
    return plane->offset - csg_dot(plane->normal, space->center);
}

static double parallel_coordinate(const struct csg_carrier_space *space,
                                  const struct csg_plane *plane)
{
    const double offset = offset_of(space, plane);
    return (csg_direction_is_reversed(plane->normal) ? -offset : offset) / space->fine;
}

/* A plane and its reverse get the same ones. */
static void plane_coordinates(const struct csg_carrier_space *space, int width,
                              const struct csg_plane *plane, double coordinates[3])
{
    csg_direction_coordinates(plane->normal, space->widths[width].direction, coordinates);
    coordinates[2] = fabs(offset_of(space, plane)) / space->widths[width].offset;
}

/* A third of the norm of f's second derivatives, squared: what it is of a sphere. */
static double curvature(const struct csg_quadric *quadric)
{
    double sum = 0;
    for (int j = 0; j < 3; j++)
        for (int k = 0; k < 3; k++) {
            double entry = 0;
            for (int i = 0; i < 3; i++)
                entry += quadric->diag[i] * quadric->to_canon.m[i][j] * quadric->to_canon.m[i][k];
            sum += entry * entry;
        }
    return sqrt(sum / 3);
}

/*
 * How far p is from the surface, nearly: exactly for a sphere, and bounded wherever the gradient
 * vanishes (Taubin 1994, Distance approximations for rasterizing implicit curves, eq. 9, with one
 * norm for all second derivatives). It does not depend on how the surface was brought to its
 * normal form.
 */
static double distance_of(const struct csg_quadric *quadric, double curved, struct csg_vec3 p)
{
    const double value = fabs(csg_quadric_value(quadric, p));
    const double slope = csg_length(csg_quadric_gradient(quadric, p));
    const double sum = slope + sqrt(slope * slope + 4 * value * curved);
    return sum > 0 ? 2 * value / sum : value;
}

static void quadric_coordinates(const struct csg_carrier_space *space,
                                const struct csg_quadric *quadric, double coordinates[3])
{
    const double curved = curvature(quadric);
    for (int i = 0; i < 3; i++)
        coordinates[i] = distance_of(quadric, curved, space->probes[i]) / space->cell;
}

/* ---- keys --------------------------------------------------------------------------------- */

/* Of a cell, for one of the three ways to look. */
static uint64_t key_of_cell(uint64_t kind, const int64_t cell[3])
{
    uint64_t hash = csg_hash_number(0, kind + 1);
    for (int i = 0; i < 3; i++)
        hash = csg_hash_number(hash, (uint64_t)cell[i]);
    return hash;
}

static uint64_t key_of(uint64_t kind, const double coordinates[3])
{
    return key_of_cell(kind, (const int64_t[3]){csg_grid_cell(coordinates[0]),
                                                csg_grid_cell(coordinates[1]),
                                                csg_grid_cell(coordinates[2])});
}

/* The keys of a face's cell and of the neighbours that it is near to in some coordinates. */
static int keys_around(uint64_t kind, const double coordinates[3], const double near[3],
                       uint64_t keys[8])
{
    int num = 0, far = 0;
    for (int i = 0; i < 3; i++)
        far |= csg_grid_is_near(coordinates[i], near[i]) << i;
    for (int k = 0; k < 8; k++) {
        int64_t cell[3];
        for (int i = 0; i < 3; i++)
            cell[i] =
                k >> i & 1 ? csg_grid_neighbour(coordinates[i]) : csg_grid_cell(coordinates[i]);
        if ((k & ~far) == 0)
            keys[num++] = key_of_cell(kind, cell);
    }
    return num;
}

static uint64_t parallel_key(int64_t number, int64_t cell)
{
    return key_of_cell(KEY_PARALLEL, (const int64_t[3]){number, cell, 0});
}

uint64_t csg_parallel_key(const struct csg_carrier_space *space, const struct csg_plane *plane,
                          int64_t number)
{
    return parallel_key(number, csg_grid_cell(parallel_coordinate(space, plane)));
}

int csg_parallel_keys(const struct csg_carrier_space *space, const struct csg_plane *plane,
                      uint64_t keys[8])
{
    const double coordinate = parallel_coordinate(space, plane);
    const int64_t number = csg_direction_number(plane->normal);
    keys[0] = parallel_key(number, csg_grid_cell(coordinate));
    if (!csg_grid_is_near(coordinate, NEAR))
        return 1;
    keys[1] = parallel_key(number, csg_grid_neighbour(coordinate));
    return 2;
}

uint64_t csg_normal_key(const struct csg_carrier_space *space, int width,
                        const struct csg_plane *plane)
{
    double coordinates[3];
    plane_coordinates(space, width, plane, coordinates);
    return key_of(KEY_NORMAL + (uint64_t)width, coordinates);
}

int csg_normal_keys(const struct csg_carrier_space *space, int width, const struct csg_plane *plane,
                    uint64_t keys[8])
{
    const double near_direction = space->widths[width].near_direction;
    const double near[3] = {near_direction, near_direction, NEAR};
    double coordinates[3];
    plane_coordinates(space, width, plane, coordinates);
    return keys_around(KEY_NORMAL + (uint64_t)width, coordinates, near, keys);
}

/* Only quadrics of equal normal forms, up to their sign, can be the same surface. */
static uint64_t quadric_kind(const struct csg_quadric *quadric)
{
    int code = 0, negated = 0;
    for (int i = 0; i < 4; i++) {
        code = 3 * code + (int)quadric->diag[i] + 1;
        negated = 3 * negated - (int)quadric->diag[i] + 1;
    }
    return KEY_QUADRIC + (uint64_t)(code < negated ? code : negated);
}

/* Modulo 2^16: only what is in one cell or in neighbours is compared. */
static void put_place(const double coordinates[3], uint16_t place[3])
{
    for (int i = 0; i < 3; i++)
        place[i] = (uint16_t)(uint64_t)csg_grid_cell(PARTS * coordinates[i]);
}

bool csg_is_near_place(const uint16_t a[3], const uint16_t b[3])
{
    for (int i = 0; i < 3; i++) {
        const uint16_t apart = (uint16_t)(a[i] - b[i] + NEAR_PARTS);
        if (apart > 2 * NEAR_PARTS)
            return false;
    }
    return true;
}

uint64_t csg_quadric_key(const struct csg_carrier_space *space, const struct csg_quadric *quadric,
                         uint16_t place[3])
{
    double coordinates[3];
    quadric_coordinates(space, quadric, coordinates);
    put_place(coordinates, place);
    return key_of(quadric_kind(quadric), coordinates);
}

int csg_quadric_keys(const struct csg_carrier_space *space, const struct csg_quadric *quadric,
                     uint64_t keys[8], uint16_t place[3])
{
    static const double near[3] = {NEAR, NEAR, NEAR};
    double coordinates[3];
    quadric_coordinates(space, quadric, coordinates);
    put_place(coordinates, place);
    return keys_around(quadric_kind(quadric), coordinates, near, keys);
}
