/* SPDX-License-Identifier: MIT */
#include "files/svg_curve.h"

#include <math.h>

#include "solids/facets.h"

/* OpenSCAD's: points of each Bezier curve, and of an arc for each half turn and besides. */
enum { curve_points = 20, arc_points = 10, more_arc_points = 4 };

/* Coordinates are cut off to a grid later on, so they are rounded as OpenSCAD's are. */
static double quadratic(double a, double b, double c, double t)
{
    return a * pow(1 - t, 2) + b * 2 * pow(1 - t, 1) * t + c * t * t;
}

static double cubic(double a, double b, double c, double d, double t)
{
    return a * pow(1 - t, 3) + b * 3 * pow(1 - t, 2) * t + c * 3 * pow(1 - t, 1) * t * t +
           d * t * t * t;
}

void csg_svg_add_curve(struct csg_svg_paths *paths, const struct csg_vec2 *p, int degree)
{
    for (int i = 1; i <= curve_points; i++) {
        const double t = i * (1.0 / curve_points);
        if (degree == 2)
            csg_svg_add_point(paths, quadratic(p[0].x, p[1].x, p[2].x, t),
                              quadratic(p[0].y, p[1].y, p[2].y, t));
        else
            csg_svg_add_point(paths, cubic(p[0].x, p[1].x, p[2].x, p[3].x, t),
                              cubic(p[0].y, p[1].y, p[2].y, p[3].y, t));
    }
}

/* In degrees, whole ones where it is all but one. */
static double direction(double x, double y)
{
    const double degrees = atan2(y, x) * (180 / acos(-1.0)), whole = round(degrees);
    return fabs(degrees - whole) < 3e-14 ? whole : degrees;
}

/* The ellipse of an arc: its centre, half axes, and the angles at which the arc is on it. */
struct ellipse {
    double cx, cy, rx, ry, c, s, start, sweep;
};

/* SVG 1.1, F.6.5: from ends to centre. */
static struct ellipse ellipse_of(const struct csg_svg_arc *arc, struct csg_vec2 a,
                                 struct csg_vec2 b)
{
    struct ellipse e = {.rx = arc->rx,
                        .ry = arc->ry,
                        .c = csg_cos_degrees(arc->turn),
                        .s = csg_sin_degrees(arc->turn)};
    const double dx = (a.x - b.x) / 2, dy = (a.y - b.y) / 2;
    const double x = e.c * dx + e.s * dy, y = -e.s * dx + e.c * dy;
    const double d = (x * x) / (e.rx * e.rx) + (y * y) / (e.ry * e.ry);
    if (d > 1) {
        e.rx = fabs(sqrt(d) * e.rx);
        e.ry = fabs(sqrt(d) * e.ry);
    }
    const double part = e.rx * e.rx * y * y + e.ry * e.ry * x * x;
    const double rest = e.rx * e.rx * e.ry * e.ry - e.rx * e.rx * y * y - e.ry * e.ry * x * x;
    const double root = sqrt((rest < 0 ? 0 : rest) / part);
    const double k = arc->is_large == arc->is_sweep ? -root : root;
    const double cx = k * e.rx * y / e.ry, cy = k * -e.ry * x / e.rx;
    e.cx = e.c * cx - e.s * cy + (a.x + b.x) / 2;
    e.cy = e.s * cx + e.c * cy + (a.y + b.y) / 2;
    const double ux = (x - cx) / e.rx, uy = (y - cy) / e.ry;
    const double vx = (-x - cx) / e.rx, vy = (-y - cy) / e.ry;
    e.start = direction(ux, uy) - direction(1, 0);
    e.start += e.start < 0 ? 360 : 0;
    e.sweep = direction(vx, vy) - direction(ux, uy);
    e.sweep += e.sweep < 0 ? 360 : 0;
    e.sweep -= arc->is_sweep ? 0 : 360;
    return e;
}

void csg_svg_add_arc(struct csg_svg_paths *paths, const struct csg_svg_arc *arc, struct csg_vec2 a,
                     struct csg_vec2 b)
{
    const struct ellipse e = ellipse_of(arc, a, b);
    if (!isfinite(e.sweep))
        return;
    const int num = (int)(fabs(e.sweep) * arc_points / 180 + more_arc_points);
    for (int i = 0; i <= num; i++) {
        const double phi = e.start + e.sweep * i / num;
        const double c = csg_cos_degrees(phi), s = csg_sin_degrees(phi);
        const double x = e.c * c * e.rx - e.s * s * e.ry, y = e.s * c * e.rx + e.c * s * e.ry;
        csg_svg_add_point(paths, x + e.cx, y + e.cy);
    }
}
