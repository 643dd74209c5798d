/* SPDX-License-Identifier: MIT */
#include "sharpness/recall.h"

#include <stdlib.h>
#include <string.h>

#include "sharpness/surveyor.h"

/* Planes of a block. Smaller ones have more of what is compared asked twice where one is stale. */
#define BLOCK 128

bool csg_recall_add_leaf(struct csg_recall *recall, const struct csgcast_scene *scene,
                         uint32_t leaf, uint8_t *marks)
{
    const struct csg_recall_leaf now = {leaf, scene->leaves[leaf].box};
    const size_t i = recall->num_leaves++;
    if (i >= recall->leaves.num) {
        marks[leaf] |= CSG_RECALL_MOVED;
        return csg_array_push(&recall->leaves, now);
    }
    struct csg_recall_leaf *before = &recall->leaves.data[i];
    if (before->leaf != leaf || memcmp(&before->box, &now.box, sizeof now.box) != 0)
        marks[leaf] |= CSG_RECALL_MOVED;
    *before = now;
    return true;
}

/* Their places follow from their normals. */
static bool is_same_flat(const struct csg_flat *a, const struct csg_flat *b)
{
    return a->normal.x == b->normal.x && a->normal.y == b->normal.y && a->normal.z == b->normal.z &&
           a->height == b->height && a->carrier == b->carrier && a->leaf == b->leaf &&
           a->turned == b->turned;
}

static bool is_same_ball(const struct csg_ball *a, const struct csg_ball *b)
{
    return memcmp(a, b, sizeof *a) == 0;
}

static bool start_anew(struct csg_recall *recall, const struct csg_flats *flats)
{
    const size_t num = flats->all.num;
    recall->flats.num = recall->blocks.num = 0;
    if (!csg_array_reserve(&recall->flats, num) ||
        !csg_array_reserve(&recall->blocks, num / BLOCK + 1))
        return false;
    for (size_t i = 0; i < num; i++)
        recall->flats.data[recall->flats.num++] = flats->sorted.data[i];
    while (recall->blocks.num * BLOCK < num)
        recall->blocks.data[recall->blocks.num++].stale = true;
    return true;
}

/* Planes are compared with those behind them. */
static void find_stale(struct csg_recall *recall, const struct csg_flats *flats,
                       const uint8_t *marks)
{
    for (size_t i = 0; i < recall->flats.num; i++) {
        const struct csg_flat *now = &flats->sorted.data[i];
        if (!(marks[now->leaf] & CSG_RECALL_MOVED) && is_same_flat(now, &recall->flats.data[i]))
            continue;
        const size_t first = i < CSG_FINE_NEIGHBOURS ? 0 : i - CSG_FINE_NEIGHBOURS;
        for (size_t block = first / BLOCK; block <= i / BLOCK; block++)
            recall->blocks.data[block].stale = true;
        recall->flats.data[i] = *now;
    }
}

bool csg_recall_compare(struct csg_recall *recall, const struct csg_flats *flats,
                        const uint8_t *marks, const struct csg_ball *ball)
{
    const bool holds =
        recall->holds && recall->flats.num == flats->all.num && is_same_ball(&recall->ball, ball);
    recall->leaves.num = recall->num_leaves;
    recall->ball = *ball;
    if (!holds)
        return start_anew(recall, flats);
    find_stale(recall, flats, marks);
    return true;
}

size_t csg_recall_count_stale(const struct csg_recall *recall)
{
    size_t num = 0;
    for (size_t i = 0; i < recall->blocks.num; i++)
        num += recall->blocks.data[i].stale;
    return num;
}

void csg_recall_renew(struct csg_recall *recall, const struct csg_flats *flats,
                      const struct csgcast_scene *scene, size_t begin, size_t end)
{
    for (size_t i = begin; i < end; i++) {
        struct csg_recall_block *block = &recall->blocks.data[i];
        const size_t last = (i + 1) * BLOCK;
        if (!block->stale)
            continue;
        *block = (struct csg_recall_block){.sharp = csg_sharpness_blunt};
        csg_flats_note(flats, scene, i * BLOCK, last < flats->all.num ? last : flats->all.num,
                       &recall->ball, &block->sharp);
    }
}

void csg_recall_finish(struct csg_recall *recall)
{
    free(recall->flats.data);
    free(recall->leaves.data);
    free(recall->blocks.data);
}
