/* SPDX-License-Identifier: MIT */
#include "random_scene.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include "common/random.h"

struct writer {
    char *text;
    size_t num, capacity;
    struct random_state *random;
    const struct random_params *params;
    int leaves_left;
};

double random_between(struct random_state *random, double lo, double hi)
{
    return csg_random_between(&random->state, lo, hi);
}

static void put(struct writer *writer, const char *format, ...)
{
    char line[512];
    va_list args;
    va_start(args, format);
    const int length = vsnprintf(line, sizeof line, format, args);
    va_end(args);
    if (writer->num + (size_t)length + 1 > writer->capacity) {
        writer->capacity = 2 * writer->capacity + sizeof line;
        writer->text = realloc(writer->text, writer->capacity);
        if (!writer->text)
            abort();
    }
    for (int i = 0; i <= length; i++)
        writer->text[writer->num + (size_t)i] = line[i];
    writer->num += (size_t)length;
}

static int pick(struct writer *writer, int num)
{
    return (int)random_between(writer->random, 0, num);
}

static double number(struct writer *writer, double lo, double hi)
{
    const double value = random_between(writer->random, lo, hi);
    const int grid = writer->params->grid;
    return grid ? (floor(value * grid) + (lo >= 0 ? 1 : 0)) / grid : value;
}

static void put_solid(struct writer *writer)
{
    const double a = number(writer, 2, 9), b = number(writer, 2, 9), c = number(writer, 2, 9);
    const char *center = pick(writer, 2) ? "true" : "false";
    switch (pick(writer, writer->params->bounded ? 8 : 11)) {
    case 0:
    case 1:
        put(writer, "cube(size = [%.9g, %.9g, %.9g], center = %s);\n", a, b, c, center);
        break;
    case 2:
        put(writer, "sphere($fn = 0, $fa = 12, $fs = 2, r = %.9g);\n", a);
        break;
    case 3:
        put(writer,
            "cylinder($fn = 0, $fa = 12, $fs = 2, h = %.9g, r1 = %.9g, r2 = %.9g, "
            "center = %s);\n",
            a, b, b, center);
        break;
    case 4:
        put(writer,
            "cylinder($fn = 0, $fa = 12, $fs = 2, h = %.9g, r1 = %.9g, r2 = %.9g, "
            "center = %s);\n",
            a, b, c, center);
        break;
    case 5:
        put(writer,
            "cylinder($fn = 6, $fa = 12, $fs = 2, h = %.9g, r1 = %.9g, r2 = 0, "
            "center = %s);\n",
            a, b, center);
        break;
    case 6:
        put(writer, "ellipsoid(r = [%.9g, %.9g, %.9g]);\n", a, b, c);
        break;
    case 7:
        put(writer,
            "tetrahedron(points = [[0, 0, 0], [%.9g, 0, 1], [0, %.9g, 0], [1, 1, %.9g]]);\n", a, b,
            c);
        break;
    case 8:
        put(writer, "intersection() { cube(size = 12, center = true); quadric(coefficients = "
                    "[1, 0, 0, 0, 1, 0, 0, -1, 0, -4]); }\n");
        break;
    case 9:
        put(writer, "intersection() { cube(size = 10, center = true); quadric(coefficients = "
                    "[1, 0, 0, 0, -1, 0, 0, 0, -1, 0]); }\n");
        break;
    default:
        put(writer, "intersection() { sphere(r = 8); quadric(coefficients = "
                    "[-1, 0, 0, 0, -1, 0, 0, 1, 0, 2]); }\n");
    }
}

static void put_transform(struct writer *writer)
{
    const double x = number(writer, -6, 6), y = number(writer, -6, 6), z = number(writer, -6, 6);
    if (writer->params->grid) {
        static const char *const turns[] = {
            "1,0,0,%.9g],[0,1,0,%.9g],[0,0,1,%.9g", "0,-1,0,%.9g],[1,0,0,%.9g],[0,0,1,%.9g",
            "1,0,0,%.9g],[0,0,-1,%.9g],[0,1,0,%.9g", "-1,0,0,%.9g],[0,1,0,%.9g],[0,0,1,%.9g"};
        put(writer, "multmatrix([[");
        put(writer, turns[pick(writer, 4)], x, y, z);
        put(writer, "],[0,0,0,1]]) ");
        return;
    }
    double m[9];
    for (int i = 0; i < 9; i++)
        m[i] = random_between(writer->random, -0.7, 0.7) + (i % 4 == 0 ? 0.6 : 0);
    put(writer,
        "multmatrix([[%.9g,%.9g,%.9g,%.9g],[%.9g,%.9g,%.9g,%.9g],"
        "[%.9g,%.9g,%.9g,%.9g],[0,0,0,1]]) ",
        m[0], m[1], m[2], x, m[3], m[4], m[5], y, m[6], m[7], m[8], z);
}

/* Recursion is as deep as params->depth says. */
static void put_node(struct writer *writer, int depth)
{
    static const char *const ops[] = {"union", "difference", "intersection", "difference"};
    if (pick(writer, 2))
        put_transform(writer);
    if (depth == 0 || pick(writer, 5) == 0 || writer->leaves_left < 2) {
        writer->leaves_left--;
        put_solid(writer);
        return;
    }
    const int num = 2 + pick(writer, 2);
    put(writer, "%s() {\n", ops[pick(writer, 4)]);
    for (int i = 0; i < num; i++)
        put_node(writer, depth - 1);
    put(writer, "}\n");
}

char *random_scene(struct random_state *random, const struct random_params *params)
{
    struct writer writer = {.random = random, .params = params, .leaves_left = params->leaves};
    while (writer.leaves_left > 0)
        put_node(&writer, params->depth);
    return writer.text;
}
