/* SPDX-License-Identifier: MIT */
/*
 * Any tree, from the data texture: records [begin, end) are run by a machine with one accumulator
 * and a stack. dual asks for the complement of the tree: where does the solid end?
 * What several convex solids have in common is one interval, so a product is a literal, whose
 * records narrow one span.
 */

/* Narrows span by the leaf whose record is at p; moves p past it. */
void csg_read_leaf(inout int p, vec4 head, vec2 d, inout csg_span span, out csg_real2 gap)
{
    int flags = int(head.z), entries = int(head.x), exits = int(head.y);
    gap = csg_real2(CSG_KEY_MAX);
    csg_clip_planes(p + 1, entries, exits, d, span);
    p += 1 + (entries + exits) * CSG_TERM_TEXELS;
#ifdef CSG_HAS_QUADRIC
    if ((flags & CSG_RECORD_QUADRIC) != 0) {
        csg_crossings at = csg_quadric(csg_term(p, 0), csg_term(p, 1), csg_term(p, 2), d);
#ifdef CSG_HAS_STIFF
        if ((at.code & CSG_QUADRIC_STIFF) != 0)
            at.key = csg_stiff_quadric(p, d);
#endif
#ifdef CSG_HAS_GAP
        if ((flags & CSG_RECORD_GAP) != 0)
            gap = csg_gap_quadric(at, entries + exits, span);
        else
#endif
            csg_clip_quadric(at, entries + exits, span);
        p += CSG_QUADRIC_TEXELS * CSG_TERM_TEXELS;
    }
#endif
}

/* Where, at k or later, the literal whose record is at p can be true at the soonest, span being
 * what the records of it before that have left; moves p on. */
csg_real csg_record_next(inout int p, vec4 head, vec2 d, csg_real k, bool negated,
                         inout csg_span span)
{
#ifdef CSG_HAS_BANDS
    if ((int(head.z) & CSG_RECORD_BANDS) != 0) {
        csg_real next = csg_bands_next(p, d, k, negated);
        p += 1 + int(head.x);
        return next;
    }
#endif
#ifdef CSG_HAS_SURFACE
    if ((int(head.z) & CSG_RECORD_SURFACE) != 0) {
        csg_real next = csg_surface_next(p, d, k, negated);
        p += 1 + int(head.x);
        return next;
    }
#endif
    csg_real2 gap;
    csg_read_leaf(p, head, d, span, gap);
#ifdef CSG_HAS_GAP
    return negated ? csg_outside_gap(k, span.key, gap) : csg_inside_gap(k, span.key, gap);
#else
    return negated ? csg_outside(k, span.key) : csg_inside(k, span.key);
#endif
}

/* The literal's solid just before and after k, and the face there of the leaf whose record is at p;
 * the same otherwise. */
bvec2 csg_record_around(inout int p, vec4 head, vec2 d, csg_real k, inout csg_span span,
                        out int face)
{
#ifdef CSG_HAS_BANDS
    if ((int(head.z) & CSG_RECORD_BANDS) != 0) {
        bvec2 at = csg_bands_around(p, d, k, face);
        p += 1 + int(head.x);
        return at;
    }
#endif
#ifdef CSG_HAS_SURFACE
    if ((int(head.z) & CSG_RECORD_SURFACE) != 0) {
        bvec2 at = csg_surface_around(p, d, k, face);
        p += 1 + int(head.x);
        return at;
    }
#endif
    csg_real2 gap;
    csg_read_leaf(p, head, d, span, gap);
    bvec2 around = csg_around_gap(k, span.key, gap);
    face = csg_face_at_gap(k, span, gap, int(head.x) + int(head.y), !around.x);
    return around;
}

/*
 * The soonest k' >= k at which the tree can be true. What an innermost operand of a union says may
 * be too soon; while that could be the union's answer it is asked again from there on, so that not
 * each operand costs a look at all the others.
 */
csg_real csg_program_next(int begin, int end, vec2 d, csg_real k, bool dual)
{
    csg_real stack[CSG_STACK_SIZE];
    int top = 0, group = 0, again = 0;
    csg_real result = 0.0, at_group = k;
    csg_span span = csg_whole_ray();
    for (int p = begin; p < end;) {
        int record = p;
        vec4 head = csg_texel(p);
        int flags = int(head.z);
        bool all = ((flags & CSG_RECORD_AND) != 0) != dual;
        csg_real value;
        if ((flags & CSG_RECORD_BOUND) != 0) {
            p = result < head.w || result >= csg_screen_key.z ? end : p + 1;
            continue;
        }
        if ((flags & CSG_RECORD_POP) != 0) {
            value = result;
            result = stack[--top];
            if (!all && value > at_group && value < result && value < csg_screen_key.z &&
                again < CSG_MAX_AGAIN) {
                at_group = value;
                again++;
                p = group;
                continue;
            }
            again = CSG_MAX_AGAIN;
            at_group = k;
            p++;
        } else {
            bool negated = ((flags & CSG_RECORD_NEGATED) != 0) != dual;
            /* In an intersection nothing before what the operands so far ask for can be true. */
            csg_real at = all && (flags & CSG_RECORD_START) == 0 ? result : at_group;
            value = csg_record_next(p, head, d, at, negated, span);
        }
        bool more = (flags & CSG_RECORD_MORE) != 0;
        span.key = more ? span.key : csg_whole_ray().key;
        if ((flags & CSG_RECORD_PUSH) != 0) {
            stack[top++] = result;
            again = record == group ? again : 0;
            group = record;
        }
        if ((flags & CSG_RECORD_START) != 0)
            result = more ? result : value;
        else
            result = more ? result : all ? max(result, value) : min(result, value);
    }
    return result;
}

/* Record and face of the literal that is responsible for the change at k. */
ivec2 csg_program_change(int begin, int end, vec2 d, csg_real k, bool dual)
{
    csg_change stack[CSG_STACK_SIZE];
    int top = 0;
    csg_change result = csg_change(false, false, CSG_RANK_NONE, ivec2(0));
    csg_span span = csg_whole_ray();
    ivec2 enters = ivec2(begin, 0), leaves = enters; /* by whose face: its record, and its block */
    bool more = false;
    for (int p = begin; p < end;) {
        int record = p;
        vec4 head = csg_texel(p);
        int flags = int(head.z);
        bool all = ((flags & CSG_RECORD_AND) != 0) != dual;
        csg_change value;
        if ((flags & CSG_RECORD_BOUND) != 0) {
            p = k < head.w ? end : p + 1;
            continue;
        }
        if ((flags & CSG_RECORD_POP) != 0) {
            value = result;
            result = stack[--top];
            p++;
        } else {
            int face;
            bool negated = (flags & CSG_RECORD_NEGATED) != 0;
            csg_real2 before = span.key;
            bvec2 around = csg_record_around(p, head, d, k, span, face);
            enters = span.key.x > before.x || !more ? ivec2(record, head.w) : enters;
            leaves = span.key.y < before.y || !more ? ivec2(record, head.w) : leaves;
            record = around.x ? leaves.x : enters.x;
            int block = around.x ? leaves.y : enters.y;
            bool taken = negated;
#ifdef CSG_HAS_BANDS
            if ((flags & CSG_RECORD_BANDS) != 0) {
                vec4 band = csg_texel(record + face);
                block = csg_band_block(band);
                taken = negated != (band.w != 0.0);
            }
#endif
            int leaf = int(csg_texel(block * 4 + CSG_ATTRIBUTE_LEAF).x);
            value = csg_literal(negated != dual ? not(around) : around,
                                leaf + (taken ? CSG_RANK_NEGATED : 0), ivec2(record, face));
        }
        if ((flags & CSG_RECORD_PUSH) != 0)
            stack[top++] = result;
        more = (flags & CSG_RECORD_MORE) != 0;
        if (more)
            continue;
        span = csg_whole_ray();
        if ((flags & CSG_RECORD_START) != 0)
            result = value;
        else
            result = all ? csg_all(result, value) : csg_any(result, value);
    }
    return result.place;
}
