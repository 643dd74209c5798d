/* SPDX-License-Identifier: MIT */
#include "pack/precision.h"

#include <stdio.h>

#include "carrier/carrier.h"

/* Rounding of a key to float, and of the three terms that it is the sum of. */
#define KEY_ROUNDING (1.5 / (1 << 24))

/* What is finer than this many times the error of a key needs better keys. */
#define MIN_STEPS 64.0

/* Radians that a normal may be off, with the error of a key as its bound says: the errors that are
 * measured are a tenth of that, and docs/numerics.md promises 0.05 degrees. */
#define MAX_NORMAL_ERROR 1.5e-3

/* The same, as part of the picture's width, for silhouettes: measured, one ray in 10^5 is wrong. */
#define MAX_EDGE_ERROR 2e-4

/* Where depths differ more than this, some terms are much larger than the keys of what is seen. */
#define MAX_RATIO 8.0

void csg_depth_range(const struct csg_screen *screen, const struct csg_box *box, double range[2])
{
    const struct csg_vec3 middle = csg_box_middle(box);
    const struct csg_vec3 half = csg_scale(0.5, csg_sub(box->hi, box->lo)), f = screen->forward;
    const double t = csg_dot(csg_sub(middle, screen->origin), f);
    const double reach = fabs(half.x * f.x) + fabs(half.y * f.y) + fabs(half.z * f.z);
    range[0] = t - reach;
    range[1] = t + reach;
    if (!csg_box_is_finite(box)) {
        range[0] = -INFINITY;
        range[1] = INFINITY;
    }
    if (!screen->orthographic)
        range[0] = fmax(range[0], 0);
}

/* Width of the picture in scene units at depth t. */
static double width_at(const struct csg_screen *screen, double t)
{
    const double size = fmin(screen->width, screen->height);
    return screen->orthographic ? size * csg_length(screen->origin_dx)
                                : size * csg_length(screen->direction_dx) * t;
}

/* Error of a key as a length, for surfaces that are not seen at a flat angle and across the view
 * axis at most that far from the pixel that terms are counted from. */
static double resolution(const struct csg_screen *screen, const double range[2], double across)
{
    across = fmin(across, width_at(screen, range[1]));
    if (screen->orthographic || screen->a != 0) {
        const double near = fabs(csg_screen_key(screen, range[0]));
        const double far = fabs(csg_screen_key(screen, range[1]));
        const double stretch = screen->orthographic ? 1 : range[1] * range[1] / screen->b;
        return KEY_ROUNDING * (fmax(near, far) * stretch + across);
    }
    return KEY_ROUNDING * (range[1] + across);
}

static bool is_too_fine(struct csg_precision *precision, int reason, uint32_t leaf, double size,
                        double least)
{
    if (!(size < least) || precision->precise)
        return false;
    precision->precise = true;
    precision->reason = (uint8_t)reason;
    precision->leaf = leaf;
    precision->size = size;
    return true;
}

static void judge_geometry(const struct csg_screen *screen, const struct csg_sharpness *sharp,
                           const double range[2], double across, struct csg_precision *precision)
{
    const double error = resolution(screen, range, across);
    const double width = width_at(screen, fmax(range[0], range[1] / MAX_RATIO));
    const double least[CSG_NUM_FINE] = {[CSG_FINE_THICKNESS] = MIN_STEPS * error,
                                        [CSG_FINE_CURVATURE] = error / MAX_NORMAL_ERROR,
                                        [CSG_FINE_ANGLE] = error / MAX_EDGE_ERROR / width,
                                        [CSG_FINE_GAP] = MIN_STEPS * error};
    precision->resolved = error;
    for (int i = 0; i < CSG_NUM_FINE; i++)
        is_too_fine(precision, i, sharp->leaf[i], sharp->least[i], least[i]);
    precision->zoomed = width < error / MAX_EDGE_ERROR;
    is_too_fine(precision, CSG_REASON_VIEW, sharp->leaf[0], width, error / MAX_EDGE_ERROR);
}

double csg_precision_need(const struct csg_sharpness *sharp)
{
    const double *least = sharp->least;
    return fmin(fmin(least[CSG_FINE_THICKNESS], least[CSG_FINE_GAP]) / MIN_STEPS,
                least[CSG_FINE_CURVATURE] * MAX_NORMAL_ERROR);
}

bool csg_precision_suffices(const struct csg_screen *screen, const double range[2], double need)
{
    const double error = resolution(screen, range, INFINITY);
    const double width = width_at(screen, fmax(range[0], range[1] / MAX_RATIO));
    return need >= error && width >= error / MAX_EDGE_ERROR;
}

/*
 * k = -1/t of a plane at the height h is (n.d) / h. The error of its terms is relative to the
 * largest of them, and a surface far away has small keys: relative to its depth that is an error of
 * KEY_ROUNDING t (|n.d0| + x |n.dx| + y |n.dy|) / |h|.
 */
static double plane_error(const struct csg_screen *screen, const struct csg_plane *plane,
                          const double range[2])
{
    const struct csg_vec3 n = plane->normal;
    const double height = csg_dot(n, screen->origin) - plane->offset;
    const double x = 0.5 * screen->width * csg_dot(n, screen->direction_dx);
    const double y = 0.5 * screen->height * csg_dot(n, screen->direction_dy);
    const double along = csg_dot(n, screen->direction) + x + y; /* in the picture's middle */
    const double spread = fabs(x) + fabs(y);
    const double most = fmax(along / -height, 0) + spread / fabs(height); /* of -k in the picture */
    const double least = along / -height - spread / fabs(height);
    if (height == 0 || most < 1 / range[1] || least > 1 / range[0])
        return 0;
    const double t = fmin(range[1], 1 / fmax(least, 0));
    return KEY_ROUNDING / 1.5 * t * (fabs(along) + spread) / fabs(height);
}

static void judge_depths(const struct csg_screen *screen, const struct csgcast_scene *scene,
                         uint32_t leaf, struct csg_precision *precision)
{
    const struct csg_box box = scene->leaves[leaf].box;
    struct csg_map inverse = csg_map_identity;
    double range[2];
    bool flipped;
    csg_depth_range(screen, &box, range);
    if (!(range[1] > 0))
        return;
    csg_map_invert(&scene->leaves[leaf].shape.frame, &inverse);
    for (uint32_t i = 0; i < csg_num_faces(scene, leaf); i++) {
        const struct csg_plane plane = csg_carrier_of_face(scene, leaf, i, &inverse, &flipped);
        const double error = plane_error(screen, &plane, range);
        if (is_too_fine(precision, CSG_REASON_DEPTH, leaf, CSG_MAX_DEPTH_ERROR, error))
            precision->resolved = error;
    }
}

static void judge_near(const struct csg_screen *screen, const struct csgcast_scene *scene,
                       const struct csg_object *object, struct csg_precision *precision)
{
    const struct csg_node *nodes = scene->trees[object->layer].data;
    for (uint32_t i = object->begin; i < object->end && !precision->precise; i++)
        if (nodes[i].op == CSG_LEAF && !nodes[i].spare)
            judge_depths(screen, scene, nodes[i].leaf, precision);
}

/* How far the object's points are from the middle of the scene. */
static double across(const struct csg_box *box, const struct csg_box *focus)
{
    if (!csg_box_is_finite(box))
        return INFINITY;
    const struct csg_vec3 middle = csg_box_middle(focus);
    const struct csg_vec3 lo = csg_sub(box->lo, middle), hi = csg_sub(box->hi, middle);
    return csg_length(csg_vec3(fmax(fabs(lo.x), fabs(hi.x)), fmax(fabs(lo.y), fabs(hi.y)),
                               fmax(fabs(lo.z), fabs(hi.z))));
}

struct csg_precision csg_precision_of(const struct csg_screen *screen,
                                      const struct csgcast_scene *scene, size_t index,
                                      const struct csg_box *focus)
{
    struct csg_precision precision = {.precise = false};
    const struct csg_object *object = &scene->objects->data[index];
    double range[2];
    csg_depth_range(screen, csg_box_is_finite(&object->box) ? &object->box : focus, range);
    if (range[1] >= range[0] && (screen->orthographic || range[1] > 0)) {
        const struct csg_sharpness sharp = csg_sharpness_of(scene, index);
        judge_geometry(screen, &sharp, range, across(&object->box, focus), &precision);
    }
    csg_depth_range(screen, &object->box, range);
    if (!screen->orthographic && screen->a == 0 && range[1] > MAX_RATIO * range[0])
        judge_near(screen, scene, object, &precision);
    return precision;
}

/* ---- what the shader computes, twin of shaders/solids/quadric.glsl ----------------------------
 */

#define DEFINE_CROSSINGS(name, real, root_of)                                                      \
    static bool name(const double texels[CSG_QUADRIC_TEXELS][4], double px, double py,             \
                     double keys[2])                                                               \
    {                                                                                              \
        real t[CSG_QUADRIC_TEXELS][4];                                                             \
        for (int i = 0; i < CSG_QUADRIC_TEXELS; i++)                                               \
            for (int j = 0; j < 4; j++)                                                            \
                t[i][j] = (real)texels[i][j];                                                      \
        const real dx = (real)px, dy = (real)py;                                                   \
        const int code = (int)t[0][3];                                                             \
        const real x = t[1][0] + (t[1][1] * dx + t[1][2] * dy);                                    \
        const real y = t[2][0] + (t[1][1] * dy - t[1][2] * dx);                                    \
        const real xx = code & CSG_QUADRIC_X_MINUS ? -x : code & CSG_QUADRIC_X_PLUS ? x : 0;       \
        const real h = (t[1][3] + y * (t[2][2] + y * t[2][3])) + x * (t[2][1] + xx);               \
        const real m = t[0][0] + (t[0][1] * dx + t[0][2] * dy);                                    \
        const real root = root_of(h > 0 ? h : 0);                                                  \
        const real c =                                                                             \
            t[3][0] + x * (t[3][1] + t[4][0] * x + t[4][1] * y) + y * (t[3][2] + t[4][2] * y);     \
        const real q = m < 0 ? root - m : -root - m;                                               \
        const bool stiff = code & CSG_QUADRIC_STIFF;                                               \
        keys[0] = (double)(stiff ? q * t[3][3] : m - root);                                        \
        keys[1] = (double)(stiff ? c / (q != 0 ? q : (real)1e-30) : m + root);                     \
        return h >= 0;                                                                             \
    }

DEFINE_CROSSINGS(crossings_in_float, float, sqrtf)
DEFINE_CROSSINGS(crossings_in_double, double, sqrt)

/* Samples in each direction. */
#define NUM_SAMPLES 9

/* Error of the depth that belongs to a key, relative; 0 outside of what is seen. */
static double relative_error(const struct csg_screen *screen, double key, double error,
                             const double depth[2])
{
    if (screen->orthographic)
        return key + screen->a >= depth[0] && key + screen->a <= depth[1]
                   ? error / fmax(depth[1] - depth[0], fabs(key + screen->a))
                   : 0;
    const double t = screen->b / (screen->a - key);
    return t > 0 && t >= depth[0] && t <= depth[1] ? error * t / screen->b : 0;
}

double csg_quadric_error(const struct csg_screen *screen, struct csg_pixel at,
                         const struct csg_rect *rect, const double depth[2],
                         const double texels[CSG_QUADRIC_TEXELS][4])
{
    double largest = 0;
    for (int i = 0; i < NUM_SAMPLES * NUM_SAMPLES; i++) {
        double rough[2], right[2];
        const double u = (i % NUM_SAMPLES + 0.5) / NUM_SAMPLES;
        const double v = ((double)(i / NUM_SAMPLES) + 0.5) / NUM_SAMPLES;
        const double x = floor(rect->lo[0] + u * (rect->hi[0] - rect->lo[0])) + 0.5 - at.x;
        const double y = floor(rect->lo[1] + v * (rect->hi[1] - rect->lo[1])) + 0.5 - at.y;
        if (!crossings_in_double(texels, x, y, right) || !crossings_in_float(texels, x, y, rough))
            continue;
        for (int j = 0; j < 2; j++)
            largest =
                fmax(largest, relative_error(screen, right[j], fabs(rough[j] - right[j]), depth));
    }
    return largest;
}

/* ---- for people -------------------------------------------------------------------------------
 */

void csg_precision_explain(const struct csg_precision *precision, char *text, size_t size)
{
    static const char *const formats[CSG_NUM_REASONS] = {
        [CSG_REASON_THICKNESS] = "%.2g thick, float resolves %.1g there",
        [CSG_REASON_CURVATURE] = "radius of curvature %.2g, float resolves %.1g there",
        [CSG_REASON_ANGLE] = "planes at %.2g radians, float resolves %.1g there",
        [CSG_REASON_GAP] = "surfaces %.2g apart, float resolves %.1g there",
        [CSG_REASON_VIEW] = "the picture shows a width of %.2g, float resolves %.1g there",
    };
    if (precision->reason < CSG_NUM_FINE || precision->reason == CSG_REASON_VIEW)
        snprintf(text, size, formats[precision->reason], precision->size, precision->resolved);
    else if (precision->reason == CSG_REASON_DEPTH || precision->reason == CSG_REASON_STIFF)
        snprintf(text, size, "%s, depths in float would be off by %.1g",
                 precision->reason == CSG_REASON_DEPTH ? "the eye is close to a face"
                                                       : "rays nearly along its surface",
                 precision->resolved);
    else
        snprintf(text, size, "%s",
                 precision->reason == CSG_REASON_ASKED ? "asked for"
                                                       : "shares a surface with one that needs it");
}
