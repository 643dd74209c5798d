/* SPDX-License-Identifier: MIT */
#include "pack/seen.h"

#include <math.h>
#include <stdlib.h>

/* The terms of fewer leaves are soon made. */
#define MIN_NODES 256

/* Where the picture shows a larger share of the leaves, all are kept: cells need all. */
#define SMALL_SHARE 0.5

/* A face may be drawn on another one's carrier, off by far less, in pixels and in pictures. */
#define MARGIN_PIXELS 8.0
#define MARGIN_SHARE 0.05

enum { NUM_SIDES = 4 };

/* The sides of what the picture shows, normals outwards. A ray lies within all of them from its
 * start on. */
struct sides {
    struct csg_plane planes[NUM_SIDES];
};

static struct csg_vec3 point_of(const struct csg_screen *screen, struct csg_pixel at)
{
    return csg_add(csg_screen_origin(screen, at), csg_screen_direction(screen, at));
}

static struct sides find_sides(const struct csg_screen *screen)
{
    const double w = screen->width, h = screen->height;
    const double x = MARGIN_PIXELS + MARGIN_SHARE * w, y = MARGIN_PIXELS + MARGIN_SHARE * h;
    const struct csg_pixel corners[NUM_SIDES] = {
        {-x, -y}, {w + x, -y}, {w + x, h + y}, {-x, h + y}};
    const struct csg_vec3 middle = point_of(screen, (struct csg_pixel){0.5 * w, 0.5 * h});
    struct sides sides;
    for (int i = 0; i < NUM_SIDES; i++) {
        const struct csg_vec3 from = point_of(screen, corners[i]);
        const struct csg_vec3 to = point_of(screen, corners[(i + 1) % NUM_SIDES]);
        const struct csg_vec3 n =
            csg_cross(csg_screen_direction(screen, corners[i]), csg_sub(to, from));
        const double sign = csg_dot(n, csg_sub(middle, from)) > 0 ? -1 : 1;
        sides.planes[i].normal = csg_scale(sign, n);
        sides.planes[i].offset = csg_dot(sides.planes[i].normal, from);
    }
    return sides;
}

/* The least or the largest of n.p in a box. */
static double extreme(const struct csg_box *box, struct csg_vec3 n, bool largest)
{
    return n.x * ((n.x > 0) == largest ? box->hi.x : box->lo.x) +
           n.y * ((n.y > 0) == largest ? box->hi.y : box->lo.y) +
           n.z * ((n.z > 0) == largest ? box->hi.z : box->lo.z);
}

static bool misses(const struct sides *sides, const struct csg_box *box)
{
    for (int i = 0; i < NUM_SIDES; i++)
        if (extreme(box, sides->planes[i].normal, false) > sides->planes[i].offset)
            return true;
    return false;
}

static bool holds(const struct sides *sides, const struct csg_box *box)
{
    for (int i = 0; i < NUM_SIDES; i++)
        if (!(extreme(box, sides->planes[i].normal, true) <= sides->planes[i].offset))
            return false;
    return true;
}

/* Returns how many leaves may be seen. */
static size_t look(struct csg_seen *seen, const struct csgcast_scene *scene,
                   const struct sides *sides)
{
    size_t num = 0;
    for (uint32_t i = seen->begin; i < seen->end; i++) {
        const uint32_t leaf = seen->nodes[i].leaf;
        if (seen->nodes[i].op != CSG_LEAF)
            continue;
        const bool missed = misses(sides, &scene->leaves[leaf].box);
        seen->known[leaf] = missed ? CSG_NOTHING : CSG_VARIES;
        num += !missed;
    }
    return num;
}

void csg_seen_all(struct csg_seen *seen, const struct csgcast_scene *scene,
                  const struct csg_object *object)
{
    seen->nodes = scene->trees[object->layer].data;
    seen->begin = object->begin;
    seen->end = object->end;
    seen->is_part = false;
}

bool csg_seen_find(struct csg_seen *seen, const struct csgcast_scene *scene,
                   const struct csg_screen *screen, const struct csg_object *object)
{
    csg_seen_all(seen, scene, object);
    const size_t num = object->end - object->begin;
    if (num < MIN_NODES)
        return true;
    const struct sides sides = find_sides(screen);
    if (holds(&sides, &object->box))
        return true;
    if (!seen->known && !(seen->known = malloc(scene->num_leaves + 1)))
        return false;
    if ((double)look(seen, scene, &sides) > SMALL_SHARE * (double)num)
        return true;
    seen->tree.num = 0;
    if (!csg_tree_append(&seen->tree, seen->nodes, object->begin, object->end) ||
        !csg_tree_simplify_in(&seen->room, &seen->tree, seen->known))
        return false;
    seen->nodes = seen->tree.data;
    seen->begin = 0;
    seen->end = (uint32_t)seen->tree.num;
    seen->is_part = true;
    return true;
}

/* ---- where that is -------------------------------------------------------------------------- */

static struct csg_rect leaf_rect(const struct csgcast_scene *scene, const struct csg_screen *screen,
                                 const struct csg_node *node)
{
    const struct csg_shape *shape = &scene->leaves[node->leaf].shape;
    if (node->negated)
        return (struct csg_rect){{0, 0}, {screen->width, screen->height}};
    if (node->spare)
        return (struct csg_rect){{1, 1}, {0, 0}};
    return csg_screen_rect(screen, &shape->frame, &shape->bounds);
}

static void combine_rects(struct csg_rect *into, const struct csg_rect *rect, bool all)
{
    for (int i = 0; i < 2; i++) {
        into->lo[i] = all ? fmax(into->lo[i], rect->lo[i]) : fmin(into->lo[i], rect->lo[i]);
        into->hi[i] = all ? fmin(into->hi[i], rect->hi[i]) : fmax(into->hi[i], rect->hi[i]);
    }
}

static struct csg_rect node_rect(const struct csg_seen *seen, const struct csg_screen *screen,
                                 uint32_t i)
{
    const struct csg_node *nodes = seen->nodes;
    const bool all = nodes[i].op == CSG_AND;
    struct csg_rect rect = {{0, 0}, {screen->width, screen->height}};
    if (!all)
        rect = (struct csg_rect){{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (uint32_t child = i + 1; child < nodes[i].end; child = nodes[child].end) {
        const struct csg_rect *operand = &seen->rects.data[child - seen->begin];
        if (all || !csg_rect_is_empty(operand))
            combine_rects(&rect, operand, all);
    }
    return rect;
}

bool csg_seen_narrow(struct csg_seen *seen, const struct csgcast_scene *scene,
                     const struct csg_screen *screen, struct csg_rect *rect)
{
    seen->rects.num = 0;
    if (!csg_array_reserve(&seen->rects, seen->end - seen->begin))
        return false;
    for (uint32_t i = seen->end; i-- > seen->begin;)
        seen->rects.data[i - seen->begin] = seen->nodes[i].op == CSG_LEAF
                                                ? leaf_rect(scene, screen, &seen->nodes[i])
                                                : node_rect(seen, screen, i);
    combine_rects(rect, &seen->rects.data[0], true);
    return true;
}

void csg_seen_finish(struct csg_seen *seen)
{
    free(seen->tree.data);
    csg_tree_room_finish(&seen->room);
    free(seen->known);
    free(seen->rects.data);
}
