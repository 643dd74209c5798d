/* SPDX-License-Identifier: MIT */
#include "pack/surface_face.h"

#include <math.h>

/* Triangles thinner than this, in pixels, are slivers or seen along their plane, whose affine key
 * magnifies the rounding of the pixel: what is met is on the longest side. */
#define THIN 1e-4

/* Sides shorter than this, in pixels, are seen end on: they have no direction. */
#define SHORT 1e-2

/* Coordinates rounded to float are off by less than this, in pixels, and by this share. */
#define PIXEL_MARGIN 1e-3
#define SHARE_MARGIN 1e-6

/*
 * The part of the edge within the part's rows, from its lower end: x = x0 + slope (y - y0). Both
 * triangles of an edge get the same numbers, with the ends exchanged.
 */
static bool fill_edge(const struct csg_surface_part *part, const double a[2], const double b[2],
                      struct csg_view_edge *edge)
{
    const bool upwards = a[1] < b[1];
    const double *low = upwards ? a : b, *high = upwards ? b : a;
    double x0 = low[0] - part->lo[0], y0 = low[1] - part->lo[1];
    double x1 = high[0] - part->lo[0], y1 = high[1] - part->lo[1];
    const double slope = (x1 - x0) / (y1 - y0), top = part->size[1] + 1;
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
    edge->rows = (last < part->size[1] ? last : part->size[1]) - edge->first_row;
    edge->turns = upwards ? 1 : -1;
    const double margin = PIXEL_MARGIN + SHARE_MARGIN * (fabs(x0) + fabs(x1));
    edge->left = fmin(x0, x1) - margin;
    edge->right = fmax(x0, x1) + margin;
    return edge->rows > 0;
}

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

struct csg_vec3 csg_view_face_fill_plane(struct csg_view_face *face,
                                         const struct csg_surface_part *part)
{
    const struct csg_frame *frame = part->terms->frame;
    const struct csg_surface_view *view = part->view;
    const struct csg_triangle *triangle = &view->surface->triangles.data[face->triangle];
    bool flipped;
    const struct csg_plane plane = csg_carrier_of_face(part->terms->scene, view->leaf,
                                                       triangle->plane, &view->inverse, &flipped);
    const struct csg_vec3 normal = csg_scale(flipped ? -1 : 1, plane.normal);
    csg_screen_plane(&frame->screen, frame->at, &plane, flipped, face->plane);
    if (!face->thin)
        return normal;
    const struct csg_view_point *corners[3];
    double keys = 0;
    for (int i = 0; i < 3; i++) {
        corners[i] = &view->points[triangle->points[i]];
        keys += corners[i]->key;
    }
    if (!isnan(keys))
        fill_thin(corners, face->plane);
    return normal;
}

bool csg_view_face_fill(struct csg_view_face *face, const struct csg_surface_part *part,
                        uint32_t triangle)
{
    *face = (struct csg_view_face){.triangle = triangle};
    double polygon[4][2];
    const int num = csg_surface_view_polygon(part->view, triangle, polygon);
    double lo = INFINITY, hi = -INFINITY;
    int first = part->size[1], last = 0;
    for (int i = 0; i < num; i++) {
        struct csg_view_edge *edge = &face->edges[face->num_edges];
        if (!fill_edge(part, polygon[i], polygon[(i + 1) % num], edge))
            continue;
        face->num_edges++;
        lo = fmin(lo, edge->left);
        hi = fmax(hi, edge->right);
        first = edge->first_row < first ? edge->first_row : first;
        last = edge->first_row + edge->rows > last ? edge->first_row + edge->rows : last;
    }
    if (face->num_edges == 0 || hi < 0 || lo > part->size[0])
        return false;
    face->thin = is_thin(polygon, num);
    face->left = lo;
    face->right = hi;
    face->first_row = first;
    face->end_row = last;
    return true;
}
