/* SPDX-License-Identifier: MIT */
#include "cells/build.h"

#include <stdlib.h>

#include "carrier/side.h"
#include "cells/balls.h"
#include "cells/cells.h"

/* Of cuts: rays take a step for some of them each time they begin at the root anew. */
#define MAX_DEPTH 32

/* Literals of a cell that are never worth a cut. */
#define SMALL_CELL 4
#define SMALL_BUNCHED 5

/* Of fewer literals balls are not compared, nor where a cut spared a good part of them: balls that
 * do not overlap are soon told apart. */
#define MANY_LITERALS 64
#define OVERLAPPING_SHARE 0.7

static uint8_t side_of(const struct csg_cell_builder *builder, uint32_t leaf,
                       const struct csg_box *around)
{
    return csg_cell_leaf_side(builder->scene, builder->leaves, leaf, around);
}

/* What is left of an intersection of literals, as csg_tree_simplify_to has it. */
static bool fold_chain(struct csg_cell_builder *builder, const struct csg_box *around,
                       const struct csg_tree *tree)
{
    struct csg_tree *left = &builder->room.tree;
    left->num = 0;
    if (!csg_array_reserve(left, tree->num))
        return false;
    left->data[left->num++] = tree->data[0];
    for (size_t i = 1; i < tree->num; i++) {
        const struct csg_node *node = &tree->data[i];
        const uint8_t side = side_of(builder, node->leaf, around);
        if (side == CSG_VARIES)
            left->data[left->num++] = *node;
        else if ((side == CSG_NOTHING) != node->negated) {
            left->num = 0;
            return true;
        }
    }
    left->data[0].end = (uint32_t)left->num;
    if (left->num > MANY_LITERALS && (double)left->num > OVERLAPPING_SHARE * (double)tree->num)
        csg_balls_drop(builder->leaves, left, around, builder->margin);
    return true;
}

/* What is left of the tree in the box: the room's tree. */
static bool fold(struct csg_cell_builder *builder, const struct csg_box *box,
                 const struct csg_tree *tree)
{
    const struct csg_box around = csg_box_grown(box, builder->margin);
    if (builder->bunched && tree->num && tree->data[0].op == CSG_AND)
        return fold_chain(builder, &around, tree);
    for (size_t i = 0; i < tree->num; i++)
        if (tree->data[i].op == CSG_LEAF)
            builder->known[tree->data[i].leaf] = side_of(builder, tree->data[i].leaf, &around);
    return csg_tree_simplify_to(&builder->room, tree, builder->known);
}

static bool put_record(struct csg_cell_builder *builder, uint32_t faces, uint32_t flags,
                       uint32_t place, uint32_t leaf)
{
    if (!csg_array_reserve(&builder->records, 4))
        return false;
    float *record = builder->records.data + builder->records.num;
    record[0] = (float)(faces & 0xffffff);
    record[1] = (float)(flags + (faces >> 24) * CSG_CELL_FLAGS);
    record[2] = (float)place;
    record[3] = (float)leaf;
    builder->records.num += 4;
    return true;
}

/* The faces of a literal that pass through the cell, four a texel. */
static bool put_literal(struct csg_cell_builder *builder, const struct csg_step *step,
                        const struct csg_box *around)
{
    const struct csg_carriers *carriers = builder->scene->carriers;
    const uint32_t begin = carriers->face_begin[step->leaf];
    const uint32_t num = carriers->face_begin[step->leaf + 1] - begin;
    const uint32_t place = builder->places[step->leaf];
    uint32_t faces = 0, used = 0, flags = step->flags;
    if (flags & CSG_RECORD_QUADRIC &&
        !csg_cell_leaf_quadric_varies(builder->scene, builder->leaves, step->leaf, around))
        flags &= ~(uint32_t)(CSG_RECORD_QUADRIC | CSG_RECORD_GAP);
    for (uint32_t i = 0; i < num; i++) {
        if (!csg_side_plane_varies(builder->scene, carriers->faces[begin + i], around))
            continue;
        if (used == CSG_CELL_FACES) {
            if (!put_record(builder, faces, flags | CSG_RECORD_MORE, place, step->leaf))
                return false;
            faces = used = 0;
        }
        faces |= (i + 1) << (CSG_CELL_FACE_BITS * used++);
    }
    return put_record(builder, faces, flags, place, step->leaf);
}

static bool put_cell(struct csg_cell_builder *builder, const struct csg_work *work,
                     const struct csg_tree *tree)
{
    const struct csg_box around = csg_box_grown(&work->box, builder->margin);
    struct csg_branch *branch = &builder->branches.data[work->branch];
    branch->kind = CSG_BRANCH_CELL;
    if (builder->bunched) {
        branch->first = (uint32_t)(builder->bunches.texels.num / 4);
        const bool ok = csg_bunches_add(&builder->bunches, tree, &around);
        branch->end = (uint32_t)(builder->bunches.texels.num / 4);
        return ok;
    }
    branch->first = (uint32_t)(builder->records.num / 4);
    builder->program.num = 0;
    if (tree->num &&
        !csg_program_append(&builder->program_room, &builder->program, builder->scene, tree, 0))
        return false;
    for (size_t i = 0; i < builder->program.num; i++) {
        const struct csg_step *step = &builder->program.data[i];
        builder->nested |= (step->flags & CSG_RECORD_POP) != 0;
        const bool ok = step->flags & CSG_RECORD_POP ? put_record(builder, 0, step->flags, 0, 0)
                                                     : put_literal(builder, step, &around);
        if (!ok)
            return false;
    }
    branch->end = (uint32_t)(builder->records.num / 4);
    return true;
}

static bool costs_more(const struct csg_work *a, const struct csg_work *b)
{
    return a->cost > b->cost || (a->cost == b->cost && a->branch < b->branch);
}

static void swap(struct csg_work *a, struct csg_work *b)
{
    const struct csg_work other = *a;
    *a = *b;
    *b = other;
}

static bool push_work(struct csg_cell_builder *builder, const struct csg_work *work)
{
    if (!csg_array_push(&builder->work, *work))
        return false;
    struct csg_work *heap = builder->work.data;
    for (size_t i = builder->work.num - 1; i > 0 && costs_more(&heap[i], &heap[(i - 1) / 2]);
         i = (i - 1) / 2)
        swap(&heap[i], &heap[(i - 1) / 2]);
    return true;
}

static struct csg_work pop_work(struct csg_cell_builder *builder)
{
    struct csg_work *heap = builder->work.data;
    const struct csg_work top = heap[0];
    const size_t num = --builder->work.num;
    heap[0] = heap[num];
    for (size_t i = 0, child; (child = 2 * i + 1) < num; i = child) {
        child += child + 1 < num && costs_more(&heap[child + 1], &heap[child]);
        if (!costs_more(&heap[child], &heap[i]))
            break;
        swap(&heap[child], &heap[i]);
    }
    return top;
}

/* What is left of the tree in the work's box waits to be cut, or it is a cell at once. */
static bool add_work(struct csg_cell_builder *builder, struct csg_work work,
                     const struct csg_tree *tree)
{
    const struct csg_tree *left = &builder->room.tree;
    if (!fold(builder, &work.box, tree))
        return false;
    const size_t num = csg_tree_count_leaves(left);
    work.cost = (double)num * csg_box_half_area(&work.box);
    if (num <= (builder->bunched ? SMALL_BUNCHED : SMALL_CELL) || work.depth >= MAX_DEPTH)
        return put_cell(builder, &work, left);
    if (csg_tree_copy(left, &work.tree) && push_work(builder, &work))
        return true;
    free(work.tree.data);
    return false;
}

static bool cut(struct csg_cell_builder *builder, const struct csg_work *work,
                const struct csg_split *split)
{
    const uint32_t first = (uint32_t)builder->branches.num;
    const struct csg_branch open = {.kind = CSG_BRANCH_OPEN};
    struct csg_work lower = {
        .box = csg_split_box(&work->box, split, false), .branch = first, .depth = work->depth + 1};
    struct csg_work upper = lower;
    upper.box = csg_split_box(&work->box, split, true);
    upper.branch = first + 1;
    if (!csg_array_push(&builder->branches, open) || !csg_array_push(&builder->branches, open))
        return false;
    builder->branches.data[work->branch] =
        (struct csg_branch){(uint8_t)split->axis, split->at, first, 0};
    return add_work(builder, lower, &work->tree) && add_work(builder, upper, &work->tree);
}

static bool run(struct csg_cell_builder *builder, const struct csg_work *work)
{
    struct csg_split split;
    if (csg_split_find(&builder->splitter, &work->box, &work->tree, &split))
        return cut(builder, work, &split);
    return put_cell(builder, work, &work->tree);
}

void csg_cell_builder_start(struct csg_cell_builder *builder, const struct csg_box *box,
                            const struct csg_tree *tree, uint32_t depth)
{
    const struct csg_work work = {.box = *box, .depth = depth};
    const struct csg_branch open = {.kind = CSG_BRANCH_OPEN};
    builder->known = malloc(builder->scene->num_leaves + 1);
    builder->bunches.scene = builder->scene;
    builder->bunches.places = builder->places;
    builder->bunches.leaves = builder->leaves;
    builder->splitter.leaves = builder->leaves;
    builder->splitter.margin = builder->margin;
    builder->failed = !builder->known || !csg_array_push(&builder->branches, open) ||
                      !add_work(builder, work, tree);
}

void csg_cell_builder_cut(struct csg_cell_builder *builder, size_t num)
{
    while (!builder->failed && builder->work.num && builder->work.num < num &&
           builder->branches.num < builder->max_branches) {
        struct csg_work work = pop_work(builder);
        builder->failed = !run(builder, &work);
        free(work.tree.data);
    }
}

void csg_cell_builder_close(struct csg_cell_builder *builder)
{
    for (size_t i = 0; i < builder->work.num && !builder->failed; i++)
        builder->failed = !put_cell(builder, &builder->work.data[i], &builder->work.data[i].tree);
}

void csg_cell_builder_finish(struct csg_cell_builder *builder)
{
    for (size_t i = 0; i < builder->work.num; i++)
        free(builder->work.data[i].tree.data);
    free(builder->work.data);
    free(builder->branches.data);
    free(builder->records.data);
    free(builder->bunches.literals.data);
    free(builder->bunches.texels.data);
    free(builder->splitter.inside.data);
    free(builder->program.data);
    csg_program_room_finish(&builder->program_room);
    csg_tree_room_finish(&builder->room);
    free(builder->known);
}
