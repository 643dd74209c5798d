/* SPDX-License-Identifier: MIT */
/* OpenSCAD's fragments and vertices: cylinders and spheres as polyhedra. */
#include "solid_args.h"

#include "solids/facets.h"

#define PI 3.14159265358979323846

/* Corner i of n at height z, as the text of OpenSCAD's manual has it. */
static struct csg_vec3 corner(double radius, double z, int i, int n)
{
    return csg_vec3(radius * cos(2 * PI * i / n), radius * sin(2 * PI * i / n), z);
}

/* The planes are the faces of the corners' hull: all corners are behind all planes, and every
 * plane has three corners or more. */
static void check_hull(const struct csg_shape *shape, const struct csg_vec3 *corners, size_t num,
                       const char *what)
{
    struct csg_box hull = csg_box_empty;
    for (size_t i = 0; i < num; i++)
        csg_box_extend(&hull, corners[i]);
    CHECK(same_box(&hull, &shape->written) && same_box(&hull, &shape->bounds), "%s", what);
    for (size_t i = 0; i < shape->num_planes; i++) {
        const struct csg_plane *plane = &shape->planes[i];
        size_t num_on = 0;
        for (size_t j = 0; j < num; j++) {
            const double above = csg_dot(plane->normal, corners[j]) - plane->offset;
            CHECK(above < 1e-13, "%s: corner %d is %g above plane %d", what, (int)j, above, (int)i);
            num_on += above > -1e-13;
        }
        CHECK(num_on >= 3, "%s: plane %d has %d corners", what, (int)i, (int)num_on);
    }
}

static void check_cylinder_facets(double r1, double r2, int n)
{
    struct csg_vec3 corners[200];
    struct csg_shape shape;
    struct messages messages;
    char args[80];
    snprintf(args, sizeof args, "h=3 r1=%g r2=%g $fn=%d", r1, r2, n);
    const enum csg_read_result result =
        read_solid("cylinder", args, CSGCAST_FACETS_AS_WRITTEN, &shape, &messages);
    CHECK(result == CSG_READ_OK, "%s: %s", args, messages.last);
    CHECK(shape.facetted && shape.convex && !shape.has_quadric, "%s", args);
    for (int i = 0; i < n; i++) {
        corners[i] = corner(r1, 0, i, n);
        corners[n + i] = corner(r2, 3, i, n);
    }
    CHECK(shape.num_planes == (size_t)(n + (r1 > 0) + (r2 > 0)), "%s", args);
    check_hull(&shape, corners, (size_t)(2 * n), args);
    csg_shape_finish(&shape);
}

static void check_sphere_facets(int n)
{
    struct csg_vec3 corners[40 * 20];
    struct csg_shape shape;
    struct messages messages;
    char args[80];
    const int rings = (n + 1) / 2;
    snprintf(args, sizeof args, "r=2 $fn=%d", n);
    const enum csg_read_result result =
        read_solid("sphere", args, CSGCAST_FACETS_AS_WRITTEN, &shape, &messages);
    CHECK(result == CSG_READ_OK, "%s: %s", args, messages.last);
    CHECK(shape.facetted && shape.convex && !shape.has_quadric, "%s", args);
    for (int j = 0; j < rings; j++)
        for (int i = 0; i < n; i++)
            corners[j * n + i] =
                corner(2 * sin(PI * (j + 0.5) / rings), 2 * cos(PI * (j + 0.5) / rings), i, n);
    CHECK(shape.num_planes == (size_t)((rings - 1) * n + 2), "%s", args);
    check_hull(&shape, corners, (size_t)(rings * n), args);
    csg_shape_finish(&shape);
}

static void check_counts(void)
{
    static const struct {
        double fn, fa, fs, radius;
        int count;
    } counts[] = {
        {0, 12, 2, 1, 5},    {0, 12, 2, 10, 30},   {0, 12, 2, 5, 16},   {5.7, 12, 2, 1, 5},
        {1, 12, 2, 1, 3},    {100, 12, 2, 1, 100}, {-5, 12, 2, 10, 30}, {0, 12, 2, 1e-7, 3},
        {NAN, 12, 2, 10, 3}, {0, 1, 0.1, 10, 360}, {0, 50, 2, 100, 8},  {0.5, 12, 2, 9, 3},
    };
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
        const struct csg_facets facets = {counts[i].fn, counts[i].fa, counts[i].fs};
        const int count = csg_facets_count(&facets, counts[i].radius);
        CHECK(count == counts[i].count, "$fn=%g r=%g: %d", counts[i].fn, counts[i].radius, count);
    }
}

static void check_degrees(void)
{
    for (int i = -1440; i <= 1440; i++) {
        const double degrees = 0.75 * i;
        CHECK(fabs(csg_sin_degrees(degrees) - sin(degrees * PI / 180)) < 1e-14, "%g", degrees);
        CHECK(fabs(csg_cos_degrees(degrees) - cos(degrees * PI / 180)) < 1e-14, "%g", degrees);
    }
    CHECK(csg_sin_degrees(30) == 0.5 && csg_sin_degrees(-30) == -0.5 && csg_sin_degrees(180) == 0 &&
              csg_cos_degrees(60) == 0.5 && csg_cos_degrees(90) == 0 && csg_cos_degrees(270) == 0 &&
              csg_cos_degrees(180) == -1 && csg_sin_degrees(45) == csg_cos_degrees(45) &&
              csg_cos_degrees(-1e-20) == 1 && isnan(csg_sin_degrees(INFINITY)),
          "degrees");
}

static bool is_facetted(const char *kind, const char *args, enum csgcast_facets facets)
{
    struct csg_shape shape;
    struct messages messages;
    const enum csg_read_result result = read_solid(kind, args, facets, &shape, &messages);
    const bool facetted = shape.facetted;
    CHECK(result == CSG_READ_OK, "%s(%s): %s", kind, args, messages.last);
    csg_shape_finish(&shape);
    return facetted;
}

static void check_modes(void)
{
    CHECK(!is_facetted("sphere", "", CSGCAST_FACETS_AUTO), "auto");
    CHECK(!is_facetted("sphere", "$fn=13", CSGCAST_FACETS_AUTO), "auto");
    CHECK(!is_facetted("cylinder", "$fn=6", CSGCAST_FACETS_EXACT), "exact");
    CHECK(is_facetted("sphere", "", CSGCAST_FACETS_AS_WRITTEN), "as-written");
    for (double fn = 0.5; fn < 13; fn += 0.5) {
        char args[32];
        snprintf(args, sizeof args, "$fn=%g", fn);
        CHECK(is_facetted("cylinder", args, CSGCAST_FACETS_AUTO), "%s", args);
    }
}

/* The camera frames OpenSCAD's corners even where the solid is exact, whatever $fn is. */
static void check_written(void)
{
    struct csg_shape shape;
    struct messages messages;
    CHECK(read_solid("sphere", "r=2 $fn=8", CSGCAST_FACETS_EXACT, &shape, &messages) == CSG_READ_OK,
          "exact");
    CHECK(fabs(shape.written.hi.z - 2 * cos(PI / 8)) < 1e-12 && shape.bounds.hi.z == 2, "exact");
    CHECK(read_solid("cylinder", "$fn=1e300", CSGCAST_FACETS_EXACT, &shape, &messages) ==
              CSG_READ_OK,
          "huge");
    CHECK(same_box(&shape.written, &shape.bounds), "huge");
    csg_shape_finish(&shape);
    CHECK(read_solid("sphere", "$fn=1e300", CSGCAST_FACETS_AS_WRITTEN, &shape, &messages) ==
                  CSG_READ_ERROR &&
              messages.num == 1,
          "huge");
    csg_shape_finish(&shape);
}

int main(void)
{
    check_counts();
    check_degrees();
    check_modes();
    check_written();
    for (int n = 3; n <= 36; n++) {
        check_cylinder_facets(2, 2, n);
        check_cylinder_facets(2, 0, n);
        check_cylinder_facets(0, 1, n);
        check_cylinder_facets(1.5, 4, n);
        check_sphere_facets(n);
    }
    return num_failed > 0;
}
