/* SPDX-License-Identifier: MIT */
/*
 * Two pieces of one cylinder or cone, written with six digits, lie on one carrier, wherever they
 * are and however short: a coarse place must not part them.
 */
#include <stdlib.h>
#include <string.h>

#include "carrier/carrier.h"
#include "check.h"
#include "csg/scene.h"
#include "dice.h"

enum { NUM_PAIRS = 300 };

struct turned {
    struct csg_vec3 x, y, z;
};

static struct csg_vec3 random_direction(void)
{
    const struct csg_vec3 d =
        csg_vec3(random_between(-1, 1), random_between(-1, 1), random_between(0.1, 1));
    return csg_scale(1 / csg_length(d), d);
}

static struct turned random_turn(void)
{
    struct turned turned = {.z = random_direction()};
    turned.x = csg_normalize(csg_cross(turned.z, random_direction()));
    turned.y = csg_cross(turned.z, turned.x);
    return turned;
}

static void put_piece(FILE *out, const struct turned *t, struct csg_vec3 at, double h, double r1,
                      double r2)
{
    fprintf(out,
            "multmatrix([[%g, %g, %g, %g], [%g, %g, %g, %g], [%g, %g, %g, %g], [0, 0, 0, 1]]) "
            "cylinder($fn = 0, $fa = 12, $fs = 2, h = %g, r1 = %g, r2 = %g, center = false);\n",
            t->x.x, t->y.x, t->z.x, at.x, t->x.y, t->y.y, t->z.y, at.y, t->x.z, t->y.z, t->z.z,
            at.z, h, r1, r2);
}

/* length: of a piece, in radii. */
static void put_pair(FILE *out, double length)
{
    const struct turned turned = random_turn();
    const struct csg_vec3 at =
        csg_vec3(random_between(-700, 700), random_between(-700, 700), random_between(-700, 700));
    const double r = random_between(20, 30), h = length * r;
    const double slope = random_below(2) ? random_between(-0.1, 0.1) : 0;
    const double further = h + random_between(0, 2) * r;
    put_piece(out, &turned, at, h, r, r + slope * h);
    put_piece(out, &turned, csg_add(at, csg_scale(further, turned.z)), h, r + slope * further,
              r + slope * (further + h));
}

static void check_length(double length)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    CHECK(out, "memory");
    if (!out)
        return;
    fprintf(out, "difference() { cube(size = [2000, 2000, 2000], center = true);\n");
    for (int i = 0; i < NUM_PAIRS; i++)
        put_pair(out, length);
    fprintf(out, "}\n");
    fclose(out);
    struct csgcast_scene *scene = csgcast_scene_parse(text, size, NULL);
    CHECK(scene && scene->carriers->num_quadrics == NUM_PAIRS, "length %g: %zu quadrics", length,
          scene ? scene->carriers->num_quadrics : 0);
    csgcast_scene_destroy(scene);
    free(text);
}

int main(void)
{
    static const double lengths[] = {1, 0.25};
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++)
        check_length(lengths[i]);
    return num_failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
