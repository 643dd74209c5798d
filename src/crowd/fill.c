/* SPDX-License-Identifier: MIT */
#include "crowd/fill.h"

#include <stdlib.h>
#include <string.h>

#include "carrier/carrier.h"
#include "common/order.h"
#include "common/parallel.h"
#include "common/prefetch.h"
#include "crowd/crowd.h"
#include "crowd/cull.h"
#include "crowd/occluders.h"
#include "crowd/sift.h"
#include "pack/ball.h"
#include "pack/terms.h"

/* What of a class is drawn, and where it goes. */
struct class_plan {
    size_t num, num_owners, num_rects, num_others; /* of all: others own nothing */
    size_t first;                                  /* number of its first member */
    size_t instances;                              /* in floats */
    size_t terms, blocks;                          /* in texels */
};

/* Leaves lie far apart in memory: so many of them are on their way. */
enum { PREFETCHED = 8 };

struct filler {
    struct csg_cull cull;
    struct csg_frame *frame;
    const struct csgcast_scene *scene;
    const struct csg_frame_params *params;
    struct class_plan classes[CSG_CROWD_MAX_CLASSES];
    size_t *first;     /* per block: the number of its first member */
    size_t *instances; /* ... where its first instance goes, in floats */
    size_t *pixels;    /* covered by the block's rectangles */
    int32_t *numbers;  /* per member that owns pixels */
};

static size_t stride_of(const struct csg_crowd_class *class)
{
    return 4 + csg_member_num_terms(class) + 1;
}

static size_t texels_of(const struct csg_crowd_class *class)
{
    return (size_t)CSG_BLOCK_TEXELS((int)class->has_quadric, (int)class->num_planes);
}

/* Pixels lo to hi, both included, in clip space. */
static void put_rect(const struct csg_screen *screen, const int lo[2], const int hi[2],
                     float rect[4])
{
    const double size[2] = {screen->width, screen->height};
    for (int i = 0; i < 2; i++) {
        rect[i] = (float)(2 * lo[i] / size[i] - 1);
        rect[2 + i] = (float)(2 * (hi[i] + 1) / size[i] - 1);
    }
}

/* ---- one member ---- */

static void put_instance(const struct filler *filler, const struct csg_crowd_class *class,
                         const struct csg_candidate *candidate, const float *terms, size_t place,
                         float *out)
{
    const int lo[2] = {candidate->lo[0], candidate->lo[1]};
    const int hi[2] = {candidate->hi[0], candidate->hi[1]};
    const int32_t first = (int32_t)(place + CSG_ATTRIBUTE_NORMALS);
    put_rect(&filler->frame->screen, lo, hi, out);
    memcpy(out + 4, terms, csg_member_num_terms(class) * sizeof *terms);
    memcpy(out + stride_of(class) - 1, &first, sizeof first);
}

/* The leaf's colour, number and normals at texel place. */
static void put_block(struct filler *filler, const struct csg_crowd_class *class, uint32_t member,
                      size_t place)
{
    const uint32_t leaf = filler->cull.view.crowd->leaf[member];
    float(*block)[4] = (float(*)[4])(filler->frame->texels.data + 4 * place);
    memset(block, 0, texels_of(class) * sizeof *block);
    csg_face_color(filler->params->scheme, &filler->scene->leaves[leaf], NULL, CSG_LAYER_MODEL,
                   false, block[CSG_ATTRIBUTE_COLOR]);
    block[CSG_ATTRIBUTE_LEAF][0] = (float)leaf;
    csg_member_normals(&filler->cull.view, class, member, (float)(place / 4 + 1),
                       block + CSG_ATTRIBUTE_NORMALS);
}

/* Member number n of all; its instance, if it has one, goes to out. */
static void put_member(struct filler *filler, const struct csg_candidate *candidate, size_t n,
                       float *out)
{
    const struct csg_crowd_class *class = &filler->cull.view.crowd->classes[candidate->class];
    const struct class_plan *plan = &filler->classes[candidate->class];
    const float *terms = csg_cull_terms(&filler->cull, candidate->class, candidate->member);
    const size_t place = plan->blocks + (n - plan->first) * texels_of(class);
    const size_t num_terms = csg_member_num_terms(class);
    if (!terms) { /* a rectangle without pixels */
        memset(out, 0, stride_of(class) * sizeof *out);
        filler->cull.demoted[candidate->member] = 1;
        return;
    }
    put_block(filler, class, candidate->member, place);
    if (candidate->by_rect)
        put_instance(filler, class, candidate, terms, place, out);
    if (candidate->owns)
        filler->numbers[candidate->member] = (int32_t)n;
    if (plan->num_owners)
        memcpy(filler->frame->texels.data + 4 * plan->terms + (n - plan->first) * num_terms, terms,
               num_terms * sizeof *terms);
}

static void fill_block(void *user, size_t task)
{
    struct filler *filler = user;
    const struct csg_crowd_block *block = &filler->cull.blocks.data[task];
    const struct csg_crowd_class *class = &filler->cull.view.crowd->classes[block->class];
    const uint32_t *leaves = filler->cull.view.crowd->leaf;
    float *out = filler->frame->crowd.instances.data + filler->instances[task];
    filler->pixels[task] = 0;
    for (uint32_t i = 0; i < block->num; i++) {
        const struct csg_candidate *candidate = &filler->cull.candidates[block->begin + i];
        if (i + PREFETCHED < block->num)
            csg_prefetch(filler->scene->leaves[leaves[candidate[PREFETCHED].member]].color);
        put_member(filler, candidate, filler->first[task] + i, out);
        if (!candidate->by_rect)
            continue;
        filler->pixels[task] +=
            filler->cull.demoted[candidate->member] ? 0 : csg_candidate_num_pixels(candidate);
        out += stride_of(class);
    }
}

/* ---- all of them ---- */

static void count(struct filler *filler)
{
    const struct csg_cull *cull = &filler->cull;
    for (size_t i = 0; i < cull->blocks.num; i++) {
        const struct csg_crowd_block *block = &cull->blocks.data[i];
        struct class_plan *plan = &filler->classes[block->class];
        const size_t stride = stride_of(&cull->view.crowd->classes[block->class]);
        filler->first[i] = plan->num;
        filler->instances[i] = plan->num_rects * stride;
        plan->num += block->num;
        for (size_t j = block->begin; j < block->begin + block->num; j++) {
            plan->num_owners += cull->candidates[j].owns;
            plan->num_rects += cull->candidates[j].by_rect;
            plan->num_others += !cull->candidates[j].owns;
        }
    }
}

/* The run of a class's instances, and that of the pixels its members own. */
static bool add_runs(struct filler *filler, const struct csg_crowd_class *class,
                     const struct class_plan *plan, size_t owned)
{
    struct csg_frame_crowd *out = &filler->frame->crowd;
    struct csg_crowd_run run = csg_member_run(&filler->cull.view, class);
    if (plan->num_owners) {
        run.owned = true;
        run.first = owned;
        run.stride = sizeof(struct csg_owned_instance) / sizeof(float);
        run.num = 1;
        run.num_members = plan->num_owners;
        if (!csg_array_push(&out->runs, run))
            return false;
    }
    run.owned = false;
    run.first = plan->instances;
    run.stride = stride_of(class);
    run.num = plan->num_rects;
    run.num_members = plan->num_others;
    return !plan->num_rects || csg_array_push(&out->runs, run);
}

static size_t aligned(size_t texels)
{
    return (texels + 3) / 4 * 4;
}

static void put_owned(const struct filler *filler, const struct class_plan *plan, float *out)
{
    struct csg_owned_instance instance = {.begin = (int32_t)plan->first,
                                          .end = (int32_t)(plan->first + plan->num),
                                          .terms = (int32_t)plan->terms,
                                          .blocks = (int32_t)plan->blocks,
                                          .width = filler->frame->screen.width};
    put_rect(&filler->frame->screen, filler->cull.owned.lo, filler->cull.owned.hi, instance.rect);
    memcpy(out, &instance, sizeof instance);
}

/* Where everything goes: attribute blocks begin at multiples of four texels. */
static bool plan(struct filler *filler)
{
    struct csg_frame_crowd *out = &filler->frame->crowd;
    const struct csg_crowd *crowd = filler->cull.view.crowd;
    const size_t own_size = sizeof(struct csg_owned_instance) / sizeof(float);
    size_t num = 0, floats = crowd->num_classes * own_size;
    size_t texels = aligned(filler->frame->texels.num / 4);
    count(filler);
    for (size_t i = 0; i < crowd->num_classes; i++) {
        struct class_plan *of = &filler->classes[i];
        of->first = num;
        of->instances = floats;
        of->terms = texels;
        if (of->num_owners)
            texels = aligned(texels + of->num * csg_member_num_terms(&crowd->classes[i]) / 4);
        of->blocks = texels;
        texels += of->num * texels_of(&crowd->classes[i]);
        num += of->num;
        floats += of->num_rects * stride_of(&crowd->classes[i]);
        if (!add_runs(filler, &crowd->classes[i], of, i * own_size))
            return false;
    }
    for (size_t i = 0; i < filler->cull.blocks.num; i++) {
        filler->first[i] += filler->classes[filler->cull.blocks.data[i].class].first;
        filler->instances[i] += filler->classes[filler->cull.blocks.data[i].class].instances;
    }
    if (!csg_array_reserve(&out->instances, floats + 1) ||
        !csg_array_reserve(&filler->frame->texels, 4 * texels - filler->frame->texels.num))
        return false;
    filler->frame->texels.num = 4 * texels;
    out->instances.num = floats;
    for (size_t i = 0; i < crowd->num_classes; i++)
        put_owned(filler, &filler->classes[i], out->instances.data + i * own_size);
    return true;
}

/* The picture of owners from the bottom row on, for the program that draws them. */
static void put_owners(void *user, size_t task)
{
    const struct filler *filler = user;
    const struct csg_owners *owners = &filler->cull.owners;
    const int end = csg_strip_begin(owners->height, task + 1);
    for (int y = csg_strip_begin(owners->height, task); y < end; y++) {
        const uint32_t *who = owners->who + (size_t)y * owners->stride;
        int32_t *out = filler->frame->crowd.owners.data + (size_t)y * (size_t)owners->width;
        for (int x = 0; x < owners->width; x++)
            out[x] = who[x] < CSG_SEVERAL ? filler->numbers[who[x]] : -1;
    }
}

static bool fill_owners(struct filler *filler)
{
    struct csg_frame_crowd *out = &filler->frame->crowd;
    const struct csg_screen *screen = &filler->frame->screen;
    const size_t num = (size_t)screen->width * (size_t)screen->height;
    if (filler->cull.owned.num == 0)
        return true;
    if (!csg_array_reserve(&out->owners, num))
        return false;
    out->owners.num = num;
    csg_parallel(filler->frame->num_threads, CSG_NUM_STRIPS, put_owners, filler);
    filler->frame->proxy_pixels += filler->cull.owned.num;
    filler->frame->solid_tests += filler->cull.owned.num;
    return true;
}

/* Members that may show with carriers in common stay together: file order decides where they tie.
 * What of them is drawn twice has the same keys both times. */
static bool demote_kin(struct filler *filler)
{
    const struct csg_cull *cull = &filler->cull;
    const struct csg_crowd *crowd = cull->view.crowd;
    bool any = false;
    for (size_t i = 0; i < crowd->num && !any; i++)
        any = cull->demoted[i] && crowd->kin[i] != CSG_CROWD_NO_KIN;
    uint8_t *kin = any ? calloc(filler->scene->objects->num + 1, 1) : NULL;
    if (!kin)
        return !any;
    for (size_t i = 0; i < crowd->num; i++)
        if (cull->demoted[i] && crowd->kin[i] != CSG_CROWD_NO_KIN)
            kin[crowd->kin[i]] = 1;
    for (size_t i = 0; i < cull->blocks.num; i++) {
        const struct csg_crowd_block *block = &cull->blocks.data[i];
        for (size_t j = block->begin; j < block->begin + block->num; j++) {
            const uint32_t member = cull->candidates[j].member;
            cull->demoted[member] |=
                crowd->kin[member] != CSG_CROWD_NO_KIN && kin[crowd->kin[member]];
        }
    }
    free(kin);
    return true;
}

/* The objects that are no members, and the demoted ones. */
static bool list_objects(const struct filler *filler)
{
    struct csg_frame *frame = filler->frame;
    const struct csg_crowd *crowd = filler->cull.view.crowd;
    if (!csg_array_reserve(&frame->listed, crowd->num_others + 1))
        return false;
    memcpy(frame->listed.data, crowd->others, crowd->num_others * sizeof *crowd->others);
    frame->listed.num = crowd->num_others;
    for (size_t i = 0; i < crowd->num; i++)
        if (filler->cull.demoted[i] && !csg_array_push(&frame->listed, crowd->object[i]))
            return false;
    if (frame->listed.num > crowd->num_others)
        qsort(frame->listed.data, frame->listed.num, sizeof *frame->listed.data,
              csg_compare_indices);
    return true;
}

/* Those that are no longer members are counted where they are drawn. */
static void count_singles(struct filler *filler)
{
    const struct csg_cull *cull = &filler->cull;
    struct csg_singles *singles = &filler->frame->singles;
    for (size_t i = 0; i < cull->blocks.num && singles->is_wanted; i++) {
        const struct csg_crowd_block *block = &cull->blocks.data[i];
        for (size_t j = block->begin; j < block->begin + block->num; j++) {
            const struct csg_candidate *candidate = &cull->candidates[j];
            if (!cull->demoted[candidate->member])
                csg_singles_note(singles, filler->scene, cull->view.crowd->leaf[candidate->member],
                                 candidate->by_rect ? csg_candidate_num_pixels(candidate) : 0);
        }
    }
}

/* Each of these pixels is its owner's alone. */
static void count_owned(struct filler *filler)
{
    const struct csg_cull *cull = &filler->cull;
    const struct csg_owners *owners = &cull->owners;
    struct csg_singles *singles = &filler->frame->singles;
    for (int y = 0; y < owners->height && singles->is_wanted; y++)
        for (int x = 0; x < owners->width; x++) {
            const uint32_t who = owners->who[(size_t)y * owners->stride + (size_t)x];
            if (who < CSG_SEVERAL)
                csg_singles_add_pixel(singles, filler->scene, cull->view.crowd->leaf[who]);
        }
}

static bool fill(struct filler *filler)
{
    const size_t num = filler->cull.blocks.num;
    filler->first = malloc((3 * num + 1) * sizeof *filler->first);
    filler->numbers = malloc((filler->cull.view.crowd->num + 1) * sizeof *filler->numbers);
    if (!filler->first || !filler->numbers)
        return false;
    filler->instances = filler->first + num;
    filler->pixels = filler->instances + num;
    if (!plan(filler))
        return false;
    csg_parallel(filler->frame->num_threads, num, fill_block, filler);
    for (size_t i = 0; i < num; i++) {
        filler->frame->proxy_pixels += filler->pixels[i];
        filler->frame->solid_tests += filler->pixels[i]; /* each has one solid */
    }
    filler->frame->crowd.together = filler->cull.together;
    if (!fill_owners(filler) || !demote_kin(filler))
        return false;
    count_singles(filler);
    count_owned(filler);
    return list_objects(filler) && csg_sift(filler->frame, filler->scene,
                                            filler->cull.has_relief ? &filler->cull.relief : NULL);
}

bool csg_crowd_fill(struct csg_frame *frame, const struct csgcast_scene *scene,
                    const struct csg_frame_params *params)
{
    struct filler filler = {.cull.view = {.scene = scene,
                                          .crowd = scene->crowd,
                                          .frame = frame,
                                          .square = csg_screen_is_square(&frame->screen)},
                            .cull.without = params->crowds_without,
                            .cull.max_owners = params->crowds_without ? 0 : params->max_owners,
                            .frame = frame,
                            .scene = scene,
                            .params = params};
    frame->crowd.runs.num = frame->crowd.instances.num = frame->crowd.owners.num = 0;
    const bool ok = csg_cull_run(&filler.cull) && fill(&filler);
    csg_cull_finish(&filler.cull);
    free(filler.first);
    free(filler.numbers);
    return ok;
}
