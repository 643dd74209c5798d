/* SPDX-License-Identifier: MIT */
#include "plane/prism.h"

bool csg_lift_add_caps(const struct csg_lift *lift, struct csg_shape *shape)
{
    return csg_shape_add_plane(shape, csg_vec3(0, 0, -1), -lift->z0) &&
           csg_shape_add_plane(shape, csg_vec3(0, 0, 1), lift->z1);
}

struct csg_box csg_lift_box(const struct csg_lift *lift, const struct csg_box *section)
{
    struct csg_box box = csg_box_empty;
    csg_box_extend(&box, csg_vec3(lift->s0 * section->lo.x, lift->s0 * section->lo.y, lift->z0));
    csg_box_extend(&box, csg_vec3(lift->s0 * section->hi.x, lift->s0 * section->hi.y, lift->z0));
    csg_box_extend(&box, csg_vec3(lift->s1 * section->lo.x, lift->s1 * section->lo.y, lift->z1));
    csg_box_extend(&box, csg_vec3(lift->s1 * section->hi.x, lift->s1 * section->hi.y, lift->z1));
    return box;
}

/*
 * The line n.p = d becomes n.p = d s(z), s(z) = s0 + (s1 - s0) (z - z0) / (z1 - z0): the plane
 *     n.x x + n.y y - d g z <= d (s0 - g z0),   g = (s1 - s0) / (z1 - z0).
 */
static bool add_line(struct csg_shape *shape, const struct csg_line *line,
                     const struct csg_lift *lift)
{
    const double g = (lift->s1 - lift->s0) / (lift->z1 - lift->z0);
    return csg_shape_add_plane(shape, csg_vec3(line->normal.x, line->normal.y, -line->offset * g),
                               line->offset * (lift->s0 - g * lift->z0));
}

bool csg_prism_fill(struct csg_shape *shape, const struct csg_pieces *pieces,
                    const struct csg_piece *piece, const struct csg_lift *lift)
{
    struct csg_box section = csg_box_empty;
    bool ok = csg_lift_add_caps(lift, shape);
    for (uint32_t i = 0; i < piece->num_lines && ok; i++)
        ok = add_line(shape, &pieces->lines.data[piece->first_line + i], lift);
    for (uint32_t i = 0; i < piece->num_corners; i++) {
        const struct csg_vec2 corner = pieces->corners.data[piece->first_corner + i];
        csg_box_extend(&section, csg_vec3(corner.x, corner.y, 0));
    }
    shape->convex = true;
    shape->bounds = shape->written = csg_lift_box(lift, &section);
    return ok;
}

/* Half the extent of an ellipse along x and y. */
static struct csg_box disc_box(const struct csg_map *disc)
{
    const double x = hypot(disc->m[0][0], disc->m[0][1]), y = hypot(disc->m[1][0], disc->m[1][1]);
    return (struct csg_box){{disc->m[0][3] - x, disc->m[1][3] - y, 0},
                            {disc->m[0][3] + x, disc->m[1][3] + y, 0}};
}

/*
 * The disc is c + A u, |u| <= 1; at height z it is s(z) (c + A u). With S the larger of s0 and s1
 * canonical p.z = s(z) / S and p.xy = A^-1 ((x, y) / S - p.z c), all at most 1 in size on the
 * solid: x^2 + y^2 = z^2, or 1 where s0 == s1. See also solids/cylinder.
 */
static void fill_quadric(struct csg_quadric *quadric, const struct csg_map *inverse,
                         const struct csg_map *disc, const struct csg_lift *lift)
{
    const double largest = fmax(lift->s0, lift->s1);
    struct csg_map *to = &quadric->to_canon;
    quadric->diag[0] = quadric->diag[1] = 1;
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            to->m[i][j] = inverse->m[i][j] / largest;
    if (lift->s0 == lift->s1) {
        quadric->diag[3] = -1;
        to->m[0][3] = inverse->m[0][3];
        to->m[1][3] = inverse->m[1][3];
        to->m[2][2] = sqrt(fabs(csg_map_determinant(inverse))) / largest;
        return;
    }
    const double rise = (lift->s1 - lift->s0) / (lift->z1 - lift->z0) / largest;
    const double middle = 0.5 * (lift->s0 + lift->s1) / largest;
    quadric->diag[2] = -1;
    to->m[2][2] = rise;
    to->m[2][3] = middle - rise * 0.5 * (lift->z0 + lift->z1);
    for (int i = 0; i < 2; i++) {
        const double c = inverse->m[i][0] * disc->m[0][3] + inverse->m[i][1] * disc->m[1][3];
        to->m[i][2] = -c * to->m[2][2];
        to->m[i][3] = -c * to->m[2][3];
    }
}

bool csg_disc_fill(struct csg_shape *shape, const struct csg_map *disc, const struct csg_lift *lift)
{
    const struct csg_box section = disc_box(disc);
    struct csg_map inverse;
    if (!csg_map_invert(disc, &inverse))
        return true; /* discs are regular */
    shape->has_quadric = true;
    shape->convex = true;
    shape->sheet = lift->s0 == lift->s1 ? 0 : 1;
    fill_quadric(&shape->quadric, &inverse, disc, lift);
    shape->bounds = shape->written = csg_lift_box(lift, &section);
    return csg_lift_add_caps(lift, shape);
}
