/* SPDX-License-Identifier: MIT */
#include "carrier/carrier.h"

#include <stdlib.h>

#include "carrier/builder.h"
#include "carrier/own_faces.h"
#include "csg/object.h"

uint32_t csg_num_faces(const struct csgcast_scene *scene, uint32_t leaf)
{
    const struct csg_shape *shape = &scene->leaves[leaf].shape;
    return shape->surface ? (uint32_t)shape->surface->planes.num : shape->num_planes;
}

struct csg_plane csg_carrier_of_face(const struct csgcast_scene *scene, uint32_t leaf,
                                     uint32_t face, const struct csg_map *inverse, bool *flipped)
{
    const struct csg_carriers *carriers = scene->carriers;
    const struct csg_surface *surface = scene->leaves[leaf].shape.surface;
    const uint32_t begin = carriers->face_begin[leaf];
    const bool is_own = surface && (begin == carriers->face_begin[leaf + 1] ||
                                    carriers->faces[begin + face].carrier == CSG_NO_CARRIER);
    *flipped = is_own ? surface->own[face].flipped : carriers->faces[begin + face].flipped;
    return is_own ? csg_own_plane(surface, surface->own[face].plane, inverse)
                  : carriers->planes[carriers->faces[begin + face].carrier];
}

/* Faces of surfaces have a place where not all are remote. */
static size_t count_faces(const struct csg_carrier_builder *builder, size_t leaf)
{
    const struct csg_shape *shape = &builder->scene->leaves[leaf].shape;
    if (!shape->surface)
        return shape->num_planes;
    return builder->remote.near && builder->remote.near[leaf] ? shape->surface->planes.num : 0;
}

bool csg_carriers_allocate_faces(struct csg_carrier_builder *builder)
{
    struct csg_carriers *carriers = builder->carriers;
    const struct csgcast_scene *scene = builder->scene;
    const size_t num = scene->num_leaves;
    carriers->face_begin = malloc((num + 1) * sizeof *carriers->face_begin);
    if (!carriers->face_begin)
        return false;
    uint32_t total = 0;
    for (size_t i = 0; i < num; i++) {
        carriers->face_begin[i] = total;
        total += (uint32_t)count_faces(builder, i);
    }
    carriers->face_begin[num] = total;
    carriers->faces = calloc(total + 1, sizeof *carriers->faces);
    carriers->quadric_faces = malloc((num + 1) * sizeof *carriers->quadric_faces);
    carriers->sheets = calloc(num + 1, sizeof *carriers->sheets);
    if (!carriers->faces || !carriers->quadric_faces || !carriers->sheets)
        return false;
    for (size_t i = 0; i < num; i++)
        carriers->quadric_faces[i] = (struct csg_face){.carrier = CSG_NO_CARRIER};
    return true;
}

/* Edits are followed where leaves have bounds and are no specks: what the others' faces lie on
 * depends on more than the faces near them. */
static bool can_keep(const struct csg_carrier_builder *builder)
{
    for (size_t i = 0; i < builder->leaves.num; i++)
        if (!csg_carrier_can_follow(builder, builder->leaves.data[i].leaf))
            return false;
    return builder->leaves.num > 1;
}

/* Likewise the faces of surfaces, which are placed for that. */
static bool place_faces(struct csg_carrier_builder *builder)
{
    for (uint32_t i = 0; builder->placed && i < builder->scene->num_leaves && builder->keeps; i++) {
        const struct csg_shape *shape = &builder->scene->leaves[i].shape;
        const uint8_t *near = builder->remote.near[i];
        if (!near)
            continue;
        builder->placed[i] = csg_placed_faces_create(shape);
        if (!builder->placed[i])
            return false;
        builder->keeps = csg_carrier_can_follow_faces(builder->placed[i], near, shape);
    }
    return true;
}

static bool find_remote(struct csg_carrier_builder *builder)
{
    if (!csg_remote_find(&builder->remote, builder->scene, builder->wanted,
                         csg_remote_rounding(builder->largest_rounding)))
        return false;
    if (builder->remote.near)
        builder->placed = calloc(builder->scene->num_leaves + 1, sizeof *builder->placed);
    return builder->placed || !builder->remote.near;
}

static bool start(struct csg_carrier_builder *builder)
{
    return csg_carrier_outline(builder) && find_remote(builder) && place_faces(builder) &&
           csg_carrier_start_index(builder);
}

static bool index_carriers(struct csg_carrier_builder *builder)
{
    const struct csg_carriers *carriers = builder->carriers;
    bool ok = true;
    for (uint32_t i = 0; i < carriers->num_planes && ok; i++)
        ok = csg_index_add_plane(&builder->index, &carriers->planes[i], i);
    for (uint32_t i = 0; i < carriers->num_quadrics && ok; i++)
        ok = csg_index_add_quadric(&builder->index,
                                   csg_carrier_quadric(builder->scene, carriers, i), i);
    return ok;
}

/* For edits, the index is made anew with room for them, and with all faces. Its cells are so much
 * wider that to look for every face in them would take much longer than in those of the scene. */
static bool make_room(struct csg_carrier_builder *builder)
{
    csg_index_finish(&builder->index);
    csg_loners_finish(&builder->loners);
    builder->index = (struct csg_carrier_index){0};
    builder->has_room = true;
    return csg_carrier_outline(builder) && csg_carrier_start_index(builder) &&
           index_carriers(builder);
}

/* Coincidence is looked for among all leaves: flush faces of different objects share carriers too,
 * so that the depth buffer sees equal depths and the first object wins everywhere. */
static bool assign_all(struct csg_carrier_builder *builder)
{
    if (!csg_carrier_rank_leaves(builder))
        return false;
    builder->keeps = builder->keeps && can_keep(builder);
    builder->is_alone = builder->leaves.num == 1 &&
                        !builder->scene->leaves[builder->leaves.data[0].leaf].shape.surface;
    if (!builder->is_alone && !start(builder))
        return false;
    if (!csg_carriers_allocate_faces(builder) ||
        (!builder->is_alone && !csg_loners_find(&builder->loners, builder)))
        return false;
    for (size_t i = 0; i < builder->leaves.num; i++)
        if (!csg_carrier_assign_leaf(builder, &builder->leaves.data[i]))
            return false;
    return !builder->keeps || make_room(builder);
}

/* Whether each object is one leaf, and all of a quadric that can be seen is the leaf it came
 * from. */
static bool are_boxes_of_leaves(const struct csgcast_scene *scene,
                                const struct csg_carriers *carriers)
{
    for (size_t i = 0; i < scene->objects->num; i++) {
        const struct csg_object *object = &scene->objects->data[i];
        const struct csg_node *node = &scene->trees[object->layer].data[object->begin];
        if (object->end != object->begin + 1 || node->op != CSG_LEAF || node->spare)
            return false;
        const uint32_t carrier = carriers->quadric_faces[node->leaf].carrier;
        if (carrier != CSG_NO_CARRIER && carriers->quadric_leaves[carrier] != node->leaf)
            return false;
    }
    return true;
}

/* Its leaves, as far as the objects reach that they are in. */
bool csg_carriers_fill_boxes(const struct csgcast_scene *scene, struct csg_carriers *carriers)
{
    const size_t num = carriers->num_quadrics;
    carriers->quadric_boxes = NULL;
    if (are_boxes_of_leaves(scene, carriers))
        return true;
    carriers->quadric_boxes = malloc((num + 1) * sizeof *carriers->quadric_boxes);
    if (!carriers->quadric_boxes)
        return false;
    for (size_t i = 0; i < num; i++)
        carriers->quadric_boxes[i] = csg_box_empty;
    for (size_t i = 0; i < scene->objects->num; i++) {
        const struct csg_object *object = &scene->objects->data[i];
        const struct csg_node *nodes = scene->trees[object->layer].data;
        for (uint32_t j = object->begin; j < object->end; j++) {
            const struct csg_face face = nodes[j].op == CSG_LEAF && !nodes[j].spare
                                             ? carriers->quadric_faces[nodes[j].leaf]
                                             : (struct csg_face){.carrier = CSG_NO_CARRIER};
            if (face.carrier == CSG_NO_CARRIER)
                continue;
            struct csg_box box = scene->leaves[nodes[j].leaf].box;
            box = csg_box_intersection(&box, &object->box);
            if (!csg_box_is_empty(&box))
                carriers->quadric_boxes[face.carrier] =
                    csg_box_union(&carriers->quadric_boxes[face.carrier], &box);
        }
    }
    return true;
}

void csg_carrier_builder_finish(struct csg_carrier_builder *builder)
{
    csg_index_finish(&builder->index);
    for (size_t i = 0; builder->placed && i < builder->remote.num_leaves; i++)
        csg_placed_faces_destroy(builder->placed[i]);
    free(builder->placed);
    csg_remote_finish(&builder->remote);
    csg_loners_finish(&builder->loners);
    free(builder->wanted);
    csg_plane_table_finish(&builder->others);
    for (int kind = 0; kind < CSG_NUM_FACE_KINDS; kind++) {
        free(builder->lists[kind].rounding.data);
        free(builder->lists[kind].ranks.data);
        free(builder->lists[kind].uses.data);
        free(builder->lists[kind].free.data);
    }
    free(builder->leaves.data);
}

void csg_carrier_builder_destroy(struct csg_carrier_builder *builder)
{
    if (builder)
        csg_carrier_builder_finish(builder);
    free(builder);
}

struct csg_carriers *csg_carriers_create(const struct csgcast_scene *scene, bool keeps)
{
    struct csg_carriers *carriers = calloc(1, sizeof *carriers);
    struct csg_carrier_builder *builder = calloc(1, sizeof *builder);
    if (carriers && builder) {
        *builder =
            (struct csg_carrier_builder){.scene = scene, .carriers = carriers, .keeps = keeps};
        if (assign_all(builder) && csg_carriers_fill_boxes(scene, carriers)) {
            carriers->kept = builder->keeps ? builder : NULL;
            if (!builder->keeps)
                csg_carrier_builder_destroy(builder);
            return carriers;
        }
    }
    csg_carrier_builder_destroy(builder);
    csg_carriers_destroy(carriers);
    return NULL;
}

void csg_carriers_destroy(struct csg_carriers *carriers)
{
    if (!carriers)
        return;
    csg_carrier_builder_destroy(carriers->kept);
    free(carriers->planes);
    free(carriers->quadric_boxes);
    free(carriers->quadric_leaves);
    free(carriers->face_begin);
    free(carriers->faces);
    free(carriers->quadric_faces);
    free(carriers->sheets);
    free(carriers->renewed);
    free(carriers);
}
