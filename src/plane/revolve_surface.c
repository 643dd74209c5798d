/* SPDX-License-Identifier: MIT */
#include "plane/revolve_surface.h"

#include <stdlib.h>

#include "plane/triangulate.h"
#include "polyhedra/mesh.h"
#include "solids/facets.h"

/* More faces are left to rings. */
#define MAX_FACES 5000000.0

/* Corners turn from column to column; one on the axis is one point for all of them. */
struct turner {
    struct csg_mesh *mesh;
    const struct csg_drawing *drawing;
    const struct csg_figure *figure;
    const struct csg_turn *turn;
    double snap, from;
    uint32_t begin, num_corners; /* of the drawing's points */
    uint32_t num_columns;        /* of points; all round the first is also the last */
    bool all_round;
    CSG_ARRAY(uint32_t) first; /* point of each corner in the first column */
};

static bool is_on_axis(const struct turner *turner, uint32_t corner)
{
    return fabs(turner->drawing->points.data[turner->begin + corner].x) <= turner->snap;
}

static uint32_t point_of(const struct turner *turner, uint32_t corner, uint32_t column)
{
    const uint32_t at = column < turner->num_columns ? column : 0;
    return turner->first.data[corner] + (is_on_axis(turner, corner) ? 0 : at);
}

static bool add_points(struct turner *turner)
{
    const double size = fabs(turner->turn->angle);
    bool ok = true;
    for (uint32_t i = 0; i < turner->num_corners && ok; i++) {
        const struct csg_vec2 p = turner->drawing->points.data[turner->begin + i];
        const bool on_axis = is_on_axis(turner, i);
        ok = csg_array_push(&turner->first, (uint32_t)turner->mesh->points.num);
        for (uint32_t j = 0; j < (on_axis ? 1 : turner->num_columns) && ok; j++) {
            const double degrees = turner->from + size * j / turner->turn->num;
            const double x = on_axis ? 0 : p.x;
            ok = csg_mesh_add_point(turner->mesh, csg_vec3(x * csg_cos_degrees(degrees),
                                                           x * csg_sin_degrees(degrees), p.y));
        }
    }
    return ok;
}

static bool add_corner(struct turner *turner, uint32_t corner, uint32_t column)
{
    return csg_array_push(&turner->mesh->corners, point_of(turner, corner, column));
}

/* The faces that the side between two corners sweeps over. */
static bool add_side(struct turner *turner, uint32_t a, uint32_t b)
{
    const bool a_on_axis = is_on_axis(turner, a), b_on_axis = is_on_axis(turner, b);
    bool ok = true;
    for (uint32_t i = 0; i < (uint32_t)turner->turn->num && ok && !(a_on_axis && b_on_axis); i++)
        ok = add_corner(turner, a, i) && (a_on_axis || add_corner(turner, a, i + 1)) &&
             add_corner(turner, b, i + 1) && (b_on_axis || add_corner(turner, b, i)) &&
             csg_mesh_close_face(turner->mesh);
    return ok;
}

static bool add_sides(struct turner *turner)
{
    bool ok = true;
    for (uint32_t i = turner->figure->begin; i < turner->figure->end; i++) {
        const struct csg_contour *contour = &turner->drawing->contours.data[i];
        for (uint32_t j = contour->begin; j < contour->end && ok; j++) {
            const uint32_t next = j + 1 < contour->end ? j + 1 : contour->begin;
            ok = add_side(turner, j - turner->begin, next - turner->begin);
        }
    }
    return ok;
}

/* Where part of a turn begins and ends; sides run with the profile at its beginning. */
static bool add_ends(struct turner *turner)
{
    struct csg_triangles ends = {0};
    bool ok = turner->all_round || csg_figure_triangulate(turner->drawing, turner->figure, &ends);
    for (size_t i = 0; i < ends.corners.num && ok; i += 3) {
        const uint32_t *p = &ends.corners.data[i];
        const uint32_t a = p[0] - turner->begin, b = p[1] - turner->begin, c = p[2] - turner->begin;
        const uint32_t last = (uint32_t)turner->turn->num;
        ok = add_corner(turner, c, last) && add_corner(turner, b, last) &&
             add_corner(turner, a, last) && csg_mesh_close_face(turner->mesh) &&
             add_corner(turner, a, 0) && add_corner(turner, b, 0) && add_corner(turner, c, 0) &&
             csg_mesh_close_face(turner->mesh);
    }
    free(ends.corners.data);
    return ok;
}

bool csg_revolve_mesh(struct csg_mesh *mesh, struct csg_mesh_gaps *gaps,
                      const struct csg_drawing *drawing, const struct csg_profile *profile,
                      const struct csg_turn *turn, double rounding)
{
    const struct csg_figure *figure = &drawing->figures.data[drawing->figures.num - 1];
    if (figure->begin == figure->end)
        return true;
    struct turner turner = {.mesh = mesh,
                            .drawing = drawing,
                            .figure = figure,
                            .turn = turn,
                            .snap = profile->snap,
                            .from = turn->start + (turn->angle < 0 ? turn->angle : 0),
                            .begin = drawing->contours.data[figure->begin].begin,
                            .all_round = fabs(turn->angle) >= 360};
    turner.num_corners = drawing->contours.data[figure->end - 1].end - turner.begin;
    turner.num_columns = (uint32_t)turn->num + (turner.all_round ? 0 : 1);
    if ((double)turner.num_corners * turn->num > MAX_FACES ||
        turner.num_corners > CSG_TRIANGULATE_MAX_CORNERS)
        return true;
    mesh->rounding = rounding;
    mesh->is_simple = fabs(turn->angle) < 180.0 * turn->num;
    const bool ok = add_points(&turner) && add_sides(&turner) && add_ends(&turner) &&
                    csg_mesh_orient(mesh, gaps);
    free(turner.first.data);
    return ok;
}

/* Half a turn in one segment is flat, as OpenSCAD's mesh of it. */
static bool fill_flat(struct csg_shape *shape, const struct csg_mesh *mesh,
                      const struct csg_mesh_gaps *gaps)
{
    struct csg_mesh films = {0};
    const bool ok = csg_mesh_films(mesh, gaps, &films) &&
                    (films.faces.num == 0 || csg_mesh_to_shape(&films, true, shape));
    csg_mesh_finish(&films);
    return ok;
}

bool csg_revolve_surface(struct csg_shape *shape, const struct csg_drawing *drawing,
                         const struct csg_profile *profile, const struct csg_turn *turn,
                         double rounding)
{
    struct csg_mesh mesh = {0};
    struct csg_mesh_gaps gaps = {0};
    bool ok = csg_revolve_mesh(&mesh, &gaps, drawing, profile, turn, rounding);
    if (ok && gaps.num == 0 && mesh.faces.num > 0) {
        ok = csg_turn_is_flat(turn) ? fill_flat(shape, &mesh, &gaps)
                                    : csg_mesh_to_shape(&mesh, false, shape);
        shape->facetted = ok;
    }
    csg_mesh_finish(&mesh);
    return ok;
}
