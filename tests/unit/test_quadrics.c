/* SPDX-License-Identifier: MIT */
/* quadric(): the 17 classes, their complements and degenerate forms against the polynomial. */
#include "solid_args.h"

#include "solids/sample.h"

#define NUM_POINTS 10000
#define NUM_POSES 10

/* sum of diag[i] x_i^2 + 2 linear z + diag[3], before scaling, turning and shifting. */
static const struct quadric_class {
    const char *name;
    double diag[4], linear;
    enum csg_read_result result;
    bool convex;
    size_t num_planes;
} classes[] = {
    {"ellipsoid", {1, 1, 1, -1}, 0, CSG_READ_OK, true, 0},
    {"imaginary ellipsoid", {1, 1, 1, 1}, 0, CSG_READ_EMPTY, false, 0},
    {"hyperboloid of one sheet", {1, 1, -1, -1}, 0, CSG_READ_OK, false, 0},
    {"hyperboloid of two sheets", {1, 1, -1, 1}, 0, CSG_READ_OK, false, 0},
    {"cone", {1, 1, -1, 0}, 0, CSG_READ_OK, false, 0},
    {"imaginary cone", {1, 1, 1, 0}, 0, CSG_READ_EMPTY, false, 0},
    {"elliptic paraboloid", {1, 1, 0, 0}, -0.5, CSG_READ_OK, true, 0},
    {"hyperbolic paraboloid", {1, -1, 0, 0}, -0.5, CSG_READ_OK, false, 0},
    {"elliptic cylinder", {1, 1, 0, -1}, 0, CSG_READ_OK, true, 0},
    {"imaginary elliptic cylinder", {1, 1, 0, 1}, 0, CSG_READ_EMPTY, false, 0},
    {"hyperbolic cylinder", {1, 0, -1, 1}, 0, CSG_READ_OK, false, 0},
    {"parabolic cylinder", {1, 0, 0, 0}, -0.5, CSG_READ_OK, true, 0},
    {"intersecting planes", {1, 0, -1, 0}, 0, CSG_READ_OK, false, 0},
    {"imaginary intersecting planes", {1, 1, 0, 0}, 0, CSG_READ_EMPTY, false, 0},
    {"parallel planes", {1, 0, 0, -1}, 0, CSG_READ_OK, true, 2},
    {"imaginary parallel planes", {1, 0, 0, 1}, 0, CSG_READ_EMPTY, false, 0},
    {"coincident planes", {1, 0, 0, 0}, 0, CSG_READ_EMPTY, false, 0},
    {"outside of an ellipsoid", {-1, -1, -1, 1}, 0, CSG_READ_OK, false, 0},
    {"outside of an elliptic cylinder", {-1, -1, 0, 1}, 0, CSG_READ_OK, false, 0},
    {"outside of a cone", {-1, -1, 1, 0}, 0, CSG_READ_OK, false, 0},
    {"outside of a paraboloid", {-1, -1, 0, 0}, 0.5, CSG_READ_OK, false, 0},
    {"outside of a slab", {-1, 0, 0, 1}, 0, CSG_READ_OK, false, 0},
    {"all but a point", {-1, -1, -1, 0}, 0, CSG_READ_OK, true, 0},
    {"everything", {-1, -1, -1, -1}, 0, CSG_READ_OK, true, 0},
    {"plane", {0, 0, 0, 0}, 0.5, CSG_READ_OK, true, 1},
    {"constant below zero", {0, 0, 0, -1}, 0, CSG_READ_OK, true, 0},
    {"constant above zero", {0, 0, 0, 1}, 0, CSG_READ_EMPTY, false, 0},
};

/* A symmetric 4x4 matrix in extended precision: the coefficients are rounded once, at the end. */
struct form {
    long double q[4][4];
};

static struct form canonical(const struct quadric_class *class, const double lengths[3])
{
    struct form form = {{{0}}};
    for (int i = 0; i < 3; i++)
        form.q[i][i] = class->diag[i] / ((long double)lengths[i] * lengths[i]);
    form.q[3][3] = class->diag[3];
    form.q[2][3] = form.q[3][2] = class->linear / (long double)lengths[2];
    return form;
}

/* transpose(m) * form * m */
static struct form congruent(const struct form *form, long double m[4][4])
{
    struct form half = {{{0}}}, whole = {{{0}}};
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            for (int k = 0; k < 4; k++)
                half.q[i][j] += form->q[i][k] * m[k][j];
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            for (int k = 0; k < 4; k++)
                whole.q[i][j] += m[k][i] * half.q[k][j];
    return whole;
}

/* A random rotation (from a quaternion) of x - center. */
static void random_pose(long double m[4][4], const double center[3])
{
    long double q[4], length = 0;
    for (int i = 0; i < 4; i++) {
        q[i] = random_between(-1, 1);
        length += q[i] * q[i];
    }
    for (int i = 0; i < 4; i++)
        q[i] /= sqrtl(length);
    const long double w = q[0], x = q[1], y = q[2], z = q[3];
    const long double r[3][3] = {
        {1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
        {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
        {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
    for (int i = 0; i < 3; i++) {
        m[i][3] = 0;
        for (int j = 0; j < 3; j++) {
            m[i][j] = r[i][j];
            m[i][3] -= r[i][j] * center[j];
        }
    }
    m[3][0] = m[3][1] = m[3][2] = 0;
    m[3][3] = 1;
}

static long double value_at(const struct form *form, struct csg_vec3 p)
{
    const long double x[4] = {p.x, p.y, p.z, 1};
    long double value = 0;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            value += x[i] * form->q[i][j] * x[j];
    return value;
}

/* Size of the terms that value_at adds up: its rounding is a share of this. */
static long double size_at(const struct form *form, struct csg_vec3 p)
{
    const long double x[4] = {p.x, p.y, p.z, 1};
    long double size = 0;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            size += fabsl(x[i] * form->q[i][j] * x[j]);
    return size;
}

static void print_form(const struct form *form, bool as_matrix, char *text, size_t size)
{
    size_t at = (size_t)snprintf(text, size, as_matrix ? "matrix=[" : "coefficients=[");
    for (int i = 0; i < 4; i++) {
        at += (size_t)snprintf(text + at, size - at, as_matrix ? "[" : "");
        for (int j = as_matrix ? 0 : i; j < 4; j++)
            at += (size_t)snprintf(text + at, size - at, "%.17g,", (double)form->q[i][j]);
        at += (size_t)snprintf(text + at, size - at, as_matrix ? "]," : "");
    }
    snprintf(text + at, size - at, "]");
}

/* Members agree with the polynomial wherever its sign stands above tolerance times its terms. */
static void check_members(const char *name, const struct form *form, const struct csg_shape *shape,
                          const double center[3], double reach, long double tolerance)
{
    struct csg_box bounds = csg_box_map(&shape->frame, &shape->bounds);
    for (int i = 0; i < NUM_POINTS; i++) {
        const double scale = reach * pow(10, random_between(-2, 0));
        const struct csg_vec3 p = csg_vec3(center[0] + random_between(-scale, scale),
                                           center[1] + random_between(-scale, scale),
                                           center[2] + random_between(-scale, scale));
        const long double value = value_at(form, p);
        if (fabsl(value) <= tolerance * size_at(form, p))
            continue;
        CHECK(csg_shape_contains(shape, p) == (value < 0), "%s at %g %g %g: %Lg of %Lg", name, p.x,
              p.y, p.z, value, size_at(form, p));
        CHECK(value > 0 || (p.x >= bounds.lo.x && p.y >= bounds.lo.y && p.z >= bounds.lo.z &&
                            p.x <= bounds.hi.x && p.y <= bounds.hi.y && p.z <= bounds.hi.z),
              "%s at %g %g %g is out of bounds", name, p.x, p.y, p.z);
    }
}

static void check_surface(const char *name, const struct form *form, const struct csg_shape *shape,
                          long double tolerance)
{
    struct csg_vec3 points[24];
    const size_t num = csg_shape_sample(shape, points, 24);
    CHECK(!shape->has_quadric || num >= 12, "%s: %d samples", name, (int)num);
    for (size_t i = 0; i < num; i++) {
        const long double value = value_at(form, points[i]), size = size_at(form, points[i]);
        CHECK(fabsl(value) <= tolerance * size, "%s: sample %d is off: %Lg of %Lg", name, (int)i,
              value, size);
    }
}

static void check_pose(const struct quadric_class *class, const double lengths[3],
                       const double center[3], bool turned, long double tolerance)
{
    const struct form straight = canonical(class, lengths);
    long double pose[4][4] = {
        {1, 0, 0, -center[0]}, {0, 1, 0, -center[1]}, {0, 0, 1, -center[2]}, {0, 0, 0, 1}};
    struct csg_shape shape;
    struct messages messages;
    char text[1024];
    if (turned)
        random_pose(pose, center);
    const struct form form = congruent(&straight, pose);
    print_form(&form, turned, text, sizeof text);
    const enum csg_read_result result =
        read_solid("quadric", text, CSGCAST_FACETS_AUTO, &shape, &messages);
    CHECK(result != CSG_READ_ERROR, "%s: %s: %s", class->name, text, messages.last);
    /* Rounded coefficients may leave of a class without volume a sliver, but no more. */
    if (!turned)
        CHECK(result == class->result, "%s: %s", class->name, text);
    if (result == CSG_READ_OK) {
        const double reach = 4 * fmax(lengths[0], fmax(lengths[1], lengths[2]));
        if (!turned)
            CHECK(shape.convex == class->convex && shape.num_planes == class->num_planes, "%s",
                  class->name);
        check_members(class->name, &form, &shape, center, reach, tolerance);
        check_surface(class->name, &form, &shape, tolerance);
    }
    csg_shape_finish(&shape);
}

/* Bounds of a turned ellipsoid touch it: along the gradient's axes the surface is reached. */
static void check_tight(void)
{
    struct csg_shape shape;
    struct messages messages;
    const char *text = "coefficients=[1,0.5,0,-1, 2,0,-3, 4,0.5,1]";
    CHECK(read_solid("quadric", text, CSGCAST_FACETS_AUTO, &shape, &messages) == CSG_READ_OK, "%s",
          messages.last);
    struct csg_box found = csg_box_empty;
    for (int i = 0; i < 400000; i++) {
        const struct csg_vec3 p = csg_vec3(random_between(shape.bounds.lo.x, shape.bounds.hi.x),
                                           random_between(shape.bounds.lo.y, shape.bounds.hi.y),
                                           random_between(shape.bounds.lo.z, shape.bounds.hi.z));
        if (csg_shape_contains(&shape, p))
            csg_box_extend(&found, p);
    }
    const struct csg_vec3 size = csg_sub(shape.bounds.hi, shape.bounds.lo);
    const struct csg_vec3 lost = csg_sub(size, csg_sub(found.hi, found.lo));
    CHECK(lost.x < 0.02 * size.x && lost.y < 0.02 * size.y && lost.z < 0.02 * size.z,
          "%g %g %g of %g %g %g", lost.x, lost.y, lost.z, size.x, size.y, size.z);
    csg_shape_finish(&shape);
}

static const char *const errors[] = {
    "",
    "coefficients=[1,2,3]",
    "coefficients=3",
    "coefficients=[1,0,0,0,1,0,0,1,0,nan]",
    "coefficients=[1,0,0,0,1,0,0,inf,0,-1]",
    "coefficients=[1,0,0,0,1,0,0,x,0,-1]",
    "matrix=[[1,0,0,0],[0,1,0,0],[0,0,1,0]]",
    "matrix=[[1,0,0,0],[0,1,0,0],[0,0,1],[0,0,0,-1]]",
    "matrix=[[1,0.5,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,-1]]",
    "coefficients=[1,0,0,0,1,0,0,1,0,-1] matrix=[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,-1]]",
};

static void check_errors(void)
{
    for (size_t i = 0; i < sizeof errors / sizeof *errors; i++) {
        struct csg_shape shape;
        struct messages messages;
        CHECK(read_solid("quadric", errors[i], CSGCAST_FACETS_AUTO, &shape, &messages) ==
                  CSG_READ_ERROR,
              "%s", errors[i]);
        CHECK(messages.num == 1 && strncmp(messages.last, "test:3:5: quadric: ", 19) == 0, "%s: %s",
              errors[i], messages.last);
        csg_shape_finish(&shape);
    }
}

/* The normal form of f and of -f is the same up to sign: carrier/carrier.c relies on it. */
static void check_complement(const struct quadric_class *class)
{
    const double lengths[3] = {1, 2, 3};
    struct form form = canonical(class, lengths);
    struct csg_shape shapes[2];
    for (int i = 0; i < 2; i++) {
        char text[1024];
        struct messages messages;
        print_form(&form, false, text, sizeof text);
        read_solid("quadric", text, CSGCAST_FACETS_AUTO, &shapes[i], &messages);
        for (int j = 0; j < 16; j++)
            form.q[j / 4][j % 4] *= -1;
    }
    const struct csg_quadric *a = &shapes[0].quadric, *b = &shapes[1].quadric;
    const bool is_ambiguous = a->diag[0] + a->diag[1] + a->diag[2] == 0 && a->diag[3] == 0;
    if (shapes[0].has_quadric && shapes[1].has_quadric && !is_ambiguous)
        for (int i = 0; i < 4; i++)
            CHECK(a->diag[i] == -b->diag[i], "%s: diag[%d]", class->name, i);
    csg_shape_finish(&shapes[0]);
    csg_shape_finish(&shapes[1]);
}

/* Coefficients of any size, most of them absurd: never a crash, and a shape of numbers or none. */
static void check_extremes(void)
{
    for (int i = 0; i < 20000; i++) {
        char text[1024];
        struct form form = {{{0}}};
        struct csg_shape shape;
        struct messages messages;
        const double exponent = random_between(0, 308);
        for (int j = 0; j < 4; j++)
            for (int k = j; k < 4; k++)
                if (random_unit() < 0.6)
                    form.q[j][k] =
                        random_between(-1, 1) * pow(10, random_between(-exponent, exponent));
        print_form(&form, false, text, sizeof text);
        const enum csg_read_result result =
            read_solid("quadric", text, CSGCAST_FACETS_AUTO, &shape, &messages);
        bool finite = true;
        for (int j = 0; result == CSG_READ_OK && shape.has_quadric && j < 12; j++)
            finite &= isfinite(shape.quadric.to_canon.m[j / 4][j % 4]) != 0;
        for (size_t j = 0; j < shape.num_planes; j++)
            finite &= isfinite(csg_length(shape.planes[j].normal) + shape.planes[j].offset) != 0;
        CHECK(result != CSG_READ_ERROR && finite, "%s", text);
        CHECK(result != CSG_READ_OK ||
                  !isnan(shape.bounds.lo.x + shape.bounds.lo.y + shape.bounds.lo.z),
              "%s", text);
        csg_shape_finish(&shape);
    }
}

int main(void)
{
    static const double origin[3] = {0, 0, 0}, away[3] = {3, -4, 5}, unit[3] = {1, 1, 1};
    static const double long_x[3] = {1e4, 1, 1}, long_z[3] = {1, 1, 1e4}, flat[3] = {1e4, 1e4, 1};
    for (size_t i = 0; i < sizeof classes / sizeof *classes; i++) {
        check_pose(&classes[i], unit, origin, false, 1e-12L);
        check_pose(&classes[i], unit, away, false, 1e-12L);
        for (int j = 0; j < NUM_POSES; j++) {
            const double lengths[3] = {random_between(0.5, 5), random_between(0.5, 5),
                                       random_between(0.5, 5)};
            check_pose(&classes[i], lengths, away, true, 1e-10L);
        }
        /* Eigenvalues in a ratio of 1e8. */
        check_pose(&classes[i], long_x, origin, false, 1e-12L);
        check_pose(&classes[i], long_x, origin, true, 1e-7L);
        check_pose(&classes[i], long_z, origin, true, 1e-7L);
        check_pose(&classes[i], flat, origin, true, 1e-7L);
        check_complement(&classes[i]);
    }
    check_tight();
    check_errors();
    check_extremes();
    return num_failed > 0;
}
