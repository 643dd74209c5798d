/* SPDX-License-Identifier: MIT */
/*
 * hyperboloid(r = [rx, ry], c = 1, h, center = false, sheets = 1): with q = x^2/rx^2 + y^2/ry^2,
 *     one sheet    q - z^2/c^2 <= 1, its waist has the radii r,
 *     two sheets   z^2/c^2 - q >= 1, their tips are at z = +-c.
 * Both have the asymptotic cone q = z^2/c^2. h cuts z to 0..h or, with center, to -h/2..h/2.
 */
#include "solids/checked.h"
#include "solids/solid.h"

struct measures {
    double r[2], c, h; /* h infinite: unbounded */
    bool center;
    double sheets;
};

static bool read_measures(const struct csg_args *args, struct measures *m, double *rounding)
{
    *m = (struct measures){{1, 1}, 1, INFINITY, false, 1};
    if (!csg_checked_lengths(args, "r", 2, m->r, rounding) ||
        !csg_checked_positive(args, "c", &m->c, rounding) ||
        !csg_checked_positive(args, "h", &m->h, rounding) ||
        !csg_checked_number(args, "sheets", &m->sheets, NULL))
        return false;
    m->center = csg_args_bool(args, "center");
    if (m->sheets != 1 && m->sheets != 2) {
        csg_args_error(args, "sheets is %g, but must be 1 or 2", m->sheets);
        return false;
    }
    const double reach = m->center ? m->h / 2 : m->h;
    if (m->sheets == 2 && !(reach > m->c)) {
        csg_args_error(args, "nothing is left: h ends at z = %g, the sheets begin at c = %g", reach,
                       m->c);
        return false;
    }
    return true;
}

static void fill_quadric(struct csg_shape *shape, const struct measures *m)
{
    shape->has_quadric = true;
    shape->quadric = (struct csg_quadric){
        .diag = {1, 1, -1, m->sheets == 2 ? 1 : -1},
        .to_canon = csg_map_scaling(csg_vec3(1 / m->r[0], 1 / m->r[1], 1 / m->c))};
    /* Cut from 0 upwards, one of two sheets is left. */
    if (m->sheets == 2 && isfinite(m->h) && !m->center) {
        shape->convex = true;
        shape->sheet = 1;
    }
}

/* The radii at height z are r sqrt(z^2/c^2 +- 1), largest at the end that is further away. */
static bool fill_bounds(struct csg_shape *shape, const struct measures *m)
{
    shape->bounds = csg_box_all;
    if (!isfinite(m->h))
        return true;
    const double lo = m->center ? -m->h / 2 : 0, hi = m->center ? m->h / 2 : m->h;
    const double t = hi / m->c;
    const double widening = m->sheets == 1 ? hypot(t, 1) : sqrt((t - 1) * (t + 1));
    const double x = m->r[0] * widening, y = m->r[1] * widening;
    const double bottom = m->sheets == 2 && !m->center ? m->c : lo;
    shape->bounds = (struct csg_box){{-x, -y, bottom}, {x, y, hi}};
    return csg_shape_add_plane(shape, csg_vec3(0, 0, -1), -lo) &&
           csg_shape_add_plane(shape, csg_vec3(0, 0, 1), hi);
}

static enum csg_read_result read(const struct csg_args *args, struct csg_shape *shape)
{
    struct measures measures;
    if (!read_measures(args, &measures, &shape->rounding))
        return CSG_READ_ERROR;
    fill_quadric(shape, &measures);
    if (!fill_bounds(shape, &measures))
        return csg_log_memory(args->log), CSG_READ_ERROR;
    shape->written = shape->bounds;
    return CSG_READ_OK;
}

const struct csg_solid_ops csg_solid_hyperboloid = {
    .name = "hyperboloid",
    .parameters = "r c h center sheets",
    .read = read,
};
