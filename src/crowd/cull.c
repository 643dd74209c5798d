/* SPDX-License-Identifier: MIT */
#include "crowd/cull.h"

#include <stdlib.h>
#include <string.h>

#include "common/parallel.h"
#include "crowd/occlusion.h"
#include "crowd/project.h"
#include "pack/ball.h"
#include "pack/precision.h"

enum verdict { DROPPED, SEEN, DEMOTED };

static enum verdict look_at(const struct csg_cull *cull, const struct csg_camera *camera,
                            const struct csg_crowd_class *class, struct csg_candidate *out)
{
    const struct csg_crowd *crowd = cull->view.crowd;
    const size_t i = out->member;
    const struct csg_seen_ball ball = csg_camera_see(
        camera, csg_vec3(crowd->x[i], crowd->y[i], crowd->z[i]), crowd->radius[i]);
    const double r = ball.radius, t = ball.t, near = CSG_BALL_NEAR * r;
    const double *numbers =
        crowd->numbers + class->numbers + (i - class->begin) * csg_outline_size(class->outline);
    struct csg_footprint print;
    if (!camera->orthographic) {
        if (t < -r)
            return DROPPED;
        if (!(t > CSG_BALL_FRONT * r) ||
            ball.c[0] * ball.c[0] + ball.c[1] * ball.c[1] + t * t < near * near)
            return csg_ball_crosses_picture(camera, &ball) ? DEMOTED : DROPPED;
    }
    if (!csg_outline_project(camera, class->outline, numbers, &ball, &print))
        return DROPPED;
    const double range[2] = {t - r, t + r};
    if (!cull->all_in_float &&
        !csg_precision_suffices(&cull->view.frame->screen, range, (double)crowd->need[i]))
        return DEMOTED;
    memcpy(out->lo, print.lo, sizeof out->lo);
    memcpy(out->hi, print.hi, sizeof out->hi);
    out->key = csg_occlusion_near(&cull->view.frame->screen, print.near);
    return SEEN;
}

static void look_at_block(void *user, size_t task)
{
    struct csg_cull *cull = user;
    const struct csg_camera camera = csg_camera_of(&cull->view.frame->screen);
    struct csg_crowd_block *block = &cull->blocks.data[task];
    const struct csg_crowd_class *class = &cull->view.crowd->classes[block->class];
    block->num = 0;
    block->lo_key = INFINITY;
    block->hi_key = -INFINITY;
    for (uint32_t i = block->begin; i < block->end; i++) {
        struct csg_candidate *candidate = &cull->candidates[block->begin + block->num];
        candidate->member = i;
        candidate->class = (uint16_t)block->class;
        candidate->by_rect = true;
        candidate->owns = false;
        const enum verdict verdict = look_at(cull, &camera, class, candidate);
        cull->demoted[i] = verdict == DEMOTED;
        if (verdict != SEEN)
            continue;
        block->num++;
        block->lo_key = candidate->key < block->lo_key ? candidate->key : block->lo_key;
        block->hi_key = candidate->key > block->hi_key ? candidate->key : block->hi_key;
    }
}

static void hide_block(void *user, size_t task)
{
    struct csg_cull *cull = user;
    struct csg_crowd_block *block = &cull->blocks.data[task];
    struct csg_candidate *candidates = cull->candidates + block->begin;
    uint32_t num = 0;
    for (uint32_t i = 0; i < block->num; i++)
        if (csg_occlusion_shows(cull, &candidates[i]))
            candidates[num++] = candidates[i];
    block->num = num;
}

/* Translucent members are drawn as other objects are. */
static void demote_translucent(struct csg_cull *cull)
{
    for (size_t i = 0; i < cull->blocks.num; i++) {
        struct csg_crowd_block *block = &cull->blocks.data[i];
        struct csg_candidate *candidates = cull->candidates + block->begin;
        uint32_t num = 0;
        for (uint32_t j = 0; j < block->num; j++) {
            if (cull->view.crowd->opaque[candidates[j].member])
                candidates[num++] = candidates[j];
            else
                cull->demoted[candidates[j].member] = 1;
        }
        block->num = num;
    }
}

static bool plan_blocks(struct csg_cull *cull)
{
    cull->blocks.num = 0;
    for (uint32_t i = 0; i < cull->view.crowd->num_classes; i++) {
        const struct csg_crowd_class *class = &cull->view.crowd->classes[i];
        for (size_t begin = class->begin; begin < class->end; begin += CSG_CROWD_BLOCK) {
            const size_t end = begin + CSG_CROWD_BLOCK;
            const struct csg_crowd_block block = {
                i, (uint32_t)begin, (uint32_t)(end < class->end ? end : class->end), 0, 0, 0};
            if (!csg_array_push(&cull->blocks, block))
                return false;
        }
    }
    return true;
}

/* What suffices for the finest member over all depths suffices for each over its own. */
static bool are_all_in_float(const struct csg_cull *cull)
{
    double range[2];
    csg_depth_range(&cull->view.frame->screen, &cull->view.scene->box, range);
    return range[1] > range[0] &&
           csg_precision_suffices(&cull->view.frame->screen, range,
                                  (double)cull->view.crowd->least_need);
}

const float *csg_cull_terms(struct csg_cull *cull, uint32_t class, uint32_t member)
{
    const struct csg_crowd_class *of = &cull->view.crowd->classes[class];
    float *terms =
        cull->terms + cull->terms_at[class] + (member - of->begin) * csg_member_num_terms(of);
    if (cull->state[member] == CSG_TERMS_UNKNOWN)
        cull->state[member] = csg_member_terms(&cull->view, of, member, terms) ? CSG_TERMS_KNOWN
                                                                               : CSG_TERMS_STIFF;
    return cull->state[member] == CSG_TERMS_KNOWN ? terms : NULL;
}

/* Pages that no member's terms are written to cost nothing. */
static bool allocate(struct csg_cull *cull)
{
    const struct csg_crowd *crowd = cull->view.crowd;
    size_t num_terms = 0;
    for (size_t i = 0; i < crowd->num_classes; i++) {
        const struct csg_crowd_class *class = &crowd->classes[i];
        cull->terms_at[i] = num_terms;
        num_terms += (class->end - class->begin) * csg_member_num_terms(class);
    }
    cull->candidates = malloc((crowd->num + 1) * sizeof *cull->candidates);
    cull->demoted = malloc(crowd->num + 1);
    cull->state = calloc(crowd->num + 1, 1);
    cull->terms = malloc((num_terms + 1) * sizeof *cull->terms);
    return cull->candidates && cull->demoted && cull->state && cull->terms;
}

bool csg_cull_run(struct csg_cull *cull)
{
    if (!allocate(cull) || !plan_blocks(cull))
        return false;
    cull->all_in_float = are_all_in_float(cull);
    csg_parallel(cull->view.frame->num_threads, cull->blocks.num, look_at_block, cull);
    if (!csg_occlusion_draw(cull))
        return false;
    if (cull->has_relief)
        csg_parallel(cull->view.frame->num_threads, cull->blocks.num, hide_block, cull);
    if (!csg_occlusion_hide_translucent(cull))
        return false;
    demote_translucent(cull);
    return true;
}

void csg_cull_finish(struct csg_cull *cull)
{
    free(cull->blocks.data);
    free(cull->candidates);
    free(cull->demoted);
    free(cull->state);
    free(cull->terms);
    csg_relief_finish(&cull->relief);
    csg_owners_finish(&cull->owners);
    free(cull->drawn);
}
