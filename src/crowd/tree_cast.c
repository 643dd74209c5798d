/* SPDX-License-Identifier: MIT */
#include "crowd/tree_cast.h"

#include "common/wide.h"
#include "crowd/member.h"

/* ---- which objects ---- */

static bool can_cast(const struct csgcast_scene *scene, const struct csg_node *node)
{
    const struct csg_shape *shape = &scene->leaves[node->leaf].shape;
    return !node->spare && !shape->surface && shape->convex &&
           shape->num_planes <= CSG_CROWD_MAX_PLANES;
}

bool csg_tree_cast_can(const struct csgcast_scene *scene, const struct csg_object *object)
{
    const struct csg_node *nodes = scene->trees[object->layer].data;
    size_t num_leaves = 0;
    if (object->end - object->begin > CSG_TREE_CAST_NODES)
        return false;
    for (uint32_t i = object->begin; i < object->end; i++) {
        if (nodes[i].op != CSG_LEAF)
            continue;
        if (++num_leaves > CSG_TREE_CAST_LEAVES || !can_cast(scene, &nodes[i]))
            return false;
    }
    return true;
}

bool csg_tree_cast_init(struct csg_tree_cast *tree, const struct csg_frame *frame,
                        const struct csgcast_scene *scene, const struct csg_object *object,
                        const struct csg_cast_rect *rect, float noise)
{
    const struct csg_carriers *carriers = scene->carriers;
    uint32_t num_leaves = 0;
    tree->nodes = scene->trees[object->layer].data + object->begin;
    tree->begin = object->begin;
    tree->num = object->end - object->begin;
    for (uint32_t i = 0; i < tree->num; i++) {
        const uint32_t leaf = tree->nodes[i].leaf;
        if (tree->nodes[i].op != CSG_LEAF)
            continue;
        float *terms = tree->terms[num_leaves];
        if (!csg_leaf_cast_terms(frame, scene, leaf, terms) ||
            !csg_cast_init(
                &tree->casts[num_leaves], carriers->quadric_faces[leaf].carrier != CSG_NO_CARRIER,
                carriers->face_begin[leaf + 1] - carriers->face_begin[leaf], terms, rect, noise))
            return false;
        tree->leaves[i] = num_leaves++;
    }
    return true;
}

/* ---- rays ---- */

/* A literal is true from lo on and before hi; a complement is not. */
struct literal {
    float lo[CSG_CAST_LANES], hi[CSG_CAST_LANES];
};

/* Bounds the literal's set from inside, or from outside. */
PART void bound_literal(const struct csg_spans *spans, bool inner, struct literal *literal)
{
    for (int i = 0; i < CSG_CAST_LANES; i++) {
        literal->lo[i] = inner ? spans->entry_hi[i] : spans->entry_lo[i];
        literal->hi[i] = inner ? spans->exit_lo[i] : spans->exit_hi[i];
    }
}

/* The soonest key from k on at which the literal can be true. */
PART void ask_literal(const struct literal *literal, bool negated, const float *k, float *soonest)
{
    for (int i = 0; i < CSG_CAST_LANES; i++) {
        const float lo = literal->lo[i], hi = literal->hi[i];
        const float from = k[i] > lo ? k[i] : lo;
        const float inside = from < hi ? from : CSG_KEY_MAX;
        const float outside = ((k[i] >= lo) & (k[i] < hi)) ? hi : k[i];
        soonest[i] = negated ? outside : inside;
    }
}

PART void combine(enum csg_op op, const float *operand, float *into)
{
    for (int i = 0; i < CSG_CAST_LANES; i++) {
        const float least = operand[i] < into[i] ? operand[i] : into[i];
        const float most = operand[i] > into[i] ? operand[i] : into[i];
        into[i] = op == CSG_AND ? most : least;
    }
}

struct keys {
    float of[CSG_CAST_LANES];
};

/* One step of docs/pipeline.md#the-first-visible-point. Whether any lane moved on. */
WIDE bool step(const struct csg_tree_cast *tree, const struct literal *literals, float *k)
{
    struct keys keys[CSG_TREE_CAST_NODES];
    unsigned moved = 0;
    for (uint32_t i = tree->num; i-- > 0;) {
        const struct csg_node *node = &tree->nodes[i];
        if (node->op == CSG_LEAF) {
            ask_literal(&literals[tree->leaves[i]], node->negated, k, keys[i].of);
            continue;
        }
        const float start = node->op == CSG_AND ? -CSG_KEY_MAX : CSG_KEY_MAX;
        for (int j = 0; j < CSG_CAST_LANES; j++)
            keys[i].of[j] = start;
        for (uint32_t child = i + 1; child < node->end - tree->begin;
             child = tree->nodes[child].end - tree->begin)
            combine((enum csg_op)node->op, keys[child].of, keys[i].of);
    }
    for (int i = 0; i < CSG_CAST_LANES; i++) {
        moved |= keys[0].of[i] > k[i] ? 1 : 0;
        k[i] = keys[0].of[i];
    }
    return moved != 0;
}

/* Each step but the last leaves an interval of a literal behind. */
enum { MAX_STEPS = 2 * CSG_TREE_CAST_LEAVES + 2 };

/* The first key at which the set is true. false: not found, and nothing is before it. */
static bool find_first(const struct csg_tree_cast *tree, const struct literal *literals, float *k)
{
    for (int i = 0; i < CSG_CAST_LANES; i++)
        k[i] = -CSG_KEY_MAX;
    for (int i = 0; i < MAX_STEPS; i++)
        if (!step(tree, literals, k))
            return true;
    return false;
}

WIDE void bound_literals(const struct csg_tree_cast *tree, const struct csg_spans *spans,
                         bool inner, struct literal *literals)
{
    for (uint32_t i = 0; i < tree->num; i++) {
        const struct csg_node *node = &tree->nodes[i];
        if (node->op == CSG_LEAF)
            bound_literal(&spans[tree->leaves[i]], inner != node->negated,
                          &literals[tree->leaves[i]]);
    }
}

/* Whether anything may show before the keys. */
WIDE bool any_before(const float *near, const float *keys)
{
    unsigned before = 0;
    for (int i = 0; i < CSG_CAST_LANES; i++)
        before |= ((near[i] < CSG_KEY_MAX) & (near[i] <= keys[i])) ? 1 : 0;
    return before != 0;
}

WIDE void take_nearer(const float *far, int num, float *keys)
{
    for (int i = 0; i < CSG_CAST_LANES; i++)
        keys[i] = ((i < num) & (far[i] < keys[i])) ? far[i] : keys[i];
}

bool csg_tree_cast_draw(const struct csg_tree_cast *tree, float dx, float dy, int num, float *keys)
{
    struct csg_spans spans[CSG_TREE_CAST_LEAVES];
    struct literal literals[CSG_TREE_CAST_LEAVES];
    float first[CSG_CAST_LANES];
    for (uint32_t i = 0; i < tree->num; i++)
        if (tree->nodes[i].op == CSG_LEAF)
            csg_cast_spans(&tree->casts[tree->leaves[i]], dx, dy, &spans[tree->leaves[i]]);
    bound_literals(tree, spans, false, literals);
    find_first(tree, literals, first);
    for (int i = num; i < CSG_CAST_LANES; i++)
        first[i] = CSG_KEY_MAX;
    if (!any_before(first, keys))
        return false;
    bound_literals(tree, spans, true, literals);
    if (find_first(tree, literals, first))
        take_nearer(first, num, keys);
    return true;
}
