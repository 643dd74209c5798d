/* SPDX-License-Identifier: MIT */

/*
 * A side of the box of what is left in render() nodes is found by halving boxes: the one that
 * reaches farthest is asked whether anything of its node can be in it; if so it is cut, else it is
 * dropped. The first one to be small enough is the answer.
 */
#include "prepare/framing.h"

#include <math.h>
#include <stdlib.h>

#include "carrier/carrier.h"
#include "carrier/side.h"
#include "common/parallel.h"
#include "csg/wholes.h"

/* Parts of the size of all, along the side's axis and across. */
#define FINE 1024
#define COARSE 128

/* Times that a leaf is compared with a box, for all sides of all nodes. What is over then is framed
 * too widely. */
#define MAX_TESTS 400000

/* Boxes are asked about without this part of them along their faces, where cuts are flush. */
#define SKIN 1e-3

enum { no_operand = 3 }; /* besides enum csg_known: nothing of the node's is in the subtree */

/* A render() node in the tree of a layer. */
struct piece {
    const struct csg_tree *tree;
    const struct csg_whole *whole;
    uint32_t begin, end; /* of the subtree that all of it is in */
    struct csg_box box;
};

struct candidate {
    struct csg_box box;
    uint32_t piece;
};

struct framing {
    const struct csgcast_scene *scene;
    CSG_ARRAY(struct piece) pieces;
    CSG_ARRAY(struct candidate) heap; /* the one that reaches farthest first */
    uint8_t *known;                   /* by node of the subtree that is asked */
    size_t num_tests;
    int axis, sign; /* of the side */
};

struct csg_box csg_written_box(const struct csg_leaf *leaf)
{
    return leaf->is_hole ? csg_box_empty : csg_box_map(&leaf->shape.frame, &leaf->shape.written);
}

/* Runs of nodes that cores look at; smaller trees are through before threads have started. */
enum { NUM_TASKS = 32, MIN_NODES = 20000 };

struct start {
    const struct csgcast_scene *scene;
    const struct csg_tree *tree;
    struct csg_box boxes[NUM_TASKS];
};

static void frame_task(void *user, size_t task)
{
    struct start *start = user;
    const size_t num = start->tree->num;
    start->boxes[task] = csg_box_empty;
    for (size_t i = num * task / NUM_TASKS; i < num * (task + 1) / NUM_TASKS; i++) {
        const struct csg_node *node = &start->tree->data[i];
        if (node->op != CSG_LEAF || node->negated || csg_find_whole(start->scene, node->leaf))
            continue;
        const struct csg_box box = csg_written_box(&start->scene->leaves[node->leaf]);
        if (csg_box_is_finite(&box))
            start->boxes[task] = csg_box_union(&start->boxes[task], &box);
    }
}

void csg_framing_start(struct csgcast_scene *scene)
{
    scene->written = csg_box_empty;
    for (int layer = 0; layer < CSG_NUM_LAYERS; layer++) {
        struct start start = {.scene = scene, .tree = &scene->trees[layer]};
        const bool is_large = start.tree->num >= MIN_NODES;
        csg_parallel(is_large ? scene->num_threads : 1, NUM_TASKS, frame_task, &start);
        for (size_t i = 0; i < NUM_TASKS; i++)
            scene->written = csg_box_union(&scene->written, &start.boxes[i]);
    }
}

/* ---- pieces ------------------------------------------------------------------------------- */

static bool is_in(const struct csg_whole *whole, uint32_t leaf)
{
    return whole->begin <= leaf && leaf < whole->end;
}

/* From the smallest subtree that has the nodes first to last. */
static void narrow(struct piece *piece, uint32_t first, uint32_t last)
{
    const struct csg_node *nodes = piece->tree->data;
    piece->begin = 0;
    piece->end = (uint32_t)piece->tree->num;
    for (uint32_t i = 0; i <= first; i = nodes[i].end > last ? i + 1 : nodes[i].end)
        if (nodes[i].end > last) {
            piece->begin = i;
            piece->end = nodes[i].end;
        }
}

static bool add_piece(struct framing *framing, const struct csg_tree *tree, uint32_t first)
{
    const struct csg_whole *whole = csg_find_whole(framing->scene, tree->data[first].leaf);
    struct piece piece = {.tree = tree, .whole = whole, .box = csg_box_empty};
    uint32_t last = first;
    for (uint32_t i = first; i < tree->num; i++) {
        const struct csg_node *node = &tree->data[i];
        if (node->op != CSG_LEAF || node->spare)
            continue;
        if (!is_in(whole, node->leaf))
            break;
        last = i;
        const struct csg_box box = csg_written_box(&framing->scene->leaves[node->leaf]);
        if (!node->negated && csg_box_is_finite(&box))
            piece.box = csg_box_union(&piece.box, &box);
    }
    narrow(&piece, first, last);
    return whole->negated || csg_box_is_empty(&piece.box) ||
           csg_array_push(&framing->pieces, piece);
}

static bool find_pieces(struct framing *framing, const struct csg_tree *tree)
{
    const struct csg_whole *last = NULL;
    bool done = true;
    for (uint32_t i = 0; i < tree->num && done; i++) {
        const struct csg_node *node = &tree->data[i];
        if (node->op != CSG_LEAF || node->spare)
            continue;
        const struct csg_whole *whole = csg_find_whole(framing->scene, node->leaf);
        if (whole && whole != last)
            done = add_piece(framing, tree, i);
        last = whole;
    }
    return done;
}

/* ---- what is in a box --------------------------------------------------------------------- */

static uint8_t known_of_leaf(struct framing *framing, const struct piece *piece,
                             const struct csg_node *node, const struct csg_box *box)
{
    const struct csgcast_scene *scene = framing->scene;
    if (!is_in(piece->whole, node->leaf))
        return no_operand;
    framing->num_tests++;
    if (node->spare)
        return CSG_NOTHING;
    uint8_t known;
    if (scene->leaves[node->leaf].shape.surface)
        known = csg_side_of_box(&scene->leaves[node->leaf].box, box) == CSG_NOTHING ? CSG_NOTHING
                                                                                    : CSG_VARIES;
    else
        known = csg_side_of_leaf(scene, node->leaf, csg_side_is_box(scene, node->leaf), box);
    if (!node->negated || known == CSG_VARIES)
        return known;
    return known == CSG_NOTHING ? CSG_EVERYTHING : CSG_NOTHING;
}

/* known: by node from piece->begin on, filled behind node. */
static uint8_t known_of_operands(const struct framing *framing, const struct piece *piece,
                                 uint32_t node)
{
    const struct csg_node *nodes = piece->tree->data;
    const uint8_t decides = nodes[node].op == CSG_OR ? CSG_EVERYTHING : CSG_NOTHING;
    uint8_t known = no_operand;
    for (uint32_t i = node + 1; i < nodes[node].end; i = nodes[i].end) {
        const uint8_t operand = framing->known[i - piece->begin];
        if (operand == decides)
            return decides;
        if (operand != no_operand && known != CSG_VARIES)
            known = operand;
    }
    return known;
}

static bool is_empty_in(struct framing *framing, const struct piece *piece,
                        const struct csg_box *box)
{
    for (uint32_t i = piece->end; i-- > piece->begin;) {
        const struct csg_node *node = &piece->tree->data[i];
        framing->known[i - piece->begin] = node->op == CSG_LEAF
                                               ? known_of_leaf(framing, piece, node, box)
                                               : known_of_operands(framing, piece, i);
    }
    return framing->known[0] == CSG_NOTHING;
}

/* ---- the farthest box --------------------------------------------------------------------- */

static double *end_of(struct csg_box *box, int axis, int sign)
{
    struct csg_vec3 *corner = sign > 0 ? &box->hi : &box->lo;
    return axis == 0 ? &corner->x : axis == 1 ? &corner->y : &corner->z;
}

static double reach(const struct framing *framing, const struct csg_box *box)
{
    struct csg_box copy = *box;
    return framing->sign * *end_of(&copy, framing->axis, framing->sign);
}

static bool push(struct framing *framing, struct candidate candidate)
{
    if (!csg_array_push(&framing->heap, candidate))
        return false;
    struct candidate *heap = framing->heap.data;
    for (size_t i = framing->heap.num - 1, up; i > 0; i = up) {
        up = (i - 1) / 2;
        if (reach(framing, &heap[up].box) >= reach(framing, &heap[i].box))
            break;
        const struct candidate other = heap[up];
        heap[up] = heap[i];
        heap[i] = other;
    }
    return true;
}

static struct candidate pop(struct framing *framing)
{
    struct candidate *heap = framing->heap.data;
    const struct candidate top = heap[0], last = heap[--framing->heap.num];
    const size_t num = framing->heap.num;
    size_t i = 0;
    for (size_t down = 1; down < num; down = 2 * i + 1) {
        down +=
            down + 1 < num && reach(framing, &heap[down + 1].box) > reach(framing, &heap[down].box);
        if (reach(framing, &heap[down].box) <= reach(framing, &last.box))
            break;
        heap[i] = heap[down];
        i = down;
    }
    heap[i] = last;
    return top;
}

/* The axis to cut along: where the box is longest, for its fineness; -1: it is small enough. */
static int axis_to_cut(const struct framing *framing, struct csg_box *box, const double size[3])
{
    double most = 1;
    int axis = -1;
    for (int i = 0; i < 3; i++) {
        const double length = *end_of(box, i, 1) - *end_of(box, i, -1);
        const double parts = length / size[i] * (i == framing->axis ? FINE : COARSE);
        if (parts > most) {
            most = parts;
            axis = i;
        }
    }
    return axis;
}

static bool cut(struct framing *framing, struct candidate candidate, int axis)
{
    struct candidate low = candidate, high = candidate;
    const double middle =
        0.5 * (*end_of(&candidate.box, axis, -1) + *end_of(&candidate.box, axis, 1));
    *end_of(&low.box, axis, 1) = *end_of(&high.box, axis, -1) = middle;
    return push(framing, low) && push(framing, high);
}

static struct csg_box without_skin(const struct csg_box *box)
{
    const struct csg_vec3 skin = csg_scale(SKIN, csg_sub(box->hi, box->lo));
    return (struct csg_box){csg_add(box->lo, skin), csg_sub(box->hi, skin)};
}

/* How far along the side's axis anything is; what reaches no farther than so_far does not
 * matter. */
static bool find_side(struct framing *framing, const double size[3], double so_far, double *side)
{
    bool done = true;
    *side = so_far;
    framing->heap.num = 0;
    for (uint32_t i = 0; i < framing->pieces.num && done; i++)
        done = push(framing, (struct candidate){framing->pieces.data[i].box, i});
    while (done && framing->heap.num > 0) {
        struct candidate top = pop(framing);
        const struct csg_box inner = without_skin(&top.box);
        if (reach(framing, &top.box) <= so_far)
            break;
        if (is_empty_in(framing, &framing->pieces.data[top.piece], &inner))
            continue;
        const int axis = axis_to_cut(framing, &top.box, size);
        if (axis < 0 || framing->num_tests > MAX_TESTS) {
            *side = reach(framing, &top.box);
            break;
        }
        done = cut(framing, top, axis);
    }
    return done;
}

static struct csg_box box_of_all(const struct csgcast_scene *scene, const struct framing *framing)
{
    struct csg_box all = scene->written;
    for (size_t i = 0; i < framing->pieces.num; i++)
        all = csg_box_union(&all, &framing->pieces.data[i].box);
    return all;
}

/* One round over all sides, from the boxes of the pieces. */
static bool find_box(struct framing *framing, const struct csg_box *around, struct csg_box *found)
{
    struct csg_box outer = *around, floor = framing->scene->written;
    double size[3];
    bool done = true;
    for (int i = 0; i < 3; i++)
        size[i] = fmax(*end_of(&outer, i, 1) - *end_of(&outer, i, -1), 1e-300);
    for (int i = 0; i < 6 && done; i++) {
        double side;
        framing->axis = i / 2;
        framing->sign = i % 2 ? 1 : -1;
        done = find_side(framing, size, reach(framing, &floor), &side);
        *end_of(found, framing->axis, framing->sign) = framing->sign * side;
    }
    return done;
}

static void clip_pieces(struct framing *framing, const struct csg_box *to)
{
    for (size_t i = 0; i < framing->pieces.num; i++) {
        struct piece *piece = &framing->pieces.data[i];
        piece->box = csg_box_intersection(&piece->box, to);
        if (csg_box_is_empty(&piece->box))
            framing->pieces.data[i--] = framing->pieces.data[--framing->pieces.num];
    }
}

/* Once more where what is left is much smaller than the solids that it was cut out of. */
static bool frame_pieces(struct csgcast_scene *scene, struct framing *framing)
{
    struct csg_box all = box_of_all(scene, framing), found = all;
    enum { max_rounds = 4 };
    bool done = true;
    for (int i = 0; i < max_rounds && done && framing->pieces.num > 0; i++) {
        const double before = csg_length(csg_sub(all.hi, all.lo));
        framing->num_tests = 0;
        done = find_box(framing, &all, &found);
        all = found;
        if (csg_box_is_empty(&all) || csg_length(csg_sub(all.hi, all.lo)) > 0.5 * before)
            break;
        clip_pieces(framing, &all);
    }
    scene->written = all;
    return done;
}

static bool frame_wholes(struct csgcast_scene *scene, struct framing *framing)
{
    size_t most = 0;
    for (int layer = 0; layer < CSG_NUM_LAYERS; layer++) {
        if (!find_pieces(framing, &scene->trees[layer]))
            return false;
        most = scene->trees[layer].num > most ? scene->trees[layer].num : most;
    }
    framing->known = malloc(most + 1);
    return framing->known && frame_pieces(scene, framing);
}

bool csg_framing_finish(struct csgcast_scene *scene)
{
    struct framing framing = {.scene = scene};
    const bool done = scene->wholes.num == 0 || frame_wholes(scene, &framing);
    free(framing.pieces.data);
    free(framing.heap.data);
    free(framing.known);
    return done;
}
