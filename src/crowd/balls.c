/* SPDX-License-Identifier: MIT */
#include "crowd/balls.h"

#include "common/wide.h"
#include "pack/ball.h"

/* Balls in the camera's axes, as struct csg_seen_ball. */
struct seen {
    double c[2][CSG_BALLS_MAX], t[CSG_BALLS_MAX];
};

PART void see(const struct csg_camera *camera, const double *restrict x, const double *restrict y,
              const double *restrict z, size_t num, struct seen *restrict out)
{
    const struct csg_vec3 o = camera->origin, a = camera->axis[0], b = camera->axis[1];
    const struct csg_vec3 f = camera->forward;
    for (size_t i = 0; i < num; i++) {
        const double px = x[i] - o.x, py = y[i] - o.y, pz = z[i] - o.z;
        out->c[0][i] = px * a.x + py * a.y + pz * a.z;
        out->c[1][i] = px * b.x + py * b.y + pz * b.z;
        out->t[i] = px * f.x + py * f.y + pz * f.z;
    }
}

PART double at_most(double a, double b)
{
    return a < b ? a : b;
}

PART double at_least(double a, double b)
{
    return a > b ? a : b;
}

/* The pixels whose centres lie between, as pixel_range in project.c has them. */
PART void put_range(double lo, double hi, double size, int32_t *restrict first,
                    int32_t *restrict last)
{
    const double from = at_most(at_least(lo - (0.5 + CSG_OUTLINE_MARGIN), 0), size);
    const double to = at_least(at_most(hi - (0.5 - CSG_OUTLINE_MARGIN), size - 1), -1);
    const int32_t down = (int32_t)from, end = (int32_t)(to + 1);
    *first = down + (down < from ? 1 : 0);
    *last = end - 1;
}

/* The tangents of reach_ball in project.c. */
PART void project_axis(const struct csg_camera *camera, int axis, const struct seen *seen,
                       const double *restrict radius, size_t num,
                       struct csg_ball_prints *restrict out)
{
    const double scale = camera->scale[axis], shift = camera->shift[axis];
    const double size = camera->size[axis];
    for (size_t i = 0; i < num; i++) {
        const double c = seen->c[axis][i], t = seen->t[i], r = radius[i];
        const double far = t * t - r * r, q = 1 / far;
        const double middle = q * c * t, half = q * r * sqrt(at_least(c * c + far, 0));
        put_range((middle - half) * scale - shift, (middle + half) * scale - shift, size,
                  &out->lo[axis][i], &out->hi[axis][i]);
    }
}

PART void project_flat_axis(const struct csg_camera *camera, int axis, const struct seen *seen,
                            const double *restrict radius, size_t num,
                            struct csg_ball_prints *restrict out)
{
    const double scale = camera->scale[axis], size = camera->size[axis];
    for (size_t i = 0; i < num; i++)
        put_range((seen->c[axis][i] - radius[i]) * scale, (seen->c[axis][i] + radius[i]) * scale,
                  size, &out->lo[axis][i], &out->hi[axis][i]);
}

WIDE void project(const struct csg_camera *camera, const double *restrict x,
                  const double *restrict y, const double *restrict z, const double *restrict radius,
                  size_t num, struct csg_ball_prints *restrict out)
{
    struct seen seen;
    see(camera, x, y, z, num, &seen);
    for (int axis = 0; axis < 2; axis++)
        if (camera->orthographic)
            project_flat_axis(camera, axis, &seen, radius, num, out);
        else
            project_axis(camera, axis, &seen, radius, num, out);
    const bool flat = camera->orthographic;
    for (size_t i = 0; i < num; i++) {
        const double r = radius[i], t = seen.t[i], near = CSG_BALL_NEAR * r;
        const double square = seen.c[0][i] * seen.c[0][i] + seen.c[1][i] * seen.c[1][i] + t * t;
        out->near[i] = t - r;
        out->plain[i] = flat | ((t > CSG_BALL_FRONT * r) & (square >= near * near));
    }
}

void csg_balls_project(const struct csg_camera *camera, const double *x, const double *y,
                       const double *z, const double *radius, size_t num,
                       struct csg_ball_prints *out)
{
    project(camera, x, y, z, radius, num, out);
}
