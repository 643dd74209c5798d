/* SPDX-License-Identifier: MIT */
#include "pack/surface_record.h"

#include <stdlib.h>
#include <string.h>

#include "pack/record.h"
#include "pack/surface_face.h"

/* Cells are squares of a power of two pixels; or single pixels, whose lists have no edges. */
enum { min_cell = 4, max_cell = 1 << 14 };

/* Making a texel takes as long as this many pixels that read one. */
#define TEXEL_COST 12.0

/* A face in a cell's list. */
struct entry {
    uint32_t cell, face;
    uint8_t first_edge, num_edges; /* none: the face covers all of the cell, */
    int8_t turns;                  /* ... in that sense */
};

struct record {
    struct csg_surface_part part; /* of the picture, that it is for */
    int cell, columns, rows;
    uint32_t first_normal, num_normals;
    CSG_ARRAY(struct csg_view_face) faces;
    CSG_ARRAY(struct entry) entries;
};

/* ---- lists -------------------------------------------------------------------------------- */

enum side { BESIDE, COVERS, CUTS };

/* What an edge is to a cell: to the left of it or in other rows; to the right of all of it; or the
 * shader has to ask. */
static enum side side_of(const struct record *record, const struct csg_view_edge *edge, int column,
                         int row)
{
    const int left = column * record->cell, bottom = row * record->cell;
    const int top =
        bottom + record->cell < record->part.size[1] ? bottom + record->cell : record->part.size[1];
    const int end = edge->first_row + edge->rows;
    if (end <= bottom || edge->first_row >= top || edge->right < left)
        return BESIDE;
    const bool all_rows = edge->first_row <= bottom && end >= top;
    return all_rows && edge->left > left + record->cell ? COVERS : CUTS;
}

static bool push_entry(struct record *record, struct entry entry)
{
    struct csg_view_face *face = &record->faces.data[entry.face];
    if (face->normal == 0)
        face->normal = record->first_normal + record->num_normals++;
    return csg_array_push(&record->entries, entry);
}

static bool add_to_cell(struct record *record, uint32_t face_index, int column, int row)
{
    const struct csg_view_face *face = &record->faces.data[face_index];
    struct entry entry = {.cell = (uint32_t)(row * record->columns + column), .face = face_index};
    bool cuts = false;
    int turns = 0;
    for (int i = 0; i < face->num_edges; i++) {
        const enum side side = side_of(record, &face->edges[i], column, row);
        turns += side == COVERS ? face->edges[i].turns : 0;
        cuts |= side == CUTS;
    }
    bool ok = true;
    entry.turns = turns < 0 ? -1 : 1;
    for (int i = 0; i < abs(turns) && !cuts && ok; i++)
        ok = push_entry(record, entry);
    for (int i = 0; i < face->num_edges && cuts && ok; i += 3) {
        entry.first_edge = (uint8_t)i;
        entry.num_edges = (uint8_t)(face->num_edges - i < 3 ? face->num_edges - i : 3);
        ok = push_entry(record, entry);
    }
    return ok;
}

static int clamp_cell(double pixel, int cell, int num)
{
    const double place = floor(pixel / cell);
    return place < 0 ? 0 : place >= num ? num - 1 : (int)place;
}

static bool add_to_cells(struct record *record, uint32_t index)
{
    const struct csg_view_face face = record->faces.data[index];
    const int lo = clamp_cell(face.left, record->cell, record->columns);
    const int hi = clamp_cell(face.right, record->cell, record->columns);
    bool ok = true;
    for (int row = face.first_row / record->cell; row * record->cell < face.end_row && ok; row++)
        for (int column = lo; column <= hi && ok; column++)
            ok = add_to_cell(record, index, column, row);
    return ok;
}

/* Pixels of the row whose centres are to the left of the edge; as the shader asks it. */
static int pixels_before(const struct record *record, const struct csg_view_edge *edge, int row)
{
    const float low = edge->texel[0] < edge->texel[1] ? edge->texel[0] : edge->texel[1];
    const float x = edge->texel[2] + edge->texel[3] * ((float)row + 0.5f - low);
    const double num = ceil((double)x - 0.5);
    return num < 0 ? 0 : num > record->part.size[0] ? record->part.size[0] : (int)num;
}

/* The pixels of a row that the face covers, each as often as the edges to the right of it turn. */
static bool add_to_row(struct record *record, uint32_t index, int row)
{
    const struct csg_view_face *face = &record->faces.data[index];
    int ends[4], turns[4], num = 0;
    for (int i = 0; i < face->num_edges; i++) {
        const struct csg_view_edge *edge = &face->edges[i];
        if (row < edge->first_row || row >= edge->first_row + edge->rows)
            continue;
        int at = num++;
        const int end = pixels_before(record, edge, row);
        for (; at > 0 && ends[at - 1] > end; at--) {
            ends[at] = ends[at - 1];
            turns[at] = turns[at - 1];
        }
        ends[at] = end;
        turns[at] = edge->turns;
    }
    int sum = 0;
    bool ok = true;
    for (int i = num - 1; i > 0 && ok; i--) {
        sum += turns[i];
        struct entry entry = {.face = index, .turns = sum < 0 ? -1 : 1};
        for (int column = ends[i - 1]; column < ends[i] && sum != 0 && ok; column++) {
            entry.cell = (uint32_t)(row * record->columns + column);
            for (int j = 0; j < abs(sum) && ok; j++)
                ok = push_entry(record, entry);
        }
    }
    return ok;
}

static bool add_to_pixels(struct record *record, uint32_t index)
{
    const struct csg_view_face *face = &record->faces.data[index];
    const int first = face->first_row, end = face->end_row;
    bool ok = true;
    for (int row = first; row < end && ok; row++)
        ok = add_to_row(record, index, row);
    return ok;
}

/* ---- the record --------------------------------------------------------------------------- */

/* Pixels that a face covers within the record, and how long its edges are there; about. */
struct extent {
    double area, length;
};

static struct extent extent_of(const struct record *record, const struct csg_view_face *face)
{
    struct extent extent = {0};
    for (int i = 0; i < face->num_edges; i++) {
        const struct csg_view_edge *edge = &face->edges[i];
        const double left = fmax(edge->left, 0), right = fmin(edge->right, record->part.size[0]);
        const double middle = 0.5 * (edge->left + edge->right);
        extent.area += edge->turns * edge->rows * fmin(fmax(middle, 0), record->part.size[0]);
        extent.length += edge->rows + fmax(right - left, 0);
    }
    extent.area = fabs(extent.area);
    return extent;
}

/*
 * What cells of some size cost, in texels read. A convex face of area a and perimeter p meets
 * a / s^2 + 2 p / (pi s) + 1 squares of size s on average (Santalo 1976, integral geometry), about
 * p / s + 1 of them with its edges, the length of an edge taken along the axes.
 */
static double cost_of(const struct record *record, const struct extent *extents, int size)
{
    const double area = (double)record->part.size[0] * record->part.size[1], s = size;
    double texels = 0;
    for (size_t i = 0; i < record->faces.num; i++) {
        const double cuts = size == 1 ? 0 : extents[i].length / s + 1;
        const double meets = fmax(extents[i].area / (s * s) + 0.5 * cuts, cuts);
        texels += meets + CSG_SURFACE_EDGES * cuts;
    }
    return TEXEL_COST * (ceil(area / (s * s)) + texels) + s * s * texels;
}

static bool choose_cells(struct record *record)
{
    const int larger =
        record->part.size[0] > record->part.size[1] ? record->part.size[0] : record->part.size[1];
    struct extent *extents = malloc((record->faces.num + 1) * sizeof *extents);
    if (!extents)
        return false;
    for (size_t i = 0; i < record->faces.num; i++)
        extents[i] = extent_of(record, &record->faces.data[i]);
    double best = cost_of(record, extents, 1);
    record->cell = 1;
    for (int cell = min_cell; cell < 2 * larger && cell <= max_cell; cell *= 2) {
        const double cost = cost_of(record, extents, cell);
        if (cost < best) {
            best = cost;
            record->cell = cell;
        }
    }
    free(extents);
    record->columns = (record->part.size[0] + record->cell - 1) / record->cell;
    record->rows = (record->part.size[1] + record->cell - 1) / record->cell;
    record->first_normal = (uint32_t)(CSG_SURFACE_CELLS + record->columns * record->rows);
    return true;
}

static void put_normal(struct csg_vec3 normal, bool negated, float mark, float *texel)
{
    const double sign = negated ? -1 : 1;
    texel[0] = (float)(sign * normal.x);
    texel[1] = (float)(sign * normal.y);
    texel[2] = (float)(sign * normal.z);
    texel[3] = mark;
}

static uint32_t entry_texels(const struct record *record, bool cuts)
{
    return (record->part.terms->precise ? 2u : 1u) + (cuts ? CSG_SURFACE_EDGES : 0);
}

static void put_entry(const struct record *record, const struct entry *entry, float *to)
{
    const struct csg_view_face *face = &record->faces.data[entry->face];
    const double plane[4] = {face->plane[0], face->plane[1], face->plane[2],
                             (double)face->normal * (entry->num_edges ? 1 : entry->turns)};
    to = csg_record_put_term(record->part.terms, plane, to);
    for (int i = 0; i < entry->num_edges; i++)
        memcpy(to + 4 * i, face->edges[entry->first_edge + i].texel, 4 * sizeof *to);
}

/* A cell's list while it is written: entries that cover the cell, then those that cut it. */
struct cell {
    uint32_t covers, cuts;         /* how many */
    uint32_t next_cover, next_cut; /* texels */
};

/* The lists by cell, from texel first on; returns the length of the longest. */
static size_t put_lists(const struct record *record, struct cell *cells, float *texels,
                        size_t first)
{
    size_t longest = 0, num_cells = (size_t)record->columns * (size_t)record->rows;
    for (size_t i = 0; i < record->entries.num; i++) {
        const struct entry *entry = &record->entries.data[i];
        cells[entry->cell].covers += entry->num_edges == 0;
        cells[entry->cell].cuts += entry->num_edges > 0;
    }
    for (size_t i = 0; i < num_cells; i++) {
        float *texel = texels + 4 * (CSG_SURFACE_CELLS + i);
        texel[0] = (float)first;
        texel[1] = (float)cells[i].covers;
        texel[2] = (float)cells[i].cuts;
        cells[i].next_cover = (uint32_t)first;
        cells[i].next_cut = (uint32_t)first + entry_texels(record, false) * cells[i].covers;
        first = cells[i].next_cut + (size_t)entry_texels(record, true) * cells[i].cuts;
        if (cells[i].covers + cells[i].cuts > longest)
            longest = cells[i].covers + cells[i].cuts;
    }
    for (size_t i = 0; i < record->entries.num; i++) {
        const struct entry *entry = &record->entries.data[i];
        uint32_t *next =
            entry->num_edges ? &cells[entry->cell].next_cut : &cells[entry->cell].next_cover;
        put_entry(record, entry, texels + (size_t)4 * *next);
        *next += entry_texels(record, entry->num_edges > 0);
    }
    return longest;
}

/* Planes and normals of the faces that are in lists. */
static void put_faces(struct record *record, const struct csg_step *step, float mark, float *texels)
{
    for (size_t i = 0; i < record->faces.num; i++) {
        struct csg_view_face *face = &record->faces.data[i];
        if (face->normal)
            put_normal(csg_view_face_fill_plane(face, &record->part),
                       step->flags & CSG_RECORD_NEGATED, mark, texels + (size_t)4 * face->normal);
    }
}

static bool put_record(struct record *record, const struct csg_step *step)
{
    struct csg_frame *frame = record->part.terms->frame;
    const struct csg_leaf_terms *leaf = csg_terms_of(record->part.terms, step->leaf);
    const size_t first = record->first_normal + record->num_normals;
    size_t num = first;
    for (size_t i = 0; i < record->entries.num; i++)
        num += entry_texels(record, record->entries.data[i].num_edges > 0);
    struct cell *cells = calloc((size_t)record->columns * (size_t)record->rows, sizeof *cells);
    float *texels = cells ? csg_frame_add_texels(frame, num) : NULL;
    if (!texels) {
        free(cells);
        return false;
    }
    texels[0] = (float)(num - 1);
    texels[2] = (float)step->flags;
    texels[3] = (float)leaf->attributes;
    float *grid = texels + 4;
    grid[0] = (float)record->part.lo[0];
    grid[1] = (float)record->part.lo[1];
    grid[2] = 1.0f / (float)record->cell;
    grid[3] = (float)record->columns;
    put_faces(record, step, (float)(leaf->attributes + 1), texels);
    float *start = texels + 8;
    start[0] = (float)record->part.view->turns;
    start[1] = (float)put_lists(record, cells, texels, first);
    free(cells);
    return true;
}

static bool add_face(struct record *record, uint32_t triangle)
{
    struct csg_view_face face;
    return !csg_view_face_fill(&face, &record->part, triangle) ||
           csg_array_push(&record->faces, face);
}

static bool fill_record(struct record *record, const struct csg_view_list *list)
{
    bool ok = true;
    for (size_t i = 0; i < list->num && ok; i++)
        ok = add_face(record, list->data[i]);
    ok = ok && choose_cells(record);
    for (size_t i = 0; i < record->faces.num && ok; i++)
        ok = record->cell == 1 ? add_to_pixels(record, (uint32_t)i)
                               : add_to_cells(record, (uint32_t)i);
    return ok;
}

bool csg_surface_add_record(struct csg_terms *terms, const struct csg_step *step, const int lo[2],
                            const int hi[2])
{
    const struct csg_pixel at = terms->frame->at;
    struct record record = {.part = {.terms = terms, .view = csg_terms_view(terms, step->leaf)}};
    for (int i = 0; i < 2; i++) {
        const int begin = lo[i] / CSG_PIXEL_BLOCK * CSG_PIXEL_BLOCK;
        const int end = (hi[i] + CSG_PIXEL_BLOCK - 1) / CSG_PIXEL_BLOCK * CSG_PIXEL_BLOCK;
        record.part.size[i] = end - begin;
        record.part.lo[i] = begin - (i == 0 ? at.x : at.y);
    }
    const struct csg_view_rect rect = {{record.part.lo[0] + 0.5, record.part.lo[1] + 0.5},
                                       {record.part.lo[0] + record.part.size[0] - 0.5,
                                        record.part.lo[1] + record.part.size[1] - 0.5}};
    struct csg_view_list list = {0};
    const bool ok = csg_surface_view_list(record.part.view, &rect, &list) &&
                    fill_record(&record, &list) && put_record(&record, step);
    free(list.data);
    free(record.faces.data);
    free(record.entries.data);
    return ok;
}
