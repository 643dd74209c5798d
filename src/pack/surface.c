/* SPDX-License-Identifier: MIT */
#include "pack/surface.h"

#include <stdlib.h>

#include "common/parallel.h"
#include "solids/shape.h"

/* Triangles are cut off nearer than this share of the surface's distance and size. */
#define NEAR_SHARE 1e-11

/* Part of a pixel by which rectangles grow: corners are rounded to float later. */
#define RECT_MARGIN 1e-3

/* Keys of the shader are off by this share, with room to spare. */
#define KEY_MARGIN 1e-6

/* Along the ray a carrier may lie off its face by this many times the rounding of the file. */
#define SLACK_ROUNDINGS 16.0

/* Fewer points are projected before threads have started. */
#define MIN_POINTS 10000

/* Pixel coordinates times w, w and the distance along the view axis. */
struct homogeneous {
    double x, y, w, t;
};

static struct homogeneous project(const struct csg_screen *screen, struct csg_pixel at,
                                  struct csg_vec3 p)
{
    const bool flat = screen->orthographic;
    const struct csg_vec3 across = csg_sub(p, screen->origin);
    const double t = csg_dot(across, screen->forward), w = flat ? 1 : t;
    const struct csg_vec3 dx = flat ? screen->origin_dx : screen->direction_dx;
    const struct csg_vec3 dy = flat ? screen->origin_dy : screen->direction_dy;
    const struct csg_vec3 off = flat ? across : csg_sub(across, csg_scale(t, screen->direction));
    return (struct homogeneous){csg_dot(off, dx) / csg_dot(dx, dx) - w * at.x,
                                csg_dot(off, dy) / csg_dot(dy, dy) - w * at.y, w, t};
}

static struct csg_view_point view_point(const struct csg_surface_view *view,
                                        const struct csg_screen *screen, struct csg_pixel at,
                                        struct csg_vec3 p)
{
    const struct homogeneous h = project(screen, at, p);
    if (!(h.t > view->tnear))
        return (struct csg_view_point){NAN, NAN, NAN};
    return (struct csg_view_point){h.x / h.w, h.y / h.w, csg_screen_key(screen, h.t)};
}

static const struct csg_view_node nowhere = {
    {INFINITY, INFINITY}, {-INFINITY, -INFINITY}, INFINITY, -INFINITY};

static void extend(struct csg_view_node *node, const struct csg_view_node *by)
{
    for (int i = 0; i < 2; i++) {
        node->lo[i] = csg_least(node->lo[i], by->lo[i]);
        node->hi[i] = csg_most(node->hi[i], by->hi[i]);
    }
    node->near = csg_least(node->near, by->near);
    node->far = csg_most(node->far, by->far);
}

/* A triangle that is partly behind the eye may be anywhere in front of it. */
static struct csg_view_node cut_triangle(const struct csg_view_point *points[3])
{
    struct csg_view_node node = {
        {-INFINITY, -INFINITY}, {INFINITY, INFINITY}, -(double)CSG_KEY_MAX, -INFINITY};
    for (int i = 0; i < 3; i++)
        if (!isnan(points[i]->key))
            node.far = fmax(node.far, points[i]->key);
    return node.far > -INFINITY ? node : nowhere;
}

static double least(double a, double b, double c)
{
    const double ab = a < b ? a : b;
    return ab < c ? ab : c;
}

static struct csg_view_node view_triangle(const struct csg_surface_view *view, uint32_t triangle)
{
    const uint32_t *corners = view->surface->triangles.data[triangle].points;
    const struct csg_view_point *p[3] = {&view->points[corners[0]], &view->points[corners[1]],
                                         &view->points[corners[2]]};
    if (isnan(p[0]->key + p[1]->key + p[2]->key))
        return cut_triangle(p);
    return (struct csg_view_node){{least(p[0]->x, p[1]->x, p[2]->x) - RECT_MARGIN,
                                   least(p[0]->y, p[1]->y, p[2]->y) - RECT_MARGIN},
                                  {RECT_MARGIN - least(-p[0]->x, -p[1]->x, -p[2]->x),
                                   RECT_MARGIN - least(-p[0]->y, -p[1]->y, -p[2]->y)},
                                  least(p[0]->key, p[1]->key, p[2]->key),
                                  -least(-p[0]->key, -p[1]->key, -p[2]->key)};
}

/* Whether a half number is between lo and hi. What is added and taken away rounds to a whole
 * number; floor() is a call where processors need not have the instruction. */
static bool holds_half(double lo, double hi)
{
    static const double whole = 0x1.8p52;
    const double top = hi + 0.5, nearest = (top + whole) - whole;
    return (nearest > top ? nearest - 1 : nearest) >= lo + 0.5;
}

/* Whether a pixel's centre is within. */
static bool holds_center(const struct csg_view_node *node)
{
    return holds_half(node->lo[0], node->hi[0]) && holds_half(node->lo[1], node->hi[1]);
}

static void fill_nodes(struct csg_surface_view *view)
{
    const struct csg_box_node *nodes = view->surface->nodes.data;
    for (size_t i = view->surface->nodes.num; i-- > 0;) {
        struct csg_view_node node = nowhere;
        for (uint32_t j = 0; j < nodes[i].num; j++) {
            const struct csg_view_node triangle = view_triangle(view, nodes[i].first + j);
            if (holds_center(&triangle))
                extend(&node, &triangle);
        }
        if (nodes[i].num == 0) {
            node = view->nodes[i + 1];
            extend(&node, &view->nodes[nodes[i + 1].end]);
        }
        view->nodes[i] = node;
    }
}

static void set_near(struct csg_surface_view *view, const struct csg_screen *screen)
{
    const struct csg_box box = csg_box_map(&view->place, &view->surface->nodes.data[0].box);
    const struct csg_vec3 center = csg_scale(0.5, csg_add(box.lo, box.hi));
    const double radius = 0.5 * csg_length(csg_sub(box.hi, box.lo));
    const double distance = csg_length(csg_sub(center, screen->origin));
    const double t = fmax(distance - radius, NEAR_SHARE * radius);
    view->tnear = screen->orthographic ? -INFINITY : NEAR_SHARE * (radius + distance);
    view->slack =
        SLACK_ROUNDINGS * view->rounding * (screen->orthographic ? 1 : screen->b / (t * t));
    view->turns =
        screen->orthographic ? 0 : csg_surface_winding(view->surface, &view->place, screen->origin);
}

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

struct projection {
    struct csg_surface_view *views;
    const struct csg_screen *screen;
    struct csg_pixel at;
};

/* A view without points is one for which there was no memory. */
static void project_view(void *user, size_t task)
{
    const struct projection *projection = user;
    struct csg_surface_view *view = &projection->views[task];
    const struct csg_surface *surface = view->surface;
    view->nodes = malloc((surface->nodes.num + 1) * sizeof *view->nodes);
    view->points = view->nodes ? malloc((surface->points.num + 1) * sizeof *view->points) : NULL;
    if (!view->points)
        return;
    if (surface->nodes.num && !view->spare)
        set_near(view, projection->screen);
    else
        view->tnear = INFINITY; /* nothing is in front */
    for (size_t i = 0; i < surface->points.num; i++)
        view->points[i] = view_point(view, projection->screen, projection->at,
                                     csg_map_point(&view->place, surface->points.data[i]));
    fill_nodes(view);
}

bool csg_surface_views_project(const struct csg_surface_views *views,
                               const struct csg_screen *screen, struct csg_pixel at,
                               int num_threads)
{
    const struct projection projection = {views->data, screen, at};
    size_t num_points = 0;
    for (size_t i = 0; i < views->num; i++)
        num_points += views->data[i].surface->points.num;
    csg_parallel(num_points < MIN_POINTS ? 1 : num_threads, views->num, project_view,
                 (void *)&projection);
    for (size_t i = 0; i < views->num; i++)
        if (!views->data[i].points)
            return false;
    return true;
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
    struct csg_view_node sum = nowhere;
    for (size_t i = 0; i < view->surface->nodes.num;) {
        const struct csg_view_node *node = &view->nodes[i];
        if (!overlaps(node, rect)) {
            i = nodes[i].end;
        } else if (nodes[i].num || is_within(node, rect)) {
            extend(&sum, node);
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
            const struct csg_view_node node = view_triangle(view, nodes[i].first + j);
            if (overlaps(&node, rect) && holds_center(&node) &&
                !csg_array_push(list, nodes[i].first + j))
                return false;
        }
        i++;
    }
    return true;
}

/* Where the edge between a corner behind and one in front is cut; the former comes first, so that
 * both triangles of the edge get the same. */
static void cut_edge(const struct homogeneous *behind, const struct homogeneous *front, double t,
                     double place[2])
{
    const double s = (t - behind->t) / (front->t - behind->t);
    place[0] = (behind->x + s * (front->x - behind->x)) / t;
    place[1] = (behind->y + s * (front->y - behind->y)) / t;
}

int csg_surface_view_polygon(const struct csg_surface_view *view, const struct csg_screen *screen,
                             struct csg_pixel at, uint32_t triangle, double polygon[4][2])
{
    uint32_t corners[3];
    struct homogeneous h[3] = {{0}};
    bool front[3];
    bool all = true;
    csg_triangle_corners(&view->surface->triangles.data[triangle], view->is_mirrored, corners);
    for (int i = 0; i < 3; i++) {
        front[i] = !isnan(view->points[corners[i]].key);
        all &= front[i];
    }
    for (int i = 0; i < 3 && !all; i++)
        h[i] = project(screen, at,
                       csg_map_point(&view->place, view->surface->points.data[corners[i]]));
    int num = 0;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        if (front[i]) {
            polygon[num][0] = view->points[corners[i]].x;
            polygon[num++][1] = view->points[corners[i]].y;
        }
        if (front[i] != front[j])
            cut_edge(&h[front[i] ? j : i], &h[front[i] ? i : j], view->tnear, polygon[num++]);
    }
    return num;
}
