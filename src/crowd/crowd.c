/* SPDX-License-Identifier: MIT */
#include "crowd/crowd.h"

#include <stdlib.h>
#include <string.h>

#include "carrier/carrier.h"
#include "common/parallel.h"
#include "crowd/class.h"
#include "crowd/kin.h"
#include "crowd/tree_cast.h"
#include "csg/object.h"
#include "csg/prune.h"

struct builder {
    const struct csgcast_scene *scene;
    uint8_t *keys;     /* per object: csg_crowd_key, */
    float *needs;      /* ... and what csg_precision_need says of it then */
    uint32_t *parents; /* per object: see csg_kin_find */
};

/* Classes are drawn one after the other: kin of several classes are left to file order. */
static void part_classes(struct builder *builder)
{
    const size_t num = builder->scene->objects->num;
    for (uint32_t i = 0; i < num; i++) {
        const uint32_t root = csg_kin_root(builder->parents, i);
        if (builder->keys[i] != builder->keys[root])
            builder->keys[root] = CSG_CROWD_NO_CLASS;
    }
    for (uint32_t i = 0; i < num; i++)
        builder->keys[i] = builder->keys[csg_kin_root(builder->parents, i)];
}

/* Objects or members that one core looks at, at a time. */
enum { CHUNK = 4096 };

static size_t num_chunks(size_t num)
{
    return (num + CHUNK - 1) / CHUNK;
}

static void find_keys(void *user, size_t chunk)
{
    struct builder *builder = user;
    const struct csg_objects *objects = builder->scene->objects;
    for (size_t i = CHUNK * chunk; i < CHUNK * (chunk + 1) && i < objects->num; i++) {
        builder->keys[i] = csg_crowd_key(builder->scene, &objects->data[i], &builder->needs[i]);
        builder->parents[i] = (uint32_t)i;
    }
}

static bool classify(struct builder *builder)
{
    const size_t num = builder->scene->objects->num;
    builder->keys = malloc(num + 1);
    builder->needs = malloc((num + 1) * sizeof *builder->needs);
    builder->parents = malloc((num + 1) * sizeof *builder->parents);
    if (!builder->keys || !builder->needs || !builder->parents)
        return false;
    csg_parallel(builder->scene->num_threads, num_chunks(num), find_keys, builder);
    if (builder->scene->carriers->num_shared == 0)
        return true;
    if (!csg_kin_find(builder->scene, builder->parents))
        return false;
    part_classes(builder);
    return true;
}

/* Counts members; a class's members are contiguous. */
static void plan_classes(struct csg_crowd *crowd, const struct builder *builder,
                         size_t next[CSG_CROWD_MAX_CLASSES], size_t *num_numbers)
{
    size_t counts[CSG_CROWD_MAX_CLASSES] = {0};
    const size_t num = builder->scene->objects->num;
    *num_numbers = 0;
    for (size_t i = 0; i < num; i++)
        if (builder->keys[i] != CSG_CROWD_NO_CLASS)
            counts[builder->keys[i]]++;
    for (uint32_t key = 0; key < CSG_CROWD_MAX_CLASSES; key++) {
        next[key] = crowd->num;
        if (!counts[key])
            continue;
        struct csg_crowd_class *class = &crowd->classes[crowd->num_classes++];
        *class = csg_crowd_class_of(key);
        class->begin = crowd->num;
        class->end = crowd->num + counts[key];
        class->numbers = *num_numbers;
        crowd->num += counts[key];
        *num_numbers += counts[key] * csg_outline_size(class->outline);
    }
    crowd->num_others = num - crowd->num;
}

static bool allocate(struct csg_crowd *crowd, size_t num_numbers)
{
    double *lengths = malloc((4 * crowd->num + num_numbers + 1) * sizeof *lengths);
    uint32_t *numbers = malloc((3 * crowd->num + crowd->num_others + 1) * sizeof *numbers);
    crowd->opaque = malloc(crowd->num + 1);
    crowd->covers = malloc(crowd->num + crowd->num_others + 1);
    crowd->need = malloc((crowd->num + 1) * sizeof *crowd->need);
    crowd->x = lengths;
    crowd->object = numbers;
    if (!lengths || !numbers || !crowd->opaque || !crowd->covers || !crowd->need)
        return false;
    crowd->y = crowd->x + crowd->num;
    crowd->z = crowd->y + crowd->num;
    crowd->radius = crowd->z + crowd->num;
    crowd->numbers = crowd->radius + crowd->num;
    crowd->leaf = crowd->object + crowd->num;
    crowd->kin = crowd->leaf + crowd->num;
    crowd->others = crowd->kin + crowd->num;
    return true;
}

static const struct csg_crowd_class *class_at(const struct csg_crowd *crowd, size_t member)
{
    const struct csg_crowd_class *class = crowd->classes;
    while (member >= class->end)
        class ++;
    return class;
}

static void put_outline(struct csg_crowd *crowd, size_t at, const struct csgcast_scene *scene)
{
    const struct csg_crowd_class *class = class_at(crowd, at);
    const size_t size = csg_outline_size(class->outline);
    struct csg_outline_ball ball;
    double numbers[CSG_OUTLINE_MAX];
    csg_crowd_measure(scene, crowd->leaf[at], &ball, numbers);
    crowd->x[at] = ball.center.x;
    crowd->y[at] = ball.center.y;
    crowd->z[at] = ball.center.z;
    crowd->radius[at] = ball.radius;
    memcpy(crowd->numbers + class->numbers + size * (at - class->begin), numbers,
           size * sizeof *numbers);
}

static void find_least_need(struct csg_crowd *crowd)
{
    crowd->least_need = INFINITY;
    for (size_t i = 0; i < crowd->num; i++)
        crowd->least_need = fminf(crowd->least_need, crowd->need[i]);
}

static void fill(struct csg_crowd *crowd, struct builder *builder,
                 size_t next[CSG_CROWD_MAX_CLASSES])
{
    const struct csgcast_scene *scene = builder->scene;
    size_t num_others = 0;
    for (uint32_t i = 0; i < scene->objects->num; i++) {
        const uint8_t key = builder->keys[i];
        if (key == CSG_CROWD_NO_CLASS) {
            crowd->others[num_others++] = i;
            continue;
        }
        const size_t at = next[key]++;
        const struct csg_object *object = &scene->objects->data[i];
        crowd->object[at] = i;
        crowd->leaf[at] = csg_crowd_only_node(scene, object)->leaf;
        const uint32_t root = csg_kin_root(builder->parents, i);
        crowd->kin[at] = root == i ? CSG_CROWD_NO_KIN : root;
        crowd->need[at] = builder->needs[i];
    }
    find_least_need(crowd);
}

struct outlining {
    struct csg_crowd *crowd;
    const struct csgcast_scene *scene;
};

static void put_outlines(void *user, size_t chunk)
{
    const struct outlining *outlining = user;
    const size_t num = outlining->crowd->num;
    for (size_t i = CHUNK * chunk; i < CHUNK * (chunk + 1) && i < num; i++)
        put_outline(outlining->crowd, i, outlining->scene);
}

static enum csg_cover cover_of(const struct csgcast_scene *scene, const struct csg_object *object)
{
    const struct csg_node *nodes = scene->trees[object->layer].data;
    if (object->layer != CSG_LAYER_MODEL || object->paint != CSG_LAYER_MODEL ||
        !csg_nodes_are_opaque(scene, nodes, object->begin, object->end))
        return CSG_COVER_GLASS;
    return csg_tree_cast_can(scene, object) ? CSG_COVER_HIDES : CSG_COVER_NONE;
}

void csg_crowd_recolor_object(struct csg_crowd *crowd, const struct csgcast_scene *scene,
                              uint32_t object, uint32_t member)
{
    if (member == CSG_CROWD_NO_MEMBER) {
        crowd->covers[object] = (uint8_t)cover_of(scene, &scene->objects->data[object]);
        return;
    }
    crowd->opaque[member] = !csg_leaf_is_translucent(&scene->leaves[crowd->leaf[member]]);
    crowd->covers[object] = crowd->opaque[member] ? CSG_COVER_NONE : CSG_COVER_GLASS;
}

void csg_crowd_recolor(struct csg_crowd *crowd, const struct csgcast_scene *scene)
{
    for (size_t i = 0; i < crowd->num; i++)
        csg_crowd_recolor_object(crowd, scene, crowd->object[i], (uint32_t)i);
    for (size_t i = 0; i < crowd->num_others; i++)
        csg_crowd_recolor_object(crowd, scene, crowd->others[i], CSG_CROWD_NO_MEMBER);
}

/* A root's own number counts where it has kin. */
static bool number_kin(struct csg_crowd *crowd, const struct builder *builder)
{
    uint8_t *has_kin = calloc(builder->scene->objects->num + 1, 1);
    for (size_t i = 0; i < crowd->num && has_kin; i++)
        if (crowd->kin[i] != CSG_CROWD_NO_KIN)
            has_kin[crowd->kin[i]] = 1;
    for (size_t i = 0; i < crowd->num && has_kin; i++)
        if (has_kin[crowd->object[i]])
            crowd->kin[i] = crowd->object[i];
    const bool ok = has_kin != NULL;
    free(has_kin);
    return ok;
}

struct csg_crowd *csg_crowd_create(const struct csgcast_scene *scene)
{
    struct builder builder = {.scene = scene};
    struct csg_crowd *crowd = calloc(1, sizeof *crowd);
    size_t next[CSG_CROWD_MAX_CLASSES];
    bool ok = crowd && classify(&builder);
    if (ok) {
        size_t num_numbers;
        plan_classes(crowd, &builder, next, &num_numbers);
        ok = allocate(crowd, num_numbers);
    }
    if (ok) {
        fill(crowd, &builder, next);
        csg_parallel(scene->num_threads, num_chunks(crowd->num), put_outlines,
                     &(struct outlining){crowd, scene});
        csg_crowd_recolor(crowd, scene);
        ok = number_kin(crowd, &builder);
    }
    free(builder.keys);
    free(builder.needs);
    free(builder.parents);
    if (ok)
        return crowd;
    csg_crowd_destroy(crowd);
    return NULL;
}

/* ---- edits -------------------------------------------------------------------------------- */

void csg_crowd_list_members(const struct csg_crowd *crowd, uint32_t *members)
{
    for (size_t i = 0; i < crowd->num; i++)
        members[crowd->object[i]] = (uint32_t)i;
    for (size_t i = 0; i < crowd->num_others; i++)
        members[crowd->others[i]] = CSG_CROWD_NO_MEMBER;
}

static bool keeps_class(const struct csg_crowd *crowd, const struct csgcast_scene *scene,
                        uint32_t object, uint32_t member, float *need)
{
    const uint8_t key = csg_crowd_key(scene, &scene->objects->data[object], need);
    if (member == CSG_CROWD_NO_MEMBER || key == CSG_CROWD_NO_CLASS)
        return member == CSG_CROWD_NO_MEMBER && key == CSG_CROWD_NO_CLASS;
    const struct csg_crowd_class now = csg_crowd_class_of(key), *before = class_at(crowd, member);
    return now.outline == before->outline && now.has_quadric == before->has_quadric &&
           now.num_planes == before->num_planes;
}

bool csg_crowd_follow(struct csg_crowd *crowd, const struct csgcast_scene *scene,
                      const uint32_t *objects, size_t num, const uint32_t *members)
{
    float need;
    for (size_t i = 0; i < num; i++)
        if (!keeps_class(crowd, scene, objects[i], members[objects[i]], &need))
            return false;
    for (size_t i = 0; i < num; i++) {
        const uint32_t member = members[objects[i]];
        if (member != CSG_CROWD_NO_MEMBER) {
            keeps_class(crowd, scene, objects[i], member, &crowd->need[member]);
            put_outline(crowd, member, scene);
        }
        csg_crowd_recolor_object(crowd, scene, objects[i], member);
    }
    find_least_need(crowd);
    return true;
}

void csg_crowd_destroy(struct csg_crowd *crowd)
{
    if (!crowd)
        return;
    free(crowd->x);
    free(crowd->object);
    free(crowd->opaque);
    free(crowd->covers);
    free(crowd->need);
    free(crowd);
}
