/* SPDX-License-Identifier: MIT */

/* Corners of triangles and boxes of the hierarchy on the screen. */

#include "pack/surface.h"

#include <stdlib.h>

#include "common/parallel.h"

/* Triangles are cut off nearer than this share of the surface's distance and size. */
#define NEAR_SHARE 1e-11

/* Part of a pixel by which rectangles grow: corners are rounded to float later. */
#define RECT_MARGIN 1e-3

/* Pixels that are farther from the reference pixel are none of the picture's. */
#define FAR_PIXEL (1 << 30)

/* Along the ray a carrier may lie off its face by this many times the rounding of the file. */
#define SLACK_ROUNDINGS 16.0

/* Fewer points are projected before threads have started. */
#define MIN_POINTS 10000

/* Where a surface has fewer pixels in the picture for each of its triangles, or less than this
 * share of its rectangle is there, it is projected from the top of the hierarchy down (measured).
 */
#define FEW_PIXELS 0.03
#define SMALL_SHARE 0.5

/* ---- points ------------------------------------------------------------------------------- */

/* v . (p - origin of the rays) + start, p being where the view has a point of its surface. Counted
 * from the surface's middle, so that nothing cancels where the surface is far from its origin. */
static struct csg_view_row row_of(const struct csg_surface_view *view,
                                  const struct csg_screen *screen, struct csg_vec3 v, double start)
{
    const struct csg_vec3 moved =
        csg_sub(csg_map_point(&view->place, view->middle), screen->origin);
    return (struct csg_view_row){csg_map_transposed(&view->place, v), start + csg_dot(v, moved)};
}

static struct csg_view_row pixel_row(const struct csg_surface_view *view,
                                     const struct csg_screen *screen, struct csg_vec3 step,
                                     double at)
{
    const struct csg_vec3 v = csg_scale(1 / csg_dot(step, step), step);
    if (screen->orthographic)
        return row_of(view, screen, v, -at);
    const double along = csg_dot(screen->direction, v) + at;
    return row_of(view, screen, csg_sub(v, csg_scale(along, screen->forward)), 0);
}

static void set_rows(struct csg_surface_view *view, const struct csg_screen *screen,
                     struct csg_pixel at)
{
    const bool flat = view->flat = screen->orthographic;
    view->middle = csg_box_middle(&view->surface->nodes.data[0].box);
    view->x = pixel_row(view, screen, flat ? screen->origin_dx : screen->direction_dx, at.x);
    view->y = pixel_row(view, screen, flat ? screen->origin_dy : screen->direction_dy, at.y);
    view->t = row_of(view, screen, screen->forward, 0);
}

/* p: counted from the middle. */
static double ask_row(const struct csg_view_row *row, struct csg_vec3 p)
{
    return csg_dot(row->step, p) + row->start;
}

struct csg_view_place csg_view_place_of(const struct csg_surface_view *view, struct csg_vec3 p)
{
    const struct csg_vec3 off = csg_sub(p, view->middle);
    return (struct csg_view_place){ask_row(&view->x, off), ask_row(&view->y, off),
                                   ask_row(&view->t, off)};
}

/* floor() is a call where processors need not have the instruction. */
static int32_t whole_below(double x)
{
    const double near = csg_most(-FAR_PIXEL, csg_least(x, FAR_PIXEL));
    const int32_t whole = (int32_t)near;
    return whole - (whole > near);
}

static struct csg_view_point view_point(const struct csg_surface_view *view,
                                        const struct csg_screen *screen, struct csg_vec3 p)
{
    const struct csg_view_place place = csg_view_place_of(view, p);
    const double w = view->flat ? 1 : place.t, x = place.x / w, y = place.y / w;
    if (!(place.t > view->tnear))
        return (struct csg_view_point){
            NAN, NAN, NAN, {-FAR_PIXEL, -FAR_PIXEL}, {FAR_PIXEL, FAR_PIXEL}};
    return (struct csg_view_point){
        x,
        y,
        csg_screen_key(screen, place.t),
        {-whole_below(RECT_MARGIN + 0.5 - x), -whole_below(RECT_MARGIN + 0.5 - y)},
        {whole_below(x + RECT_MARGIN - 0.5), whole_below(y + RECT_MARGIN - 0.5)}};
}

/* ---- triangles ---------------------------------------------------------------------------- */

const struct csg_view_node csg_view_nowhere = {
    {INFINITY, INFINITY}, {-INFINITY, -INFINITY}, INFINITY, -INFINITY};

void csg_view_node_extend(struct csg_view_node *node, const struct csg_view_node *by)
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
    return node.far > -INFINITY ? node : csg_view_nowhere;
}

/* Whether a pixel's centre is in the rectangle around the corners, or one is behind the eye. */
static bool holds_pixel(const struct csg_view_point *p[3])
{
    for (int i = 0; i < 2; i++) {
        int32_t first = p[0]->first[i], last = p[0]->last[i];
        for (int j = 1; j < 3; j++) {
            first = p[j]->first[i] < first ? p[j]->first[i] : first;
            last = p[j]->last[i] > last ? p[j]->last[i] : last;
        }
        if (first > last)
            return false;
    }
    return true;
}

static double least(double a, double b, double c)
{
    return csg_least(csg_least(a, b), c);
}

bool csg_view_triangle(const struct csg_surface_view *view, uint32_t triangle,
                       struct csg_view_node *node)
{
    const uint32_t *corners = view->surface->triangles.data[triangle].points;
    const struct csg_view_point *p[3] = {&view->points[corners[0]], &view->points[corners[1]],
                                         &view->points[corners[2]]};
    if (!holds_pixel(p))
        return false;
    if (isnan(p[0]->key + p[1]->key + p[2]->key)) {
        *node = cut_triangle(p);
        return node->near <= node->far;
    }
    node->lo[0] = least(p[0]->x, p[1]->x, p[2]->x) - RECT_MARGIN;
    node->hi[0] = RECT_MARGIN - least(-p[0]->x, -p[1]->x, -p[2]->x);
    node->lo[1] = least(p[0]->y, p[1]->y, p[2]->y) - RECT_MARGIN;
    node->hi[1] = RECT_MARGIN - least(-p[0]->y, -p[1]->y, -p[2]->y);
    node->near = least(p[0]->key, p[1]->key, p[2]->key);
    node->far = -least(-p[0]->key, -p[1]->key, -p[2]->key);
    return true;
}

/* ---- the hierarchy ------------------------------------------------------------------------ */

static void fill_leaf(struct csg_surface_view *view, size_t i)
{
    const struct csg_box_node *leaf = &view->surface->nodes.data[i];
    view->nodes[i] = csg_view_nowhere;
    for (uint32_t j = 0; j < leaf->num; j++) {
        struct csg_view_node triangle;
        if (csg_view_triangle(view, leaf->first + j, &triangle))
            csg_view_node_extend(&view->nodes[i], &triangle);
    }
}

/* An inner node, from its children. */
static void fill_inner(struct csg_surface_view *view, size_t i)
{
    view->nodes[i] = view->nodes[i + 1];
    csg_view_node_extend(&view->nodes[i], &view->nodes[view->surface->nodes.data[i + 1].end]);
}

static void fill_all(struct csg_surface_view *view, const struct csg_screen *screen)
{
    const struct csg_surface *surface = view->surface;
    for (size_t i = 0; i < surface->points.num; i++)
        view->points[i] = view_point(view, screen, surface->points.data[i]);
    for (size_t i = surface->nodes.num; i-- > 0;)
        if (surface->nodes.data[i].num)
            fill_leaf(view, i);
        else
            fill_inner(view, i);
}

/* Half the extent of a row over a box of half the size half. */
static double reach(struct csg_vec3 step, struct csg_vec3 half)
{
    return fabs(step.x) * half.x + fabs(step.y) * half.y + fabs(step.z) * half.z;
}

/* The least and the largest of x / w over a box; inverse: of the least and the largest w. */
static void pixel_range(const struct csg_view_row *row, struct csg_vec3 middle,
                        struct csg_vec3 half, const double inverse[2], double range[2])
{
    const double x = ask_row(row, middle), r = reach(row->step, half);
    range[0] = (x - r) * inverse[x - r < 0 ? 0 : 1] - 2 * RECT_MARGIN;
    range[1] = (x + r) * inverse[x + r < 0 ? 1 : 0] + 2 * RECT_MARGIN;
}

/* The pixels that can show what is in a box of the surface; false: it reaches behind the eye. */
static bool box_rect(const struct csg_surface_view *view, const struct csg_box *box,
                     struct csg_view_rect *rect)
{
    const struct csg_vec3 middle = csg_sub(csg_box_middle(box), view->middle);
    const struct csg_vec3 half = csg_scale(0.5, csg_sub(box->hi, box->lo));
    const double t = ask_row(&view->t, middle), depth = reach(view->t.step, half);
    const bool flat = view->flat;
    double x[2], y[2];
    if (!(t - depth > view->tnear))
        return false;
    const double inverse[2] = {flat ? 1 : 1 / (t - depth), flat ? 1 : 1 / (t + depth)};
    pixel_range(&view->x, middle, half, inverse, x);
    pixel_range(&view->y, middle, half, inverse, y);
    *rect = (struct csg_view_rect){{x[0], y[0]}, {x[1], y[1]}};
    return true;
}

/* Leaves the part that is in the picture, with the pixels beside it that drivers draw. */
static void clip_rect(struct csg_view_rect *rect, const struct csg_view_rect *picture)
{
    for (int i = 0; i < 2; i++) {
        rect->lo[i] = csg_most(rect->lo[i], picture->lo[i]);
        rect->hi[i] = csg_least(rect->hi[i], picture->hi[i]);
    }
}

/* Whether a pixel's centre is in it. */
static bool holds_center(const struct csg_view_rect *rect)
{
    return whole_below(rect->hi[0] + 0.5) >= rect->lo[0] + 0.5 &&
           whole_below(rect->hi[1] + 0.5) >= rect->lo[1] + 0.5;
}

static bool shows_nothing(const struct csg_surface_view *view, const struct csg_box *box,
                          const struct csg_view_rect *picture)
{
    struct csg_view_rect rect;
    if (!box_rect(view, box, &rect))
        return false;
    clip_rect(&rect, picture);
    return !holds_center(&rect);
}

/* Points of the leaf's triangles that are not there yet. */
static void project_leaf(struct csg_surface_view *view, const struct csg_screen *screen,
                         const struct csg_box_node *leaf, bool *is_there)
{
    const struct csg_surface *surface = view->surface;
    for (uint32_t i = leaf->first; i < leaf->first + leaf->num; i++)
        for (int j = 0; j < 3; j++) {
            const uint32_t point = surface->triangles.data[i].points[j];
            if (!is_there[point])
                view->points[point] = view_point(view, screen, surface->points.data[point]);
            is_there[point] = true;
        }
}

/* From the top down, so that what holds no pixel's centre of the picture is left out as a whole:
 * neither the nodes in it nor its points are ever asked for. inner: room for as many as nodes. */
static void fill_shown(struct csg_surface_view *view, const struct csg_screen *screen,
                       const struct csg_view_rect *picture, bool *is_there, uint32_t *inner)
{
    const struct csg_box_node *nodes = view->surface->nodes.data;
    size_t num_inner = 0;
    for (uint32_t i = 0; i < view->surface->nodes.num;) {
        if (shows_nothing(view, &nodes[i].box, picture)) {
            view->nodes[i] = csg_view_nowhere;
            i = nodes[i].end;
            continue;
        }
        if (nodes[i].num) {
            project_leaf(view, screen, &nodes[i], is_there);
            fill_leaf(view, i);
        } else {
            inner[num_inner++] = i;
        }
        i++;
    }
    while (num_inner > 0)
        fill_inner(view, inner[--num_inner]);
}

static double area_of(const struct csg_view_rect *rect)
{
    return csg_most(rect->hi[0] - rect->lo[0], 0) * csg_most(rect->hi[1] - rect->lo[1], 0);
}

/* Whether the picture shows little enough of the surface. */
static bool shows_little(const struct csg_surface_view *view, const struct csg_view_rect *picture)
{
    struct csg_view_rect rect;
    if (!box_rect(view, &view->surface->nodes.data[0].box, &rect))
        return true;
    const double all = area_of(&rect);
    clip_rect(&rect, picture);
    const double shown = area_of(&rect);
    return shown < SMALL_SHARE * all || shown < FEW_PIXELS * (double)view->surface->triangles.num;
}

/* ---- views -------------------------------------------------------------------------------- */

static void set_near(struct csg_surface_view *view, const struct csg_screen *screen)
{
    const struct csg_box box = csg_box_map(&view->place, &view->surface->nodes.data[0].box);
    const struct csg_vec3 center = csg_box_middle(&box);
    const double radius = 0.5 * csg_length(csg_sub(box.hi, box.lo));
    const double distance = csg_length(csg_sub(center, screen->origin));
    const double t = fmax(distance - radius, NEAR_SHARE * radius);
    view->tnear = screen->orthographic ? -INFINITY : NEAR_SHARE * (radius + distance);
    view->slack =
        SLACK_ROUNDINGS * view->rounding * (screen->orthographic ? 1 : screen->b / (t * t));
    view->turns =
        screen->orthographic ? 0 : csg_surface_winding(view->surface, &view->place, screen->origin);
}

static struct csg_view_rect picture_of(const struct csg_screen *screen, struct csg_pixel at)
{
    return (struct csg_view_rect){
        {-CSG_PIXEL_BLOCK - at.x, -CSG_PIXEL_BLOCK - at.y},
        {screen->width + CSG_PIXEL_BLOCK - at.x, screen->height + CSG_PIXEL_BLOCK - at.y}};
}

/* false: out of memory. */
static bool fill(struct csg_surface_view *view, const struct csg_screen *screen,
                 struct csg_pixel at)
{
    const struct csg_surface *surface = view->surface;
    const struct csg_view_rect picture = picture_of(screen, at);
    if (!shows_little(view, &picture)) {
        fill_all(view, screen);
        return true;
    }
    bool *is_there = calloc(surface->points.num + 1, sizeof *is_there);
    uint32_t *inner = malloc((surface->nodes.num + 1) * sizeof *inner);
    const bool ok = is_there && inner;
    if (ok)
        fill_shown(view, screen, &picture, is_there, inner);
    free(is_there);
    free(inner);
    return ok;
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
    if (!view->points || surface->nodes.num == 0)
        return;
    view->nodes[0] = csg_view_nowhere;
    if (view->spare)
        return;
    set_rows(view, projection->screen, projection->at);
    set_near(view, projection->screen);
    if (fill(view, projection->screen, projection->at))
        return;
    free(view->points);
    view->points = NULL;
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
