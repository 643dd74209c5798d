/* SPDX-License-Identifier: MIT */
#include "carrier/kin.h"

#include <stdlib.h>

#include "carrier/builder.h"

struct kin {
    const struct csgcast_scene *scene;
    const struct csg_carriers *carriers;
    const uint32_t *changed;
    uint32_t *tallies[CSG_NUM_FACE_KINDS]; /* by carrier: faces of the object at hand on it */
};

static void tally(struct kin *kin, enum csg_face_kind kind, uint32_t carrier, uint32_t step)
{
    if (carrier != CSG_NO_CARRIER)
        kin->tallies[kind][carrier] += step;
}

static void tally_leaf(struct kin *kin, uint32_t leaf, uint32_t step)
{
    const struct csg_carriers *carriers = kin->carriers;
    tally(kin, CSG_QUADRIC, carriers->quadric_faces[leaf].carrier, step);
    for (uint32_t i = carriers->face_begin[leaf]; i < carriers->face_begin[leaf + 1]; i++)
        tally(kin, CSG_PLANE, carriers->faces[i].carrier, step);
}

/* Adds step for each of the object's faces. */
static void tally_object(struct kin *kin, const struct csg_object *object, uint32_t step)
{
    const struct csg_node *nodes = kin->scene->trees[object->layer].data;
    for (uint32_t i = object->begin; i < object->end; i++)
        if (nodes[i].op == CSG_LEAF && !nodes[i].spare)
            tally_leaf(kin, nodes[i].leaf, step);
}

static bool is_shared(const struct kin *kin, enum csg_face_kind kind, uint32_t carrier)
{
    return carrier != CSG_NO_CARRIER &&
           kin->carriers->kept->lists[kind].uses.data[carrier] > kin->tallies[kind][carrier];
}

static bool has_leaf_kin(const struct kin *kin, uint32_t leaf)
{
    const struct csg_carriers *carriers = kin->carriers;
    if (!carriers->kept->wanted[leaf])
        return false;
    bool found = is_shared(kin, CSG_QUADRIC, carriers->quadric_faces[leaf].carrier);
    for (uint32_t i = carriers->face_begin[leaf]; i < carriers->face_begin[leaf + 1] && !found; i++)
        found = is_shared(kin, CSG_PLANE, carriers->faces[i].carrier);
    return found;
}

static bool has_object_kin(struct kin *kin, const struct csg_object *object)
{
    const struct csg_node *nodes = kin->scene->trees[object->layer].data;
    bool found = false;
    tally_object(kin, object, 1);
    for (uint32_t i = object->begin; i < object->end && !found; i++)
        found = nodes[i].op == CSG_LEAF && kin->changed[nodes[i].leaf] &&
                has_leaf_kin(kin, nodes[i].leaf);
    tally_object(kin, object, UINT32_MAX); /* takes them off again */
    return found;
}

bool csg_carrier_find_kin(const struct csgcast_scene *scene, const struct csg_carriers *carriers,
                          const uint32_t *changed, const uint32_t *objects, size_t num, bool *found)
{
    *found = false;
    if (carriers->num_shared == 0)
        return true;
    struct kin kin = {scene, carriers, changed, {NULL}};
    kin.tallies[CSG_PLANE] = calloc(carriers->num_planes + 1, sizeof(uint32_t));
    kin.tallies[CSG_QUADRIC] = calloc(carriers->num_quadrics + 1, sizeof(uint32_t));
    const bool ok = kin.tallies[CSG_PLANE] && kin.tallies[CSG_QUADRIC];
    for (size_t i = 0; i < num && ok && !*found; i++)
        *found = has_object_kin(&kin, &scene->objects->data[objects[i]]);
    free(kin.tallies[CSG_PLANE]);
    free(kin.tallies[CSG_QUADRIC]);
    return ok;
}
