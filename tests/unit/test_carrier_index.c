/* SPDX-License-Identifier: MIT */
/*
 * Planes of nearly one normal in cells of several widths: all that a face's spread allows are found
 * in the width that is the narrowest for it, hardly any others in a narrow one, and none that was
 * taken out.
 */
#include <stdlib.h>

#include "carrier/probe.h"
#include "check.h"
#include "dice.h"

enum { NUM_PLANES = 4000, NUM_FACES = 200 };

#define RADIUS 100.0

static struct csg_plane planes[NUM_PLANES];

/* Off the first axis by a thousandth. */
static struct csg_plane random_plane(void)
{
    const struct csg_vec3 normal =
        csg_vec3(1, random_between(-1e-3, 1e-3), random_between(-1e-3, 1e-3));
    return (struct csg_plane){csg_scale(1 / csg_length(normal), normal),
                              random_between(-0.5, 0.5) * RADIUS};
}

/* As much off the plane as that, and perhaps the other way round. */
static struct csg_plane near_plane(const struct csg_plane *plane,
                                   const struct csg_carrier_spread *spread)
{
    const double share = 0.5 * spread->turn, s = random_below(2) ? 1 : -1;
    const struct csg_vec3 turn =
        csg_vec3(0, random_between(-share, share), random_between(-share, share));
    const struct csg_vec3 normal = csg_add(plane->normal, turn);
    const double offset = plane->offset + random_between(-spread->slack, spread->slack);
    return (struct csg_plane){csg_scale(s / csg_length(normal), normal), s * offset};
}

static bool is_within(const struct csg_plane *a, const struct csg_plane *b,
                      const struct csg_carrier_spread *spread)
{
    const double s = csg_dot(a->normal, b->normal) < 0 ? -1 : 1;
    return csg_length(csg_sub(a->normal, csg_scale(s, b->normal))) <= spread->turn &&
           fabs(a->offset - s * b->offset) <= spread->slack;
}

/* Planes that are met; met: which. */
static size_t probe(const struct csg_carrier_index *index, int width, const struct csg_plane *plane,
                    bool met[NUM_PLANES])
{
    struct csg_index_probe probe;
    size_t num = 0;
    for (size_t i = 0; i < NUM_PLANES; i++)
        met[i] = false;
    csg_index_probe_normals(index, width, plane, &probe);
    for (uint32_t i; (i = csg_index_next(index, &probe)) != UINT32_MAX;)
        for (; i != UINT32_MAX; i = csg_index_next_member(index, width, i)) {
            num += !met[i];
            met[i] = true;
        }
    return num;
}

static size_t check_spread(const struct csg_carrier_index *index, int width,
                           const struct csg_carrier_spread *spread)
{
    bool met[NUM_PLANES];
    size_t num = 0;
    CHECK(csg_carrier_narrowest(&index->space, spread) == width, "width %d", width);
    for (int i = 0; i < NUM_FACES; i++) {
        const struct csg_plane face = near_plane(&planes[random_below(NUM_PLANES)], spread);
        num += probe(index, width, &face, met);
        for (size_t j = 0; j < NUM_PLANES; j++)
            CHECK(met[j] || !is_within(&face, &planes[j], spread), "width %d, plane %zu", width, j);
    }
    return num;
}

/* Every second one. */
static void check_removal(struct csg_carrier_index *index)
{
    bool met[NUM_PLANES];
    for (uint32_t i = 0; i < NUM_PLANES; i += 2)
        csg_index_remove_plane(index, &planes[i], i);
    for (int width = 0; width < index->space.num_widths; width++)
        for (uint32_t i = 0; i < NUM_PLANES; i += 97) {
            struct csg_plane face = planes[i];
            face.offset += 1e-9;
            face.normal.y += 1e-9;
            probe(index, width, &face, met);
            CHECK(met[i] == (i % 2 == 1), "width %d, plane %u", width, i);
            for (size_t j = 0; j < NUM_PLANES; j += 2)
                CHECK(!met[j], "width %d, plane %zu", width, j);
        }
}

int main(void)
{
    const struct csg_carrier_spread wide = {1.0, 1e-3}, narrow = {1e-3, 1e-6};
    const struct csg_carrier_reach reach = {1e-3, 1e-3};
    struct csg_carrier_spread spreads[CSG_MAX_WIDTHS] = {{0, 0}};
    struct csg_carrier_index index = {0};
    CHECK(csg_carrier_width(&wide) < csg_carrier_width(&narrow), "as wide");
    spreads[csg_carrier_width(&wide)] = wide;
    spreads[csg_carrier_width(&narrow)] = narrow;
    const struct csg_carrier_space space =
        csg_carrier_space(csg_vec3(0, 0, 0), RADIUS, &reach, spreads);
    if (!csg_index_start(&index, &space))
        return EXIT_FAILURE;
    for (uint32_t i = 0; i < NUM_PLANES; i++) {
        planes[i] = i % 4 == 3 ? planes[i - 1] : random_plane(); /* some are parallel */
        planes[i].offset += i % 4 == 3 ? 0.1 : 0;
        CHECK(csg_index_add_plane(&index, &planes[i], i), "out of memory");
    }
    const size_t num_wide = check_spread(&index, 0, &wide);
    const size_t num_narrow = check_spread(&index, 1, &narrow);
    CHECK(num_narrow * 100 < num_wide, "%zu planes in narrow cells, %zu in wide ones", num_narrow,
          num_wide);
    check_removal(&index);
    csg_index_finish(&index);
    return num_failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
