/* SPDX-License-Identifier: MIT */

/*
 * Large scenes are read in shares, runs of nodes, side by side: what a solid becomes depends on its
 * own text and that of the nodes around it alone. Messages have an order, and compounds share what
 * the first of them opens: where there is any of either, everything is read by one thread.
 */

#include <stdlib.h>
#include <string.h>

#include "common/parallel.h"
#include "scene/build.h"

/* Fewer nodes are read sooner than threads start. */
enum { MIN_NODES = 20000, NUM_SHARES = 16 };

struct share {
    struct csg_builder builder; /* with a report and a scene of its own */
    struct csg_report report;
    struct csgcast_scene scene;
    uint32_t begin, end; /* nodes */
    bool ok;
};

static void read_share(void *user, size_t task)
{
    struct share *share = (struct share *)user + task;
    share->ok = csg_build_leaves_in(&share->builder, share->begin, share->end);
    for (int level = 0; level <= CSGCAST_LOG_INFO; level++)
        share->ok &= share->report.num[level] == 0;
}

static void start_share(struct share *share, const struct csg_builder *builder, uint32_t i)
{
    const uint64_t num = builder->end - builder->begin;
    share->builder = *builder;
    share->builder.report = &share->report;
    share->builder.scene = &share->scene;
    share->begin = builder->begin + (uint32_t)(num * i / NUM_SHARES);
    share->end = builder->begin + (uint32_t)(num * (i + 1) / NUM_SHARES);
    csg_report_init(&share->report, &csg_log_silent, builder->report->file);
}

static void finish_share(struct share *share)
{
    for (size_t i = 0; i < share->scene.num_leaves; i++)
        csg_shape_finish(&share->scene.leaves[i].shape);
    free(share->scene.leaves);
}

/* The share's leaves come behind those that the scene has. */
static bool append_share(struct csgcast_scene *scene, struct share *share)
{
    struct csgcast_scene *from = &share->scene;
    const uint32_t base = (uint32_t)scene->num_leaves;
    if (scene->leaves_capacity - scene->num_leaves < from->num_leaves &&
        !csg_array_grow((void **)&scene->leaves, &scene->leaves_capacity, scene->num_leaves,
                        from->num_leaves, sizeof *scene->leaves))
        return false;
    if (from->num_leaves)
        memcpy(scene->leaves + base, from->leaves, from->num_leaves * sizeof *from->leaves);
    scene->num_leaves += from->num_leaves;
    scene->info.num_dropped += from->info.num_dropped;
    from->num_leaves = 0; /* the scene has them now */
    csg_build_renumber(&share->builder, share->begin, share->end, base);
    return true;
}

static bool is_for_shares(const struct csg_builder *builder)
{
    bool is_simple = !builder->origins && builder->end - builder->begin >= MIN_NODES;
    for (uint32_t i = builder->begin; i < builder->end && is_simple; i++)
        is_simple = !csg_is_compound(&builder->meanings[i]);
    return is_simple;
}

/* false: there was something to say, and nothing has happened yet. */
static bool read_shares(struct csg_builder *builder, struct share *shares)
{
    bool ok = true;
    for (uint32_t i = 0; i < NUM_SHARES; i++)
        start_share(&shares[i], builder, i);
    csg_parallel(builder->num_threads, NUM_SHARES, read_share, shares);
    for (size_t i = 0; i < NUM_SHARES; i++)
        ok &= shares[i].ok;
    return ok;
}

bool csg_build_leaves(struct csg_builder *builder)
{
    struct share *shares =
        is_for_shares(builder) ? calloc(NUM_SHARES, sizeof *shares) : NULL;
    const bool is_read = shares && read_shares(builder, shares);
    bool ok = true;
    for (size_t i = 0; i < NUM_SHARES && shares; i++) {
        ok = ok && (!is_read || append_share(builder->scene, &shares[i]));
        finish_share(&shares[i]);
    }
    free(shares);
    if (!ok)
        return csg_log_memory(&builder->report->log);
    return is_read || csg_build_leaves_in(builder, builder->begin, builder->end);
}
