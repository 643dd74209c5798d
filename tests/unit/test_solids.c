/* SPDX-License-Identifier: MIT */
/* Every kind of solids.def against formulas of its own: members, bounds, samples, errors.
 * The general quadric and the facets have their own tests. */
#include "solid_args.h"

#include "solids/sample.h"

#define NUM_POINTS 20000

/* Below 0 inside, above 0 outside. */
typedef double field_fn(double x, double y, double z);

/* ---- formulas ----------------------------------------------------------------------------- */

static double box(double x, double y, double z, double a, double b, double c)
{
    return fmax(fabs(x) - a, fmax(fabs(y) - b, fabs(z) - c));
}

static double cube_corner(double x, double y, double z)
{
    return box(x - 1, y - 2, z - 3, 1, 2, 3);
}

static double cube_center(double x, double y, double z)
{
    return box(x, y, z, 1, 2, 3);
}

static double cube_one(double x, double y, double z)
{
    return box(x - 0.5, y - 0.5, z - 0.5, 0.5, 0.5, 0.5);
}

static double cube_partial(double x, double y, double z)
{
    return box(x - 2.5, y - 0.5, z - 0.5, 2.5, 0.5, 0.5);
}

static double sphere_3(double x, double y, double z)
{
    return sqrt(x * x + y * y + z * z) - 3;
}

static double ellipsoid_123(double x, double y, double z)
{
    return sqrt(x * x + y * y / 4 + z * z / 9) - 1;
}

static double frustum(double x, double y, double z, double r1, double r2, double h)
{
    return fmax(hypot(x, y) - (r1 + (r2 - r1) * z / h), fmax(-z, z - h));
}

static double cylinder_25(double x, double y, double z)
{
    return frustum(x, y, z, 2, 2, 5);
}

static double cylinder_center(double x, double y, double z)
{
    return frustum(x, y, z + 2.5, 2, 2, 5);
}

static double cone_up(double x, double y, double z)
{
    return frustum(x, y, z, 2, 0, 5);
}

static double cone_down(double x, double y, double z)
{
    return frustum(x, y, z + 2.5, 0, 3, 5);
}

static double cone_cut(double x, double y, double z)
{
    return frustum(x, y, z, 1, 3, 5);
}

static double nearly_cylinder(double x, double y, double z)
{
    return frustum(x, y, z, 2, 2.0000000001, 5);
}

static double simplex(double x, double y, double z)
{
    return fmax(fmax(-x, -y), fmax(-z, x / 2 + y / 3 + z / 4 - 1));
}

static double below_x(double x, double y, double z)
{
    (void)y, (void)z;
    return x - 5;
}

static double slanted(double x, double y, double z)
{
    return (x + 2 * y + 2 * z) / 3 - 4;
}

static double through_point(double x, double y, double z)
{
    return (x - 1 + 2 * (y - 1) + 2 * (z - 1)) / 3;
}

static double waist(double x, double y, double z, double lo, double hi)
{
    return fmax(x * x / 4 + y * y / 9 - z * z / 4 - 1, fmax(lo - z, z - hi));
}

static double waist_cut(double x, double y, double z)
{
    return waist(x, y, z, 0, 4);
}

static double waist_center(double x, double y, double z)
{
    return waist(x, y, z, -2, 2);
}

static double waist_open(double x, double y, double z)
{
    return waist(x, y, z, -INFINITY, INFINITY);
}

static double sheets(double x, double y, double z, double lo, double hi)
{
    return fmax(x * x / 4 + y * y / 9 - z * z / 4 + 1, fmax(lo - z, z - hi));
}

static double sheet_upper(double x, double y, double z)
{
    return sheets(x, y, z, 0, 4);
}

static double sheets_both(double x, double y, double z)
{
    return sheets(x, y, z, -4, 4);
}

static double bowl(double x, double y, double z)
{
    return fmax(x * x / 4 + y * y / 9 - z / 2, z - 4);
}

static double bowl_open(double x, double y, double z)
{
    return x * x / 4 + y * y / 9 - z / 2;
}

static double saddle(double x, double y, double z)
{
    return fmax(fmax(x * x / 4 - y * y / 9 - z / 2, z - 1), fmax(fabs(x) - 2, fabs(y) - 3));
}

static double saddle_open(double x, double y, double z)
{
    return x * x / 4 - y * y / 9 - z / 2;
}

/* ---- the table ---------------------------------------------------------------------------- */

#define I INFINITY

static const struct row {
    const char *kind, *args;
    field_fn *field;
    struct csg_box bounds;
    bool convex;
} rows[] = {
    {"cube", "size=[2,4,6]", cube_corner, {{0, 0, 0}, {2, 4, 6}}, true},
    {"cube", "size=[2,4,6] center=1", cube_center, {{-1, -2, -3}, {1, 2, 3}}, true},
    {"cube", "", cube_one, {{0, 0, 0}, {1, 1, 1}}, true},
    {"cube", "size=x", cube_one, {{0, 0, 0}, {1, 1, 1}}, true},
    {"cube", "size=[5,a,3]", cube_partial, {{0, 0, 0}, {5, 1, 1}}, true},
    {"sphere", "r=3", sphere_3, {{-3, -3, -3}, {3, 3, 3}}, true},
    {"sphere", "r=1 d=6", sphere_3, {{-3, -3, -3}, {3, 3, 3}}, true},
    {"ellipsoid", "r=[1,2,3]", ellipsoid_123, {{-1, -2, -3}, {1, 2, 3}}, true},
    {"ellipsoid", "d=[2,4,6]", ellipsoid_123, {{-1, -2, -3}, {1, 2, 3}}, true},
    {"ellipsoid", "r=3", sphere_3, {{-3, -3, -3}, {3, 3, 3}}, true},
    {"cylinder", "h=5 r1=2 r2=2", cylinder_25, {{-2, -2, 0}, {2, 2, 5}}, true},
    {"cylinder", "h=5 d=4", cylinder_25, {{-2, -2, 0}, {2, 2, 5}}, true},
    {"cylinder", "h=5 r=2 center=1", cylinder_center, {{-2, -2, -2.5}, {2, 2, 2.5}}, true},
    {"cylinder", "h=5 r1=2 r2=0", cone_up, {{-2, -2, 0}, {2, 2, 5}}, true},
    {"cylinder", "h=5 r1=0 d2=6 center=1", cone_down, {{-3, -3, -2.5}, {3, 3, 2.5}}, true},
    {"cylinder", "h=5 r=3 d1=2", cone_cut, {{-3, -3, 0}, {3, 3, 5}}, true},
    {"cylinder", "h=5 r1=2 r2=2.0000000001", nearly_cylinder, {{-2, -2, 0}, {2, 2, 5}}, true},
    {"tetrahedron",
     "points=[[0,0,0],[2,0,0],[0,3,0],[0,0,4]]",
     simplex,
     {{0, 0, 0}, {2, 3, 4}},
     true},
    {"tetrahedron",
     "points=[[2,0,0],[0,0,0],[0,3,0],[0,0,4]]",
     simplex,
     {{0, 0, 0}, {2, 3, 4}},
     true},
    {"halfspace", "normal=[2,0,0] offset=5", below_x, {{-I, -I, -I}, {5, I, I}}, true},
    {"halfspace", "normal=[1,2,2] offset=4", slanted, {{-I, -I, -I}, {I, I, I}}, true},
    {"halfspace", "normal=[1,2,2] point=[1,1,1]", through_point, {{-I, -I, -I}, {I, I, I}}, true},
    {"hyperboloid",
     "r=[2,3] c=2 h=4",
     waist_cut,
     {{-4.47213595499958, -6.70820393249937, 0}, {4.47213595499958, 6.70820393249937, 4}},
     false},
    {"hyperboloid",
     "r=[2,3] c=2 h=4 center=1",
     waist_center,
     {{-2.8284271247461903, -4.242640687119285, -2}, {2.8284271247461903, 4.242640687119285, 2}},
     false},
    {"hyperboloid", "r=[2,3] c=2", waist_open, {{-I, -I, -I}, {I, I, I}}, false},
    {"hyperboloid",
     "r=[2,3] c=2 h=4 sheets=2",
     sheet_upper,
     {{-3.4641016151377544, -5.196152422706632, 2}, {3.4641016151377544, 5.196152422706632, 4}},
     true},
    {"hyperboloid",
     "r=[2,3] c=2 h=8 center=1 sheets=2",
     sheets_both,
     {{-3.4641016151377544, -5.196152422706632, -4}, {3.4641016151377544, 5.196152422706632, 4}},
     false},
    {"paraboloid",
     "r=[2,3] c=2 h=4",
     bowl,
     {{-2.8284271247461903, -4.242640687119285, 0}, {2.8284271247461903, 4.242640687119285, 4}},
     true},
    {"paraboloid", "r=[2,3] c=2", bowl_open, {{-I, -I, 0}, {I, I, I}}, true},
    {"paraboloid", "r=[2,3] c=2 h=1 saddle=1", saddle, {{-2, -3, -2}, {2, 3, 1}}, false},
    {"paraboloid", "r=[2,3] c=2 saddle=1", saddle_open, {{-I, -I, -I}, {I, I, I}}, false},
};

#undef I

static struct csg_vec3 random_point(const struct csg_box *bounds)
{
    double p[3];
    const double *lo = components(&bounds->lo), *hi = components(&bounds->hi);
    for (int i = 0; i < 3; i++) {
        const double a = isfinite(lo[i]) ? lo[i] : -10, b = isfinite(hi[i]) ? hi[i] : 10;
        p[i] = random_between(a - 0.1 * (b - a), b + 0.1 * (b - a));
    }
    return csg_vec3(p[0], p[1], p[2]);
}

static void check_members(const struct row *row, const struct csg_shape *shape,
                          const struct csg_map *map)
{
    struct csg_box bounds = csg_box_map(&shape->frame, &shape->bounds);
    size_t num_inside = 0;
    for (int i = 0; i < NUM_POINTS; i++) {
        const struct csg_vec3 p = random_point(&row->bounds), q = csg_map_point(map, p);
        const double field = row->field(p.x, p.y, p.z);
        if (fabs(field) < 1e-7)
            continue;
        num_inside += field < 0;
        CHECK(csg_shape_contains(shape, q) == (field < 0), "%s(%s) at %g %g %g: %g", row->kind,
              row->args, p.x, p.y, p.z, field);
        CHECK(field > 0 || (q.x > bounds.lo.x && q.y > bounds.lo.y && q.z > bounds.lo.z &&
                            q.x < bounds.hi.x && q.y < bounds.hi.y && q.z < bounds.hi.z),
              "%s(%s): %g %g %g is out of bounds", row->kind, row->args, p.x, p.y, p.z);
    }
    CHECK(num_inside > NUM_POINTS / 50, "%s(%s)", row->kind, row->args);
}

static void check_samples(const struct row *row, const struct csg_shape *shape)
{
    struct csg_vec3 points[24];
    const size_t num = csg_shape_sample(shape, points, 24);
    CHECK(num == (shape->has_quadric ? 24 : 0), "%s(%s): %d samples", row->kind, row->args,
          (int)num);
    for (size_t i = 0; i < num; i++) {
        const double slope = csg_length(csg_quadric_gradient(&shape->quadric, points[i]));
        const double off = csg_quadric_value(&shape->quadric, points[i]) / slope;
        CHECK(fabs(off) < 1e-12, "%s(%s): %g", row->kind, row->args, off);
    }
}

static void check_row(const struct row *row)
{
    /* Mirrored, sheared and scaled. */
    const struct csg_map map = {{{2, 0.5, 0, 3}, {0, 0, -1, 5}, {0.25, 3, 0.5, -7}}};
    struct csg_shape shape;
    struct messages messages;
    const enum csg_read_result result =
        read_solid(row->kind, row->args, CSGCAST_FACETS_AUTO, &shape, &messages);
    CHECK(result == CSG_READ_OK, "%s(%s): %s", row->kind, row->args, messages.last);
    if (result == CSG_READ_OK) {
        CHECK(same_box(&shape.bounds, &row->bounds), "%s(%s)", row->kind, row->args);
        CHECK(shape.convex == row->convex && !shape.facetted, "%s(%s)", row->kind, row->args);
        check_members(row, &shape, &csg_map_identity);
        check_samples(row, &shape);
        CHECK(csg_shape_map(&shape, &map), "%s(%s)", row->kind, row->args);
        check_members(row, &shape, &map);
        check_samples(row, &shape);
    }
    csg_shape_finish(&shape);
}

/* ---- nothing and errors ------------------------------------------------------------------- */

static const struct {
    const char *kind, *args;
    enum csg_read_result result;
} others[] = {
    {"cube", "size=0", CSG_READ_EMPTY},
    {"cube", "size=[1,-2,3]", CSG_READ_EMPTY},
    {"cube", "size=[1,nan,3]", CSG_READ_EMPTY},
    {"cube", "size=inf", CSG_READ_EMPTY},
    {"sphere", "r=0", CSG_READ_EMPTY},
    {"sphere", "r=-1", CSG_READ_EMPTY},
    {"sphere", "r=nan", CSG_READ_EMPTY},
    {"sphere", "d=inf", CSG_READ_EMPTY},
    {"cylinder", "h=0", CSG_READ_EMPTY},
    {"cylinder", "h=-3", CSG_READ_EMPTY},
    {"cylinder", "h=nan", CSG_READ_EMPTY},
    {"cylinder", "h=inf center=1", CSG_READ_EMPTY},
    {"cylinder", "r1=0 r2=0", CSG_READ_EMPTY},
    {"cylinder", "r1=-1 r2=2", CSG_READ_EMPTY},
    {"cylinder", "r1=nan r2=2", CSG_READ_EMPTY},
    {"cylinder", "r1=1 r2=inf", CSG_READ_EMPTY},
    {"ellipsoid", "r=[1,2]", CSG_READ_ERROR},
    {"ellipsoid", "r=[1,0,2]", CSG_READ_ERROR},
    {"ellipsoid", "r=-1", CSG_READ_ERROR},
    {"ellipsoid", "d=nan", CSG_READ_ERROR},
    {"ellipsoid", "r=x", CSG_READ_ERROR},
    {"tetrahedron", "", CSG_READ_ERROR},
    {"tetrahedron", "points=[[0,0,0],[1,0,0],[0,1,0]]", CSG_READ_ERROR},
    {"tetrahedron", "points=[[0,0,0],[1,0,0],[0,1,0],[1,1,0]]", CSG_READ_ERROR},
    {"tetrahedron", "points=[[0,0,0],[1,0,0],[1,0,0],[1,1,1]]", CSG_READ_ERROR},
    {"tetrahedron", "points=[[0,0,0],[1,0,0],[0,1,0],[0,0,inf]]", CSG_READ_ERROR},
    {"halfspace", "normal=[0,0,0]", CSG_READ_ERROR},
    {"halfspace", "normal=3", CSG_READ_ERROR},
    {"halfspace", "offset=[1]", CSG_READ_ERROR},
    {"halfspace", "offset=1 point=[0,0,0]", CSG_READ_ERROR},
    {"hyperboloid", "r=0", CSG_READ_ERROR},
    {"hyperboloid", "c=-1", CSG_READ_ERROR},
    {"hyperboloid", "sheets=3", CSG_READ_ERROR},
    {"hyperboloid", "sheets=2 c=2 h=2", CSG_READ_ERROR},
    {"paraboloid", "h=0", CSG_READ_ERROR},
    {"paraboloid", "h=-2 saddle=1", CSG_READ_ERROR},
    {"paraboloid", "r=[1,2,3]", CSG_READ_ERROR},
};

static void check_others(void)
{
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        struct csg_shape shape;
        struct messages messages;
        const enum csg_read_result result =
            read_solid(others[i].kind, others[i].args, CSGCAST_FACETS_AUTO, &shape, &messages);
        const bool has_place = strncmp(messages.last, "test:3:5: ", 10) == 0;
        CHECK(result == others[i].result, "%s(%s): %s", others[i].kind, others[i].args,
              messages.last);
        CHECK(result == CSG_READ_ERROR ? messages.num == 1 && has_place : messages.num == 0,
              "%s(%s): %s", others[i].kind, others[i].args, messages.last);
        csg_shape_finish(&shape);
    }
}

/* ---- extremes ------------------------------------------------------------------------------ */

/* Discs, needles, cones of all slopes: the surface is found, and found within its planes. */
static void check_slender(void)
{
    for (double h = 1e-6; h < 1e7; h *= 10) {
        for (double r2 = 0; r2 <= 2; r2 = r2 > 0 ? r2 * 10 : 1e-9) {
            char args[80];
            struct csg_shape shape;
            struct messages messages;
            struct csg_vec3 points[24];
            snprintf(args, sizeof args, "h=%g r1=1 r2=%.17g center=1", h, r2);
            CHECK(read_solid("cylinder", args, CSGCAST_FACETS_AUTO, &shape, &messages) ==
                      CSG_READ_OK,
                  "%s", args);
            const size_t num = csg_shape_sample(&shape, points, 24);
            CHECK(num == 24, "%s: %d samples", args, (int)num);
            for (size_t i = 0; i < num; i++) {
                const double expected = 1 + (r2 - 1) * (points[i].z / h + 0.5);
                const double found = hypot(points[i].x, points[i].y);
                CHECK(fabs(points[i].z) <= h / 2 && fabs(found - expected) < 1e-14, "%s: %g", args,
                      found - expected);
            }
            csg_shape_finish(&shape);
        }
    }
}

/* Straight-line code takes half of a paired solid's planes for exits. */
static void check_paired(void)
{
    static const struct {
        struct csg_vec3 normal;
        bool paired;
    } planes[] = {{{1, 0, 0}, false}, {{-1, 0, 0}, true},   {{0, 3, 4}, false},
                  {{0, 1, 0}, false}, {{0, -3, -4}, false}, {{0, -1, 1e-5}, false},
                  {{0, -1, 0}, false}};
    struct csg_shape shape = {0};
    for (size_t i = 0; i < sizeof planes / sizeof *planes; i++) {
        csg_shape_add_plane(&shape, planes[i].normal, 1);
        CHECK(csg_shape_is_paired(&shape) == planes[i].paired, "%zu planes", i + 1);
    }
    csg_shape_finish(&shape);
}

int main(void)
{
    bool has_kind[CSG_NUM_KINDS] = {false};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        check_row(&rows[i]);
        has_kind[csg_solid_find(rows[i].kind, strlen(rows[i].kind))] = true;
    }
    for (int kind = 0; kind < CSG_NUM_KINDS; kind++)
        CHECK(has_kind[kind] || strcmp(csg_solids[kind]->name, "quadric") == 0, "%s has no row",
              csg_solids[kind]->name);
    check_others();
    check_slender();
    check_paired();
    return num_failed > 0;
}
