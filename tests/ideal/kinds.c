/* SPDX-License-Identifier: MIT */
#include "kinds.h"

#include <math.h>

const char *const kind_names[NUM_KINDS] = {
    "cube",      "sphere",      "cylinder", "frustum",    "cone",   "ellipsoid", "tetrahedron",
    "halfspace", "hyperboloid", "sheets",   "paraboloid", "saddle", "quadric",   "polygon",
};

/* Text and construction of one kind, both about the origin, flat at z = 0 and below it. */
struct kind_ops {
    void (*put)(struct text *text, double s, double h, enum text_digits digits);
    void (*ideal)(struct ideal_solid *solid, double s, double h);
};

static void number(struct text *text, const char *name, double value, enum text_digits digits)
{
    text_put(text, "%s = ", name);
    text_number(text, value, digits);
}

static void vector(struct text *text, const char *name, double x, double y, double z,
                   enum text_digits digits)
{
    text_put(text, "%s = ", name);
    text_vector(text, x, y, z, digits);
}

static void put_moved(struct text *text, double z, bool mirrored, enum text_digits digits)
{
    const struct map map = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, mirrored ? -1 : 1, z}}};
    map_put(text, &map, digits);
}

static void slab(struct ideal_solid *solid, double lo, double hi)
{
    ideal_solid_add(solid, ideal_plane(0, 0, 1, hi));
    ideal_solid_add(solid, ideal_plane(0, 0, -1, -lo));
}

static void put_below(struct text *text)
{
    text_put(text, "halfspace(normal = [0, 0, 1], offset = 0);");
}

/* ---- cube ---- */

static void put_cube(struct text *text, double s, double h, enum text_digits digits)
{
    const struct map map = {{{1, 0, 0, -s}, {0, 1, 0, -s}, {0, 0, 1, -h}}};
    map_put(text, &map, digits);
    text_put(text, "cube(");
    vector(text, "size", 2 * s, 2 * s, h, digits);
    text_put(text, ", center = false);");
}

static void ideal_cube(struct ideal_solid *solid, double s, double h)
{
    slab(solid, -h, 0);
    for (int side = -1; side <= 1; side += 2) {
        ideal_solid_add(solid, ideal_plane(side, 0, 0, s));
        ideal_solid_add(solid, ideal_plane(0, side, 0, s));
    }
}

/* ---- sphere and ellipsoid, cut ---- */

static void put_sphere(struct text *text, double s, double h, enum text_digits digits)
{
    (void)h;
    text_put(text, "intersection() { ");
    put_moved(text, -s / 2, false, digits);
    text_put(text, "sphere(");
    number(text, "r", s, digits);
    text_put(text, "); ");
    put_below(text);
    text_put(text, " }");
}

static void ideal_sphere(struct ideal_solid *solid, double s, double h)
{
    (void)h;
    ideal_solid_add(solid, ideal_plane(0, 0, 1, 0));
    ideal_solid_add(solid, ideal_quadric(ideal_vec(0, 0, -s / 2), 1, 1, 1, -(real)s * s));
}

static void put_ellipsoid(struct text *text, double s, double h, enum text_digits digits)
{
    text_put(text, "intersection() { ");
    put_moved(text, -h / 4, false, digits);
    text_put(text, "ellipsoid(");
    vector(text, "r", s, 0.75 * s, h, digits);
    text_put(text, "); ");
    put_below(text);
    text_put(text, " }");
}

static void ideal_ellipsoid(struct ideal_solid *solid, double s, double h)
{
    const real x = s, y = 0.75L * s, z = h;
    ideal_solid_add(solid, ideal_plane(0, 0, 1, 0));
    ideal_solid_add(
        solid, ideal_quadric(ideal_vec(0, 0, -h / 4), 1 / (x * x), 1 / (y * y), 1 / (z * z), -1));
}

/* ---- cylinder, frustum and cone ---- */

static void put_rings(struct text *text, double h, double r1, double r2, const char *facets,
                      enum text_digits digits)
{
    put_moved(text, -h, false, digits);
    text_put(text, "cylinder(%s, $fa = 12, $fs = 2, ", facets);
    number(text, "h", h, digits);
    number(text, ", r1", r1, digits);
    number(text, ", r2", r2, digits);
    text_put(text, ", center = false);");
}

static void ideal_rings(struct ideal_solid *solid, double h, double r1, double r2)
{
    /* x^2 + y^2 <= (r2 + slope z)^2 */
    const real slope = ((real)r2 - r1) / h;
    struct ideal_form form =
        ideal_quadric(ideal_vec(0, 0, 0), 1, 1, -slope * slope, -(real)r2 * r2);
    form.q[2][3] = form.q[3][2] = -slope * r2;
    slab(solid, -h, 0);
    ideal_solid_add(solid, form);
}

static void put_cylinder(struct text *text, double s, double h, enum text_digits digits)
{
    put_rings(text, h, s, s, "$fn = 0", digits);
}

static void ideal_cylinder(struct ideal_solid *solid, double s, double h)
{
    ideal_rings(solid, h, s, s);
}

static void put_frustum(struct text *text, double s, double h, enum text_digits digits)
{
    put_rings(text, h, s, s / 2, "$fn = 0", digits);
}

static void ideal_frustum(struct ideal_solid *solid, double s, double h)
{
    ideal_rings(solid, h, s, s / 2);
}

static void put_cone(struct text *text, double s, double h, enum text_digits digits)
{
    put_rings(text, h, 0, s, "$fn = 0", digits);
}

static void ideal_cone(struct ideal_solid *solid, double s, double h)
{
    ideal_rings(solid, h, 0, s);
}

/* ---- polyhedra ---- */

static void put_tetrahedron(struct text *text, double s, double h, enum text_digits digits)
{
    const double points[4][3] = {{-s, -s, 0}, {s, -s, 0}, {0, s, 0}, {0, 0, -h}};
    text_put(text, "tetrahedron(points = [");
    for (int i = 0; i < 4; i++) {
        text_put(text, i ? ", " : "");
        text_vector(text, points[i][0], points[i][1], points[i][2], digits);
    }
    text_put(text, "]);");
}

/* Sides through the apex (0, 0, -h) and the edges of the triangle. */
static void ideal_tetrahedron(struct ideal_solid *solid, double s, double h)
{
    const real S = s, H = h;
    ideal_solid_add(solid, ideal_plane(0, 0, 1, 0));
    ideal_solid_add(solid, ideal_plane(0, -H, -S, S * H));
    for (int side = -1; side <= 1; side += 2) /* through (side s, -s, 0) and (0, s, 0) */
        ideal_solid_add(solid, ideal_plane(2 * side * H, H, -S, S * H));
}

static const double walls[3][3] = {{1, 0.25, -0.5}, {-0.5, 1, 0.25}, {-0.75, -1, 0}};

static void put_halfspace(struct text *text, double s, double h, enum text_digits digits)
{
    text_put(text, "intersection() { ");
    put_below(text);
    text_put(text, " halfspace(normal = [0, 0, -1], ");
    number(text, "offset", h, digits);
    text_put(text, "); ");
    for (int i = 0; i < 3; i++) {
        const double *n = walls[i], length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        text_put(text, "halfspace(");
        vector(text, "normal", n[0], n[1], n[2], digits);
        number(text, ", offset", s / length, digits);
        text_put(text, "); ");
    }
    text_put(text, "}");
}

static void ideal_halfspace(struct ideal_solid *solid, double s, double h)
{
    slab(solid, -h, 0);
    for (int i = 0; i < 3; i++)
        ideal_solid_add(solid, ideal_plane(walls[i][0], walls[i][1], walls[i][2], s));
}

static void put_polygon(struct text *text, double s, double h, enum text_digits digits)
{
    put_rings(text, h, s, s, "$fn = 6", digits);
}

static void ideal_polygon(struct ideal_solid *solid, double s, double h)
{
    const real root = sqrtl(3);
    slab(solid, -h, 0);
    for (int side = -1; side <= 1; side += 2) {
        ideal_solid_add(solid, ideal_plane(0, side, 0, s * root / 2));
        ideal_solid_add(solid, ideal_plane(side * root, 1, 0, s * root));
        ideal_solid_add(solid, ideal_plane(side * root, -1, 0, s * root));
    }
}

/* ---- the other quadrics ---- */

static void put_hyperboloid(struct text *text, double s, double h, enum text_digits digits)
{
    put_moved(text, 0, true, digits);
    text_put(text, "hyperboloid(");
    number(text, "r", s / 2, digits);
    number(text, ", c", h / 2, digits);
    number(text, ", h", h, digits);
    text_put(text, ");");
}

static void ideal_hyperboloid(struct ideal_solid *solid, double s, double h)
{
    const real r = s / 2, c = h / 2;
    slab(solid, -h, 0);
    ideal_solid_add(solid,
                    ideal_quadric(ideal_vec(0, 0, 0), 1 / (r * r), 1 / (r * r), -1 / (c * c), -1));
}

/* Both bowls of two sheets, cut in the middle of the lower and above the tip of the upper one. */
static void put_sheets(struct text *text, double s, double h, enum text_digits digits)
{
    put_moved(text, -h / 2, false, digits);
    text_put(text, "hyperboloid(");
    number(text, "r", s / 4, digits);
    number(text, ", c", h / 8, digits);
    number(text, ", h", h, digits);
    text_put(text, ", center = true, sheets = 2);");
}

static void ideal_sheets(struct ideal_solid *solid, double s, double h)
{
    const real r = s / 4, c = h / 8;
    slab(solid, -h, 0);
    ideal_solid_add(
        solid, ideal_quadric(ideal_vec(0, 0, -h / 2), 1 / (r * r), 1 / (r * r), -1 / (c * c), 1));
}

static void put_paraboloid(struct text *text, double s, double h, enum text_digits digits)
{
    put_moved(text, -h, false, digits);
    text_put(text, "paraboloid(");
    number(text, "r", s, digits);
    number(text, ", c", h, digits);
    number(text, ", h", h, digits);
    text_put(text, ");");
}

/* z + h >= h (x^2 +- y^2) / s^2 */
static struct ideal_form bowl(double s, double h, double lift, real yy)
{
    const real k = (real)h / ((real)s * s);
    struct ideal_form form = ideal_quadric(ideal_vec(0, 0, 0), k, yy * k, 0, -(real)lift);
    form.q[2][3] = form.q[3][2] = -0.5L;
    return form;
}

static void ideal_paraboloid(struct ideal_solid *solid, double s, double h)
{
    ideal_solid_add(solid, ideal_plane(0, 0, 1, 0));
    ideal_solid_add(solid, bowl(s, h, h, 1));
}

static void put_saddle(struct text *text, double s, double h, enum text_digits digits)
{
    put_moved(text, -h, false, digits);
    text_put(text, "paraboloid(");
    number(text, "r", s, digits);
    number(text, ", c", h / 2, digits);
    number(text, ", h", h, digits);
    text_put(text, ", saddle = true);");
}

static void ideal_saddle(struct ideal_solid *solid, double s, double h)
{
    ideal_solid_add(solid, ideal_plane(0, 0, 1, 0));
    for (int side = -1; side <= 1; side += 2) {
        ideal_solid_add(solid, ideal_plane(side, 0, 0, s));
        ideal_solid_add(solid, ideal_plane(0, side, 0, s));
    }
    ideal_solid_add(solid, bowl(s, h / 2, h, -1));
}

/* An elliptic hyperboloid of one sheet, its waist in the middle. */
static void put_quadric(struct text *text, double s, double h, enum text_digits digits)
{
    const double a = 1 / (s * s), c = 2 / (h * h);
    text_put(text, "intersection() { ");
    put_moved(text, -h / 2, false, digits);
    text_put(text, "quadric(coefficients = [");
    text_number(text, 2 * a, digits);
    text_put(text, ", 0, 0, 0, ");
    text_number(text, 4 * a, digits);
    text_put(text, ", 0, 0, ");
    text_number(text, -c, digits);
    text_put(text, ", 0, -1]); ");
    put_below(text);
    text_put(text, " halfspace(normal = [0, 0, -1], ");
    number(text, "offset", h, digits);
    text_put(text, "); }");
}

static void ideal_general(struct ideal_solid *solid, double s, double h)
{
    const real a = 1 / ((real)s * s), c = 2 / ((real)h * h);
    slab(solid, -h, 0);
    ideal_solid_add(solid, ideal_quadric(ideal_vec(0, 0, -h / 2), 2 * a, 4 * a, -c, -1));
}

static const struct kind_ops ops[NUM_KINDS] = {
    [KIND_CUBE] = {put_cube, ideal_cube},
    [KIND_SPHERE] = {put_sphere, ideal_sphere},
    [KIND_CYLINDER] = {put_cylinder, ideal_cylinder},
    [KIND_FRUSTUM] = {put_frustum, ideal_frustum},
    [KIND_CONE] = {put_cone, ideal_cone},
    [KIND_ELLIPSOID] = {put_ellipsoid, ideal_ellipsoid},
    [KIND_TETRAHEDRON] = {put_tetrahedron, ideal_tetrahedron},
    [KIND_HALFSPACE] = {put_halfspace, ideal_halfspace},
    [KIND_HYPERBOLOID] = {put_hyperboloid, ideal_hyperboloid},
    [KIND_SHEETS] = {put_sheets, ideal_sheets},
    [KIND_PARABOLOID] = {put_paraboloid, ideal_paraboloid},
    [KIND_SADDLE] = {put_saddle, ideal_saddle},
    [KIND_QUADRIC] = {put_quadric, ideal_general},
    [KIND_POLYGON] = {put_polygon, ideal_polygon},
};

void map_put(struct text *text, const struct map *map, enum text_digits digits)
{
    text_put(text, "multmatrix([");
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++) {
            text_put(text, j ? ", " : "[");
            text_number(text, map->m[i][j], digits);
            text_put(text, j == 3 ? "], " : "");
        }
    text_put(text, "[0, 0, 0, 1]]) ");
}

struct map map_multiply(const struct map *a, const struct map *b)
{
    struct map c;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++) {
            c.m[i][j] = j == 3 ? a->m[i][3] : 0;
            for (int k = 0; k < 3; k++)
                c.m[i][j] += a->m[i][k] * b->m[k][j];
        }
    return c;
}

void map_turn_by(struct map *map, int axis, double angle)
{
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    for (int i = 0; i < 3; i++) {
        const double a = map->m[i][j], b = map->m[i][k];
        map->m[i][j] = a * cos(angle) + b * sin(angle);
        map->m[i][k] = b * cos(angle) - a * sin(angle);
    }
}

static void put_alias(struct text *text, const struct ideal_solid *solid, enum text_digits digits)
{
    text_put(text, "intersection() {\n");
    for (int i = 0; i < solid->num; i++) {
        const real(*q)[4] = solid->forms[i].q;
        if (q[0][0] == 0 && q[1][1] == 0 && q[2][2] == 0) {
            const real x = 2 * q[0][3], y = 2 * q[1][3], z = 2 * q[2][3];
            text_put(text, "halfspace(");
            vector(text, "normal", (double)x, (double)y, (double)z, digits);
            number(text, ", offset", (double)(-q[3][3] / sqrtl(x * x + y * y + z * z)), digits);
            text_put(text, ");\n");
            continue;
        }
        text_put(text, "quadric(coefficients = [");
        for (int j = 0; j < 4; j++)
            for (int k = j; k < 4; k++) {
                text_put(text, j + k ? ", " : "");
                text_number(text, (double)q[j][k], digits);
            }
        text_put(text, "]);\n");
    }
    text_put(text, "}\n");
}

void flat_put(struct text *text, const struct flat *flat, const struct style *style)
{
    const struct map own = {
        {{1, 0, 0, flat->x}, {0, 1, 0, flat->y}, {0, 0, flat->up ? -1 : 1, flat->z}}};
    struct map product = own;
    if (style->each && style->nested)
        map_put(text, style->each, style->digits);
    else if (style->each)
        product = map_multiply(style->each, &own);
    map_put(text, &product, style->digits);
    if (flat->alias) {
        struct ideal_solid solid = {0};
        ops[flat->kind].ideal(&solid, flat->size, flat->height);
        put_alias(text, &solid, style->digits);
    } else {
        ops[flat->kind].put(text, flat->size, flat->height, style->digits);
    }
    text_put(text, "\n");
}

struct ideal_solid flat_ideal(const struct flat *flat)
{
    struct ideal_solid solid = {0};
    ops[flat->kind].ideal(&solid, flat->size, flat->height);
    ideal_solid_place(&solid, ideal_vec(flat->x, flat->y, flat->z), flat->up);
    return solid;
}
