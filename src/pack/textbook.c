/* SPDX-License-Identifier: MIT */
#include "pack/textbook.h"

/* p.Ap + 2 q.p + r in world space, in double. */
struct form {
    struct csg_vec3 a[3], q;
    double r;
};

static struct csg_vec3 scale_by_diag(const struct csg_quadric *quadric, struct csg_vec3 v)
{
    return csg_vec3(quadric->diag[0] * v.x, quadric->diag[1] * v.y, quadric->diag[2] * v.z);
}

/* With M, m the map to canonical space: A = M'DM, q = M'(D m + linear z), r = f(m). */
static struct form form_of(const struct csg_quadric *quadric)
{
    static const struct csg_vec3 units[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const struct csg_map *map = &quadric->to_canon;
    const struct csg_vec3 m = csg_map_point(map, csg_vec3(0, 0, 0));
    struct csg_vec3 half_gradient = scale_by_diag(quadric, m);
    half_gradient.z += quadric->linear;
    struct form form = {.q = csg_map_transposed(map, half_gradient),
                        .r = csg_quadric_value(quadric, csg_vec3(0, 0, 0))};
    for (int i = 0; i < 3; i++)
        form.a[i] =
            csg_map_transposed(map, scale_by_diag(quadric, csg_map_direction(map, units[i])));
    return form;
}

static double size_of(const struct form *form)
{
    double size = 0;
    for (int i = 0; i < 3; i++)
        size = fmax(size, csg_vec3_largest(form->a[i]));
    if (size == 0)
        size = csg_vec3_largest(form->q);
    return size > 0 ? size : 1;
}

static float to_float(double value)
{
    return (float)fmin(fmax(value, -3e38), 3e38);
}

static void put_vector(float out[3], struct csg_vec3 v)
{
    out[0] = to_float(v.x);
    out[1] = to_float(v.y);
    out[2] = to_float(v.z);
}

/* The records' writer rounds to float. */
static void put_term(double out[3], struct csg_vec3 v)
{
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
}

void csg_textbook_plane(const struct csg_plane *plane, bool flipped, double texel[4])
{
    const double sign = flipped ? -1 : 1;
    put_term(texel, csg_scale(sign, plane->normal));
    texel[3] = sign * plane->offset;
}

void csg_textbook_quadric(const struct csg_quadric *quadric, bool flipped,
                          double texels[CSG_QUADRIC_TEXELS][4])
{
    const struct form form = form_of(quadric);
    const double scale = (flipped ? -1 : 1) / size_of(&form);
    for (int i = 0; i < CSG_QUADRIC_TEXELS; i++)
        for (int j = 0; j < 4; j++)
            texels[i][j] = 0;
    put_term(texels[0], csg_scale(scale, form.a[0]));
    texels[1][0] = scale * form.a[1].y;
    texels[1][1] = scale * form.a[1].z;
    texels[1][2] = scale * form.a[2].z;
    texels[1][3] = scale * form.r;
    put_term(texels[2], csg_scale(scale, form.q));
}

void csg_textbook_normal(const struct csg_quadric *quadric, float terms[4][3])
{
    const struct form form = form_of(quadric);
    const double scale = 1 / size_of(&form);
    put_vector(terms[0], csg_scale(scale, form.q));
    for (int i = 0; i < 3; i++)
        put_vector(terms[1 + i], csg_scale(scale, form.a[i]));
}

struct csg_textbook_rays csg_textbook_rays(const struct csg_screen *screen, struct csg_pixel at)
{
    struct csg_textbook_rays rays = {.start = screen->orthographic ? -CSG_KEY_MAX : 0};
    const struct csg_vec3 origin =
        csg_add(screen->origin,
                csg_add(csg_scale(at.x, screen->origin_dx), csg_scale(at.y, screen->origin_dy)));
    const struct csg_vec3 direction =
        csg_add(screen->direction, csg_add(csg_scale(at.x, screen->direction_dx),
                                           csg_scale(at.y, screen->direction_dy)));
    put_vector(rays.origin, origin);
    put_vector(rays.origin + 3, screen->origin_dx);
    put_vector(rays.origin + 6, screen->origin_dy);
    put_vector(rays.direction, direction);
    put_vector(rays.direction + 3, screen->direction_dx);
    put_vector(rays.direction + 6, screen->direction_dy);
    return rays;
}
