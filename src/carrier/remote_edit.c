/* SPDX-License-Identifier: MIT */

/*
 * Which faces of a surface are near after an edit of other leaves: those that the changed ones come
 * near as they are, and those that were near, but where only changed ones had been. These are asked
 * for among all leaves; they are few, as a leaf that is moved stays near most of what it was near.
 */
#include <stdlib.h>

#include "carrier/edit.h"
#include "carrier/nearness.h"
#include "carrier/remote.h"
#include "mesh/surface.h"

/* Marks of planes, on one face of each; see csg_nearness_mark. */
struct following {
    uint8_t *gone;  /* changed leaves were near it, and are not */
    uint8_t *near;  /* changed leaves are near it; in the end any leaf is */
    uint8_t *again; /* of those that are gone: another leaf is near it */
    uint8_t *nodes; /* by node of the surface's tree: a plane that is gone is in it */
};

static void mark_changed(const struct csgcast_scene *scene, const struct csg_nearness *own,
                         const struct csg_remote_edit *edit, const struct following *following)
{
    const struct csg_before *before = edit->before;
    for (size_t i = 0; i < before->num; i++) {
        const uint32_t leaf = before->leaves[i];
        const struct csg_shape *shape = before->shapes[i];
        const struct csg_neighbour is = csg_neighbour_of(scene, leaf);
        const struct csg_neighbour was = {shape, csg_box_map(&shape->frame, &shape->bounds)};
        if (edit->wanted_before[leaf])
            csg_nearness_mark(own, &was, following->gone);
        if (edit->wanted[leaf])
            csg_nearness_mark(own, &is, following->near);
    }
}

/* Whether any plane is gone. old: what was near. */
static bool find_gone(const struct csg_surface *surface, const uint8_t *old,
                      const struct following *following)
{
    bool is_any = false;
    for (size_t i = 0; i < surface->planes.num; i++) {
        following->gone[i] = following->gone[i] && old && old[i] && !following->near[i];
        is_any |= following->gone[i];
    }
    return is_any;
}

static void mark_nodes(const struct csg_surface *surface, const struct following *following)
{
    const struct csg_box_node *nodes = surface->nodes.data;
    uint8_t *marks = following->nodes;
    for (size_t i = surface->nodes.num; i-- > 0;) {
        for (uint32_t j = 0; j < nodes[i].num; j++) {
            const struct csg_triangle *triangle = &surface->triangles.data[nodes[i].first + j];
            marks[i] |= following->gone[surface->own[triangle->plane].plane];
        }
        for (size_t j = i + 1; j < nodes[i].end; j = nodes[j].end)
            marks[i] |= marks[j];
    }
}

static void find_again(const struct csgcast_scene *scene, const struct csg_nearness *own,
                       uint32_t leaf, const struct csg_remote_edit *edit,
                       const struct following *following)
{
    struct csg_nearness there = *own;
    mark_nodes(own->surface, following);
    there.only = following->nodes;
    for (uint32_t i = 0; i < scene->num_leaves; i++) {
        const struct csg_neighbour other = csg_neighbour_of(scene, i);
        if (i != leaf && edit->wanted[i] && !edit->before->changed[i])
            csg_nearness_mark(&there, &other, following->again);
    }
}

/* Whether any plane is near. old: what was. */
static bool keep_near(const struct csg_surface *surface, const uint8_t *old,
                      const struct following *following)
{
    bool is_any = false;
    for (size_t i = 0; i < surface->planes.num; i++) {
        const bool stays = old && old[i] && (!following->gone[i] || following->again[i]);
        following->near[i] |= stays && surface->own[i].plane == i;
        is_any |= following->near[i];
    }
    csg_nearness_spread(surface, following->near);
    return is_any;
}

bool csg_remote_follow_one(const struct csgcast_scene *scene, const struct csg_remote_edit *edit,
                           double rounding, uint32_t leaf, const uint8_t *old, uint8_t **near)
{
    const struct csg_nearness own = csg_nearness_to(scene, leaf, rounding);
    const size_t num = own.surface->planes.num + 1;
    const struct following following = {calloc(num, 1), calloc(num, 1), calloc(num, 1),
                                        calloc(own.surface->nodes.num + 1, 1)};
    const bool ok = following.gone && following.near && following.again && following.nodes;
    *near = NULL;
    if (ok) {
        mark_changed(scene, &own, edit, &following);
        if (find_gone(own.surface, old, &following))
            find_again(scene, &own, leaf, edit, &following);
        if (keep_near(own.surface, old, &following))
            *near = following.near;
    }
    if (!*near)
        free(following.near);
    free(following.gone);
    free(following.again);
    free(following.nodes);
    return ok;
}
