/* SPDX-License-Identifier: MIT */
#include "csg/sharpness.h"

#include <stdlib.h>
#include <string.h>

#include "common/parallel.h"
#include "csg/carrier_edit.h"
#include "csg/curvature.h"
#include "csg/flats.h"
#include "csg/rounds.h"
#include "csg/wall.h"

/* Objects of one solid with more planes have their sharpness kept: finding it takes a while. */
#define MAX_PLANES_OF_ONE 8

struct surfaces {
    struct csg_flats planes;
    struct csg_rounds quadrics;
};

static const struct csg_sharpness blunt = {{INFINITY, INFINITY, INFINITY, INFINITY}, {0}};

static void finish_surfaces(struct surfaces *surfaces)
{
    csg_flats_finish(&surfaces->planes);
    csg_rounds_finish(&surfaces->quadrics);
}

void csg_sharpness_note(struct csg_sharpness *sharp, enum csg_fineness what, double value,
                        uint32_t leaf)
{
    if (value < sharp->least[what]) {
        sharp->least[what] = value;
        sharp->leaf[what] = leaf;
    }
}

/* The leaf's box as it stands. */
static void box_edges(const struct csg_shape *shape, struct csg_vec3 edges[3])
{
    const double size[3] = {shape->bounds.hi.x - shape->bounds.lo.x,
                            shape->bounds.hi.y - shape->bounds.lo.y,
                            shape->bounds.hi.z - shape->bounds.lo.z};
    for (int i = 0; i < 3; i++) {
        const struct csg_vec3 axis =
            csg_vec3(shape->frame.m[0][i], shape->frame.m[1][i], shape->frame.m[2][i]);
        edges[i] = csg_scale(isfinite(size[i]) ? size[i] : 1e30, axis);
    }
}

static double thickness(const struct csg_vec3 edges[3])
{
    const double volume = fabs(csg_dot(edges[0], csg_cross(edges[1], edges[2])));
    double least = INFINITY;
    for (int i = 0; i < 3; i++)
        least = fmin(least, volume / csg_length(csg_cross(edges[(i + 1) % 3], edges[(i + 2) % 3])));
    return least;
}

/* Size of the coordinates, as far as they are finite. */
static double largest(const struct csg_box *box)
{
    const double all[6] = {box->lo.x, box->lo.y, box->lo.z, box->hi.x, box->hi.y, box->hi.z};
    double size = 0;
    for (int i = 0; i < 6; i++)
        size = isfinite(all[i]) ? fmax(size, fabs(all[i])) : size;
    return size;
}

static void note_leaf(struct csg_sharpness *sharp, const struct csgcast_scene *scene, uint32_t leaf,
                      uint8_t mark)
{
    const struct csg_shape *shape = &scene->leaves[leaf].shape;
    const struct csg_face face = scene->carriers->quadric_faces[leaf];
    struct csg_vec3 edges[3];
    box_edges(shape, edges);
    const struct csg_box place = csg_leaf_box(&scene->leaves[leaf]);
    const double thick = thickness(edges), noise = CSG_FINE_NOISE * largest(&place);
    if (thick > noise && !(mark & CSG_WALL_RING))
        csg_sharpness_note(sharp, CSG_FINE_THICKNESS, thick, leaf);
    if (face.carrier == CSG_NO_CARRIER)
        return;
    if (mark & CSG_WALL_RING) {
        csg_sharpness_note(sharp, CSG_FINE_CURVATURE, csg_wall_curvature(shape), leaf);
        return;
    }
    const struct csg_box *box =
        csg_carrier_quadric_box(scene, scene->carriers, face.carrier);
    const double size = csg_box_is_finite(box) ? csg_length(csg_sub(box->hi, box->lo)) : INFINITY;
    csg_sharpness_note(sharp, CSG_FINE_CURVATURE,
                       csg_curvature(csg_carrier_quadric(scene, scene->carriers, face.carrier), size),
                       leaf);
}

static bool add_leaf(struct surfaces *surfaces, const struct csgcast_scene *scene,
                     const struct csg_node *node, uint8_t mark)
{
    const struct csg_carriers *carriers = scene->carriers;
    const uint32_t leaf = node->leaf;
    /* The faces of a surface do not reach to where their planes meet. */
    if (scene->leaves[leaf].shape.surface)
        return true;
    for (uint32_t i = carriers->face_begin[leaf]; i < carriers->face_begin[leaf + 1]; i++) {
        const uint32_t carrier = carriers->faces[i].carrier;
        if (mark & (i == carriers->face_begin[leaf] ? CSG_WALL_LOW : CSG_WALL_HIGH))
            continue;
        const bool turned = carriers->faces[i].flipped != node->negated;
        if (!csg_flats_add(&surfaces->planes, &carriers->planes[carrier], carrier, leaf, turned))
            return false;
    }
    const uint32_t carrier = carriers->quadric_faces[leaf].carrier;
    if (carrier == CSG_NO_CARRIER)
        return true;
    const bool turned = carriers->quadric_faces[leaf].flipped != node->negated;
    const double place = csg_leaf_box(&scene->leaves[leaf]).lo.x;
    return csg_array_push(&surfaces->quadrics.all,
                          ((struct csg_round){carrier, leaf, turned, place}));
}

/* Of an unbounded object: where its planes are. */
static double radius_of_planes(const struct csg_flats *planes)
{
    double radius = 0;
    for (size_t i = 0; i < planes->all.num; i++)
        radius = fmax(radius, fabs(planes->all.data[i].height));
    return radius > 0 ? radius : 1;
}

/* Turned profiles count as such, not as their rings: marks tells which leaves are. */
static bool note_stacks(struct csg_sharpness *sharp, const struct csgcast_scene *scene,
                        const struct csg_object *object, uint8_t *marks)
{
    struct csg_stacks stacks = {0};
    bool ok = csg_stacks_find(&stacks, scene, object);
    for (size_t i = 0; i < stacks.list.num && ok; i++) {
        const struct csg_stack *stack = &stacks.list.data[i];
        double least;
        ok = csg_wall_measure(scene, &stacks, stack, marks, &least);
        csg_sharpness_note(sharp, CSG_FINE_THICKNESS, least,
                           stacks.rings.data[stack->first_ring].outer);
    }
    csg_stacks_finish(&stacks);
    return ok;
}

static void clear_marks(const struct csg_node *nodes, const struct csg_object *object,
                        uint8_t *marks)
{
    for (uint32_t i = object->begin; i < object->end; i++)
        if (nodes[i].op == CSG_LEAF)
            marks[nodes[i].leaf] = 0;
}

/* Where the object is, and how large. */
static struct csg_ball ball_of(const struct csg_object *object, const struct surfaces *surfaces)
{
    const struct csg_box *box = &object->box;
    if (!csg_box_is_finite(box) || csg_box_is_empty(box))
        return (struct csg_ball){csg_vec3(0, 0, 0), radius_of_planes(&surfaces->planes)};
    return (struct csg_ball){csg_scale(0.5, csg_add(box->lo, box->hi)),
                             0.5 * csg_length(csg_sub(box->hi, box->lo))};
}

/* An object is looked at in so many runs, side by side. Smaller ones are through before a thread
 * has started. */
enum { NUM_RUNS = 8, MIN_NODES = 1024 };

/* What counts in turn: of two that are equal the first is named. */
enum { OF_LEAVES, OF_PLANES, OF_QUADRICS, NUM_SOURCES };

struct noting {
    const struct csgcast_scene *scene;
    const struct csg_object *object;
    const uint8_t *marks;
    const struct surfaces *surfaces;
    struct csg_ball ball;
    struct csg_sharpness found[NUM_SOURCES][NUM_RUNS];
};

static void note_leaves(const struct noting *noting, size_t begin, size_t end,
                        struct csg_sharpness *sharp)
{
    const struct csg_node *nodes = noting->scene->trees[noting->object->layer].data;
    for (size_t i = begin; i < end; i++)
        if (nodes[i].op == CSG_LEAF && !nodes[i].spare)
            note_leaf(sharp, noting->scene, nodes[i].leaf, noting->marks[nodes[i].leaf]);
}

static void note_run(void *user, size_t run)
{
    struct noting *noting = user;
    const struct csg_object *object = noting->object;
    const size_t num_nodes = object->end - object->begin;
    const size_t num_planes = noting->surfaces->planes.all.num;
    const size_t num_quadrics = noting->surfaces->quadrics.keys.list.num;
    for (int source = 0; source < NUM_SOURCES; source++)
        noting->found[source][run] = blunt;
    note_leaves(noting, object->begin + num_nodes * run / NUM_RUNS,
                object->begin + num_nodes * (run + 1) / NUM_RUNS, &noting->found[OF_LEAVES][run]);
    csg_flats_note(&noting->surfaces->planes, num_planes * run / NUM_RUNS,
                   num_planes * (run + 1) / NUM_RUNS, &noting->ball,
                   &noting->found[OF_PLANES][run]);
    csg_rounds_note(&noting->surfaces->quadrics, noting->scene, num_quadrics * run / NUM_RUNS,
                    num_quadrics * (run + 1) / NUM_RUNS, noting->marks, noting->ball.radius,
                    &noting->found[OF_QUADRICS][run]);
}

static void note_runs(struct csg_sharpness *sharp, struct noting *noting)
{
    const bool is_large = noting->object->end - noting->object->begin >= MIN_NODES;
    csg_parallel(is_large ? noting->scene->num_threads : 1, NUM_RUNS, note_run, noting);
    for (int source = 0; source < NUM_SOURCES; source++)
        for (size_t run = 0; run < NUM_RUNS; run++) {
            const struct csg_sharpness *found = &noting->found[source][run];
            for (int what = 0; what < CSG_NUM_FINE; what++)
                csg_sharpness_note(sharp, (enum csg_fineness)what, found->least[what],
                                   found->leaf[what]);
        }
}

static bool note_object(struct csg_sharpness *sharp, const struct csgcast_scene *scene,
                        const struct csg_object *object, struct surfaces *surfaces, uint8_t *marks)
{
    const struct csg_node *nodes = scene->trees[object->layer].data;
    surfaces->planes.all.num = surfaces->quadrics.all.num = 0;
    clear_marks(nodes, object, marks); /* of another object with the same leaves */
    if (!note_stacks(sharp, scene, object, marks))
        return false;
    for (uint32_t i = object->begin; i < object->end; i++)
        if (nodes[i].op == CSG_LEAF && !nodes[i].spare &&
            !add_leaf(surfaces, scene, &nodes[i], marks[nodes[i].leaf]))
            return false;
    struct noting noting = {.scene = scene,
                            .object = object,
                            .marks = marks,
                            .surfaces = surfaces,
                            .ball = ball_of(object, surfaces)};
    if (!csg_flats_sort(&surfaces->planes, noting.ball.center) ||
        !csg_rounds_sort(&surfaces->quadrics))
        return false;
    note_runs(sharp, &noting);
    return true;
}

/* ---- objects of one solid ------------------------------------------------------------------ */

static bool is_of_one(const struct csgcast_scene *scene, const struct csg_object *object)
{
    const struct csg_node *node = &scene->trees[object->layer].data[object->begin];
    return object->end == object->begin + 1 && node->op == CSG_LEAF && !node->spare &&
           scene->leaves[node->leaf].shape.num_planes <= MAX_PLANES_OF_ONE;
}

/* What note_object finds: one frustum is no stack, and one quadric has no other. */
static bool note_one(struct csg_sharpness *sharp, const struct csgcast_scene *scene,
                     const struct csg_object *object)
{
    const struct csg_node *node = &scene->trees[object->layer].data[object->begin];
    struct surfaces surfaces = {.planes = {.all = {0}}};
    note_leaf(sharp, scene, node->leaf, 0);
    if (scene->leaves[node->leaf].shape.num_planes == 0)
        return true;
    bool ok = add_leaf(&surfaces, scene, node, 0);
    const struct csg_ball ball = ball_of(object, &surfaces);
    ok = ok && csg_flats_sort(&surfaces.planes, ball.center);
    if (ok)
        csg_flats_note(&surfaces.planes, 0, surfaces.planes.all.num, &ball, sharp);
    finish_surfaces(&surfaces);
    return ok;
}

/* ---- objects that an edit has not changed ---------------------------------------------------- */

static bool is_same_node(const struct csg_node *a, uint32_t a_begin, const struct csg_node *b,
                         uint32_t b_begin)
{
    return a->op == b->op && a->negated == b->negated && a->spare == b->spare &&
           a->leaf == b->leaf && a->end - a_begin == b->end - b_begin;
}

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
        if (!is_same_node(&a[i], object->begin, &b[i], other->begin) ||
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
    struct csg_sharpness sharp = blunt;
    const bool ok = note_one(&sharp, scene, &scene->objects->data[object]);
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
    struct surfaces surfaces = {.planes = {.all = {0}}};
    uint8_t *marks = calloc(scene->num_leaves + 1, 1);
    size_t at = 0;
    bool ok = marks != NULL;
    for (size_t i = begin; i < end && ok; i++) {
        if (filling->all->places[i] == CSG_SHARPNESS_OF_ONE)
            continue;
        const struct csg_object *object = &scene->objects->data[i];
        const struct csg_sharpness *kept = old ? find_kept(scene, object, old, &at) : NULL;
        struct csg_sharpness *sharp = &filling->all->kept[filling->all->places[i]];
        *sharp = kept ? *kept : blunt;
        ok = kept || note_object(sharp, scene, object, &surfaces, marks);
    }
    free(marks);
    finish_surfaces(&surfaces);
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

bool csg_sharpness_measure(const struct csgcast_scene *scene, const uint32_t *objects, size_t num,
                           struct csg_sharpness *out)
{
    struct surfaces surfaces = {.planes = {.all = {0}}};
    uint8_t *marks = calloc(scene->num_leaves + 1, 1);
    bool ok = marks != NULL;
    for (size_t i = 0; i < num && ok; i++) {
        out[i] = blunt;
        ok = scene->sharpness->places[objects[i]] == CSG_SHARPNESS_OF_ONE ||
             note_object(&out[i], scene, &scene->objects->data[objects[i]], &surfaces, marks);
    }
    free(marks);
    finish_surfaces(&surfaces);
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
        places[i] = is_of_one(scene, &scene->objects->data[i]) ? CSG_SHARPNESS_OF_ONE : num++;
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
    free(sharpness->places);
    free(sharpness->kept);
    free(sharpness);
}
