/* SPDX-License-Identifier: MIT */
#include "tile/tile.h"

#include <limits.h>
#include <stdlib.h>

#include "pack/record.h"
#include "pack/surface_record.h"
#include "tile/chain.h"
#include "tile/clauses.h"
#include "tile/tiler.h"

/* A tile whose part of the tree is this small is not worth cutting further. */
#define SMALL_LEAVES 2

/* Nor is one of twice the smallest size with so few leaves under one intersection, which a chain
 * draws (CSG_RESOLVER_CHAIN): to make four of it costs more than they spare. */
#define FEW_LEAVES 3

/* Tiles with surfaces of triangles have lists of their own in smaller cells, but nothing is drawn
 * where a tile is empty. In pixels. */
#define SURFACE_TILE_SIZE 64

/* Solids of many planes are cut into tiles, however few they are: few planes can be entry or exit
 * in a tile. All of them are asked for each tile, so these are no smaller than pays (measured). */
#define MANY_PLANES 64
#define VERY_MANY_PLANES 1024
#define PLANES_TILE_SIZE 32

/* A tile that may meet so few bands of stacks is not worth cutting for them. */
#define SMALL_BANDS 4

/* A larger area with more nodes, all of its leaves under one intersection, is first cut by the
 * leaves' rectangles on the screen: ranges tell little of so large a tile. In pixels. That ends
 * where a quarter of the area keeps more than this share of the leaves. */
#define COARSE_SIZE 32
#define COARSE_NODES 12
#define COARSE_SHARE 0.65

/* Tiles of the smallest size are cut once more where they have more leaves than a chain, up to so
 * many. */
#define CROWDED_LEAVES 16

/* Tiles of half the smallest size that have too many planes for a chain, as corners of solids have,
 * are cut to the pixel where programs are to be few, so many times in an area: if all the others
 * are chains, the picture needs one program, and a second takes longer to load than these tiles. */
#define MAX_CORNER_CUTS 64

/* Where so many leaves are left and a quarter of the area spares less than this share of them, the
 * tile is drawn as it is. */
#define STUBBORN_LEAVES 256
#define STUBBORN_SHARE 0.9

/* Tiles that are not larger need not be cut for the planes in them; stacks have none. */
static int planes_tile_size(const struct csgcast_scene *scene, const struct csg_tree *tree)
{
    size_t num = 0;
    for (size_t i = 0; i < tree->num && num < VERY_MANY_PLANES; i++)
        if (tree->data[i].op == CSG_LEAF && tree->data[i].leaf < scene->num_leaves)
            num += scene->leaves[tree->data[i].leaf].shape.num_planes;
    if (num < MANY_PLANES)
        return INT_MAX;
    return num < VERY_MANY_PLANES ? PLANES_TILE_SIZE : PLANES_TILE_SIZE / 2;
}

/* Whether tiles without a stiff quadric of their own take programs that know none: where a program
 * more is worth it. */
static bool may_tell_stiff(const struct csg_tiler *tiler)
{
    return !tiler->terms->params->few_programs && !tiler->draw->precise;
}

static bool is_stiff(const struct csg_tiler *tiler, uint32_t leaf)
{
    const int code = csg_tiler_ranges(tiler, leaf)->code;
    return code >= 0 && code & CSG_QUADRIC_STIFF;
}

static bool add_record(struct csg_tiler *tiler, size_t i, const struct csg_tile_task *task,
                       struct csg_draw *draw)
{
    const struct csg_tile_box *box = csg_tiler_box(tiler);
    const struct csg_step *step = &tiler->scan.program.data[i];
    if (step->flags & CSG_RECORD_BOUND)
        return csg_record_add_bound(tiler->terms, tiler->scan.bounds.data[i]);
    if (step->flags & CSG_RECORD_POP)
        return csg_record_add(tiler->terms, step, NULL);
    if (step->flags & CSG_RECORD_BANDS)
        return csg_band_list_put(&task->bands, tiler->terms, step, box);
    if (step->flags & CSG_RECORD_SURFACE)
        return csg_surface_add_record(tiler->terms, step, task->lo, task->hi);
    const struct csg_leaf_terms *leaf = csg_terms_of(tiler->terms, step->leaf);
    const struct csg_leaf_range *range = csg_tiler_range(tiler, step->leaf);
    tiler->planes.num = 0;
    if (!csg_array_reserve(&tiler->planes, leaf->num_entries + leaf->num_exits + 1))
        return false;
    csg_range_filter_planes(tiler->terms, leaf, range, box, tiler->planes.data);
    const struct csg_record_filter filter = {
        tiler->planes.data,
        csg_range_has_quadric(csg_tiler_ranges(tiler, step->leaf), tiler->parts.at, range)};
    draw->stiff |= filter.quadric && is_stiff(tiler, step->leaf);
    return csg_record_add(tiler->terms, step, &filter);
}

static bool is_surface_alone(const struct csg_tiler *tiler)
{
    const struct csg_step *step = tiler->scan.program.data;
    return tiler->scan.program.num == 1 && step->flags & CSG_RECORD_SURFACE &&
           !(step->flags & (CSG_RECORD_NEGATED | CSG_RECORD_BANDS)) &&
           csg_terms_view(tiler->terms, step->leaf)->turns == 0;
}

/* Appends the tile's records, and notes what draws have to know of them. */
static bool put_records(struct csg_tiler *tiler, const struct csg_tile_task *task,
                        struct csg_draw *draw)
{
    struct csg_chain_finder chain = {.faceted = !tiler->terms->params->few_programs};
    const struct csg_frame *frame = tiler->terms->frame;
    if (!csg_scan_fill(&tiler->scan, tiler->terms, &task->tree, tiler->ranges.data,
                       !draw->around_eye))
        return false;
    if (!task->flat && task->tree.num > 1)
        csg_clauses_mark(&tiler->scan.program, &task->tree);
    draw->instance.records[0] = (int32_t)(frame->texels.num / 4);
    draw->stiff &= !may_tell_stiff(tiler);
    for (size_t i = 0; i < tiler->scan.program.num; i++) {
        const struct csg_step *step = &tiler->scan.program.data[i];
        const uint32_t flags = step->flags;
        const size_t at = frame->texels.num;
        draw->bands |= (flags & CSG_RECORD_BANDS) != 0;
        draw->surface |= (flags & (CSG_RECORD_SURFACE | CSG_RECORD_BANDS)) == CSG_RECORD_SURFACE;
        if (!add_record(tiler, i, task, draw))
            return false;
        csg_chain_add(&chain, step, frame->texels.data + at);
    }
    draw->stiff |= draw->bands && tiler->terms->stiff; /* their records all have one form */
    draw->chain = csg_chain_end(&chain);
    draw->surface_alone = is_surface_alone(tiler);
    draw->instance.records[1] = (int32_t)(frame->texels.num / 4);
    return true;
}

/* Draws the tile by its records. */
static bool add_draw(struct csg_tiler *tiler, const struct csg_tile_task *task, size_t num_leaves,
                     struct csg_draw *draw)
{
    struct csg_frame *frame = tiler->terms->frame;
    const struct csg_rect rect = csg_tile_rect(task);
    const size_t before = frame->solid_tests;
    csg_draw_set_rect(draw, &frame->screen, &rect);
    csg_frame_count(frame, &rect, num_leaves + task->bands.num);
    if (tiler->budget)
        atomic_fetch_add(&tiler->budget->spent, frame->solid_tests - before);
    *(tiler->opaque ? &frame->tiles_opaque : &frame->tiles_mixed) += 1;
    return draw->instance.records[0] == draw->instance.records[1] ||
           csg_array_push(&frame->draws, *draw);
}

static bool is_within(const struct csg_tile_task *task, int size)
{
    return task->hi[0] - task->lo[0] <= size && task->hi[1] - task->lo[1] <= size;
}

/* Whether chains may draw the object's tiles: they take a tenth of what the loop takes for a pixel,
 * so tiles that have too much for them are cut once more. */
static bool may_chain(const struct csg_tiler *tiler)
{
    const struct csg_draw *draw = tiler->draw;
    return !tiler->fine && !tiler->terms->params->tile_size && !draw->around_eye &&
           !draw->precise && (!draw->stiff || may_tell_stiff(tiler));
}

/* Whether one of the leaves has a stiff quadric, which is for the loop. */
static bool has_stiff(const struct csg_tiler *tiler, const struct csg_tree *tree)
{
    const struct csgcast_scene *scene = tiler->terms->scene;
    for (size_t i = 0; i < tree->num && tiler->draw->stiff; i++) {
        const uint32_t leaf = tree->data[i].leaf;
        if (tree->data[i].op == CSG_LEAF && leaf < scene->num_leaves &&
            !scene->leaves[leaf].shape.surface && is_stiff(tiler, leaf))
            return true;
    }
    return false;
}

/* Whether the tree is an intersection of literals, some of them products: the loop needs one look
 * at each of these, so that smaller tiles do not repay their making. */
static bool has_products(const struct csg_tiler *tiler, const struct csg_tree *tree)
{
    bool found = false;
    for (uint32_t i = 1; i < tree->num; i = tree->data[i].end) {
        const bool product = csg_node_is_product(tiler->terms->scene, tree, i);
        if (!product && tree->data[i].op != CSG_LEAF)
            return false;
        found |= product;
    }
    return found && tree->data[0].op == CSG_AND;
}

static bool is_crowded(const struct csg_tiler *tiler, const struct csg_tile_task *task,
                       size_t num_leaves)
{
    return may_chain(tiler) && num_leaves > CSG_CHAIN_LITERALS && num_leaves <= CROWDED_LEAVES &&
           !has_stiff(tiler, &task->tree) && !has_products(tiler, &task->tree);
}

/* As small as tiles are cut for other reasons than planes. */
static bool is_small(const struct csg_tile_task *task)
{
    return is_within(task, CSG_TILE_SIZE / 2);
}

static bool may_cut_corner(const struct csg_tiler *tiler, const struct csg_tile_task *task)
{
    return tiler->terms->params->few_programs && tiler->num_corner_cuts < MAX_CORNER_CUTS &&
           !is_within(task, 1);
}

/* Whether only planes keep the tile from being a chain. Of solids with many all are asked for each
 * tile. */
static bool has_many_planes(const struct csg_tiler *tiler, const struct csg_tile_task *task,
                            const struct csg_draw *draw, size_t num_leaves)
{
    return may_chain(tiler) && !draw->stiff && draw->chain.planes > CSG_CHAIN_PLANES &&
           draw->chain.slots == 0 && num_leaves <= CSG_CHAIN_LITERALS && !draw->surface &&
           !draw->bands && (!is_small(task) || may_cut_corner(tiler, task)) &&
           planes_tile_size(tiler->terms->scene, &task->tree) == INT_MAX;
}

static bool is_worth_cutting(const struct csg_tiler *tiler, const struct csg_tile_task *task,
                             size_t num_leaves)
{
    const int few = !tiler->fine && task->flat && num_leaves <= FEW_LEAVES ? 2 : 1;
    const int tile =
        is_crowded(tiler, task, num_leaves) ? csg_tile_size(tiler) / 2 : few * csg_tile_size(tiler);
    const bool smallest = is_within(task, tile);
    const bool stubborn = num_leaves > STUBBORN_LEAVES && task->before[1] > 0 &&
                          (double)num_leaves > STUBBORN_SHARE * (double)task->before[1];
    if (tiler->terms->views.num > 0 && !is_within(task, SURFACE_TILE_SIZE))
        return true;
    if (smallest || tiler->terms->frame->texels.num / 4 >= tiler->max_texels)
        return false;
    return task->bands.num > SMALL_BANDS || (!stubborn && num_leaves > SMALL_LEAVES) ||
           !is_within(task, planes_tile_size(tiler->terms->scene, &task->tree));
}

/* Draws a tile; *drawn is false where it is to be cut all the same. */
static bool draw_tile(struct csg_tiler *tiler, const struct csg_tile_task *task, size_t num_leaves,
                      bool *drawn)
{
    struct csg_draw draw = *tiler->draw;
    if (!put_records(tiler, task, &draw))
        return false;
    *drawn = !has_many_planes(tiler, task, &draw, num_leaves);
    if (*drawn)
        return add_draw(tiler, task, num_leaves, &draw);
    tiler->num_corner_cuts += is_small(task);
    tiler->terms->frame->texels.num = 4 * (size_t)draw.instance.records[0];
    return true;
}

/* What was folded last is drawn, or waits to be cut. Takes the task. */
static bool settle(struct csg_tiler *tiler, struct csg_tile_task *task)
{
    const size_t num_leaves = csg_tree_count_leaves(&task->tree);
    bool ok = true, done = task->tree.num == 0;
    if (done)
        tiler->terms->frame->tiles_empty++;
    else if (!is_worth_cutting(tiler, task, num_leaves))
        ok = draw_tile(tiler, task, num_leaves, &done);
    if (ok && !done && csg_array_push(&tiler->tasks, *task))
        return true;
    csg_task_drop(tiler, task);
    return ok && done;
}

static bool fold_and_settle(struct csg_tiler *tiler, struct csg_tile_task *task, int part)
{
    tiler->parts.at = part;
    if (csg_tiler_fold(tiler, task))
        return settle(tiler, task);
    csg_task_drop(tiler, task);
    return false;
}

/* Whether the leaves' rectangles tell enough of the task's parts. */
static bool is_coarse(const struct csg_tiler *tiler, const struct csg_tile_task *task)
{
    return task->flat && task->tree.num > COARSE_NODES && !is_within(task, COARSE_SIZE) &&
           (task->before[1] == 0 ||
            (double)csg_tree_count_leaves(&task->tree) <= COARSE_SHARE * (double)task->before[1]) &&
           tiler->terms->frame->texels.num / 4 < tiler->max_texels;
}

/* What of the task's tree the tile does not miss by rectangles is left to do. Takes the task. */
static bool sift_and_leave(struct csg_tiler *tiler, struct csg_tile_task *task)
{
    const bool ok = csg_tiler_sift(tiler, task);
    tiler->terms->frame->tiles_empty += ok && task->tree.num == 0;
    if (ok && task->tree.num > 0 && csg_array_push(&tiler->tasks, *task))
        return true;
    csg_task_drop(tiler, task);
    return ok && task->tree.num == 0;
}

/* Takes the task, of which parts are left to do. */
static bool run(struct csg_tiler *tiler, struct csg_tile_task *task)
{
    struct csg_tile_task parts[CSG_TILE_LANES];
    tiler->parts.num = csg_task_cut(tiler, task, parts);
    for (int i = 0; i < tiler->parts.num; i++)
        tiler->parts.rects[i] = csg_tile_rect(&parts[i]);
    const bool coarse = is_coarse(tiler, task);
    bool ok = coarse || csg_tiler_look(tiler, task);
    for (int i = 0; i < tiler->parts.num && ok; i++)
        ok = csg_task_copy(tiler, task, &parts[i]) &&
             (coarse ? sift_and_leave(tiler, &parts[i]) : fold_and_settle(tiler, &parts[i], i));
    csg_task_drop(tiler, task);
    return ok;
}

/* The first task, which is all of the area. Takes it. */
static bool begin(struct csg_tiler *tiler, struct csg_tile_task *task)
{
    if (is_coarse(tiler, task))
        return sift_and_leave(tiler, task);
    tiler->parts.num = 1;
    tiler->parts.rects[0] = csg_tile_rect(task);
    if (csg_tiler_sift(tiler, task) && csg_tiler_look(tiler, task))
        return fold_and_settle(tiler, task, 0);
    csg_task_drop(tiler, task);
    return false;
}

static bool is_spent(struct csg_tile_budget *budget)
{
    return budget && atomic_load(&budget->spent) > budget->most;
}

/* What is left to do; nothing is done any more where memory is out, or more is spent than may be.
 */
static bool run_tasks(struct csg_tiler *tiler, bool ok)
{
    while (tiler->tasks.num) {
        struct csg_tile_task task = tiler->tasks.data[--tiler->tasks.num];
        if (ok && !is_spent(tiler->budget))
            ok = run(tiler, &task);
        else
            csg_task_drop(tiler, &task);
    }
    return ok;
}

bool csg_tile_area(struct csg_tiler *tiler, struct csg_terms *terms,
                   const struct csg_tile_area *area, const struct csg_draw *draw)
{
    struct csg_tile_task whole = {.lo = {area->lo[0], area->lo[1]},
                                  .hi = {area->hi[0], area->hi[1]}};
    tiler->terms = terms;
    tiler->draw = draw;
    tiler->budget = area->budget;
    tiler->fine = area->fine;
    tiler->num_corner_cuts = 0;
    tiler->max_texels = area->max_texels + terms->frame->texels.num / 4;
    return run_tasks(tiler, csg_task_start(tiler, &whole) && begin(tiler, &whole));
}

void csg_tiler_finish(struct csg_tiler *tiler)
{
    for (size_t i = 0; i < tiler->spare.num; i++)
        free(tiler->spare.data[i].data);
    free(tiler->spare.data);
    csg_tree_room_finish(&tiler->room);
    free(tiler->tasks.data);
    free(tiler->parts.ranges.data);
    free(tiler->ranges.data);
    free(tiler->origins.data);
    free(tiler->members.data);
    free(tiler->nodes.data);
    free(tiler->contexts.data);
    free(tiler->stacks.data);
    free(tiler->planes.data);
    free(tiler->keys.data);
    free(tiler->known.data);
    csg_scan_finish(&tiler->scan);
}
