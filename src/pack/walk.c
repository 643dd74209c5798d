/* SPDX-License-Identifier: MIT */
#include "pack/walk.h"

#include "pack/record.h"

/* The nearest point of a box may be this much nearer than its middle, at most. */
#define MAX_DEPTH_RATIO 50.0

bool csg_walk_can_see(const struct csg_screen *screen, const struct csg_box *box)
{
    double range[2] = {INFINITY, -INFINITY};
    for (int i = 0; i < 8; i++) {
        const double t = csg_dot(csg_sub(csg_box_corner(box, i), screen->origin), screen->forward);
        range[0] = fmin(range[0], t);
        range[1] = fmax(range[1], t);
    }
    return screen->orthographic || range[1] < MAX_DEPTH_RATIO * range[0];
}

static void put_vector(float *texel, struct csg_vec3 a, double w)
{
    texel[0] = (float)a.x;
    texel[1] = (float)a.y;
    texel[2] = (float)a.z;
    texel[3] = (float)w;
}

/*
 * Rays about the box's center c: with t0 the depth of c and (x, y) the pixel from the reference
 * one, the point at depth t0 + s is origin + x origin_dx + y origin_dy + s (direction + ...), from
 * c. Its key is (alpha + beta s) / (1 + gamma s), csg_screen_key written about t0.
 */
static void put_rays(const struct csg_frame *frame, const struct csg_cells *cells, size_t root,
                     float *to)
{
    const struct csg_screen *screen = &frame->screen;
    const struct csg_pixel at = frame->at;
    const struct csg_vec3 c = csg_box_middle(&cells->box);
    const struct csg_vec3 direction =
        csg_add(screen->direction, csg_add(csg_scale(at.x, screen->direction_dx),
                                           csg_scale(at.y, screen->direction_dy)));
    const struct csg_vec3 origin =
        csg_add(screen->origin,
                csg_add(csg_scale(at.x, screen->origin_dx), csg_scale(at.y, screen->origin_dy)));
    const double t0 = csg_dot(csg_sub(c, screen->origin), screen->forward);
    const bool flat = screen->orthographic;
    const double alpha = flat ? t0 - screen->a : (screen->a * t0 - screen->b) / t0;
    const double beta = flat ? 1 : screen->a / t0, gamma = flat ? 0 : 1 / t0;
    put_vector(to, csg_add(csg_sub(origin, c), csg_scale(t0, direction)), alpha);
    put_vector(to + 4, csg_add(screen->origin_dx, csg_scale(t0, screen->direction_dx)), beta);
    put_vector(to + 8, csg_add(screen->origin_dy, csg_scale(t0, screen->direction_dy)), gamma);
    put_vector(to + 12, direction, (double)root);
    put_vector(to + 16, screen->direction_dx, 0);
    put_vector(to + 20, screen->direction_dy, 0);
    put_vector(to + 24, csg_scale(0.5, csg_sub(cells->box.hi, cells->box.lo)), 0);
}

/* A leaf's terms in the order of its faces, whichever way rays cross them. */
static bool put_leaf(struct csg_terms *terms, const struct csg_leaf_terms *leaf)
{
    const uint32_t num = leaf->num_entries + leaf->num_exits;
    const bool has_quadric = leaf->flags & CSG_RECORD_QUADRIC;
    const uint32_t first_face = has_quadric ? CSG_NORMAL_TERMS : 0;
    float *header =
        csg_frame_add_texels(terms->frame, 1 + num + (has_quadric ? CSG_QUADRIC_TEXELS : 0));
    if (!header)
        return false;
    header[0] = (float)num;
    header[2] = (float)leaf->flags;
    header[3] = (float)leaf->attributes;
    for (uint32_t i = 0; i < num; i++) {
        const double *texel = csg_terms_texel(terms, leaf, i);
        const uint32_t face = (uint32_t)fabs(texel[3]) - 1 - first_face;
        csg_record_put_term(terms, texel, header + 4 * (1 + face));
    }
    for (uint32_t i = 0; i < CSG_QUADRIC_TEXELS && has_quadric; i++)
        csg_record_put_term(terms, csg_terms_texel(terms, leaf, num + i),
                            header + 4 * (1 + num + i));
    return true;
}

/* Where the next cells will be. */
static size_t end_of_cells(const struct csg_frame *frame)
{
    if (frame->cells.num == 0)
        return 0;
    const struct csg_frame_cells *last = &frame->cells.data[frame->cells.num - 1];
    return last->first + last->cells->texels.num / 4;
}

bool csg_walk_has_room(const struct csg_frame *frame, const struct csg_cells *cells)
{
    return end_of_cells(frame) + cells->texels.num / 4 <= CSG_CELLS_MAX_TEXELS;
}

bool csg_walk_add(struct csg_terms *terms, const struct csg_cells *cells,
                  const struct csg_rect *rect, const struct csg_draw *draw)
{
    struct csg_frame *frame = terms->frame;
    struct csg_draw walk = *draw;
    const struct csg_frame_cells added = {cells, end_of_cells(frame)};
    const size_t begin = frame->texels.num / 4;
    float *header = csg_frame_add_texels(frame, CSG_WALK_HEADER);
    if (!header || !csg_array_push(&frame->cells, added))
        return false;
    put_rays(frame, cells, added.first, header);
    walk.instance.records[0] = (int32_t)begin;
    walk.instance.records[1] = (int32_t)(frame->texels.num / 4);
    walk.walk = true;
    walk.nested = cells->nested;
    walk.bunched = cells->bunched;
    for (size_t i = 0; i < terms->leaves.num; i++)
        if (!put_leaf(terms, &terms->leaves.data[i]))
            return false;
    csg_draw_set_rect(&walk, &frame->screen, rect);
    csg_frame_count(frame, rect, 0);
    return csg_array_push(&frame->draws, walk);
}
