/* SPDX-License-Identifier: MIT */
#include "pack/precise.h"

#include <stdlib.h>
#include <string.h>

#include "carrier/carrier.h"
#include "pack/apart.h"

/* Of more precise objects in a place none is looked at by itself. */
enum { MAX_KNOWN = 4 };

/* What is known of the precise objects that have a face on one side of a carrier. */
struct mark {
    uint32_t color;     /* of those faces */
    struct csg_box box; /* around the objects */
    const struct csg_object *known[MAX_KNOWN];
    int num; /* of the objects; MAX_KNOWN + 1: or more */
};

struct marks {
    const struct csgcast_scene *scene;
    bool leaves;      /* each leaf is a colour of its own */
    uint32_t *places; /* by carrier and side, planes, then quadrics: 1 + place in data, or 0 */
    struct mark *data;
    size_t num, capacity;
    bool far; /* wherever the objects are */
    bool changed, failed;
};

/* So often objects hand on to those that they meet; then to all that share a surface, so that a row
 * of objects is not walked one by one. */
#define MAX_ROUNDS 4

#define MANY_COLORS 1

static uint32_t color_of(const struct csg_leaf *leaf)
{
    uint32_t color = 0;
    for (int i = 0; i < 4; i++)
        color = color * 251 + (uint32_t)(int32_t)(255 * leaf->color[i]) + 2;
    return color > MANY_COLORS ? color : 2;
}

static bool contains(const struct csg_box *outer, const struct csg_box *inner)
{
    const struct csg_box both = csg_box_union(outer, inner);
    return memcmp(&both, outer, sizeof both) == 0;
}

static struct csg_box box_of(const struct marks *marks, const struct csg_object *object)
{
    return marks->far ? csg_box_all : object->box;
}

/* Adds the object to those of the mark. false: it is one of them. */
static bool add_known(struct mark *mark, const struct csg_object *object)
{
    if (mark->num > MAX_KNOWN)
        return false;
    for (int i = 0; i < mark->num; i++)
        if (mark->known[i] == object)
            return false;
    if (mark->num < MAX_KNOWN)
        mark->known[mark->num] = object;
    mark->num++;
    return true;
}

static void mark_face(struct marks *marks, size_t slot, uint32_t color,
                      const struct csg_object *object)
{
    if (marks->places[slot] == 0) {
        const struct mark first = {.color = color, .box = box_of(marks, object)};
        marks->failed |= !csg_array_push(marks, first);
        marks->places[slot] = marks->failed ? 0 : (uint32_t)marks->num;
    }
    if (marks->failed)
        return;
    struct mark *mark = &marks->data[marks->places[slot] - 1];
    marks->changed |= add_known(mark, object);
    if (mark->color != color && mark->color != MANY_COLORS) {
        mark->color = MANY_COLORS;
        marks->changed = true;
    }
    const struct csg_box box = box_of(marks, object);
    if (!contains(&mark->box, &box)) {
        mark->box = csg_box_union(&mark->box, &box);
        marks->changed = true;
    }
}

/* Whether a face of another colour may be in the same place, where the first object in the file is
 * to win in every pixel. */
static bool meets_mark(const struct marks *marks, size_t slot, uint32_t color,
                       const struct csg_object *object)
{
    if (marks->places[slot] == 0)
        return false;
    const struct mark *mark = &marks->data[marks->places[slot] - 1];
    const struct csg_box box = box_of(marks, object);
    if (mark->color == color || !csg_box_overlaps(&mark->box, &box))
        return false;
    bool meets = mark->num > MAX_KNOWN;
    for (int i = 0; i < mark->num && !meets; i++)
        meets = !csg_objects_are_apart(marks->scene, mark->known[i], object);
    return meets;
}

/* Visits a face: marks it, or tells whether it meets a mark. */
static bool visit_face(struct marks *marks, size_t slot, uint32_t color,
                       const struct csg_object *object, bool mark)
{
    if (mark)
        mark_face(marks, slot, color, object);
    return !mark && meets_mark(marks, slot, color, object);
}

static bool visit(struct marks *marks, const struct csg_object *object, bool mark)
{
    const struct csg_carriers *carriers = marks->scene->carriers;
    const struct csg_node *nodes = marks->scene->trees[object->layer].data;
    bool found = false;
    for (uint32_t i = object->begin; i < object->end; i++) {
        const uint32_t leaf = nodes[i].leaf;
        if (nodes[i].op != CSG_LEAF || nodes[i].spare)
            continue;
        const uint32_t color = marks->leaves ? leaf + 2 : color_of(&marks->scene->leaves[leaf]);
        for (uint32_t j = carriers->face_begin[leaf]; j < carriers->face_begin[leaf + 1]; j++)
            found |= carriers->faces[j].carrier != CSG_NO_CARRIER &&
                     visit_face(marks,
                                2 * (size_t)carriers->faces[j].carrier +
                                    (carriers->faces[j].flipped != nodes[i].negated),
                                color, object, mark);
        const struct csg_face face = carriers->quadric_faces[leaf];
        if (face.carrier != CSG_NO_CARRIER)
            found |= visit_face(marks,
                                2 * (carriers->num_planes + face.carrier) +
                                    (face.flipped != nodes[i].negated),
                                color, object, mark);
    }
    return found;
}

/* Until nothing changes: an object that shares a surface where it meets one hands it on. */
static void spread(struct csg_frame *frame, const struct csg_objects *objects, struct marks *marks)
{
    for (int round = 0; marks->changed && !marks->failed; round++) {
        marks->changed = false;
        marks->far = round >= MAX_ROUNDS;
        for (size_t j = 0; j < frame->listed.num; j++) {
            const uint32_t i = frame->listed.data[j];
            struct csg_precision *precision = &frame->precisions.data[i];
            if (!precision->precise && visit(marks, &objects->data[i], false))
                *precision = (struct csg_precision){
                    .precise = true, .reason = CSG_REASON_SHARED, .leaf = precision->leaf};
            if (precision->precise)
                visit(marks, &objects->data[i], true);
        }
    }
}

static bool spread_to_sharers(struct csg_frame *frame, const struct csgcast_scene *scene,
                              bool leaves)
{
    struct marks marks = {.scene = scene, .leaves = leaves, .changed = true};
    const size_t num = scene->carriers->num_planes + scene->carriers->num_quadrics;
    marks.places = calloc(2 * num + 1, sizeof *marks.places);
    marks.failed = marks.places == NULL;
    if (!marks.failed)
        spread(frame, scene->objects, &marks);
    free(marks.places);
    free(marks.data);
    return !marks.failed;
}

bool csg_frame_judge(struct csg_frame *frame, const struct csgcast_scene *scene,
                     const struct csg_frame_params *params, const struct csg_box *focus)
{
    const size_t num = scene->objects->num;
    size_t num_precise = 0;
    frame->precisions.num = 0;
    if (!csg_array_reserve(&frame->precisions, num + 1))
        return false;
    frame->precisions.num = num;
    for (size_t j = 0; j < frame->listed.num; j++) {
        const uint32_t i = frame->listed.data[j];
        struct csg_precision *precision = &frame->precisions.data[i];
        *precision = (struct csg_precision){.precise = false};
        if (!params->textbook &&
            (params->has_double || scene->objects->data[i].layer == CSG_LAYER_MODEL))
            *precision = csg_precision_of(&frame->screen, scene, i, focus);
        if (params->precise) {
            precision->precise = true;
            precision->reason = CSG_REASON_ASKED;
        }
        num_precise += precision->precise;
    }
    return num_precise == 0 || num_precise == frame->listed.num ||
           spread_to_sharers(frame, scene, params->leaves);
}

struct csg_precision csg_frame_precision(const struct csg_frame *frame,
                                         const struct csgcast_scene *scene, uint32_t object,
                                         uint8_t layer)
{
    if (object != CSG_WHOLE_LAYER)
        return frame->precisions.data[object];
    for (size_t i = 0; i < frame->listed.num; i++) {
        const uint32_t listed = frame->listed.data[i];
        if (scene->objects->data[listed].layer == layer && frame->precisions.data[listed].precise)
            return frame->precisions.data[listed];
    }
    return (struct csg_precision){.precise = false};
}
