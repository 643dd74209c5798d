/* SPDX-License-Identifier: MIT */
#include "pack/terms.h"

#include "common/parallel.h"
#include "pack/textbook.h"

#include <stdlib.h>
#include <string.h>

bool csg_terms_init(struct csg_terms *terms, struct csg_frame *frame,
                    const struct csgcast_scene *scene, const struct csg_frame_params *params)
{
    *terms = (struct csg_terms){.frame = frame, .scene = scene, .params = params};
    const size_t room = csg_stacks_room(scene->num_leaves);
    terms->index = calloc(room, sizeof *terms->index);
    terms->known = malloc(room);
    return terms->index && terms->known;
}

void csg_terms_finish(struct csg_terms *terms)
{
    csg_seen_finish(&terms->seen);
    csg_surface_views_clear(&terms->views);
    csg_stacks_finish(&terms->stacks);
    csg_bands_finish(&terms->bands);
    free(terms->views.data);
    free(terms->leaves.data);
    free(terms->texels.data);
    free(terms->index);
    free(terms->known);
}

void csg_terms_take(struct csg_terms *to, struct csg_terms *from)
{
    *to = *from;
    to->seen = (struct csg_seen){
        .nodes = from->seen.nodes, .begin = from->seen.begin, .end = from->seen.end};
    to->index = NULL;
    to->known = NULL;
    memset(&from->leaves, 0, sizeof from->leaves);
    memset(&from->texels, 0, sizeof from->texels);
    memset(&from->views, 0, sizeof from->views);
    memset(&from->stacks, 0, sizeof from->stacks);
    memset(&from->bands, 0, sizeof from->bands);
}

static void face_color(const struct csg_terms *terms, const struct csg_object *object,
                       const struct csg_node *node, float rgba[4])
{
    const struct csg_leaf *leaf = &terms->scene->leaves[node->leaf];
    const struct csg_leaf *minuend = terms->params->cut_color == CSGCAST_CUT_MINUEND
                                         ? csg_object_minuend(terms->scene, object)
                                         : NULL;
    csg_face_color(terms->params->scheme, leaf, minuend, object->paint, node->negated, rgba);
}

static void put_normal(float texel[4], struct csg_vec3 normal, double sign, float block)
{
    texel[0] = (float)(sign * normal.x);
    texel[1] = (float)(sign * normal.y);
    texel[2] = (float)(sign * normal.z);
    texel[3] = block;
}

/* The planes' texels, entries before exits, and their normals in the order of the leaf's faces. */
static uint32_t put_planes(const struct csg_terms *terms, const struct csg_node *node,
                           uint32_t first_face, double (*texels)[4], float (*normals)[4],
                           float block)
{
    const struct csg_carriers *carriers = terms->scene->carriers;
    const uint32_t begin = carriers->face_begin[node->leaf];
    const uint32_t num = carriers->face_begin[node->leaf + 1] - begin;
    uint32_t num_entries = 0, num_exits = 0;
    for (uint32_t i = 0; i < num; i++) {
        const struct csg_face face = carriers->faces[begin + i];
        const struct csg_plane *plane = &carriers->planes[face.carrier];
        put_normal(normals[first_face + i], plane->normal, face.flipped != node->negated ? -1 : 1,
                   block);
        if (terms->params->textbook) {
            csg_textbook_plane(plane, face.flipped, texels[num_entries++]);
            continue;
        }
        double texel[4];
        csg_screen_plane(&terms->frame->screen, terms->frame->at, plane, face.flipped, texel);
        /* Exits fill up from the back, so that both runs are contiguous. */
        const uint32_t slot = texel[3] > 0 ? num_entries++ : num - 1 - num_exits++;
        texel[3] *= first_face + i + 1;
        memcpy(texels[slot], texel, sizeof texel);
    }
    return num_entries;
}

void csg_terms_crossings(const struct csg_frame *frame, const struct csgcast_scene *scene,
                         uint32_t leaf, double texels[CSG_QUADRIC_TEXELS][4], float *base)
{
    const struct csg_carriers *carriers = scene->carriers;
    const struct csg_face face = carriers->quadric_faces[leaf];
    const struct csg_box *box = csg_carrier_quadric_box(scene, carriers, face.carrier);
    struct csg_vec3 center = {0, 0, 0};
    double radius = INFINITY;
    if (csg_box_is_finite(box)) {
        center = csg_box_middle(box);
        radius = 0.5 * csg_length(csg_sub(box->hi, box->lo));
    }
    csg_screen_quadric(
        &frame->screen, frame->at, csg_carrier_quadric(scene, carriers, face.carrier), face.flipped,
        scene->leaves[leaf].shape.convex, carriers->sheets[leaf], center, radius, texels);
    if (base)
        csg_screen_base(&frame->screen, (const double(*)[4])texels, center, radius, base);
}

/* What some of the leaves tell of all of them: see csg_terms. */
struct notes {
    bool translucent, stiff;
    double error;
    uint32_t roughest;
};

/* Stiff quadrics are those whose crossings float may not hold. */
static void note_stiff(const struct csg_terms *terms, const struct csg_rect *rect, uint32_t leaf,
                       const double (*texels)[4], struct notes *notes)
{
    const struct csg_screen *screen = &terms->frame->screen;
    const uint32_t carrier = terms->scene->carriers->quadric_faces[leaf].carrier;
    double depth[2];
    if (terms->params->textbook || !((int)texels[0][3] & CSG_QUADRIC_STIFF))
        return;
    notes->stiff = true;
    if (terms->precise)
        return;
    csg_depth_range(screen, csg_carrier_quadric_box(terms->scene, terms->scene->carriers, carrier),
                    depth);
    const double error = csg_quadric_error(screen, terms->frame->at, rect, depth, texels);
    if (error <= notes->error)
        return;
    notes->error = error;
    notes->roughest = leaf;
}

static void put_quadric(const struct csg_terms *terms, const struct csg_node *node,
                        double (*texels)[4], float (*normals)[4], float block)
{
    const struct csg_face face = terms->scene->carriers->quadric_faces[node->leaf];
    const struct csg_quadric *quadric =
        csg_carrier_quadric(terms->scene, terms->scene->carriers, face.carrier);
    const bool textbook = terms->params->textbook;
    float normal[CSG_NORMAL_TERMS][3], base[3] = {0, 0, 0};
    if (textbook) {
        csg_textbook_quadric(quadric, face.flipped, texels);
        csg_textbook_normal(quadric, normal);
    } else {
        csg_terms_crossings(terms->frame, terms->scene, node->leaf, texels,
                            terms->precise ? base : NULL);
        csg_screen_normal(&terms->frame->screen, terms->frame->at, quadric, base, normal);
    }
    for (int i = 0; i < CSG_NORMAL_TERMS; i++)
        put_normal(normals[i], csg_vec3(normal[i][0], normal[i][1], normal[i][2]),
                   face.flipped != node->negated ? -1 : 1, i == 0 ? -block : base[i - 1]);
}

/* A solid that no ray meets, with as many faces as the leaf has, half of them exits: what has
 * planes in pairs has no fewer (csg_shape_is_paired). Returns the number of entries. */
static uint32_t put_nothing(uint32_t num_planes, bool has_quadric, double (*texels)[4])
{
    const uint32_t num_entries = num_planes - num_planes / 2;
    for (uint32_t i = 0; i < num_planes; i++) {
        texels[i][0] = CSG_KEY_MAX;
        texels[i][1] = texels[i][2] = 0;
        texels[i][3] = i < num_entries ? i + 1.0 : -(i + 1.0);
    }
    if (!has_quadric)
        return num_entries;
    memset(texels + num_planes, 0, CSG_QUADRIC_TEXELS * sizeof *texels);
    texels[num_planes][3] = CSG_QUADRIC_BETWEEN;
    texels[num_planes + 1][3] = -1; /* the constant of the silhouette conic */
    return num_entries;
}

static bool add_view(struct csg_terms *terms, const struct csg_node *node,
                     struct csg_leaf_terms *leaf)
{
    struct csg_surface_view view;
    csg_surface_view_init(&view, &terms->scene->leaves[node->leaf].shape, node->leaf, node->spare);
    leaf->view = (uint32_t)terms->views.num;
    return csg_array_push(&terms->views, view);
}

/* Of fewer leaves tiles are as soon made without. */
#define MIN_RECT_NODES 24

static struct csg_rect leaf_rect(const struct csg_terms *terms, const struct csg_object *object,
                                 const struct csg_shape *shape)
{
    const struct csg_screen *screen = &terms->frame->screen;
    if (object->end - object->begin < MIN_RECT_NODES || shape->surface)
        return (struct csg_rect){{0, 0}, {screen->width, screen->height}};
    return csg_screen_rect(screen, &shape->frame, &shape->bounds);
}

/* The terms that a leaf has already; NULL: none. Parts of a distributed object have what cuts them
 * in common (prepare/distribute.h), and a layer that is drawn as one object has them all. */
static struct csg_leaf_terms *find_placed(const struct csg_terms *terms,
                                          const struct csg_node *nodes, uint32_t leaf)
{
    const uint32_t at = terms->index[leaf];
    struct csg_leaf_terms *placed = terms->leaves.data + at;
    return at < terms->leaves.num && nodes[placed->node].leaf == leaf ? placed : NULL;
}

/* Makes room for a leaf's terms and attributes. */
static bool place_leaf(struct csg_terms *terms, const struct csg_node *nodes, uint32_t at)
{
    const struct csg_node *node = &nodes[at];
    struct csg_leaf_terms *placed = find_placed(terms, nodes, node->leaf);
    if (placed) {
        placed->node = nodes[placed->node].spare ? at : placed->node;
        return true;
    }
    const struct csg_carriers *carriers = terms->scene->carriers;
    const struct csg_shape *shape = &terms->scene->leaves[node->leaf].shape;
    const uint32_t num_planes =
        shape->surface ? 0
                       : carriers->face_begin[node->leaf + 1] - carriers->face_begin[node->leaf];
    const uint32_t first_face = shape->has_quadric ? CSG_NORMAL_TERMS : 0;
    const size_t num_texels = num_planes + (shape->has_quadric ? CSG_QUADRIC_TEXELS : 0);
    const size_t block = (terms->frame->texels.num / 4 + 3) / 4;
    const size_t padding = block * 4 - terms->frame->texels.num / 4;
    struct csg_leaf_terms leaf = {.node = at,
                                  .texels = terms->texels.num / 4,
                                  .num_entries = num_planes,
                                  .attributes = block};
    if (!csg_frame_add_texels(terms->frame,
                              padding + CSG_ATTRIBUTE_NORMALS + first_face + num_planes) ||
        !csg_array_reserve(&terms->texels, 4 * num_texels) ||
        (shape->surface && !add_view(terms, node, &leaf)))
        return false;
    terms->texels.num += 4 * num_texels;
    terms->index[node->leaf] = (uint32_t)terms->leaves.num;
    return csg_array_push(&terms->leaves, leaf);
}

/* Fills the room of a leaf. */
static void fill_leaf(const struct csg_terms *terms, const struct csg_object *object,
                      const struct csg_node *node, const struct csg_rect *rect, struct notes *notes)
{
    const struct csg_carriers *carriers = terms->scene->carriers;
    const struct csg_shape *shape = &terms->scene->leaves[node->leaf].shape;
    struct csg_leaf_terms *leaf = &terms->leaves.data[terms->index[node->leaf]];
    const uint32_t num_planes = leaf->num_entries;
    float(*attributes)[4] = (float(*)[4])terms->frame->texels.data + 4 * leaf->attributes;
    double(*texels)[4] = (double(*)[4])terms->texels.data + leaf->texels;
    float(*normals)[4] = attributes + CSG_ATTRIBUTE_NORMALS;
    const float mark = (float)(leaf->attributes + 1);
    face_color(terms, object, node, attributes[CSG_ATTRIBUTE_COLOR]);
    attributes[CSG_ATTRIBUTE_LEAF][0] = (float)node->leaf;
    leaf->flags = csg_node_flags(terms->scene, node);
    leaf->carrier = carriers->quadric_faces[node->leaf].carrier;
    leaf->rect = leaf_rect(terms, object, shape);
    if (node->spare)
        leaf->num_entries = put_nothing(num_planes, shape->has_quadric, texels);
    else if (!shape->surface)
        leaf->num_entries = put_planes(terms, node, shape->has_quadric ? CSG_NORMAL_TERMS : 0,
                                       texels, normals, mark);
    leaf->num_exits = num_planes - leaf->num_entries;
    if (shape->has_quadric && !node->spare) {
        put_quadric(terms, node, texels + num_planes, normals, mark);
        note_stiff(terms, rect, node->leaf, (const double(*)[4])texels + num_planes, notes);
    }
    notes->translucent |= !node->spare && attributes[CSG_ATTRIBUTE_COLOR][3] < 1;
}

/* Nodes that one core fills at a time. */
#define CHUNK 128

struct filling {
    const struct csg_terms *terms;
    const struct csg_object *object;
    const struct csg_rect *rect;
    struct notes *notes; /* by chunk */
};

static void fill_chunk(void *user, size_t chunk)
{
    const struct filling *filling = user;
    const struct csg_object *object = filling->object;
    const struct csg_seen *seen = &filling->terms->seen;
    const struct csg_node *nodes = seen->nodes;
    const size_t begin = seen->begin + CHUNK * chunk;
    for (size_t i = begin; i < begin + CHUNK && i < seen->end; i++)
        if (nodes[i].op == CSG_LEAF && csg_terms_of(filling->terms, nodes[i].leaf)->node == i)
            fill_leaf(filling->terms, object, &nodes[i], filling->rect, &filling->notes[chunk]);
}

/* As if the chunks had been filled one after the other. */
static void take_notes(struct csg_terms *terms, const struct notes *notes)
{
    terms->translucent |= notes->translucent;
    terms->stiff |= notes->stiff;
    if (notes->error <= terms->error)
        return;
    terms->error = notes->error;
    terms->roughest = notes->roughest;
}

static bool fill_leaves(struct csg_terms *terms, const struct csg_object *object,
                        const struct csg_rect *rect)
{
    const size_t num = (terms->seen.end - terms->seen.begin + CHUNK - 1) / CHUNK;
    struct filling filling = {terms, object, rect, calloc(num + 1, sizeof *filling.notes)};
    if (!filling.notes)
        return false;
    csg_parallel(terms->params->num_threads, num, fill_chunk, &filling);
    for (size_t i = 0; i < num; i++)
        take_notes(terms, &filling.notes[i]);
    free(filling.notes);
    return true;
}

/* A leaf of its own for each stack. */
static bool add_stacks(struct csg_terms *terms, const struct csg_object *object)
{
    bool ok = terms->seen.is_part || csg_stacks_find(&terms->stacks, terms->scene, object);
    for (size_t i = 0; i < terms->stacks.list.num && ok; i++) {
        terms->index[terms->scene->num_leaves + i] = (uint32_t)terms->leaves.num;
        ok = csg_array_push(&terms->leaves,
                            ((struct csg_leaf_terms){.flags = CSG_RECORD_SURFACE | CSG_RECORD_BANDS,
                                                     .carrier = CSG_NO_CARRIER}));
    }
    return ok && csg_bands_fill(&terms->bands, terms, &terms->stacks);
}

static bool fill(struct csg_terms *terms, const struct csg_object *object,
                 const struct csg_rect *rect)
{
    const struct csg_seen *seen = &terms->seen;
    terms->leaves.num = terms->texels.num = 0;
    csg_surface_views_clear(&terms->views);
    terms->translucent = terms->stiff = false;
    terms->error = 0;
    for (uint32_t i = seen->begin; i < seen->end; i++)
        if (seen->nodes[i].op == CSG_LEAF && !place_leaf(terms, seen->nodes, i))
            return false;
    return fill_leaves(terms, object, rect) &&
           (terms->params->textbook || add_stacks(terms, object));
}

/* Stacks are of all the object. */
bool csg_terms_see(struct csg_terms *terms, const struct csg_object *object, bool whole)
{
    csg_seen_all(&terms->seen, terms->scene, object);
    if (whole)
        return true;
    if (!csg_seen_find(&terms->seen, terms->scene, &terms->frame->screen, object))
        return false;
    if (!terms->seen.is_part)
        return true;
    const bool ok = csg_stacks_find(&terms->stacks, terms->scene, object);
    if (terms->stacks.list.num)
        csg_seen_all(&terms->seen, terms->scene, object);
    return ok;
}

bool csg_terms_fill(struct csg_terms *terms, const struct csg_object *object,
                    const struct csg_rect *rect)
{
    const size_t begin = terms->frame->texels.num;
    if (!fill(terms, object, rect))
        return false;
    const bool can_help = terms->params->has_double || object->layer == CSG_LAYER_MODEL;
    if (terms->precise || terms->error <= CSG_MAX_DEPTH_ERROR || !can_help)
        return true;
    const double error = terms->error;
    terms->frame->texels.num = begin;
    terms->precise = true;
    const bool ok = fill(terms, object, rect);
    terms->error = error;
    return ok;
}
