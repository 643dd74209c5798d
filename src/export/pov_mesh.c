/* SPDX-License-Identifier: MIT */

/* Solids as POV-Ray's mesh2, whose inside is found by counting crossings along a fixed direction.
 */

#include "export/pov.h"
#include "mesh/surface.h"
#include "polyhedra/cell.h"

static void begin_list(struct csg_text *text, const char *name, size_t num)
{
    csg_text_open(text, name);
    csg_text_line(text, "%zu", num);
}

static void write_point(struct csg_text *text, struct csg_vec3 p)
{
    char vector[CSG_TEXT_VECTOR];
    csg_text_line(text, ", %s", csg_text_vector(vector, p));
}

static void finish(struct csg_text *text, const char *tail)
{
    csg_text_line(text, "inside_vector <0.31, 0.23, 0.92>"); /* along no usual face */
    csg_text_line(text, "%s", tail);
    csg_text_close(text);
}

/* ---- polyhedra ------------------------------------------------------------------------------ */

static void write_points(struct csg_text *text, const struct csg_cell *cell)
{
    size_t num = 0;
    for (size_t i = 0; i < cell->faces.num; i++)
        num += cell->faces.data[i].points.num;
    begin_list(text, "vertex_vectors", num);
    for (size_t i = 0; i < cell->faces.num; i++)
        for (size_t j = 0; j < cell->faces.data[i].points.num; j++)
            write_point(text, cell->faces.data[i].points.data[j]);
    csg_text_close(text);
}

static void write_fans(struct csg_text *text, const struct csg_cell *cell)
{
    size_t num = 0, first = 0;
    for (size_t i = 0; i < cell->faces.num; i++)
        num += cell->faces.data[i].points.num - 2;
    begin_list(text, "face_indices", num);
    for (size_t i = 0; i < cell->faces.num; i++) {
        for (size_t j = 2; j < cell->faces.data[i].points.num; j++)
            csg_text_line(text, ", <%zu, %zu, %zu>", first, first + j - 1, first + j);
        first += cell->faces.data[i].points.num;
    }
    csg_text_close(text);
}

bool csg_pov_polygons(struct csg_text *text, const struct csg_shape *shape, const char *tail)
{
    struct csg_cell cell = {0};
    const bool ok = csg_cell_from_shape(&cell, shape);
    if (ok && cell.faces.num) {
        csg_text_open(text, "mesh2");
        write_points(text, &cell);
        write_fans(text, &cell);
        finish(text, tail);
    }
    csg_cell_finish(&cell);
    return ok;
}

/* ---- surfaces ------------------------------------------------------------------------------- */

void csg_pov_triangles(struct csg_text *text, const struct csg_shape *shape, const char *tail)
{
    const struct csg_surface *surface = shape->surface;
    const bool is_mirrored = csg_map_determinant(&shape->frame) < 0;
    csg_text_open(text, "mesh2");
    begin_list(text, "vertex_vectors", surface->points.num);
    for (size_t i = 0; i < surface->points.num; i++)
        write_point(text, csg_map_point(&shape->frame, surface->points.data[i]));
    csg_text_close(text);
    begin_list(text, "face_indices", surface->triangles.num);
    for (size_t i = 0; i < surface->triangles.num; i++) {
        uint32_t p[3];
        csg_triangle_corners(&surface->triangles.data[i], is_mirrored, p);
        csg_text_line(text, ", <%u, %u, %u>", (unsigned)p[0], (unsigned)p[1], (unsigned)p[2]);
    }
    csg_text_close(text);
    finish(text, tail);
}
