/* SPDX-License-Identifier: MIT */
/*
 * surface() of a text file of heights, or of an image: each cell is four triangles about its
 * centre, and the whole stands on a floor one below the lowest height, or -1 if that is higher
 * (surface.cc of OpenSCAD).
 */
#include <stdlib.h>

#include "nodes/compounds.h"
#include "nodes/heights.h"
#include "nodes/import.h"
#include "nodes/mesh_file.h"
#include "nodes/polyhedron.h"

/* Of a row with a word that is no number, what stands before it counts. */
static bool add_row(struct csg_heights *heights, struct csg_words *words, bool *is_good)
{
    const size_t begin = heights->values.num;
    bool ok = true;
    for (struct csg_words ahead = *words; ok; ahead = *words) {
        const char *word;
        size_t length;
        double value;
        if (!csg_words_next(&ahead, &word, &length))
            break;
        *is_good = csg_words_number(words, &value);
        if (!*is_good)
            break;
        heights->floor = fmin(heights->floor, value - 1);
        ok = csg_array_push(&heights->values, value);
    }
    const size_t columns = heights->values.num - begin;
    if (columns == 0)
        return ok;
    heights->columns = columns > heights->columns ? columns : heights->columns;
    return ok && csg_array_push(&heights->rows, heights->values.num);
}

/* OpenSCAD stops at a word that is no number. line: where that is. */
static bool read_heights(struct csg_heights *heights, const struct csg_bytes *bytes, size_t *line)
{
    struct csg_words words = {.at = bytes->data, .end = bytes->data + bytes->num, .line = 1};
    bool ok = true, is_good = true;
    *line = 0;
    for (bool more = bytes->num > 0; more && ok && is_good; more = csg_words_next_line(&words)) {
        struct csg_words ahead = words;
        const char *word;
        size_t length;
        if (csg_words_next(&ahead, &word, &length) && word[0] != '#')
            ok = add_row(heights, &words, &is_good);
        if (!is_good)
            *line = words.line;
    }
    return ok;
}

static double height_at(const struct csg_heights *heights, size_t row, size_t column)
{
    const size_t begin = row ? heights->rows.data[row - 1] : 0;
    return begin + column < heights->rows.data[row] ? heights->values.data[begin + column] : 0;
}

/* ---- the mesh ----------------------------------------------------------------------------- */

struct relief {
    const struct csg_heights *heights;
    struct csg_mesh *mesh;
    size_t rows, columns;
    double x, y; /* of the first height */
};

static bool add_points(const struct relief *relief)
{
    bool ok = true;
    for (size_t i = 0; i < relief->rows; i++)
        for (size_t j = 0; j < relief->columns && ok; j++)
            ok = csg_mesh_add_point(relief->mesh,
                                    csg_vec3(relief->x + (double)j, relief->y + (double)i,
                                             height_at(relief->heights, i, j)));
    return ok;
}

static bool add_face(struct csg_mesh *mesh, const uint32_t *corners, int num)
{
    bool ok = true;
    for (int i = 0; i < num && ok; i++)
        ok = csg_array_push(&mesh->corners, corners[i]);
    return ok && csg_mesh_close_face(mesh);
}

static bool add_cell(const struct relief *relief, size_t i, size_t j)
{
    struct csg_mesh *mesh = relief->mesh;
    const uint32_t a = (uint32_t)(i * relief->columns + j), b = a + 1;
    const uint32_t d = a + (uint32_t)relief->columns, c = d + 1, ring[4] = {a, b, c, d};
    const uint32_t center = (uint32_t)mesh->points.num;
    const struct csg_vec3 *p = mesh->points.data;
    const double z = (p[a].z + p[b].z + p[d].z + p[c].z) / 4;
    bool ok = csg_mesh_add_point(
        mesh, csg_vec3(relief->x + (double)j + 0.5, relief->y + (double)i + 0.5, z));
    for (int k = 0; k < 4 && ok; k++)
        ok = add_face(mesh, (const uint32_t[]){ring[k], ring[(k + 1) % 4], center}, 3);
    return ok;
}

/* The border, counter-clockwise. */
static void list_border(const struct relief *relief, uint32_t *border)
{
    const uint32_t columns = (uint32_t)relief->columns, rows = (uint32_t)relief->rows;
    size_t num = 0;
    for (uint32_t j = 0; j + 1 < columns; j++)
        border[num++] = j;
    for (uint32_t i = 0; i + 1 < rows; i++)
        border[num++] = i * columns + columns - 1;
    for (uint32_t j = columns - 1; j > 0; j--)
        border[num++] = (rows - 1) * columns + j;
    for (uint32_t i = rows - 1; i > 0; i--)
        border[num++] = i * columns;
}

static bool add_walls(const struct relief *relief, const uint32_t *border, uint32_t num)
{
    struct csg_mesh *mesh = relief->mesh;
    const uint32_t first = (uint32_t)mesh->points.num;
    bool ok = true;
    for (uint32_t k = 0; k < num && ok; k++) {
        const struct csg_vec3 p = mesh->points.data[border[k]];
        ok = csg_mesh_add_point(mesh, csg_vec3(p.x, p.y, relief->heights->floor));
    }
    for (uint32_t k = 0; k < num && ok; k++) {
        const uint32_t next = (k + 1) % num;
        ok =
            add_face(mesh, (const uint32_t[]){first + k, first + next, border[next], border[k]}, 4);
    }
    for (uint32_t k = num; k-- > 0 && ok;)
        ok = csg_array_push(&mesh->corners, first + k);
    return ok && csg_mesh_close_face(mesh);
}

static bool add_relief(const struct relief *relief)
{
    const size_t num = 2 * (relief->rows + relief->columns) - 4;
    uint32_t *border = malloc(num * sizeof *border);
    bool ok = border && add_points(relief);
    for (size_t i = 0; i + 1 < relief->rows && ok; i++)
        for (size_t j = 0; j + 1 < relief->columns && ok; j++)
            ok = add_cell(relief, i, j);
    if (ok) {
        list_border(relief, border);
        ok = add_walls(relief, border, (uint32_t)num);
    }
    free(border);
    return ok && csg_mesh_clean(relief->mesh, NULL);
}

static bool add_heights(struct csg_walk *walk, uint32_t node, const struct csg_heights *heights,
                        bool center, struct csg_part *part)
{
    struct csg_mesh mesh = {0};
    struct relief relief = {
        .heights = heights, .mesh = &mesh, .rows = heights->rows.num, .columns = heights->columns};
    if (relief.rows < 2 || relief.columns < 2)
        return true;
    if (relief.rows > CSG_HEIGHTS_MAX / relief.columns) {
        csg_walk_unsupported(walk, node, "surface: it has more than %d heights", CSG_HEIGHTS_MAX);
        return true;
    }
    relief.x = center ? -((double)relief.columns - 1) / 2 : 0;
    relief.y = center ? -((double)relief.rows - 1) / 2 : 0;
    const bool ok = (add_relief(&relief) || csg_walk_no_memory(walk)) &&
                    csg_polyhedron_add(walk, node, true, &mesh, part);
    csg_mesh_finish(&mesh);
    return ok;
}

static bool read_image(struct csg_walk *walk, uint32_t node, const char *name,
                       const struct csg_bytes *bytes, bool invert, struct csg_heights *heights)
{
    const enum csg_heights_result result = csg_heights_read_png(heights, bytes, invert);
    if (result == CSG_HEIGHTS_TOO_MANY)
        csg_walk_unsupported(walk, node, "surface: it has more than %d heights", CSG_HEIGHTS_MAX);
    else if (result == CSG_HEIGHTS_BROKEN)
        csg_walk_warning(walk, node, "%.160s: malformed; nothing is drawn", name);
    return result != CSG_HEIGHTS_NO_MEMORY || csg_walk_no_memory(walk);
}

static bool read_text(struct csg_walk *walk, uint32_t node, const char *name,
                      const struct csg_bytes *bytes, struct csg_heights *heights)
{
    size_t line = 0;
    const bool ok = read_heights(heights, bytes, &line);
    if (ok && line > 0)
        csg_walk_warning(walk, node, "%.160s:%zu: not a number; the file ends here", name, line);
    else if (ok && (heights->rows.num < 2 || heights->columns < 2))
        csg_walk_warning(walk, node, "%.160s: less than two rows or columns; nothing is drawn",
                         name);
    return ok || csg_walk_no_memory(walk);
}

bool csg_compound_surface(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                          bool in_boolean, struct csg_part *part)
{
    const bool center = csg_args_bool(args, "center");
    const bool invert = csg_args_bool(args, "invert");
    struct csg_heights heights = {0};
    struct csg_bytes bytes = {0};
    const char *name;
    (void)in_boolean;
    bool ok = csg_import_read(walk, node, args, &name, &bytes);
    if (ok && name)
        ok = (csg_heights_is_png(&bytes) ? read_image(walk, node, name, &bytes, invert, &heights)
                                         : read_text(walk, node, name, &bytes, &heights)) &&
             add_heights(walk, node, &heights, center, part);
    free(bytes.data);
    free(heights.values.data);
    free(heights.rows.data);
    return ok;
}
