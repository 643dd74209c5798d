/* SPDX-License-Identifier: MIT */
#include "pack/record.h"

static bool add_pop(struct csg_terms *terms, const struct csg_step *step)
{
    float *header = csg_frame_add_texels(terms->frame, 1);
    if (header)
        header[2] = (float)step->flags;
    return header != NULL;
}

float *csg_record_put_term(const struct csg_terms *terms, const double *term, float *to)
{
    for (int i = 0; i < 4; i++)
        to[i] = (float)term[i];
    for (int i = 0; i < 4 && terms->precise; i++)
        to[4 + i] = (float)(term[i] - (double)to[i]);
    return to + (terms->precise ? 8 : 4);
}

/* Copies the planes at places [begin, end) that the filter takes; returns how many. */
static uint32_t put_record_planes(const struct csg_terms *terms, const struct csg_leaf_terms *leaf,
                                  uint32_t begin, uint32_t end,
                                  const struct csg_record_filter *filter, float **to)
{
    uint32_t num = 0;
    for (uint32_t i = begin; i < end; i++)
        if (!filter || filter->planes[i]) {
            *to = csg_record_put_term(terms, csg_terms_texel(terms, leaf, i), *to);
            num++;
        }
    return num;
}

bool csg_record_add(struct csg_terms *terms, const struct csg_step *step,
                    const struct csg_record_filter *filter)
{
    if (step->flags & CSG_RECORD_POP)
        return add_pop(terms, step);
    const struct csg_leaf_terms *leaf = csg_terms_of(terms, step->leaf);
    const uint32_t num_planes = leaf->num_entries + leaf->num_exits;
    const bool quadric = leaf->flags & CSG_RECORD_QUADRIC && (!filter || filter->quadric);
    const size_t width = terms->precise ? 2 : 1;
    struct csg_frame *frame = terms->frame;
    float *header = csg_frame_reserve_texels(frame, 1 + width * (num_planes + CSG_QUADRIC_TEXELS));
    if (!header)
        return false;
    float *end = header + 4;
    const uint32_t entries = put_record_planes(terms, leaf, 0, leaf->num_entries, filter, &end);
    const uint32_t exits =
        put_record_planes(terms, leaf, leaf->num_entries, num_planes, filter, &end);
    for (uint32_t i = 0; i < CSG_QUADRIC_TEXELS && quadric; i++)
        end = csg_record_put_term(terms, csg_terms_texel(terms, leaf, num_planes + i), end);
    const uint32_t dropped =
        quadric || !(leaf->flags & CSG_RECORD_QUADRIC) ? 0 : CSG_RECORD_QUADRIC | CSG_RECORD_GAP;
    header[0] = (float)entries;
    header[1] = (float)exits;
    header[2] = (float)(step->flags & ~dropped);
    header[3] = (float)leaf->attributes;
    frame->texels.num = (size_t)(end - frame->texels.data);
    return true;
}

bool csg_record_add_bound(struct csg_terms *terms, double key)
{
    float *header = csg_frame_add_texels(terms->frame, 1);
    if (!header)
        return false;
    header[2] = CSG_RECORD_BOUND;
    header[3] = nextafterf((float)key, -INFINITY);
    return true;
}
