/* SPDX-License-Identifier: MIT */
#include "crowd/cull.h"

#include <stdlib.h>
#include <string.h>

#include "common/parallel.h"
#include "crowd/balls.h"
#include "crowd/occlusion.h"
#include "crowd/project.h"
#include "pack/ball.h"
#include "pack/precision.h"

enum verdict { DROPPED, SEEN, DEMOTED };

/* Of what covers pixels, from depth begin on. */
static enum verdict judge(const struct csg_cull *cull, const struct csg_footprint *print,
                          double begin, struct csg_candidate *out)
{
    const struct csg_crowd *crowd = cull->view.crowd;
    const double range[2] = {begin, begin + 2 * crowd->radius[out->member]};
    if (!cull->all_in_float &&
        !csg_precision_suffices(&cull->view.frame->screen, range, (double)crowd->need[out->member]))
        return DEMOTED;
    memcpy(out->lo, print->lo, sizeof out->lo);
    memcpy(out->hi, print->hi, sizeof out->hi);
    out->key = csg_occlusion_near(&cull->view.frame->screen, print->near);
    return SEEN;
}

static enum verdict look_at(const struct csg_cull *cull, const struct csg_camera *camera,
                            const struct csg_crowd_class *class, struct csg_candidate *out)
{
    const struct csg_crowd *crowd = cull->view.crowd;
    const size_t i = out->member;
    const struct csg_seen_ball ball =
        csg_camera_see(camera, csg_vec3(crowd->x[i], crowd->y[i], crowd->z[i]), crowd->radius[i]);
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
    return judge(cull, &print, t - r, out);
}

static void look_at_member(struct csg_cull *cull, const struct csg_camera *camera,
                           struct csg_crowd_block *block, uint32_t member,
                           const struct csg_footprint *known)
{
    const struct csg_crowd_class *class = &cull->view.crowd->classes[block->class];
    struct csg_candidate *candidate = &cull->candidates[block->begin + block->num];
    candidate->member = member;
    candidate->class = (uint16_t)block->class;
    candidate->by_rect = true;
    candidate->owns = false;
    const enum verdict verdict = known ? judge(cull, known, known->near, candidate)
                                       : look_at(cull, camera, class, candidate);
    cull->demoted[member] = verdict == DEMOTED;
    if (verdict != SEEN)
        return;
    block->num++;
    block->lo_key = candidate->key < block->lo_key ? candidate->key : block->lo_key;
    block->hi_key = candidate->key > block->hi_key ? candidate->key : block->hi_key;
}

/* At most CSG_BALLS_MAX. */
static void look_at_balls(struct csg_cull *cull, const struct csg_camera *camera,
                          struct csg_crowd_block *block, uint32_t begin, uint32_t end)
{
    const struct csg_crowd *crowd = cull->view.crowd;
    struct csg_ball_prints prints;
    csg_balls_project(camera, crowd->x + begin, crowd->y + begin, crowd->z + begin,
                      crowd->radius + begin, end - begin, &prints);
    for (uint32_t i = 0; i < end - begin; i++) {
        const int32_t lo[2] = {prints.lo[0][i], prints.lo[1][i]};
        const int32_t hi[2] = {prints.hi[0][i], prints.hi[1][i]};
        const struct csg_footprint print = {
            {(int16_t)lo[0], (int16_t)lo[1]}, {(int16_t)hi[0], (int16_t)hi[1]}, prints.near[i]};
        if (prints.plain[i] && (lo[0] > hi[0] || lo[1] > hi[1]))
            cull->demoted[begin + i] = false; /* it covers no pixel */
        else
            look_at_member(cull, camera, block, begin + i, prints.plain[i] ? &print : NULL);
    }
}

static void look_at_block(void *user, size_t task)
{
    struct csg_cull *cull = user;
    const struct csg_camera camera = csg_camera_of(&cull->view.frame->screen);
    struct csg_crowd_block *block = &cull->blocks.data[task];
    const bool balls = cull->view.crowd->classes[block->class].outline == CSG_OUTLINE_BALL;
    const uint32_t step = balls ? CSG_BALLS_MAX : 1;
    block->num = 0;
    block->lo_key = INFINITY;
    block->hi_key = -INFINITY;
    for (uint32_t i = block->begin; i < block->end; i += step)
        if (balls)
            look_at_balls(cull, &camera, block, i, i + step < block->end ? i + step : block->end);
        else
            look_at_member(cull, &camera, block, i, NULL);
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

/* Translucent members are drawn as other objects are, and classes that are to be. */
static void demote(struct csg_cull *cull)
{
    for (size_t i = 0; i < cull->blocks.num; i++) {
        struct csg_crowd_block *block = &cull->blocks.data[i];
        const struct csg_crowd_run run =
            csg_member_run(&cull->view, &cull->view.crowd->classes[block->class]);
        const bool stays = !(cull->without & csg_crowd_run_bit(&run));
        struct csg_candidate *candidates = cull->candidates + block->begin;
        uint32_t num = 0;
        for (uint32_t j = 0; j < block->num; j++) {
            if (stays && cull->view.crowd->opaque[candidates[j].member])
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
    csg_depth_range(&cull->view.frame->screen, &cull->view.scene->drawn, range);
    return range[1] > range[0] && csg_precision_suffices(&cull->view.frame->screen, range,
                                                         (double)cull->view.crowd->least_need);
}

const float *csg_cull_terms(struct csg_cull *cull, uint32_t class, uint32_t member)
{
    const struct csg_crowd_class *of = &cull->view.crowd->classes[class];
    const size_t size = csg_member_num_terms(of);
    float *terms = cull->terms + cull->terms_at[class];
    uint32_t *place = &cull->places[member];
    if (*place == CSG_TERMS_UNKNOWN) {
        const uint32_t at =
            atomic_fetch_add_explicit(&cull->num_terms[class], 1, memory_order_relaxed);
        const bool known = csg_member_terms(&cull->view, of, member, terms + at * size);
        *place = known ? CSG_TERMS_FIRST + at : CSG_TERMS_STIFF;
    }
    return *place >= CSG_TERMS_FIRST ? terms + (*place - CSG_TERMS_FIRST) * size : NULL;
}

/* Room for the terms of all members: pages that none are written to cost nothing. */
static bool allocate(struct csg_cull *cull)
{
    const struct csg_crowd *crowd = cull->view.crowd;
    size_t num_terms = 0;
    for (size_t i = 0; i < crowd->num_classes; i++) {
        const struct csg_crowd_class *class = &crowd->classes[i];
        cull->terms_at[i] = num_terms;
        atomic_init(&cull->num_terms[i], 0);
        num_terms += (class->end - class->begin) * csg_member_num_terms(class);
    }
    cull->candidates = malloc((crowd->num + 1) * sizeof *cull->candidates);
    cull->demoted = malloc(crowd->num + 1);
    cull->places = calloc(crowd->num + 1, sizeof *cull->places);
    cull->terms = malloc((num_terms + 1) * sizeof *cull->terms);
    return cull->candidates && cull->demoted && cull->places && cull->terms;
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
    demote(cull);
    return true;
}

void csg_cull_finish(struct csg_cull *cull)
{
    free(cull->blocks.data);
    free(cull->candidates);
    free(cull->demoted);
    free(cull->places);
    free(cull->terms);
    csg_relief_finish(&cull->relief);
    csg_owners_finish(&cull->owners);
    free(cull->drawn);
}
