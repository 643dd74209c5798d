/* SPDX-License-Identifier: MIT */
#include "pack/surface_record.h"

#include <stdlib.h>
#include <string.h>

/* Cells are squares of a power of two pixels; or single pixels, whose lists have no edges. */
enum { min_cell = 4, max_cell = 1 << 14 };

/* Making a texel takes as long as this many pixels that read one. */
#define TEXEL_COST 12.0

/* Triangles thinner than this, in pixels, are slivers or seen along their plane, whose affine key
 * magnifies the rounding of the pixel: what is met is on the longest side. */
#define THIN 1e-4

/* Sides shorter than this, in pixels, are seen end on: they have no direction. */
#define SHORT 1e-2

/* Coordinates rounded to float are off by less than this, in pixels, and by this share. */
#define PIXEL_MARGIN 1e-3
#define SHARE_MARGIN 1e-6

/* An edge of a triangle in the record's pixels, as the shader gets it. */
struct edge {
    float texel[4];
    double left, right;  /* where it is within the record's rows */
    int first_row, rows; /* whose centres it passes */
    int turns;           /* 1 upwards, -1 downwards */
};

struct face {
    double plane[4];
    struct edge edges[4];
    int num_edges;
    double left, right; /* pixels */
    int first_row, end_row;
    uint32_t normal; /* place in the record; 0 while no list has the face */
    uint32_t triangle;
};

/* A face in a cell's list. */
struct entry {
    uint32_t cell, face;
    uint8_t first_edge, num_edges; /* none: the face covers all of the cell, */
    int8_t turns;                  /* ... in that sense */
};

struct record {
    struct csg_terms *terms;
    const struct csg_surface_view *view;
    int size[2];  /* pixels */
    double lo[2]; /* counted from the reference pixel */
    int cell, columns, rows;
    uint32_t first_normal, num_normals;
    CSG_ARRAY(struct face) faces;
    CSG_ARRAY(struct entry) entries;
};

/* ---- edges -------------------------------------------------------------------------------- */

/*
 * The part of the edge within the record's rows, from its lower end: x = x0 + slope (y - y0). Both
 * triangles of an edge get the same numbers, with the ends exchanged.
 */
static bool fill_edge(const struct record *record, const double a[2], const double b[2],
                      struct edge *edge)
{
    const bool upwards = a[1] < b[1];
    const double *low = upwards ? a : b, *high = upwards ? b : a;
    double x0 = low[0] - record->lo[0], y0 = low[1] - record->lo[1];
    double x1 = high[0] - record->lo[0], y1 = high[1] - record->lo[1];
    const double slope = (x1 - x0) / (y1 - y0), top = record->size[1] + 1;
    if (!(y0 < y1) || y1 <= -1 || y0 >= top)
        return false;
    const double from = x0;
    if (y0 < -1)
        x0 = from + slope * (-1 - y0);
    if (y1 > top)
        x1 = from + slope * (top - y0);
    const float bottom = (float)(y0 < -1 ? -1 : y0), end = (float)(y1 > top ? top : y1);
    edge->texel[0] = upwards ? bottom : end;
    edge->texel[1] = upwards ? end : bottom;
    edge->texel[2] = (float)x0;
    edge->texel[3] = bottom < end ? (float)((x1 - x0) / ((double)end - (double)bottom)) : 0;
    const int first = (int)ceil((double)bottom - 0.5), last = (int)ceil((double)end - 0.5);
    edge->first_row = first > 0 ? first : 0;
    edge->rows = (last < record->size[1] ? last : record->size[1]) - edge->first_row;
    edge->turns = upwards ? 1 : -1;
    const double margin = PIXEL_MARGIN + SHARE_MARGIN * (fabs(x0) + fabs(x1));
    edge->left = fmin(x0, x1) - margin;
    edge->right = fmax(x0, x1) + margin;
    return edge->rows > 0;
}

/* ---- faces -------------------------------------------------------------------------------- */

/* Twice the area over the longest edge. */
static bool is_thin(double (*polygon)[2], int num)
{
    double area = 0, longest = 0;
    for (int i = 0; i < num; i++) {
        const double *a = polygon[i], *b = polygon[(i + 1) % num];
        const double dx = b[0] - a[0], dy = b[1] - a[1];
        area += (a[0] - polygon[0][0]) * dy - (a[1] - polygon[0][1]) * dx;
        longest = fmax(longest, sqrt(dx * dx + dy * dy));
    }
    return !(fabs(area) > THIN * longest);
}

static struct csg_plane carrier_of(const struct record *record, uint32_t triangle, bool *flipped)
{
    const struct csg_surface_view *view = record->view;
    return csg_carrier_of_face(record->terms->scene, view->leaf,
                               view->surface->triangles.data[triangle].plane, &view->inverse,
                               flipped);
}

/* The key along the longest side, the same across it; of a point, that of its middle. */
static void fill_thin(const struct csg_view_point *corners[3], double plane[4])
{
    const struct csg_view_point *a = corners[0], *b = corners[0];
    double longest = SHORT * SHORT;
    for (int i = 0; i < 3; i++) {
        const struct csg_view_point *p = corners[i], *q = corners[(i + 1) % 3];
        const double length = (q->x - p->x) * (q->x - p->x) + (q->y - p->y) * (q->y - p->y);
        if (length > longest) {
            longest = length;
            a = p;
            b = q;
        }
    }
    const double slope = (b->key - a->key) / longest;
    plane[1] = slope * (b->x - a->x);
    plane[2] = slope * (b->y - a->y);
    plane[0] = a == b ? (corners[0]->key + corners[1]->key + corners[2]->key) / 3
                      : a->key - plane[1] * a->x - plane[2] * a->y;
}

static void fill_plane(const struct record *record, struct face *face, bool thin)
{
    const struct csg_frame *frame = record->terms->frame;
    bool flipped;
    const struct csg_plane plane = carrier_of(record, face->triangle, &flipped);
    csg_screen_plane(&frame->screen, frame->at, &plane, flipped, face->plane);
    if (!thin)
        return;
    const struct csg_surface_view *view = record->view;
    const uint32_t *points = view->surface->triangles.data[face->triangle].points;
    const struct csg_view_point *corners[3];
    double keys = 0;
    for (int i = 0; i < 3; i++) {
        corners[i] = &view->points[points[i]];
        keys += corners[i]->key;
    }
    if (!isnan(keys))
        fill_thin(corners, face->plane);
}

static bool add_face(struct record *record, uint32_t triangle)
{
    const struct csg_frame *frame = record->terms->frame;
    struct face face = {.triangle = triangle};
    double polygon[4][2];
    const int num =
        csg_surface_view_polygon(record->view, &frame->screen, frame->at, triangle, polygon);
    double lo = INFINITY, hi = -INFINITY;
    int first = record->size[1], last = 0;
    for (int i = 0; i < num; i++) {
        struct edge *edge = &face.edges[face.num_edges];
        if (!fill_edge(record, polygon[i], polygon[(i + 1) % num], edge))
            continue;
        face.num_edges++;
        lo = fmin(lo, edge->left);
        hi = fmax(hi, edge->right);
        first = edge->first_row < first ? edge->first_row : first;
        last = edge->first_row + edge->rows > last ? edge->first_row + edge->rows : last;
    }
    if (face.num_edges == 0 || hi < 0 || lo > record->size[0])
        return true;
    fill_plane(record, &face, is_thin(polygon, num));
    face.left = lo;
    face.right = hi;
    face.first_row = first;
    face.end_row = last;
    return csg_array_push(&record->faces, face);
}

/* ---- lists -------------------------------------------------------------------------------- */

enum side { BESIDE, COVERS, CUTS };

/* What an edge is to a cell: to the left of it or in other rows; to the right of all of it; or the
 * shader has to ask. */
static enum side side_of(const struct record *record, const struct edge *edge, int column, int row)
{
    const int left = column * record->cell, bottom = row * record->cell;
    const int top =
        bottom + record->cell < record->size[1] ? bottom + record->cell : record->size[1];
    const int end = edge->first_row + edge->rows;
    if (end <= bottom || edge->first_row >= top || edge->right < left)
        return BESIDE;
    const bool all_rows = edge->first_row <= bottom && end >= top;
    return all_rows && edge->left > left + record->cell ? COVERS : CUTS;
}

static bool push_entry(struct record *record, struct entry entry)
{
    struct face *face = &record->faces.data[entry.face];
    if (face->normal == 0)
        face->normal = record->first_normal + record->num_normals++;
    return csg_array_push(&record->entries, entry);
}

static bool add_to_cell(struct record *record, uint32_t face_index, int column, int row)
{
    const struct face *face = &record->faces.data[face_index];
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
    const struct face face = record->faces.data[index];
    const int lo = clamp_cell(face.left, record->cell, record->columns);
    const int hi = clamp_cell(face.right, record->cell, record->columns);
    bool ok = true;
    for (int row = face.first_row / record->cell; row * record->cell < face.end_row && ok; row++)
        for (int column = lo; column <= hi && ok; column++)
            ok = add_to_cell(record, index, column, row);
    return ok;
}

/* Pixels of the row whose centres are to the left of the edge; as the shader asks it. */
static int pixels_before(const struct record *record, const struct edge *edge, int row)
{
    const float low = edge->texel[0] < edge->texel[1] ? edge->texel[0] : edge->texel[1];
    const float x = edge->texel[2] + edge->texel[3] * ((float)row + 0.5f - low);
    const double num = ceil((double)x - 0.5);
    return num < 0 ? 0 : num > record->size[0] ? record->size[0] : (int)num;
}

/* The pixels of a row that the face covers, each as often as the edges to the right of it turn. */
static bool add_to_row(struct record *record, uint32_t index, int row)
{
    const struct face *face = &record->faces.data[index];
    int ends[4], turns[4], num = 0;
    for (int i = 0; i < face->num_edges; i++) {
        const struct edge *edge = &face->edges[i];
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
    const struct face *face = &record->faces.data[index];
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

static struct extent extent_of(const struct record *record, const struct face *face)
{
    struct extent extent = {0};
    for (int i = 0; i < face->num_edges; i++) {
        const struct edge *edge = &face->edges[i];
        const double left = fmax(edge->left, 0), right = fmin(edge->right, record->size[0]);
        const double middle = 0.5 * (edge->left + edge->right);
        extent.area += edge->turns * edge->rows * fmin(fmax(middle, 0), record->size[0]);
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
    const double area = (double)record->size[0] * record->size[1], s = size;
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
    const int larger = record->size[0] > record->size[1] ? record->size[0] : record->size[1];
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
    record->columns = (record->size[0] + record->cell - 1) / record->cell;
    record->rows = (record->size[1] + record->cell - 1) / record->cell;
    record->first_normal = (uint32_t)(CSG_SURFACE_CELLS + record->columns * record->rows);
    return true;
}

static void put_normal(const struct record *record, const struct face *face, bool negated,
                       float mark, float *texel)
{
    bool flipped;
    const struct csg_plane plane = carrier_of(record, face->triangle, &flipped);
    const double sign = flipped != negated ? -1 : 1;
    texel[0] = (float)(sign * plane.normal.x);
    texel[1] = (float)(sign * plane.normal.y);
    texel[2] = (float)(sign * plane.normal.z);
    texel[3] = mark;
}

static uint32_t entry_texels(const struct record *record, bool cuts)
{
    return (record->terms->precise ? 2u : 1u) + (cuts ? CSG_SURFACE_EDGES : 0);
}

static void put_entry(const struct record *record, const struct entry *entry, float *to)
{
    const struct face *face = &record->faces.data[entry->face];
    const double plane[4] = {face->plane[0], face->plane[1], face->plane[2],
                             (double)face->normal * (entry->num_edges ? 1 : entry->turns)};
    to = csg_terms_put(record->terms, plane, to);
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

static bool put_record(const struct record *record, const struct csg_step *step)
{
    struct csg_frame *frame = record->terms->frame;
    const struct csg_leaf_terms *leaf = csg_terms_of(record->terms, step->leaf);
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
    grid[0] = (float)record->lo[0];
    grid[1] = (float)record->lo[1];
    grid[2] = 1.0f / (float)record->cell;
    grid[3] = (float)record->columns;
    for (size_t i = 0; i < record->faces.num; i++) {
        const struct face *face = &record->faces.data[i];
        if (face->normal)
            put_normal(record, face, step->flags & CSG_RECORD_NEGATED,
                       (float)(leaf->attributes + 1), texels + (size_t)4 * face->normal);
    }
    float *start = texels + 8;
    start[0] = (float)record->view->turns;
    start[1] = (float)put_lists(record, cells, texels, first);
    free(cells);
    return true;
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
    struct record record = {.terms = terms,
                            .view = csg_terms_view(terms, step->leaf),
                            .size = {hi[0] - lo[0], hi[1] - lo[1]},
                            .lo = {lo[0] - at.x, lo[1] - at.y}};
    const struct csg_view_rect rect = {
        {record.lo[0] + 0.5, record.lo[1] + 0.5},
        {record.lo[0] + record.size[0] - 0.5, record.lo[1] + record.size[1] - 0.5}};
    struct csg_view_list list = {0};
    const bool ok = csg_surface_view_list(record.view, &rect, &list) &&
                    fill_record(&record, &list) && put_record(&record, step);
    free(list.data);
    free(record.faces.data);
    free(record.entries.data);
    return ok;
}
