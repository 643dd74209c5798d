/* SPDX-License-Identifier: MIT */
#include "pack/screen.h"

/* Keys are centred on the scene's depth where the scene is seen from outside and its depths differ
 * by no more than this factor; else k = -1/t keeps the same relative precision at all depths. */
#define MAX_DEPTH_RATIO 4.0

/* The same where solids without bounds may be anywhere: far behind the finite ones keys get coarse
 * again, so only where it pays, with the eye more than about 60 radii away. */
#define MAX_DEPTH_RATIO_UNBOUNDED 1.03

/* Part of a pixel by which bounds grow: float rounding of the projection in the vertex stage. */
#define RECT_MARGIN 0.01

static void init_rays(struct csg_screen *screen, const struct csgcast_frustum *frustum)
{
    const struct csg_vec3 eye = csg_vec3_of(frustum->eye), forward = csg_vec3_of(frustum->forward);
    const struct csg_vec3 right = csg_scale(frustum->half_width, csg_vec3_of(frustum->right));
    const struct csg_vec3 up = csg_scale(frustum->half_height, csg_vec3_of(frustum->up));
    const struct csg_vec3 corner = csg_scale(-1, csg_add(right, up));
    const struct csg_vec3 dx = csg_scale(2.0 / screen->width, right);
    const struct csg_vec3 dy = csg_scale(2.0 / screen->height, up);
    const struct csg_vec3 zero = {0, 0, 0};
    const bool flat = screen->orthographic;
    screen->forward = forward;
    screen->origin = flat ? csg_add(eye, corner) : eye;
    screen->origin_dx = flat ? dx : zero;
    screen->origin_dy = flat ? dy : zero;
    screen->direction = flat ? forward : csg_add(forward, corner);
    screen->direction_dx = flat ? zero : dx;
    screen->direction_dy = flat ? zero : dy;
}

static double depth_of(const struct csg_screen *screen, struct csg_vec3 p)
{
    /* In both projections the origin differs from the eye only across the view axis. */
    return csg_dot(csg_sub(p, screen->origin), screen->forward);
}

static void depth_range(const struct csg_screen *screen, const struct csg_box *box, double range[2])
{
    range[0] = INFINITY;
    range[1] = -INFINITY;
    for (int i = 0; i < 8; i++) {
        const double t = depth_of(screen, csg_box_corner(box, i));
        range[0] = fmin(range[0], t);
        range[1] = fmax(range[1], t);
    }
}

/* Depth buffer values: affine in k over a finite range; else a map of all keys to 0..1, finest at
 * range. */
static void init_depth(struct csg_screen *screen, const double range[2], bool centred, bool bounded)
{
    const double typical = isfinite(range[1]) && range[1] > 0 ? range[1] : 1;
    if (!centred) {
        screen->depth[0] = (float)(screen->orthographic ? 1 / typical : typical / screen->b);
        screen->depth[3] = screen->orthographic ? 2 : 1;
        return;
    }
    const double k0 = csg_screen_key(screen, range[0]), k1 = csg_screen_key(screen, range[1]);
    const double margin = 0.01 * (k1 - k0);
    screen->depth[0] = (float)(1 / (k1 - k0 + 2 * margin));
    screen->depth[1] = (float)((margin - k0) / (k1 - k0 + 2 * margin));
    screen->depth[3] = bounded ? 0 : 2;
}

void csg_screen_init(struct csg_screen *screen, const struct csgcast_frustum *frustum, int width,
                     int height, const struct csg_box *focus, bool bounded)
{
    *screen = (struct csg_screen){
        .width = width, .height = height, .orthographic = frustum->orthographic};
    init_rays(screen, frustum);
    double range[2] = {INFINITY, -INFINITY};
    const bool known = !csg_box_is_empty(focus) && csg_box_is_finite(focus);
    if (known)
        depth_range(screen, focus, range);
    const double middle = known ? 0.5 * (range[0] + range[1]) : 0;
    if (screen->orthographic) {
        screen->a = middle;
        screen->b = screen->scale = 1;
        screen->k_far = CSG_KEY_MAX;
        init_depth(screen, range, known && range[1] > range[0], bounded);
        return;
    }
    const double ratio = bounded ? MAX_DEPTH_RATIO : MAX_DEPTH_RATIO_UNBOUNDED;
    const bool centred = range[1] > range[0] && range[0] > 0 && range[1] < ratio * range[0];
    screen->a = centred ? middle : 0;
    screen->b = centred ? middle * middle : 1;
    screen->scale = centred ? middle : 1;
    screen->k_far = screen->a;
    init_depth(screen, range, centred, bounded);
}

void csg_screen_use_textbook(struct csg_screen *screen, const struct csg_box *focus, bool bounded)
{
    double range[2] = {INFINITY, -INFINITY};
    const bool known = !csg_box_is_empty(focus) && csg_box_is_finite(focus);
    if (known)
        depth_range(screen, focus, range);
    if (!screen->orthographic)
        range[0] = fmax(range[0], 0);
    screen->textbook = true;
    screen->a = 0;
    screen->b = screen->scale = 1;
    screen->k_far = CSG_KEY_MAX;
    const bool seen = known && range[1] > range[0];
    const double size = seen ? range[1] - range[0] : 1, margin = 0.01 * size;
    screen->depth[0] = (float)(1 / (size + 2 * margin));
    screen->depth[1] = seen ? (float)((margin - range[0]) / (size + 2 * margin)) : 0;
    screen->depth[3] = seen && bounded ? 0 : 2;
}

void csg_screen_set_near(struct csg_screen *screen, double t)
{
    const bool starts = !screen->orthographic && !screen->textbook && t > 0;
    screen->near = starts ? t : 0;
    screen->depth[2] =
        starts ? (float)fmax(csg_screen_key(screen, t), -CSG_PLANE_KEY_MAX) : -CSG_KEY_MAX;
}

double csg_screen_key(const struct csg_screen *screen, double t)
{
    if (screen->textbook)
        return t;
    return screen->orthographic ? t - screen->a : screen->a - screen->b / t;
}

bool csg_screen_eye_is_in(const struct csg_screen *screen, const struct csg_box *box)
{
    const struct csg_vec3 eye = screen->origin, lo = box->lo, hi = box->hi;
    const double near = screen->near; /* on the surface is inside of the box */
    if (screen->orthographic)
        return !csg_box_is_empty(box) && !csg_box_is_finite(box);
    return lo.x - near <= eye.x && eye.x <= hi.x + near && lo.y - near <= eye.y &&
           eye.y <= hi.y + near && lo.z - near <= eye.z && eye.z <= hi.z + near;
}

/* Continuous pixel coordinates of a point; false at or behind the eye plane. */
static bool project(const struct csg_screen *screen, struct csg_vec3 p, double pixel[2])
{
    const double t = depth_of(screen, p);
    struct csg_vec3 across = csg_sub(p, screen->origin), dx, dy;
    if (screen->orthographic) {
        dx = screen->origin_dx;
        dy = screen->origin_dy;
    } else {
        if (!(t > 0))
            return false;
        across = csg_sub(csg_scale(1 / t, across), screen->direction);
        dx = screen->direction_dx;
        dy = screen->direction_dy;
    }
    pixel[0] = csg_dot(across, dx) / csg_dot(dx, dx);
    pixel[1] = csg_dot(across, dy) / csg_dot(dy, dy);
    return true;
}

static struct csg_rect clip_rect(const struct csg_screen *screen, const double lo[2],
                                 const double hi[2])
{
    return (struct csg_rect){
        {fmax(lo[0] - RECT_MARGIN, 0), fmax(lo[1] - RECT_MARGIN, 0)},
        {fmin(hi[0] + RECT_MARGIN, screen->width), fmin(hi[1] + RECT_MARGIN, screen->height)}};
}

/* dot(n, p - from) of the points p of a mapped box, as the frame's coordinates have it: at their
 * origin, and its steps along their axes. */
struct height {
    double base;
    struct csg_vec3 step;
};

static struct height height_of(const struct csg_map *frame, struct csg_vec3 n, struct csg_vec3 from)
{
    const struct csg_vec3 origin = csg_map_column(frame, 3);
    return (struct height){csg_dot(n, csg_sub(origin, from)), csg_map_transposed(frame, n)};
}

static double height_at(const struct height *height, struct csg_vec3 p)
{
    return height->base + csg_dot(height->step, p);
}

struct csg_rect csg_screen_rect(const struct csg_screen *screen, const struct csg_map *frame,
                                const struct csg_box *box)
{
    const struct csg_rect all = {{0, 0}, {screen->width, screen->height}};
    const struct csg_rect nothing = {{1, 1}, {0, 0}};
    const bool flat = screen->orthographic;
    const struct csg_vec3 steps[2] = {flat ? screen->origin_dx : screen->direction_dx,
                                      flat ? screen->origin_dy : screen->direction_dy};
    const struct csg_vec3 first = flat ? csg_vec3(0, 0, 0) : screen->direction;
    double lo[2] = {INFINITY, INFINITY}, hi[2] = {-INFINITY, -INFINITY};
    struct height depth, across[2];
    if (!csg_box_is_finite(box))
        return all;
    depth = height_of(frame, screen->forward, screen->origin);
    for (int j = 0; j < 2; j++)
        across[j] = height_of(frame, steps[j], screen->origin);
    int num_behind = 0;
    for (int i = 0; i < 8; i++) {
        const struct csg_vec3 corner = csg_box_corner(box, i);
        const double t = flat ? 1 : height_at(&depth, corner);
        if (!(t > 0)) {
            num_behind++;
            continue;
        }
        for (int j = 0; j < 2; j++) {
            const double at = height_at(&across[j], corner) / t - csg_dot(first, steps[j]);
            lo[j] = csg_least(lo[j], at);
            hi[j] = csg_most(hi[j], at);
        }
    }
    for (int j = 0; j < 2; j++) {
        lo[j] /= csg_dot(steps[j], steps[j]);
        hi[j] /= csg_dot(steps[j], steps[j]);
    }
    if (num_behind)
        return num_behind == 8 ? nothing : all;
    return clip_rect(screen, lo, hi);
}

struct csg_pixel csg_screen_pixel(const struct csg_screen *screen, struct csg_vec3 point)
{
    double pixel[2];
    if (!project(screen, point, pixel) || !isfinite(pixel[0]) || !isfinite(pixel[1]))
        return (struct csg_pixel){floor(0.5 * screen->width), floor(0.5 * screen->height)};
    /* Whole pixels: the shader's offsets from them are exact in float. */
    return (struct csg_pixel){floor(fmin(fmax(pixel[0], 0), screen->width)),
                              floor(fmin(fmax(pixel[1], 0), screen->height))};
}

/*
 * c / slope as a plane's texel. Where rays run along the plane, or the eye is in it, slope is
 * nothing and the sign of c alone decides: the terms are scaled together, so that the sum keeps its
 * sign and is far beyond any crossing in view.
 */
static void put_plane(const struct csg_screen *screen, const double c[3], double slope,
                      double texel[4])
{
    const double size = fabs(c[0]) + screen->width * fabs(c[1]) + screen->height * fabs(c[2]);
    const double sign = slope < 0 ? -1 : 1;
    const bool steep = size > CSG_PLANE_KEY_MAX * fabs(slope);
    const double scale = steep ? sign * CSG_PLANE_KEY_MAX / size : size > 0 ? 1 / slope : 0;
    for (int i = 0; i < 3; i++)
        texel[i] = scale * c[i];
}

/*
 * With g(k) = n.P - offset P_w + k (n.W - offset W_w) <= 0 inside, the crossing is at
 * k = -g(0) / g'.
 */
void csg_screen_plane(const struct csg_screen *screen, struct csg_pixel at,
                      const struct csg_plane *plane, bool flipped, double texel[4])
{
    const struct csg_vec3 n = plane->normal;
    const double ox = csg_dot(n, screen->origin_dx), oy = csg_dot(n, screen->origin_dy);
    const double dx = csg_dot(n, screen->direction_dx), dy = csg_dot(n, screen->direction_dy);
    const double height = csg_dot(n, screen->origin) - plane->offset + at.x * ox + at.y * oy;
    const double along = csg_dot(n, screen->direction) + at.x * dx + at.y * dy;
    const double slope = screen->orthographic ? along : -height;
    if (screen->orthographic) {
        const double c[3] = {-(height + screen->a * along), -ox, -oy};
        put_plane(screen, c, slope, texel);
    } else {
        const double b = screen->b, c[3] = {screen->a * slope - b * along, -b * dx, -b * dy};
        put_plane(screen, c, slope, texel);
    }
    texel[3] = (slope >= 0) != flipped ? -1 : 1;
}
