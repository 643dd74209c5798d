/* SPDX-License-Identifier: MIT */
#include "crowd/class.h"

#include "carrier/carrier.h"
#include "pack/precision.h"

enum { DISCS_KEY = CSG_CROWD_MAX_CLASSES - 3, ELLIPSOID_KEY, BALL_KEY };

/* Spare ones count as nothing: what is left is that solid, as it would be nothing where they
 * mattered. */
const struct csg_node *csg_crowd_only_node(const struct csgcast_scene *scene,
                                           const struct csg_object *object)
{
    const struct csg_node *nodes = scene->trees[object->layer].data, *single = NULL;
    for (uint32_t i = object->begin; i < object->end; i++) {
        if (nodes[i].op != CSG_LEAF || nodes[i].spare)
            continue;
        if (single || nodes[i].negated)
            return NULL;
        single = &nodes[i];
    }
    return single;
}

enum csg_outline csg_crowd_measure(const struct csgcast_scene *scene, uint32_t leaf,
                                   struct csg_outline_ball *ball, double numbers[CSG_OUTLINE_MAX])
{
    const struct csg_face face = scene->carriers->quadric_faces[leaf];
    const struct csg_quadric *quadric =
        face.carrier == CSG_NO_CARRIER ? NULL
                                       : csg_carrier_quadric(scene, scene->carriers, face.carrier);
    return csg_outline_of(&scene->leaves[leaf].shape, quadric, ball, numbers);
}

uint8_t csg_crowd_key(const struct csgcast_scene *scene, const struct csg_object *object,
                      float *need)
{
    const struct csg_node *node = csg_crowd_only_node(scene, object);
    if (!node || object->layer != CSG_LAYER_MODEL || object->paint != CSG_LAYER_MODEL)
        return CSG_CROWD_NO_CLASS;
    const struct csg_shape *shape = &scene->leaves[node->leaf].shape;
    const struct csg_face face = scene->carriers->quadric_faces[node->leaf];
    if (!shape->convex || shape->num_planes > CSG_CROWD_MAX_PLANES ||
        !csg_box_is_finite(&shape->bounds) || (!shape->has_quadric && !shape->num_planes) ||
        (shape->has_quadric && face.flipped))
        return CSG_CROWD_NO_CLASS;
    const struct csg_sharpness sharp =
        csg_sharpness_of(scene, (size_t)(object - scene->objects->data));
    *need = (float)csg_precision_need(&sharp);
    if (sharp.least[CSG_FINE_ANGLE] < CSG_FINE_MAX_ANGLE)
        return CSG_CROWD_NO_CLASS;
    struct csg_outline_ball ball;
    double numbers[CSG_OUTLINE_MAX];
    switch (csg_crowd_measure(scene, node->leaf, &ball, numbers)) {
    case CSG_OUTLINE_BALL:
        return BALL_KEY;
    case CSG_OUTLINE_ELLIPSOID:
        return ELLIPSOID_KEY;
    case CSG_OUTLINE_DISCS:
        return DISCS_KEY;
    default:
        return (uint8_t)(2 * shape->num_planes + shape->has_quadric);
    }
}

struct csg_crowd_class csg_crowd_class_of(uint32_t key)
{
    if (key == BALL_KEY)
        return (struct csg_crowd_class){.outline = CSG_OUTLINE_BALL, .has_quadric = true};
    if (key == ELLIPSOID_KEY)
        return (struct csg_crowd_class){.outline = CSG_OUTLINE_ELLIPSOID, .has_quadric = true};
    if (key == DISCS_KEY)
        return (struct csg_crowd_class){
            .outline = CSG_OUTLINE_DISCS, .has_quadric = true, .num_planes = 2};
    return (struct csg_crowd_class){
        .outline = CSG_OUTLINE_BOX, .has_quadric = key % 2 == 1, .num_planes = key / 2};
}
