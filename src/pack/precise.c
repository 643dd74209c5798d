/* SPDX-License-Identifier: MIT */
#include "pack/precise.h"

#include <stdlib.h>
#include <string.h>

#include "csg/carrier.h"

/* The colour of the precise objects' faces by carrier and side: planes, then quadrics. */
struct marks {
    const struct csgcast_scene *scene;
    bool leaves; /* each leaf is a colour of its own */
    uint32_t *colors;
    bool changed;
};

#define NO_COLOR 0
#define MANY_COLORS 1

static uint32_t color_of(const struct csg_leaf *leaf)
{
    uint32_t color = 0;
    for (int i = 0; i < 4; i++)
        color = color * 251 + (uint32_t)(int32_t)(255 * leaf->color[i]) + 2;
    return color > MANY_COLORS ? color : 2;
}

/* Visits a face: marks it, or tells whether one of another colour may be in the same place, where
 * the first object in the file is to win in every pixel. */
static bool visit_face(struct marks *marks, size_t slot, uint32_t color, bool mark)
{
    uint32_t *known = &marks->colors[slot];
    const bool differs = *known != NO_COLOR && *known != color;
    if (mark && *known != color && *known != MANY_COLORS) {
        *known = *known == NO_COLOR ? color : MANY_COLORS;
        marks->changed = true;
    }
    return differs;
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
                                color, mark);
        const struct csg_face face = carriers->quadric_faces[leaf];
        if (face.carrier != CSG_NO_CARRIER)
            found |= visit_face(marks,
                                2 * (carriers->num_planes + face.carrier) +
                                    (face.flipped != nodes[i].negated),
                                color, mark);
    }
    return found;
}

/* Until nothing changes: an object that shares a surface hands it on. */
static void spread(struct csg_frame *frame, const struct csg_objects *objects, struct marks *marks)
{
    do {
        marks->changed = false;
        for (size_t j = 0; j < frame->listed.num; j++) {
            const uint32_t i = frame->listed.data[j];
            struct csg_precision *precision = &frame->precisions.data[i];
            if (!precision->precise && visit(marks, &objects->data[i], false))
                *precision = (struct csg_precision){
                    .precise = true, .reason = CSG_REASON_SHARED, .leaf = precision->leaf};
            if (precision->precise)
                visit(marks, &objects->data[i], true);
        }
    } while (marks->changed);
}

static bool spread_to_sharers(struct csg_frame *frame, const struct csgcast_scene *scene,
                              bool leaves)
{
    struct marks marks = {.scene = scene, .leaves = leaves};
    const size_t num = scene->carriers->num_planes + scene->carriers->num_quadrics;
    marks.colors = calloc(2 * num + 1, sizeof *marks.colors);
    const bool ok = marks.colors != NULL;
    if (ok)
        spread(frame, scene->objects, &marks);
    free(marks.colors);
    return ok;
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
