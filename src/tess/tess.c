/* SPDX-License-Identifier: MIT */
/*
 * csgcast-tess.so: GLU's tesselator. libtess2, which OpenSCAD 2021.01 cuts faces with, is its
 * descendant and finds the same triangles.
 */
#include "tess/module.h"

#include <math.h>

#include <GL/glu.h>

/* What GLU tells so far. */
struct sweep {
    uint32_t (*triangles)[3];
    size_t room, num_corners;
    bool failed;
};

static void add_corner(void *vertex, void *user)
{
    struct sweep *sweep = user;
    const size_t i = sweep->num_corners++;
    if (i < 3 * sweep->room && vertex)
        sweep->triangles[i / 3][i % 3] = (uint32_t)(uintptr_t)vertex - 1;
    else
        sweep->failed = true;
}

/* With it GLU makes single triangles, neither fans nor strips. */
static void set_edge_flag(GLboolean flag, void *user)
{
    (void)flag;
    (void)user;
}

/* Corners at one place become the first of them; a crossing is none of the corners. */
static void combine(const GLdouble point[3], void *vertices[4], const GLfloat weights[4],
                    void **vertex, void *user)
{
    (void)point;
    (void)weights;
    *vertex = vertices[0];
    if (vertices[2])
        ((struct sweep *)user)->failed = true;
}

static void fail(GLenum error, void *user)
{
    (void)error;
    ((struct sweep *)user)->failed = true;
}

static void run(GLUtesselator *tess, const float (*points)[2], uint32_t num, struct sweep *sweep)
{
    gluTessCallback(tess, GLU_TESS_VERTEX_DATA, (_GLUfuncptr)add_corner);
    gluTessCallback(tess, GLU_TESS_EDGE_FLAG_DATA, (_GLUfuncptr)set_edge_flag);
    gluTessCallback(tess, GLU_TESS_COMBINE_DATA, (_GLUfuncptr)combine);
    gluTessCallback(tess, GLU_TESS_ERROR_DATA, (_GLUfuncptr)fail);
    gluTessNormal(tess, 0, 0, 1);
    gluTessBeginPolygon(tess, sweep);
    gluTessBeginContour(tess);
    for (uint32_t i = 0; i < num; i++) {
        GLdouble point[3] = {(double)points[i][0], (double)points[i][1], 0};
        gluTessVertex(tess, point, (void *)((uintptr_t)i + 1));
    }
    gluTessEndContour(tess);
    gluTessEndPolygon(tess);
}

/* GLU hands over the last triangle first. */
static void turn_round(uint32_t (*triangles)[3], size_t num)
{
    for (size_t i = 0; i < num / 2; i++)
        for (int k = 0; k < 3; k++) {
            const uint32_t corner = triangles[i][k];
            triangles[i][k] = triangles[num - 1 - i][k];
            triangles[num - 1 - i][k] = corner;
        }
}

/* GLU does not return from others. */
static bool are_finite(const float (*points)[2], uint32_t num)
{
    bool finite = true;
    for (uint32_t i = 0; i < num; i++)
        finite = finite && isfinite(points[i][0]) && isfinite(points[i][1]);
    return finite;
}

static size_t sweep_polygon(const float (*points)[2], uint32_t num, uint32_t (*triangles)[3])
{
    struct sweep sweep = {.triangles = triangles, .room = num};
    GLUtesselator *tess = are_finite(points, num) ? gluNewTess() : NULL;
    if (!tess)
        return 0;
    run(tess, points, num, &sweep);
    gluDeleteTess(tess);
    if (sweep.failed || sweep.num_corners % 3 != 0)
        return 0;
    turn_round(triangles, sweep.num_corners / 3);
    return sweep.num_corners / 3;
}

extern const struct csg_tess_module CSG_TESS_MODULE;
__attribute__((visibility("default")))
const struct csg_tess_module CSG_TESS_MODULE = {.sweep = sweep_polygon};
