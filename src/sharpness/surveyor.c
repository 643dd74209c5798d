/* SPDX-License-Identifier: MIT */
#include "sharpness/surveyor.h"

#include <stdlib.h>

#include "carrier/carrier.h"
#include "common/parallel.h"
#include "sharpness/curvature.h"
#include "sharpness/wall.h"

/* Objects of one solid with more planes have their sharpness kept: finding it takes a while. */
#define MAX_PLANES_OF_ONE 8

const struct csg_sharpness csg_sharpness_blunt = {{INFINITY, INFINITY, INFINITY, INFINITY}, {0}};

bool csg_surveyor_init(struct csg_surveyor *surveyor, const struct csgcast_scene *scene)
{
    *surveyor = (struct csg_surveyor){.marks = calloc(scene->num_leaves + 1, 1)};
    return surveyor->marks != NULL;
}

void csg_surveyor_finish(struct csg_surveyor *surveyor)
{
    csg_flats_finish(&surveyor->planes);
    csg_rounds_finish(&surveyor->quadrics);
    csg_recall_finish(&surveyor->recall);
    free(surveyor->marks);
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
        const struct csg_vec3 axis = csg_map_column(&shape->frame, i);
        edges[i] = csg_scale(isfinite(size[i]) ? size[i] : 1e30, axis);
    }
}

static double thickness(const struct csg_vec3 edges[3])
{
    const double volume = fabs(csg_dot(edges[0], csg_cross(edges[1], edges[2])));
    double square = 0; /* of the largest side's area */
    for (int i = 0; i < 3; i++) {
        const struct csg_vec3 across = csg_cross(edges[(i + 1) % 3], edges[(i + 2) % 3]);
        square = csg_most(square, csg_dot(across, across));
    }
    return volume / sqrt(square);
}

/* Size of the coordinates, as far as they are finite. */
static double largest(const struct csg_box *box)
{
    const double all[6] = {box->lo.x, box->lo.y, box->lo.z, box->hi.x, box->hi.y, box->hi.z};
    double size = 0;
    for (int i = 0; i < 6; i++)
        size = isfinite(all[i]) ? csg_most(size, fabs(all[i])) : size;
    return size;
}

static void note_leaf(struct csg_sharpness *sharp, const struct csgcast_scene *scene, uint32_t leaf,
                      uint8_t mark)
{
    const struct csg_shape *shape = &scene->leaves[leaf].shape;
    const struct csg_face face = scene->carriers->quadric_faces[leaf];
    struct csg_vec3 edges[3];
    box_edges(shape, edges);
    const struct csg_box place = scene->leaves[leaf].box;
    const double thick = thickness(edges), noise = CSG_FINE_NOISE * largest(&place);
    if (thick > noise && !(mark & CSG_WALL_RING))
        csg_sharpness_note(sharp, CSG_FINE_THICKNESS, thick, leaf);
    if (face.carrier == CSG_NO_CARRIER)
        return;
    if (mark & CSG_WALL_RING) {
        csg_sharpness_note(sharp, CSG_FINE_CURVATURE, csg_wall_curvature(shape), leaf);
        return;
    }
    const struct csg_box *box = csg_carrier_quadric_box(scene, scene->carriers, face.carrier);
    const double size = csg_box_is_finite(box) ? csg_length(csg_sub(box->hi, box->lo)) : INFINITY;
    csg_sharpness_note(
        sharp, CSG_FINE_CURVATURE,
        csg_curvature(csg_carrier_quadric(scene, scene->carriers, face.carrier), size), leaf);
}

static bool add_leaf(struct csg_surveyor *surveyor, const struct csgcast_scene *scene,
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
        if (!csg_flats_add(&surveyor->planes, &carriers->planes[carrier], carrier, leaf, turned))
            return false;
    }
    const uint32_t carrier = carriers->quadric_faces[leaf].carrier;
    if (carrier == CSG_NO_CARRIER)
        return true;
    const bool turned = carriers->quadric_faces[leaf].flipped != node->negated;
    const double place = scene->leaves[leaf].box.lo.x;
    return csg_array_push(&surveyor->quadrics.all,
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
static struct csg_ball ball_of(const struct csg_object *object, const struct csg_surveyor *surveyor)
{
    const struct csg_box *box = &object->box;
    if (!csg_box_is_finite(box) || csg_box_is_empty(box))
        return (struct csg_ball){csg_vec3(0, 0, 0), radius_of_planes(&surveyor->planes)};
    return (struct csg_ball){csg_box_middle(box), 0.5 * csg_length(csg_sub(box->hi, box->lo))};
}

/* An object is looked at in so many runs, side by side. Smaller ones, and what an edit leaves to be
 * looked at, are through before a thread has started. */
enum { NUM_RUNS = 8, MIN_NODES = 1024 };

/* Between them count planes; of two values that are equal the first is named. */
enum { OF_LEAVES, OF_QUADRICS, NUM_SOURCES };

struct noting {
    const struct csgcast_scene *scene;
    const struct csg_object *object;
    struct csg_surveyor *surveyor;
    struct csg_ball ball;
    struct csg_sharpness found[NUM_SOURCES][NUM_RUNS];
};

static void note_leaves(const struct noting *noting, size_t begin, size_t end,
                        struct csg_sharpness *sharp)
{
    const struct csg_node *nodes = noting->scene->trees[noting->object->layer].data;
    for (size_t i = begin; i < end; i++)
        if (nodes[i].op == CSG_LEAF && !nodes[i].spare)
            note_leaf(sharp, noting->scene, nodes[i].leaf, noting->surveyor->marks[nodes[i].leaf]);
}

static void note_run(void *user, size_t run)
{
    struct noting *noting = user;
    const struct csg_object *object = noting->object;
    const size_t num_nodes = object->end - object->begin;
    const size_t num_blocks = noting->surveyor->recall.blocks.num;
    const size_t num_quadrics = noting->surveyor->quadrics.keys.list.num;
    for (int source = 0; source < NUM_SOURCES; source++)
        noting->found[source][run] = csg_sharpness_blunt;
    note_leaves(noting, object->begin + num_nodes * run / NUM_RUNS,
                object->begin + num_nodes * (run + 1) / NUM_RUNS, &noting->found[OF_LEAVES][run]);
    csg_recall_renew(&noting->surveyor->recall, &noting->surveyor->planes, noting->scene,
                     num_blocks * run / NUM_RUNS, num_blocks * (run + 1) / NUM_RUNS);
    csg_rounds_note(&noting->surveyor->quadrics, noting->scene, num_quadrics * run / NUM_RUNS,
                    num_quadrics * (run + 1) / NUM_RUNS, noting->surveyor->marks,
                    noting->ball.radius, &noting->found[OF_QUADRICS][run]);
}

static void note_found(struct csg_sharpness *sharp, const struct csg_sharpness *found)
{
    for (int what = 0; what < CSG_NUM_FINE; what++)
        csg_sharpness_note(sharp, (enum csg_fineness)what, found->least[what], found->leaf[what]);
}

static void note_runs(struct csg_sharpness *sharp, struct noting *noting)
{
    const struct csg_recall *planes = &noting->surveyor->recall;
    const bool is_large = noting->object->end - noting->object->begin >= MIN_NODES &&
                          2 * csg_recall_count_stale(planes) >= planes->blocks.num;
    csg_parallel(is_large ? noting->scene->num_threads : 1, NUM_RUNS, note_run, noting);
    for (size_t run = 0; run < NUM_RUNS; run++)
        note_found(sharp, &noting->found[OF_LEAVES][run]);
    for (size_t block = 0; block < planes->blocks.num; block++)
        note_found(sharp, &planes->blocks.data[block].sharp);
    for (size_t run = 0; run < NUM_RUNS; run++)
        note_found(sharp, &noting->found[OF_QUADRICS][run]);
}

static bool note_object(struct csg_surveyor *surveyor, struct csg_sharpness *sharp,
                        const struct csgcast_scene *scene, const struct csg_object *object)
{
    const struct csg_node *nodes = scene->trees[object->layer].data;
    surveyor->planes.all.num = surveyor->quadrics.all.num = surveyor->recall.num_leaves = 0;
    clear_marks(nodes, object, surveyor->marks); /* of another object with the same leaves */
    if (!note_stacks(sharp, scene, object, surveyor->marks))
        return false;
    for (uint32_t i = object->begin; i < object->end; i++)
        if (nodes[i].op == CSG_LEAF && !nodes[i].spare &&
            (!add_leaf(surveyor, scene, &nodes[i], surveyor->marks[nodes[i].leaf]) ||
             !csg_recall_add_leaf(&surveyor->recall, scene, nodes[i].leaf, surveyor->marks)))
            return false;
    struct noting noting = {
        .scene = scene, .object = object, .surveyor = surveyor, .ball = ball_of(object, surveyor)};
    if (!csg_flats_sort(&surveyor->planes, noting.ball.center) ||
        !csg_rounds_sort(&surveyor->quadrics) ||
        !csg_recall_compare(&surveyor->recall, &surveyor->planes, surveyor->marks, &noting.ball))
        return false;
    note_runs(sharp, &noting);
    return true;
}

bool csg_surveyor_note(struct csg_surveyor *surveyor, struct csg_sharpness *sharp,
                       const struct csgcast_scene *scene, const struct csg_object *object)
{
    surveyor->recall.holds = note_object(surveyor, sharp, scene, object);
    return surveyor->recall.holds;
}

bool csg_sharpness_is_of_one(const struct csgcast_scene *scene, const struct csg_object *object)
{
    const struct csg_node *node = &scene->trees[object->layer].data[object->begin];
    return object->end == object->begin + 1 && node->op == CSG_LEAF && !node->spare &&
           scene->leaves[node->leaf].shape.num_planes <= MAX_PLANES_OF_ONE;
}

/* One frustum is no stack, and one quadric has no other. */
bool csg_sharpness_note_one(struct csg_sharpness *sharp, const struct csgcast_scene *scene,
                            const struct csg_object *object)
{
    const struct csg_node *node = &scene->trees[object->layer].data[object->begin];
    struct csg_surveyor surveyor = {.marks = NULL};
    note_leaf(sharp, scene, node->leaf, 0);
    if (scene->leaves[node->leaf].shape.num_planes == 0)
        return true;
    bool ok = add_leaf(&surveyor, scene, node, 0);
    const struct csg_ball ball = ball_of(object, &surveyor);
    ok = ok && csg_flats_sort(&surveyor.planes, ball.center);
    if (ok)
        csg_flats_note(&surveyor.planes, scene, 0, surveyor.planes.all.num, &ball, sharp);
    csg_surveyor_finish(&surveyor);
    return ok;
}
