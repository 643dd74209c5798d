/* SPDX-License-Identifier: MIT */
#include "crowd/fill.h"

#include <stdlib.h>
#include <string.h>

#include "common/parallel.h"
#include "crowd/cull.h"
#include "csg/carrier.h"
#include "crowd/crowd.h"
#include "pack/ball.h"
#include "pack/terms.h"

struct filler {
    struct csg_cull cull;
    struct csg_frame *frame;
    const struct csgcast_scene *scene;
    const struct csg_frame_params *params;
    size_t *instances; /* per block: where its first instance goes, in floats */
    size_t *texels;    /* ... and its first attribute block */
    size_t *pixels;    /* covered by the block's rectangles */
};

static size_t stride_of(const struct csg_crowd_class *class)
{
    return 4 + csg_member_num_terms(class) + 1;
}

/* Attribute blocks begin at multiples of four texels. */
static size_t texels_of(const struct csg_crowd_class *class)
{
    const size_t normals = (class->has_quadric ? CSG_NORMAL_TERMS : 0u) + class->num_planes;
    return (CSG_ATTRIBUTE_NORMALS + normals + 3) / 4 * 4;
}

static size_t pixels_of(const struct csg_candidate *candidate)
{
    return (size_t)(candidate->hi[0] - candidate->lo[0] + 1) *
           (size_t)(candidate->hi[1] - candidate->lo[1] + 1);
}

/* ---- one instance ---- */

static void put_rect(const struct filler *filler, const struct csg_candidate *candidate, float *out)
{
    const double size[2] = {filler->frame->screen.width, filler->frame->screen.height};
    for (int i = 0; i < 2; i++) {
        out[i] = (float)(2 * candidate->lo[i] / size[i] - 1);
        out[2 + i] = (float)(2 * (candidate->hi[i] + 1) / size[i] - 1);
    }
}

/* The leaf's colour, number and normals at texel place; its instance at out. false: demoted. */
static bool put_member(struct filler *filler, const struct csg_crowd_class *class,
                       const struct csg_candidate *candidate, size_t place, float *out)
{
    const uint32_t leaf = filler->cull.view.crowd->leaf[candidate->member];
    float(*block)[4] = (float(*)[4])(filler->frame->texels.data + 4 * place);
    const float *terms = csg_cull_terms(&filler->cull, candidate->class, candidate->member);
    const float mark = (float)(place / 4 + 1);
    const int32_t first = (int32_t)(place + CSG_ATTRIBUTE_NORMALS);
    if (!terms)
        return false;
    put_rect(filler, candidate, out);
    memcpy(out + 4, terms, csg_member_num_terms(class) * sizeof *terms);
    memcpy(out + stride_of(class) - 1, &first, sizeof first);
    csg_face_color(filler->params->scheme, &filler->scene->leaves[leaf], NULL, CSG_LAYER_MODEL,
                   false, block[CSG_ATTRIBUTE_COLOR]);
    block[CSG_ATTRIBUTE_LEAF][0] = (float)leaf;
    csg_member_normals(&filler->cull.view, class, candidate->member, mark,
                       block + CSG_ATTRIBUTE_NORMALS);
    return true;
}

static void fill_block(void *user, size_t task)
{
    struct filler *filler = user;
    const struct csg_crowd_block *block = &filler->cull.blocks.data[task];
    const struct csg_crowd_class *class = &filler->cull.view.crowd->classes[block->class];
    float *out = filler->frame->crowd.instances.data + filler->instances[task];
    size_t place = filler->texels[task];
    filler->pixels[task] = 0;
    for (uint32_t i = 0; i < block->num; i++) {
        const struct csg_candidate *candidate = &filler->cull.candidates[block->begin + i];
        if (!put_member(filler, class, candidate, place, out)) {
            memset(out, 0, stride_of(class) * sizeof *out); /* a rectangle without pixels */
            filler->cull.demoted[candidate->member] = 1;
        } else {
            filler->pixels[task] += pixels_of(candidate);
        }
        out += stride_of(class);
        place += texels_of(class);
    }
}

/* ---- all of them ---- */

/* One run a class; where each block's instances and attribute blocks go. */
static bool plan(struct filler *filler)
{
    struct csg_frame_crowd *out = &filler->frame->crowd;
    const struct csg_cull *cull = &filler->cull;
    size_t floats = 0, texels = (filler->frame->texels.num / 4 + 3) / 4 * 4;
    uint32_t last = UINT32_MAX;
    for (size_t i = 0; i < cull->blocks.num; i++) {
        const struct csg_crowd_block *block = &cull->blocks.data[i];
        const struct csg_crowd_class *class = &cull->view.crowd->classes[block->class];
        const bool ball = class->outline == CSG_OUTLINE_BALL && cull->view.square;
        const struct csg_crowd_run run = {ball, class->has_quadric,
                                          class->num_planes, floats, stride_of(class), 0};
        if (block->class != last && !csg_array_push(&out->runs, run))
            return false;
        last = block->class;
        out->runs.data[out->runs.num - 1].num += block->num;
        filler->instances[i] = floats;
        filler->texels[i] = texels;
        floats += block->num * stride_of(class);
        texels += block->num * texels_of(class);
    }
    const size_t added = 4 * texels - filler->frame->texels.num;
    if (!csg_array_reserve(&out->instances, floats + 1) ||
        !csg_array_reserve(&filler->frame->texels, added))
        return false;
    if (added > 0)
        memset(filler->frame->texels.data + filler->frame->texels.num, 0, added * sizeof(float));
    filler->frame->texels.num += added;
    out->instances.num = floats;
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

static int compare_objects(const void *a, const void *b)
{
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return x < y ? -1 : x > y;
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
        qsort(frame->listed.data, frame->listed.num, sizeof *frame->listed.data, compare_objects);
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
                csg_singles_note(singles, filler->scene,
                                 cull->view.crowd->leaf[candidate->member], pixels_of(candidate));
        }
    }
}

static bool fill(struct filler *filler)
{
    const size_t num = filler->cull.blocks.num;
    filler->instances = malloc((3 * num + 1) * sizeof *filler->instances);
    if (!filler->instances)
        return false;
    filler->texels = filler->instances + num;
    filler->pixels = filler->texels + num;
    if (!plan(filler))
        return false;
    csg_parallel(filler->frame->num_threads, num, fill_block, filler);
    for (size_t i = 0; i < num; i++) {
        filler->frame->proxy_pixels += filler->pixels[i];
        filler->frame->solid_tests += filler->pixels[i]; /* each has one solid */
    }
    filler->frame->crowd.together = filler->cull.together;
    if (!demote_kin(filler))
        return false;
    count_singles(filler);
    return list_objects(filler);
}

bool csg_crowd_fill(struct csg_frame *frame, const struct csgcast_scene *scene,
                    const struct csg_frame_params *params)
{
    struct filler filler = {.cull.view = {.scene = scene, .crowd = scene->crowd, .frame = frame,
                                          .square = csg_screen_is_square(&frame->screen)},
                            .frame = frame, .scene = scene, .params = params};
    frame->crowd.runs.num = frame->crowd.instances.num = 0;
    const bool ok = csg_cull_run(&filler.cull) && fill(&filler);
    csg_cull_finish(&filler.cull);
    free(filler.instances);
    return ok;
}
