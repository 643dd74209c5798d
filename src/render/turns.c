/* SPDX-License-Identifier: MIT */
#include "render/turns.h"

#include "shader/source.h"

/*
 * Of csg_program_next's loop around a record, and of the two loops each that csg_clip_planes,
 * csg_surface_at and csg_bands_at have: a loop turns once more to end, also where no pixel enters
 * it.
 */
static double ending_turns(int features)
{
    return 3 + (features & CSG_FEATURE_SURFACE ? 2 : 0) + (features & CSG_FEATURE_BANDS ? 2 : 0);
}

/* The others. */
static double record_turns(const float *head)
{
    const int entries = (int)head[0], exits = (int)head[1], flags = (int)head[2];
    return flags & CSG_RECORD_SURFACE ? (double)head[4 * 2 + 1]
                                      : (entries + 1) / 2 + (exits + 1) / 2;
}

static double record_crossings(const float *head)
{
    return (int)head[2] & CSG_RECORD_SURFACE ? 4 + (double)head[4 * 2 + 1] : 4;
}

/* Texels of a record. */
static int32_t record_size(const float *head, bool precise)
{
    const int flags = (int)head[2];
    return 1 + (precise && !(flags & CSG_RECORD_SURFACE) ? 2 : 1) * csg_record_terms(head);
}

struct csg_turns csg_turns_of(const struct csg_frame *frame, const struct csg_draw *draw,
                              int features)
{
    /* The loop around looks, and the end of the one around records, within which the others end. */
    struct csg_turns turns = {1 + ending_turns(features), 3};
    if (draw->walk)
        return (struct csg_turns){0, INFINITY}; /* known to the ray only, which counts them */
    double group = 0; /* turns before the innermost operand that is being read */
    for (int32_t p = draw->instance.records[0]; p < draw->instance.records[1];) {
        const float *head = frame->texels.data + 4 * (size_t)p;
        const int flags = (int)head[2];
        group = flags & CSG_RECORD_PUSH ? turns.look : group;
        turns.look += ending_turns(features) + record_turns(head);
        if (flags & CSG_RECORD_POP) {
            turns.look += CSG_MAX_AGAIN * (turns.look - group);
            group = turns.look;
        }
        turns.looks += record_crossings(head);
        p += record_size(head, draw->precise);
    }
    return turns;
}

bool csg_may_give_up(const struct csg_draw *draw, const struct csg_turns *turns)
{
    if (draw->walk)
        return true;
    return turns->look * turns->looks > CSG_MAX_TURNS;
}
