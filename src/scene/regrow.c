/* SPDX-License-Identifier: MIT */

/* A node that becomes another number of solids, or the same under another tree. */

#include <stdlib.h>
#include <string.h>

#include "csg/wholes.h"
#include "nodes/walk.h"
#include "scene/reading.h"

struct regrow {
    struct csgcast_scene *scene;
    struct csg_reading *readings;
    size_t num;
    uint32_t *leaves; /* by leaf, and by their number: the number that it gets */
    /* What the scene is to have; once it does, what it had: */
    struct csg_leaf *new_leaves;
    size_t num_leaves, capacity;
    struct csg_edits edits;
    struct wholes {
        struct csg_whole *data;
        size_t num, capacity;
    } wholes;
    bool is_in;
};

/* ---- leaves -------------------------------------------------------------------------------- */

static int compare_readings(const void *a, const void *b)
{
    const struct csg_reading *x = a, *y = b;
    return (x->first > y->first) - (x->first < y->first);
}

/* Of the node whose first leaf that is; NULL: it stays as it is. */
static struct csg_reading *find_reading(const struct regrow *regrow, uint32_t first)
{
    const struct csg_reading key = {.first = first};
    return bsearch(&key, regrow->readings, regrow->num, sizeof key, compare_readings);
}

static void put_leaf(struct regrow *regrow, const struct csg_leaf *leaf,
                     const struct csg_origin *origin)
{
    regrow->new_leaves[regrow->num_leaves++] = *leaf;
    regrow->edits.origins.data[regrow->edits.origins.num++] = *origin;
}

/* A leaf of the reading, where the one that was the node's first stands. false: out of memory. */
static bool put_read_leaf(struct regrow *regrow, struct csg_reading *reading, uint32_t index)
{
    struct csg_leaf leaf = regrow->scene->leaves[reading->first];
    struct csg_origin origin = regrow->scene->edits->origins.data[reading->first];
    struct csg_shape *shape = &reading->origins.data[reading->begin + index].shape;
    const struct csg_leaf *read = &reading->scene->leaves[reading->begin + index];
    if (!csg_shape_copy(&leaf.shape, shape))
        return false;
    leaf.kind = read->kind;
    leaf.is_hole = read->is_hole;
    leaf.is_empty = !csg_space_place(&origin.space, &leaf.shape);
    origin.shape = *shape;
    origin.first = regrow->leaves[reading->first];
    origin.num = reading->num;
    origin.is_nothing = false;
    *shape = (struct csg_shape){0};
    put_leaf(regrow, &leaf, &origin);
    return true;
}

static size_t count_leaves(const struct regrow *regrow)
{
    size_t num = regrow->scene->num_leaves;
    for (size_t i = 0; i < regrow->num; i++)
        num = num - regrow->readings[i].num_before + regrow->readings[i].num;
    return num;
}

static bool put_leaves(struct regrow *regrow)
{
    const struct csgcast_scene *scene = regrow->scene;
    const size_t num = count_leaves(regrow);
    regrow->leaves = malloc((scene->num_leaves + 1) * sizeof *regrow->leaves);
    regrow->new_leaves = malloc((num + 1) * sizeof *regrow->new_leaves);
    regrow->edits.patches = calloc(num + 1, sizeof *regrow->edits.patches);
    regrow->capacity = num + 1;
    if (!regrow->leaves || !regrow->new_leaves || !regrow->edits.patches ||
        !csg_array_reserve(&regrow->edits.origins, num + 1))
        return false;
    memset(regrow->leaves, 0xff, scene->num_leaves * sizeof *regrow->leaves);
    bool ok = true;
    for (uint32_t i = 0; i < scene->num_leaves && ok; i++) {
        struct csg_origin origin = scene->edits->origins.data[i];
        struct csg_reading *reading = find_reading(regrow, origin.first);
        regrow->leaves[i] = (uint32_t)regrow->num_leaves;
        if (!reading) {
            origin.first = regrow->leaves[origin.first];
            put_leaf(regrow, &scene->leaves[i], &origin);
        }
        for (uint32_t j = 0; reading && i == origin.first && j < reading->num && ok; j++)
            ok = put_read_leaf(regrow, reading, j);
    }
    regrow->leaves[scene->num_leaves] = (uint32_t)regrow->num_leaves;
    return ok;
}

/* ---- trees --------------------------------------------------------------------------------- */

/* place: where the tree ends now. */
static bool put_part(struct regrow *regrow, struct csg_tree *tree,
                     const struct csg_reading *reading, const struct csg_part_place *place)
{
    const uint32_t first = regrow->leaves[reading->first];
    bool ok = true;
    for (uint32_t i = 0; i < reading->part_end - reading->part_begin && ok; i++)
        ok = csg_array_push(tree, csg_reading_node(reading, i, place, first));
    return ok;
}

/* The first leaf of a part's node in the scene; no leaf: the part has none. */
static uint32_t first_leaf(const struct csg_tree *tree, const struct csg_part_place *place)
{
    for (uint32_t i = place->at; i < tree->data[place->at].end; i++)
        if (tree->data[i].op == CSG_LEAF)
            return tree->data[i].leaf;
    return UINT32_MAX;
}

static struct csg_reading *reading_of(const struct regrow *regrow, const struct csg_tree *tree,
                                      const struct csg_part_place *place)
{
    const uint32_t leaf = first_leaf(tree, place);
    return leaf == UINT32_MAX
               ? NULL
               : find_reading(regrow, regrow->scene->edits->origins.data[leaf].first);
}

/* Where a node comes to stand. */
struct move {
    uint32_t to;
    bool stays; /* it is not of a part that goes */
};

/* The tree with the new parts; next is the place of the first part in it, and moves behind the
 * last. moves: by node, and of their end. */
static bool put_nodes(struct regrow *regrow, int layer, size_t *next, struct move *moves)
{
    const struct csg_tree *old = &regrow->scene->edits->whole[layer];
    const struct csg_origins *origins = &regrow->scene->edits->origins;
    struct csg_tree *tree = &regrow->edits.whole[layer];
    bool ok = true;
    for (uint32_t i = 0; i < old->num && ok;) {
        const struct csg_reading *reading = NULL;
        moves[i].to = (uint32_t)tree->num;
        if (*next < origins->places.num && origins->places.data[*next].layer == layer &&
            origins->places.data[*next].at == i) {
            struct csg_part_place place = origins->places.data[(*next)++];
            reading = reading_of(regrow, old, &place);
            place.at = moves[i].to;
            ok = csg_array_push(&regrow->edits.origins.places, place) &&
                 (!reading || put_part(regrow, tree, reading, &place));
        }
        moves[i].stays = !reading;
        ok = ok && (reading || csg_array_push(tree, old->data[i]));
        i = reading ? old->data[i].end : i + 1;
    }
    moves[old->num].to = (uint32_t)tree->num;
    return ok;
}

/* Of the nodes that were there: ends, and numbers of leaves. */
static void renumber(const struct regrow *regrow, const struct csg_tree *old, struct csg_tree *tree,
                     const struct move *moves)
{
    for (uint32_t i = 0; i < old->num; i++) {
        if (!moves[i].stays)
            continue;
        struct csg_node *node = &tree->data[moves[i].to];
        node->end = moves[old->data[i].end].to;
        if (node->op == CSG_LEAF)
            node->leaf = regrow->leaves[node->leaf];
    }
}

static bool put_trees(struct regrow *regrow)
{
    size_t next = 0;
    bool ok = true;
    for (int layer = 0; layer < CSG_NUM_LAYERS && ok; layer++) {
        const struct csg_tree *old = &regrow->scene->edits->whole[layer];
        struct csg_tree *tree = &regrow->edits.whole[layer];
        struct move *moves = calloc(old->num + 1, sizeof *moves);
        ok = moves && put_nodes(regrow, layer, &next, moves);
        if (ok)
            renumber(regrow, old, tree, moves);
        free(moves);
        ok = ok && csg_tree_copy(tree, &regrow->edits.trees[layer]) &&
             csg_tree_simplify(&regrow->edits.trees[layer], NULL);
    }
    return ok;
}

/* ---- render() nodes ------------------------------------------------------------------------ */

static bool put_wholes(struct regrow *regrow)
{
    bool ok = true;
    for (size_t i = 0; i < regrow->scene->wholes.num && ok; i++) {
        struct csg_whole whole = regrow->scene->wholes.data[i];
        whole.begin = regrow->leaves[whole.begin];
        whole.end = regrow->leaves[whole.end];
        ok = csg_array_push(&regrow->wholes, whole);
    }
    return ok;
}

/* Faces of what is taken away within a render() node are no cut faces either. */
static void mark_holes(const struct regrow *regrow)
{
    for (int layer = 0; layer < CSG_LAYER_HIGHLIGHT; layer++) {
        const struct csg_tree *tree = &regrow->scene->edits->whole[layer];
        for (size_t i = 0; i < tree->num; i++) {
            const struct csg_node *node = &tree->data[i];
            const struct csg_whole *whole =
                node->op == CSG_LEAF ? csg_find_whole(regrow->scene, node->leaf) : NULL;
            if (whole)
                regrow->scene->leaves[node->leaf].is_hole = node->negated != whole->negated;
        }
    }
}

/* ---- the whole ----------------------------------------------------------------------------- */

/* The scene and what it is to have change places. */
static void swap(struct regrow *regrow)
{
    struct csgcast_scene *scene = regrow->scene;
    const struct regrow had = *regrow;
    regrow->new_leaves = scene->leaves;
    regrow->num_leaves = scene->num_leaves;
    regrow->capacity = scene->leaves_capacity;
    memcpy(&regrow->wholes, &scene->wholes, sizeof scene->wholes);
    regrow->edits = *scene->edits;
    scene->leaves = had.new_leaves;
    scene->num_leaves = had.num_leaves;
    scene->leaves_capacity = had.capacity;
    memcpy(&scene->wholes, &had.wholes, sizeof scene->wholes);
    *scene->edits = had.edits;
    scene->edits->texts = regrow->edits.texts;
    scene->edits->text = regrow->edits.text;
    scene->edits->num_dropped = regrow->edits.num_dropped;
    regrow->is_in = !regrow->is_in;
}

/* The shapes that only what is left here has. */
static void finish_shapes(struct regrow *regrow)
{
    for (size_t i = 0; i < regrow->num && regrow->num_leaves > 0; i++) {
        const struct csg_reading *reading = &regrow->readings[i];
        const size_t first = regrow->is_in ? reading->first : regrow->leaves[reading->first];
        const size_t end = first + (regrow->is_in ? reading->num_before : reading->num);
        for (size_t j = first; j < end && j < regrow->num_leaves; j++) {
            csg_shape_finish(&regrow->new_leaves[j].shape);
            csg_shape_finish(&regrow->edits.origins.data[j].shape);
        }
    }
}

static void finish(struct regrow *regrow)
{
    finish_shapes(regrow);
    for (int layer = 0; layer < CSG_NUM_LAYERS; layer++) {
        free(regrow->edits.whole[layer].data);
        free(regrow->edits.trees[layer].data);
    }
    free(regrow->edits.origins.data);
    free(regrow->edits.origins.places.data);
    free(regrow->edits.patches);
    free(regrow->wholes.data);
    free(regrow->new_leaves);
    free(regrow->leaves);
}

bool csg_edits_regrow(struct csgcast_scene *scene, struct csg_reading *readings, size_t num)
{
    struct regrow regrow = {.scene = scene, .readings = readings, .num = num};
    qsort(readings, num, sizeof *readings, compare_readings);
    bool ok = (put_leaves(&regrow) && put_trees(&regrow) && put_wholes(&regrow)) ||
              csg_log_memory(&scene->log);
    if (ok) {
        swap(&regrow);
        mark_holes(&regrow);
        ok = csg_edits_remake(scene, NULL);
        if (!ok)
            swap(&regrow);
    }
    finish(&regrow);
    return ok;
}
