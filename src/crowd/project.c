/* SPDX-License-Identifier: MIT */

/*
 * In the plane of a screen axis and forward an ellipsoid with center c and conjugate half-axes v_i
 * lies on the line x = s t, through the eye, where
 *     (c.x - s c.t)^2 = sum (v_i.x - s v_i.t)^2,   A s^2 - 2 B s + C = 0:
 * the dual conic of Sigg et al. 2006, section 3.2, and with fewer half-axes that of a disc. By
 * Lagrange's identity
 *     B^2 - A C = sum (c x v_i)^2 - sum over i < j of (v_i x v_j)^2,
 * in which nothing large cancels where A = c.t^2 - sum v_i.t^2 does not, that is before the eye.
 */

#include "crowd/project.h"

struct csg_camera csg_camera_of(const struct csg_screen *screen)
{
    const bool flat = screen->orthographic;
    const struct csg_vec3 steps[2] = {flat ? screen->origin_dx : screen->direction_dx,
                                      flat ? screen->origin_dy : screen->direction_dy};
    struct csg_camera camera = {.origin = screen->origin,
                                .forward = screen->forward,
                                .orthographic = flat,
                                .size = {screen->width, screen->height}};
    for (int i = 0; i < 2; i++) {
        const double step = csg_length(steps[i]);
        camera.axis[i] = csg_scale(1 / step, steps[i]);
        camera.scale[i] = 1 / step;
        camera.shift[i] = flat ? 0 : csg_dot(screen->direction, camera.axis[i]) / step;
        camera.lo[i] = camera.shift[i] * step;
        camera.hi[i] = camera.lo[i] + camera.size[i] * step;
        camera.lo_norm[i] = sqrt(1 + camera.lo[i] * camera.lo[i]);
        camera.hi_norm[i] = sqrt(1 + camera.hi[i] * camera.hi[i]);
    }
    return camera;
}

struct csg_seen_ball csg_camera_see(const struct csg_camera *camera, struct csg_vec3 center,
                                    double radius)
{
    const struct csg_vec3 c = csg_sub(center, camera->origin);
    return (struct csg_seen_ball){{csg_dot(c, camera->axis[0]), csg_dot(c, camera->axis[1])},
                                  csg_dot(c, camera->forward),
                                  radius};
}

bool csg_ball_crosses_picture(const struct csg_camera *camera, const struct csg_seen_ball *ball)
{
    for (int i = 0; i < 2; i++)
        if (ball->c[i] - camera->hi[i] * ball->t > ball->radius * camera->hi_norm[i] ||
            camera->lo[i] * ball->t - ball->c[i] > ball->radius * camera->lo_norm[i])
            return false;
    return true;
}

/* What is covered along both axes (tangents; parallel rays: lengths), and the least depth. */
struct reach {
    double lo[2], hi[2], near;
};

/* A point or vector in the camera's axes: x, y and t. */
struct seen {
    double c[2], t;
};

static struct seen see(const struct csg_camera *camera, const double *v)
{
    const struct csg_vec3 vector = {v[0], v[1], v[2]};
    return (struct seen){{csg_dot(vector, camera->axis[0]), csg_dot(vector, camera->axis[1])},
                         csg_dot(vector, camera->forward)};
}

static void extend(struct reach *reach, int axis, double middle, double half)
{
    const double lo = middle - half, hi = middle + half;
    reach->lo[axis] = lo < reach->lo[axis] ? lo : reach->lo[axis];
    reach->hi[axis] = hi > reach->hi[axis] ? hi : reach->hi[axis];
}

static double cross(const struct seen *a, const struct seen *b, int axis)
{
    return a->c[axis] * b->t - b->c[axis] * a->t;
}

static void extend_near(struct reach *reach, double near)
{
    reach->near = near < reach->near ? near : reach->near;
}

/* Of num half-axes: 3 an ellipsoid, 2 a disc. */
static void reach_ellipsoid(bool orthographic, const struct seen *center, const struct seen *axes,
                            int num, struct reach *reach)
{
    double depth = 0;
    for (int i = 0; i < num; i++)
        depth += axes[i].t * axes[i].t;
    extend_near(reach, center->t - sqrt(depth));
    for (int axis = 0; axis < 2; axis++) {
        double b = center->c[axis] * center->t, sum = 0, flat = 0;
        for (int i = 0; i < num; i++) {
            const double moment = cross(center, &axes[i], axis);
            b -= axes[i].c[axis] * axes[i].t;
            sum += moment * moment;
            flat += axes[i].c[axis] * axes[i].c[axis];
            for (int j = 0; j < i; j++) {
                const double area = cross(&axes[i], &axes[j], axis);
                sum -= area * area;
            }
        }
        const double a = center->t * center->t - depth;
        if (orthographic)
            extend(reach, axis, center->c[axis], sqrt(flat));
        else
            extend(reach, axis, b / a, sqrt(sum > 0 ? sum : 0) / a);
    }
}

static struct seen shifted(const struct seen *a, double s, const struct seen *by)
{
    return (struct seen){{a->c[0] + s * by->c[0], a->c[1] + s * by->c[1]}, a->t + s * by->t};
}

static void reach_discs(bool orthographic, const struct seen *center, const struct seen axes[3],
                        const double scale[2], struct reach *reach)
{
    const struct seen zero = {{0, 0}, 0};
    for (int end = 0; end < 2; end++) {
        const struct seen middle = shifted(center, end ? 1 : -1, &axes[0]);
        const struct seen disc[2] = {shifted(&zero, scale[end], &axes[1]),
                                     shifted(&zero, scale[end], &axes[2])};
        reach_ellipsoid(orthographic, &middle, disc, 2, reach);
    }
}

static void reach_box(bool orthographic, const struct seen *center, const struct seen axes[3],
                      struct reach *reach)
{
    for (int i = 0; i < 8; i++) {
        struct seen corner = shifted(center, i & 1 ? 1 : -1, &axes[0]);
        corner = shifted(&corner, i & 2 ? 1 : -1, &axes[1]);
        corner = shifted(&corner, i & 4 ? 1 : -1, &axes[2]);
        extend_near(reach, corner.t);
        for (int axis = 0; axis < 2; axis++)
            extend(reach, axis, corner.c[axis] / (orthographic ? 1 : corner.t), 0);
    }
}

/*
 * The tangents to a ball's disc around (c, t) have the slopes (c t -+ r sqrt(c^2 + t^2 - r^2)) q,
 * with q = 1 / (t^2 - r^2).
 */
static void reach_ball(bool orthographic, const struct csg_seen_ball *ball, struct reach *reach)
{
    const double r = ball->radius, q = 1 / (ball->t * ball->t - r * r);
    extend_near(reach, ball->t - r);
    for (int i = 0; i < 2; i++) {
        if (orthographic)
            extend(reach, i, ball->c[i], r);
        else
            extend(reach, i, q * ball->c[i] * ball->t,
                   q * r * sqrt(ball->c[i] * ball->c[i] + ball->t * ball->t - r * r));
    }
}

/* The pixels whose centres lie between; false: none. */
static bool pixel_range(double lo, double hi, double size, int16_t *first, int16_t *last)
{
    lo -= 0.5 + CSG_OUTLINE_MARGIN;
    hi -= 0.5 - CSG_OUTLINE_MARGIN;
    if (!(lo <= size - 1) || !(hi >= 0))
        return false;
    lo = lo > 0 ? lo : 0;
    hi = hi < size - 1 ? hi : size - 1;
    *first = (int16_t)lo;
    *first = (int16_t)(*first + (*first < lo)); /* rounded up */
    *last = (int16_t)hi;
    return *first <= *last;
}

bool csg_outline_project(const struct csg_camera *camera, enum csg_outline kind,
                         const double *numbers, const struct csg_seen_ball *ball,
                         struct csg_footprint *out)
{
    struct reach reach = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}, INFINITY};
    const struct seen center = {{ball->c[0], ball->c[1]}, ball->t};
    if (kind == CSG_OUTLINE_BALL) {
        reach_ball(camera->orthographic, ball, &reach);
    } else {
        const struct seen axes[3] = {see(camera, numbers), see(camera, numbers + 3),
                                     see(camera, numbers + 6)};
        if (kind == CSG_OUTLINE_ELLIPSOID)
            reach_ellipsoid(camera->orthographic, &center, axes, 3, &reach);
        else if (kind == CSG_OUTLINE_DISCS)
            reach_discs(camera->orthographic, &center, axes, numbers + 9, &reach);
        else
            reach_box(camera->orthographic, &center, axes, &reach);
    }
    out->near = reach.near;
    for (int i = 0; i < 2; i++)
        if (!pixel_range(reach.lo[i] * camera->scale[i] - camera->shift[i],
                         reach.hi[i] * camera->scale[i] - camera->shift[i], camera->size[i],
                         &out->lo[i], &out->hi[i]))
            return false;
    return true;
}
