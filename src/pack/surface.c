/* SPDX-License-Identifier: MIT */
#include "pack/surface.h"

#include <stdlib.h>

#include "solids/shape.h"

/* Keys of the shader are off by this share, with room to spare. */
#define KEY_MARGIN 1e-6

void csg_surface_view_init(struct csg_surface_view *view, const struct csg_shape *shape,
                           uint32_t leaf, bool spare)
{
    *view = (struct csg_surface_view){.surface = shape->surface,
                                      .leaf = leaf,
                                      .spare = spare,
                                      .rounding = shape->rounding,
                                      .place = shape->frame,
                                      .inverse = csg_map_identity,
                                      .is_mirrored = csg_map_determinant(&shape->frame) < 0};
    csg_map_invert(&shape->frame, &view->inverse);
}

void csg_surface_views_clear(struct csg_surface_views *views)
{
    for (size_t i = 0; i < views->num; i++) {
        free(views->data[i].points);
        free(views->data[i].nodes);
    }
    views->num = 0;
}

static bool overlaps(const struct csg_view_node *node, const struct csg_view_rect *rect)
{
    return node->lo[0] <= rect->hi[0] && node->hi[0] >= rect->lo[0] && node->lo[1] <= rect->hi[1] &&
           node->hi[1] >= rect->lo[1];
}

static bool is_within(const struct csg_view_node *node, const struct csg_view_rect *rect)
{
    return node->lo[0] >= rect->lo[0] && node->hi[0] <= rect->hi[0] && node->lo[1] >= rect->lo[1] &&
           node->hi[1] <= rect->hi[1];
}

bool csg_surface_view_range(const struct csg_surface_view *view, const struct csg_view_rect *rect,
                            double keys[2])
{
    const struct csg_box_node *nodes = view->surface->nodes.data;
    struct csg_view_node sum = csg_view_nowhere;
    for (size_t i = 0; i < view->surface->nodes.num;) {
        const struct csg_view_node *node = &view->nodes[i];
        if (!overlaps(node, rect)) {
            i = nodes[i].end;
        } else if (nodes[i].num || is_within(node, rect)) {
            csg_view_node_extend(&sum, node);
            i = nodes[i].end;
        } else {
            i++;
        }
    }
    keys[0] = sum.near - view->slack - KEY_MARGIN * fabs(sum.near);
    keys[1] = sum.far + view->slack + KEY_MARGIN * fabs(sum.far);
    return sum.near <= sum.far;
}

bool csg_surface_view_list(const struct csg_surface_view *view, const struct csg_view_rect *rect,
                           struct csg_view_list *list)
{
    const struct csg_box_node *nodes = view->surface->nodes.data;
    for (size_t i = 0; i < view->surface->nodes.num;) {
        if (!overlaps(&view->nodes[i], rect)) {
            i = nodes[i].end;
            continue;
        }
        for (uint32_t j = 0; j < nodes[i].num; j++) {
            struct csg_view_node node;
            if (csg_view_triangle(view, nodes[i].first + j, &node) && overlaps(&node, rect) &&
                !csg_array_push(list, nodes[i].first + j))
                return false;
        }
        i++;
    }
    return true;
}

/* Where the edge between a corner behind and one in front is cut; the former comes first, so that
 * both triangles of the edge get the same. */
static void cut_edge(const struct csg_view_place *behind, const struct csg_view_place *front,
                     double t, double place[2])
{
    const double s = (t - behind->t) / (front->t - behind->t);
    place[0] = (behind->x + s * (front->x - behind->x)) / t;
    place[1] = (behind->y + s * (front->y - behind->y)) / t;
}

int csg_surface_view_polygon(const struct csg_surface_view *view, uint32_t triangle,
                             double polygon[4][2])
{
    uint32_t corners[3];
    struct csg_view_place places[3] = {{0}};
    bool front[3];
    bool all = true;
    csg_triangle_corners(&view->surface->triangles.data[triangle], view->is_mirrored, corners);
    for (int i = 0; i < 3; i++) {
        front[i] = !isnan(view->points[corners[i]].key);
        all &= front[i];
    }
    for (int i = 0; i < 3 && !all; i++)
        places[i] = csg_view_place_of(view, view->surface->points.data[corners[i]]);
    int num = 0;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        if (front[i]) {
            polygon[num][0] = view->points[corners[i]].x;
            polygon[num++][1] = view->points[corners[i]].y;
        }
        if (front[i] != front[j])
            cut_edge(&places[front[i] ? j : i], &places[front[i] ? i : j], view->tnear,
                     polygon[num++]);
    }
    return num;
}
