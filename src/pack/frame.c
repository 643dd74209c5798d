/* SPDX-License-Identifier: MIT */
#include "pack/frame.h"

#include <stdlib.h>
#include <string.h>

struct packer {
    struct csg_frame *frame;
    const struct csgcast_scene *scene;
    const struct csg_plan *plan;
    const struct csg_frame_params *params;
};

static struct csg_rect nothing(void)
{
    return (struct csg_rect){{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
}

static bool is_empty(const struct csg_rect *rect)
{
    return !(rect->lo[0] < rect->hi[0] && rect->lo[1] < rect->hi[1]);
}

static struct csg_rect leaf_rect(const struct packer *packer, const struct csg_node *node)
{
    const struct csg_screen *screen = &packer->frame->screen;
    const struct csg_shape *shape = &packer->scene->leaves[node->leaf].shape;
    if (node->negated)
        return (struct csg_rect){{0, 0}, {screen->width, screen->height}};
    return csg_screen_rect(screen, &shape->frame, &shape->bounds);
}

static void combine_rects(struct csg_rect *into, const struct csg_rect *rect, bool all)
{
    for (int i = 0; i < 2; i++) {
        into->lo[i] = all ? fmax(into->lo[i], rect->lo[i]) : fmin(into->lo[i], rect->lo[i]);
        into->hi[i] = all ? fmin(into->hi[i], rect->hi[i]) : fmax(into->hi[i], rect->hi[i]);
    }
}

/* The screen rectangle of an object: what its Boolean leaves of its leaves' rectangles. */
static struct csg_rect object_rect(const struct packer *packer, const struct csg_object *object,
                                   struct csg_rect *rects)
{
    const struct csg_screen *screen = &packer->frame->screen;
    const struct csg_node *nodes = packer->scene->trees[object->layer].data;
    const struct csg_rect all = {{0, 0}, {screen->width, screen->height}};
    for (uint32_t i = object->end; i-- > object->begin;) {
        struct csg_rect *rect = &rects[i - object->begin];
        if (nodes[i].op == CSG_LEAF) {
            *rect = leaf_rect(packer, &nodes[i]);
            continue;
        }
        *rect = nodes[i].op == CSG_AND ? all : nothing();
        for (uint32_t child = i + 1; child < nodes[i].end; child = nodes[child].end) {
            const struct csg_rect *operand = &rects[child - object->begin];
            if (nodes[i].op == CSG_AND || !is_empty(operand))
                combine_rects(rect, operand, nodes[i].op == CSG_AND);
        }
    }
    return rects[0];
}

static float *add_texels(struct csg_frame *frame, size_t num)
{
    if (!csg_array_reserve(&frame->texels, 4 * num))
        return NULL;
    float *texels = frame->texels.data + frame->texels.num;
    memset(texels, 0, 4 * num * sizeof *texels);
    frame->texels.num += 4 * num;
    return texels;
}

/* A subtracted solid's face as the colour of what it cuts: the first solid of the object that is
 * not subtracted. */
static const struct csg_leaf *minuend_of(const struct packer *packer,
                                         const struct csg_object *object)
{
    const struct csg_node *nodes = packer->scene->trees[object->layer].data;
    for (uint32_t i = object->begin; i < object->end; i++)
        if (nodes[i].op == CSG_LEAF && !nodes[i].negated)
            return &packer->scene->leaves[nodes[i].leaf];
    return NULL;
}

static void step_color(const struct packer *packer, const struct csg_object *object,
                       const struct csg_step *step, float rgba[4])
{
    const struct csg_leaf *leaf = &packer->scene->leaves[step->leaf];
    bool cut = step->flags & CSG_RECORD_NEGATED;
    if (cut && packer->params->cut_color == CSGCAST_CUT_MINUEND) {
        const struct csg_leaf *minuend = minuend_of(packer, object);
        leaf = minuend ? minuend : leaf;
        cut = minuend == NULL;
    }
    csg_face_color(packer->params->scheme, leaf, object->layer, cut, rgba);
}

/* Writes the planes' texels, entries before exits, and their normals in the same order. */
static uint32_t pack_planes(const struct packer *packer, const struct csg_step *step, float block,
                            float (*texels)[4], float (*normals)[4])
{
    const struct csg_carriers *carriers = packer->scene->carriers;
    const uint32_t begin = carriers->face_begin[step->leaf];
    const uint32_t num = carriers->face_begin[step->leaf + 1] - begin;
    const float sign = step->flags & CSG_RECORD_NEGATED ? -1 : 1;
    uint32_t num_entries = 0, num_exits = 0;
    for (uint32_t i = 0; i < num; i++) {
        const struct csg_face face = carriers->faces[begin + i];
        const struct csg_plane *plane = &carriers->planes[face.carrier];
        float texel[4];
        csg_screen_plane(&packer->frame->screen, packer->frame->at, plane, face.flipped, texel);
        /* Exits fill up from the back, so that both runs are contiguous. */
        const uint32_t slot = texel[3] == 0 ? num_entries++ : num - 1 - num_exits++;
        const float s = face.flipped ? -sign : sign;
        memcpy(texels[slot], texel, sizeof texel);
        normals[slot][0] = s * (float)plane->normal.x;
        normals[slot][1] = s * (float)plane->normal.y;
        normals[slot][2] = s * (float)plane->normal.z;
        normals[slot][3] = block;
    }
    return num_entries;
}

static void pack_quadric(const struct packer *packer, const struct csg_step *step, float block,
                         float (*texels)[4], float (*normals)[4])
{
    const struct csg_carriers *carriers = packer->scene->carriers;
    const struct csg_face face = carriers->quadric_faces[step->leaf];
    const struct csg_quadric *quadric = &carriers->quadrics[face.carrier];
    const struct csg_shape *shape = &packer->scene->leaves[step->leaf].shape;
    const struct csg_box *box = &carriers->quadric_boxes[face.carrier];
    struct csg_vec3 center = {0, 0, 0};
    double radius = INFINITY;
    if (csg_box_is_finite(box)) {
        center = csg_scale(0.5, csg_add(box->lo, box->hi));
        radius = 0.5 * csg_length(csg_sub(box->hi, box->lo));
    }
    csg_screen_quadric(&packer->frame->screen, packer->frame->at, quadric, face.flipped, shape->convex,
                       carriers->sheets[step->leaf], center, radius, texels);
    float terms[CSG_NORMAL_TERMS][3];
    csg_screen_normal(&packer->frame->screen, packer->frame->at, quadric, terms);
    const bool reversed = (step->flags & CSG_RECORD_NEGATED) != 0;
    const float sign = reversed != face.flipped ? -1 : 1;
    for (int i = 0; i < CSG_NORMAL_TERMS; i++)
        for (int j = 0; j < 3; j++)
            normals[i][j] = sign * terms[i][j];
    normals[0][3] = -block;
}

static size_t record_size(const struct csg_carriers *carriers, const struct csg_step *step)
{
    if (step->flags & CSG_RECORD_POP)
        return 1;
    return 1 + carriers->face_begin[step->leaf + 1] - carriers->face_begin[step->leaf] +
           (step->flags & CSG_RECORD_QUADRIC ? CSG_QUADRIC_TEXELS : 0);
}

static size_t attribute_size(const struct csg_carriers *carriers, const struct csg_step *step)
{
    if (step->flags & CSG_RECORD_POP)
        return 0;
    const size_t num_planes =
        carriers->face_begin[step->leaf + 1] - carriers->face_begin[step->leaf];
    const size_t size = CSG_ATTRIBUTE_NORMALS + num_planes +
                        (step->flags & CSG_RECORD_QUADRIC ? CSG_NORMAL_TERMS : 0);
    return (size + 3) / 4 * 4;
}

/* Whether the leaf's quadric is stiff in this view. */
static bool pack_leaf(const struct packer *packer, const struct csg_object *object,
                      const struct csg_step *step, float (*record)[4], float (*attributes)[4],
                      size_t attribute_index)
{
    const struct csg_carriers *carriers = packer->scene->carriers;
    const uint32_t num_planes =
        carriers->face_begin[step->leaf + 1] - carriers->face_begin[step->leaf];
    float(*normals)[4] = attributes + CSG_ATTRIBUTE_NORMALS;
    const float block = (float)(attribute_index / 4 + 1);
    const uint32_t entries = pack_planes(packer, step, block, record + 1, normals);
    if (step->flags & CSG_RECORD_QUADRIC)
        pack_quadric(packer, step, block, record + 1 + num_planes, normals + num_planes);
    record[0][0] = (float)entries;
    record[0][1] = (float)(num_planes - entries);
    record[0][2] = (float)step->flags;
    record[0][3] = (float)(attribute_index / 4);
    step_color(packer, object, step, attributes[CSG_ATTRIBUTE_COLOR]);
    attributes[CSG_ATTRIBUTE_LEAF][0] = (float)step->leaf;
    return step->flags & CSG_RECORD_QUADRIC &&
           ((int)record[1 + num_planes][3] & CSG_QUADRIC_STIFF);
}

/* Appends an object's records and, behind them, its attribute blocks. */
static bool pack_object(const struct packer *packer, size_t index, struct csg_draw *draw)
{
    const struct csg_carriers *carriers = packer->scene->carriers;
    const struct csg_object *object = &packer->scene->objects->data[index];
    const struct csg_step *steps = packer->plan->program.data;
    const uint32_t begin = packer->plan->begin[index], end = packer->plan->begin[index + 1];
    size_t num_records = 0, num_attributes = 0;
    for (uint32_t i = begin; i < end; i++) {
        num_records += record_size(carriers, &steps[i]);
        num_attributes += attribute_size(carriers, &steps[i]);
    }
    const size_t first = packer->frame->texels.num / 4;
    size_t record = first, attribute = (first + num_records + 3) / 4 * 4;
    draw->instance.records[0] = (int32_t)first;
    draw->instance.records[1] = (int32_t)(first + num_records);
    if (!add_texels(packer->frame, attribute + num_attributes - first))
        return false;
    float(*texels)[4] = (float(*)[4])packer->frame->texels.data;
    for (uint32_t i = begin; i < end; i++) {
        if (steps[i].flags & CSG_RECORD_POP) {
            texels[record][2] = (float)steps[i].flags;
        } else {
            draw->stiff |= pack_leaf(packer, object, &steps[i], texels + record,
                                     texels + attribute, attribute);
            draw->translucent |= texels[attribute + CSG_ATTRIBUTE_COLOR][3] < 1;
        }
        record += record_size(carriers, &steps[i]);
        attribute += attribute_size(carriers, &steps[i]);
    }
    return true;
}

static bool holds_eye(const struct csg_screen *screen, const struct csg_box *box)
{
    const struct csg_vec3 eye = screen->origin;
    if (screen->orthographic)
        return !csg_box_is_finite(box);
    return box->lo.x <= eye.x && eye.x <= box->hi.x && box->lo.y <= eye.y && eye.y <= box->hi.y &&
           box->lo.z <= eye.z && eye.z <= box->hi.z;
}

/* One for all objects: their flush faces then have the same keys to the last bit. */
static struct csg_pixel reference_pixel(const struct csg_screen *screen, const struct csg_box *box)
{
    if (!csg_box_is_empty(box) && csg_box_is_finite(box))
        return csg_screen_pixel(screen, csg_scale(0.5, csg_add(box->lo, box->hi)));
    return (struct csg_pixel){floor(0.5 * screen->width), floor(0.5 * screen->height)};
}

static bool add_object(struct packer *packer, size_t index, struct csg_rect *rects)
{
    struct csg_frame *frame = packer->frame;
    const struct csg_screen *screen = &frame->screen;
    const struct csg_object *object = &packer->scene->objects->data[index];
    if (packer->plan->begin[index] == packer->plan->begin[index + 1])
        return true;
    struct csg_rect rect = object_rect(packer, object, rects);
    const struct csg_rect by_box = csg_screen_rect(screen, &csg_map_identity, &object->box);
    combine_rects(&rect, &by_box, true);
    if (is_empty(&rect))
        return true;
    struct csg_draw draw = {.object = (uint32_t)index, .layer = object->layer};
    draw.around_eye = holds_eye(screen, &object->box);
    const double size[2] = {screen->width, screen->height};
    for (int i = 0; i < 2; i++) {
        draw.instance.rect[i] = (float)(2 * rect.lo[i] / size[i] - 1);
        draw.instance.rect[2 + i] = (float)(2 * rect.hi[i] / size[i] - 1);
    }
    frame->proxy_pixels +=
        (size_t)(ceil(rect.hi[0] - rect.lo[0]) * ceil(rect.hi[1] - rect.lo[1]));
    return pack_object(packer, index, &draw) && csg_array_push(&frame->draws, draw);
}

bool csg_frame_fill(struct csg_frame *frame, const struct csgcast_scene *scene,
                    const struct csg_frame_params *params)
{
    struct packer packer = {frame, scene, scene->plan, params};
    size_t largest = 0;
    for (size_t i = 0; i < scene->objects->num; i++) {
        const size_t size = scene->objects->data[i].end - scene->objects->data[i].begin;
        largest = size > largest ? size : largest;
    }
    struct csg_rect *rects = malloc((largest + 1) * sizeof *rects);
    if (!rects)
        return false;
    csg_screen_init(&frame->screen, params->frustum, params->width, params->height, &scene->box);
    frame->at = reference_pixel(&frame->screen, &scene->box);
    frame->texels.num = 0;
    frame->draws.num = 0;
    frame->proxy_pixels = 0;
    bool ok = true;
    for (size_t i = 0; i < scene->objects->num && ok; i++)
        ok = add_object(&packer, i, rects);
    free(rects);
    return ok;
}

void csg_frame_finish(struct csg_frame *frame)
{
    free(frame->texels.data);
    free(frame->draws.data);
    *frame = (struct csg_frame){0};
}
