/* SPDX-License-Identifier: MIT */
#include "sharpness/sharpness.h"

#include <stdlib.h>
#include <string.h>

#include "carrier/edit.h"
#include "common/parallel.h"
#include "sharpness/surveyor.h"

/* ---- objects that an edit has not changed ---------------------------------------------------- */

static bool is_same_box(const struct csg_box *a, const struct csg_box *b)
{
    return memcmp(a, b, sizeof *a) == 0;
}

/* The same leaf, on the same carriers, of which as much can be seen. */
static bool is_kept(const struct csgcast_scene *scene, const struct csgcast_scene *old,
                    uint32_t leaf)
{
    const struct csg_carriers *now = scene->carriers, *before = old->carriers;
    const uint32_t quadric = now->quadric_faces[leaf].carrier;
    if (now->renewed[leaf] || quadric == CSG_NO_CARRIER)
        return !now->renewed[leaf];
    return is_same_box(csg_carrier_quadric_box(scene, now, quadric),
                       csg_carrier_quadric_box(old, before, quadric));
}

static bool is_same_object(const struct csgcast_scene *scene, const struct csg_object *object,
                           const struct csgcast_scene *old, const struct csg_object *other)
{
    const struct csg_node *a = &scene->trees[object->layer].data[object->begin];
    const struct csg_node *b = &old->trees[other->layer].data[other->begin];
    if (object->layer != other->layer || object->end - object->begin != other->end - other->begin ||
        !is_same_box(&object->box, &other->box))
        return false;
    for (uint32_t i = 0; i < object->end - object->begin; i++)
        if (a[i].spare != b[i].spare ||
            !csg_node_is_same(&a[i], object->begin, &b[i], other->begin) ||
            (a[i].op == CSG_LEAF && !a[i].spare && !is_kept(scene, old, a[i].leaf)))
            return false;
    return true;
}

/* Layers by layers, in the order of the file. */
static uint64_t place_of(const struct csgcast_scene *scene, const struct csg_object *object)
{
    const struct csg_node *nodes = scene->trees[object->layer].data;
    uint32_t i = object->begin;
    while (i + 1 < object->end && nodes[i].op != CSG_LEAF)
        i++;
    return (uint64_t)object->layer << 32 | nodes[i].leaf;
}

/* The old object that begins where the new one does, from *at on. */
static const struct csg_sharpness *find_kept(const struct csgcast_scene *scene,
                                             const struct csg_object *object,
                                             const struct csgcast_scene *old, size_t *at)
{
    const struct csg_objects *others = old->objects;
    while (*at < others->num && place_of(old, &others->data[*at]) < place_of(scene, object))
        ++*at;
    return *at < others->num && is_same_object(scene, object, old, &others->data[*at])
               ? &old->sharpness->kept[old->sharpness->places[*at]]
               : NULL;
}

/* ---- all ------------------------------------------------------------------------------------ */

struct csg_sharpness csg_sharpness_of(const struct csgcast_scene *scene, size_t object)
{
    const uint32_t place = scene->sharpness->places[object];
    if (place != CSG_SHARPNESS_OF_ONE)
        return scene->sharpness->kept[place];
    struct csg_sharpness sharp = csg_sharpness_blunt;
    const bool ok = csg_sharpness_note_one(&sharp, scene, &scene->objects->data[object]);
    return ok ? sharp : (struct csg_sharpness){{0}, {0}};
}

/* Objects that one core looks at, at a time; fewer are through before threads have started. */
enum { NUM_TASKS = 32, MIN_OBJECTS = 4096 };

struct filling {
    const struct csgcast_scene *scene, *old;
    struct csg_sharpnesses *all;
    bool ok[NUM_TASKS];
};

static bool fill(const struct filling *filling, size_t begin, size_t end)
{
    const struct csgcast_scene *scene = filling->scene, *old = filling->old;
    struct csg_surveyor surveyor;
    size_t at = 0;
    bool ok = csg_surveyor_init(&surveyor, scene);
    for (size_t i = begin; i < end && ok; i++) {
        if (filling->all->places[i] == CSG_SHARPNESS_OF_ONE)
            continue;
        const struct csg_object *object = &scene->objects->data[i];
        const struct csg_sharpness *kept = old ? find_kept(scene, object, old, &at) : NULL;
        struct csg_sharpness *sharp = &filling->all->kept[filling->all->places[i]];
        *sharp = kept ? *kept : csg_sharpness_blunt;
        ok = kept || csg_surveyor_note(&surveyor, sharp, scene, object);
    }
    csg_surveyor_finish(&surveyor);
    return ok;
}

static void fill_task(void *user, size_t task)
{
    struct filling *filling = user;
    const size_t num = filling->scene->objects->num;
    filling->ok[task] = fill(filling, num * task / NUM_TASKS, num * (task + 1) / NUM_TASKS);
}

static bool fill_all(struct filling *filling, size_t num_kept)
{
    if (filling->old || num_kept < MIN_OBJECTS)
        return num_kept == 0 || fill(filling, 0, filling->scene->objects->num);
    csg_parallel(filling->scene->num_threads, NUM_TASKS, fill_task, filling);
    bool ok = true;
    for (size_t i = 0; i < NUM_TASKS; i++)
        ok &= filling->ok[i];
    return ok;
}

static struct csg_surveyor *create_surveyor(const struct csgcast_scene *scene)
{
    struct csg_surveyor *surveyor = malloc(sizeof *surveyor);
    if (surveyor && !csg_surveyor_init(surveyor, scene)) {
        free(surveyor);
        return NULL;
    }
    return surveyor;
}

bool csg_sharpness_measure(const struct csgcast_scene *scene, const uint32_t *objects, size_t num,
                           struct csg_sharpness *out)
{
    struct csg_sharpnesses *all = scene->sharpness;
    if (!all->surveyor)
        all->surveyor = create_surveyor(scene);
    bool ok = all->surveyor != NULL;
    for (size_t i = 0; i < num && ok; i++) {
        out[i] = csg_sharpness_blunt;
        ok = all->places[objects[i]] == CSG_SHARPNESS_OF_ONE ||
             csg_surveyor_note(all->surveyor, &out[i], scene, &scene->objects->data[objects[i]]);
    }
    return ok;
}

void csg_sharpness_swap(struct csg_sharpnesses *sharpness, const uint32_t *objects, size_t num,
                        struct csg_sharpness *other)
{
    for (size_t i = 0; i < num; i++) {
        if (sharpness->places[objects[i]] == CSG_SHARPNESS_OF_ONE)
            continue;
        struct csg_sharpness *own = &sharpness->kept[sharpness->places[objects[i]]];
        const struct csg_sharpness copy = *own;
        *own = other[i];
        other[i] = copy;
    }
}

static uint32_t find_places(const struct csgcast_scene *scene, uint32_t *places)
{
    uint32_t num = 0;
    for (size_t i = 0; i < scene->objects->num; i++)
        places[i] =
            csg_sharpness_is_of_one(scene, &scene->objects->data[i]) ? CSG_SHARPNESS_OF_ONE : num++;
    return num;
}

struct csg_sharpnesses *csg_sharpness_create(const struct csgcast_scene *scene,
                                             const struct csg_before *before)
{
    struct csg_sharpnesses *all = calloc(1, sizeof *all);
    struct filling filling = {.scene = scene,
                              .old = before && scene->carriers->renewed ? before->scene : NULL,
                              .all = all};
    if (!all)
        return NULL;
    all->places = malloc((scene->objects->num + 1) * sizeof *all->places);
    if (all->places) {
        const size_t num = find_places(scene, all->places);
        all->kept = malloc((num + 1) * sizeof *all->kept);
        if (all->kept && fill_all(&filling, num))
            return all;
    }
    csg_sharpness_destroy(all);
    return NULL;
}

void csg_sharpness_destroy(struct csg_sharpnesses *sharpness)
{
    if (!sharpness)
        return;
    if (sharpness->surveyor)
        csg_surveyor_finish(sharpness->surveyor);
    free(sharpness->surveyor);
    free(sharpness->places);
    free(sharpness->kept);
    free(sharpness);
}
