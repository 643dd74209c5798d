/* SPDX-License-Identifier: MIT */

/*
 * Large scenes are read in shares, runs of nodes, side by side: what a solid becomes depends on its
 * own text and that of the nodes around it alone. Messages have an order, and compounds share what
 * the first of them opens: where there is any of either, everything is read by one thread.
 */

#include <stdlib.h>
#include <string.h>

#include "common/parallel.h"
#include "nodes/build.h"

/* Fewer nodes are read sooner than threads start. */
enum { MIN_NODES = 20000, NUM_SHARES = 16 };

struct share {
    struct csg_builder builder; /* with a report and a scene of its own */
    struct csg_report report;
    struct csgcast_scene scene; /* its leaves are those of all shares, of which it fills some */
    uint32_t begin, end;        /* nodes */
    size_t first_leaf;
    bool ok;
};

static void read_share(void *user, size_t task)
{
    struct share *share = (struct share *)user + task;
    share->ok = csg_build_leaves_in(&share->builder, share->begin, share->end);
    for (int level = 0; level <= CSGCAST_LOG_INFO; level++)
        share->ok &= share->report.num[level] == 0;
}

/* As many leaves as there can be. */
static size_t count_solids(const struct csg_builder *builder, uint32_t begin, uint32_t end)
{
    size_t num = 0;
    for (uint32_t i = begin; i < end; i++)
        num += builder->meanings[i].role == CSG_ROLE_SOLID;
    return num;
}

/* Its leaves begin behind those of the shares before it. Returns where the next one's do. */
static size_t start_share(struct share *share, const struct csg_builder *builder, uint32_t i,
                          size_t first_leaf)
{
    const uint64_t num = builder->end - builder->begin;
    share->builder = *builder;
    share->builder.report = &share->report;
    share->builder.scene = &share->scene;
    share->begin = builder->begin + (uint32_t)(num * i / NUM_SHARES);
    share->end = builder->begin + (uint32_t)(num * (i + 1) / NUM_SHARES);
    share->first_leaf = first_leaf;
    share->scene.leaves = builder->scene->leaves;
    share->scene.num_leaves = first_leaf;
    share->scene.leaves_capacity = first_leaf + count_solids(builder, share->begin, share->end);
    csg_report_init(&share->report, &csg_log_silent, builder->report->file);
    return share->scene.leaves_capacity;
}

/* Where there were empty solids, leaves move on to those of the share before. */
static void append_share(struct csgcast_scene *scene, struct share *share)
{
    const size_t num = share->scene.num_leaves - share->first_leaf;
    const uint32_t gap = (uint32_t)(share->first_leaf - scene->num_leaves);
    if (gap) {
        memmove(scene->leaves + scene->num_leaves, scene->leaves + share->first_leaf,
                num * sizeof *scene->leaves);
        csg_build_renumber(&share->builder, share->begin, share->end, gap);
    }
    scene->num_leaves += num;
    scene->info.num_dropped += share->scene.info.num_dropped;
}

static void drop_leaves(struct share *share)
{
    for (size_t i = share->first_leaf; i < share->scene.num_leaves; i++)
        csg_shape_finish(&share->scene.leaves[i].shape);
}

static bool is_for_shares(const struct csg_builder *builder)
{
    bool is_simple = !builder->origins && builder->scene->num_leaves == 0 &&
                     builder->end - builder->begin >= MIN_NODES;
    for (uint32_t i = builder->begin; i < builder->end && is_simple; i++)
        is_simple = !csg_is_compound(&builder->meanings[i]);
    return is_simple;
}

/* false: there was something to say, or memory is out, and nothing has happened yet. */
static bool read_shares(struct csg_builder *builder, struct share *shares)
{
    struct csgcast_scene *scene = builder->scene;
    bool ok = true;
    size_t next = 0;
    const size_t room = count_solids(builder, builder->begin, builder->end);
    scene->leaves = malloc((room + 1) * sizeof *scene->leaves);
    if (!scene->leaves)
        return false;
    scene->leaves_capacity = room + 1;
    for (uint32_t i = 0; i < NUM_SHARES; i++)
        next = start_share(&shares[i], builder, i, next);
    csg_parallel(builder->num_threads, NUM_SHARES, read_share, shares);
    for (size_t i = 0; i < NUM_SHARES; i++)
        ok &= shares[i].ok;
    for (size_t i = 0; i < NUM_SHARES; i++)
        if (ok)
            append_share(scene, &shares[i]);
        else
            drop_leaves(&shares[i]);
    return ok;
}

bool csg_build_leaves(struct csg_builder *builder)
{
    struct share *shares = is_for_shares(builder) ? calloc(NUM_SHARES, sizeof *shares) : NULL;
    const bool is_read = shares && read_shares(builder, shares);
    free(shares);
    return is_read || csg_build_leaves_in(builder, builder->begin, builder->end);
}
