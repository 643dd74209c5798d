/* SPDX-License-Identifier: MIT */
/*
 * paraboloid(r = [rx, ry], c = 1, h, saddle = false): everything above
 *     z = c (x^2/rx^2 + y^2/ry^2), a bowl, or with saddle
 *     z = c (x^2/rx^2 - y^2/ry^2).
 * h cuts at z <= h, and a saddle at |x| <= rx and |y| <= ry as well.
 * Canonical forms: x^2 + y^2 = z and x^2 - y^2 = z.
 */
#include "solids/checked.h"
#include "solids/solid.h"

struct measures {
    double r[2], c, h; /* h infinite: unbounded */
    bool saddle;
};

static bool read_measures(const struct csg_args *args, struct measures *m, double *rounding)
{
    *m = (struct measures){{1, 1}, 1, INFINITY, false};
    if (!csg_checked_lengths(args, "r", 2, m->r, rounding) ||
        !csg_checked_positive(args, "c", &m->c, rounding) ||
        !csg_checked_number(args, "h", &m->h, rounding))
        return false;
    m->saddle = csg_args_bool(args, "saddle");
    const double lowest = m->saddle ? -m->c : 0;
    if (!(m->h > lowest)) {
        csg_args_error(args, "nothing is left: h is %g, the surface begins at z = %g", m->h,
                       lowest);
        return false;
    }
    return true;
}

/* Half the width along x of what h leaves: at its middle a bowl's cut is widest, a saddle's at
 * |y| = ry, where z = c (x^2/rx^2 - 1). */
static double widening(const struct measures *m)
{
    return m->saddle ? fmin(1, sqrt(1 + m->h / m->c)) : sqrt(m->h / m->c);
}

static void fill_bounds(struct csg_shape *shape, const struct measures *m)
{
    const double x = m->r[0] * widening(m), y = m->r[1] * (m->saddle ? 1 : widening(m));
    shape->bounds = csg_box_all;
    if (isfinite(m->h))
        shape->bounds = (struct csg_box){{-x, -y, m->saddle ? -m->c : 0}, {x, y, m->h}};
    else if (!m->saddle)
        shape->bounds.lo.z = 0;
    shape->written = shape->bounds;
}

static bool add_cuts(struct csg_shape *shape, const struct measures *m)
{
    if (!isfinite(m->h))
        return true;
    if (!csg_shape_add_plane(shape, csg_vec3(0, 0, 1), m->h))
        return false;
    return !m->saddle || (csg_shape_add_plane(shape, csg_vec3(-1, 0, 0), m->r[0]) &&
                          csg_shape_add_plane(shape, csg_vec3(1, 0, 0), m->r[0]) &&
                          csg_shape_add_plane(shape, csg_vec3(0, -1, 0), m->r[1]) &&
                          csg_shape_add_plane(shape, csg_vec3(0, 1, 0), m->r[1]));
}

static enum csg_read_result read(const struct csg_args *args, struct csg_shape *shape)
{
    struct measures m;
    if (!read_measures(args, &m, &shape->rounding))
        return CSG_READ_ERROR;
    shape->has_quadric = true;
    shape->convex = !m.saddle;
    shape->quadric = (struct csg_quadric){
        .diag = {1, m.saddle ? -1 : 1, 0, 0},
        .linear = -0.5,
        .to_canon = csg_map_scaling(csg_vec3(1 / m.r[0], 1 / m.r[1], 1 / m.c))};
    fill_bounds(shape, &m);
    if (!add_cuts(shape, &m))
        return csg_log_memory(args->log), CSG_READ_ERROR;
    return CSG_READ_OK;
}

const struct csg_solid_ops csg_solid_paraboloid = {
    .name = "paraboloid",
    .parameters = "r c h saddle",
    .read = read,
};
