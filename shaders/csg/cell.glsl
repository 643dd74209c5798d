/* SPDX-License-Identifier: MIT */
/*
 * The tree of one cell: records [begin, end), run by a machine with one accumulator and a stack, as
 * in csg/program.glsl. A record names the faces of a leaf that pass through the cell; their terms
 * are in the object's.
 */

#define CSG_CELL_FLAGS 1024u /* as in src/cells/cells.h */

/* What a tree is from key k on: true at the soonest, and what changes at k itself. */
struct csg_cell {
    float next;
    csg_change change;
};

#ifdef CSG_HAS_QUADRIC
/* Narrows span by the quadric behind the faces of the leaf whose terms are at place. */
void csg_cell_quadric(int flags, int place, vec2 d, inout csg_span span, inout vec2 gap)
{
    int num = int(csg_texel(place).x), p = place + 1 + num;
    csg_crossings at = csg_quadric(csg_texel(p), csg_texel(p + 1), csg_texel(p + 2), d);
#ifdef CSG_HAS_STIFF
    if ((at.code & CSG_QUADRIC_STIFF) != 0)
        at.key = csg_stiff_quadric(p, d);
#endif
#ifdef CSG_HAS_GAP
    if ((flags & CSG_RECORD_GAP) != 0)
        gap = csg_gap_quadric(at, num, span);
    else
#endif
        csg_clip_quadric(at, num, span);
}
#endif

float csg_cell_literal(float k, csg_span span, vec2 gap, bool negated)
{
#ifdef CSG_HAS_GAP
    return negated ? csg_outside_gap(k, span.key, gap) : csg_inside_gap(k, span.key, gap);
#else
    return negated ? csg_outside(k, span.key) : csg_inside(k, span.key);
#endif
}

csg_change csg_cell_change(float k, csg_span span, vec2 gap, int quadric, ivec2 leaf, bool negated)
{
#ifdef CSG_HAS_GAP
    bvec2 around = csg_around_gap(k, span.key, gap);
    int face = csg_face_at_gap(k, span, gap, quadric, !around.x);
#else
    bvec2 around = csg_around(k, span.key);
    int face = csg_face_at(k, span, !around.x);
#endif
    return csg_literal(negated ? not(around) : around, leaf.y + (negated ? CSG_RANK_NEGATED : 0),
                       ivec2(leaf.x, face));
}

/* Right within the cell. Where the tree is true at k, next is k. */
csg_cell csg_cell_run(int begin, int end, int terms, vec2 d, float k)
{
#ifdef CSG_HAS_NESTED
    csg_cell stack[CSG_STACK_SIZE];
    int top = 0;
#endif
    csg_change nothing = csg_change(false, false, CSG_RANK_NONE, ivec2(0));
    csg_cell result = csg_cell(CSG_NEVER, nothing);
    csg_span span = csg_whole_ray();
    vec2 gap = vec2(CSG_KEY_MAX);
    for (int p = begin; p < end; p++) {
        vec4 record = csg_cell_texel(p);
        uint code = uint(record.y);
        int flags = int(code % CSG_CELL_FLAGS), place = terms + int(record.z);
        csg_walk_turns += 2;
        for (uint faces = uint(record.x) | code / CSG_CELL_FLAGS << 24; faces != 0u; faces >>= 8) {
            int face = int(faces & 255u) - 1;
            csg_walk_turns++;
            csg_cell_plane(csg_texel(place + 1 + face), d, face, span);
        }
#ifdef CSG_HAS_QUADRIC
        if ((flags & CSG_RECORD_QUADRIC) != 0)
            csg_cell_quadric(flags, place, d, span, gap);
#endif
        if ((flags & CSG_RECORD_MORE) != 0)
            continue;
        bool all = (flags & CSG_RECORD_AND) != 0, starts = (flags & CSG_RECORD_START) != 0;
        bool negated = (flags & CSG_RECORD_NEGATED) != 0;
        float at = all && !starts ? result.next : k;
        csg_cell value;
        value.next = csg_cell_literal(at, span, gap, negated);
#ifdef CSG_HAS_QUADRIC
        int quadric = int(csg_texel(place).x);
#else
        int quadric = 0;
#endif
        value.change = csg_cell_change(k, span, gap, quadric, ivec2(place, int(record.w)), negated);
#ifdef CSG_HAS_NESTED
        if ((flags & CSG_RECORD_POP) != 0) {
            value = result;
            result = stack[--top];
        }
        if ((flags & CSG_RECORD_PUSH) != 0)
            stack[top++] = result;
#endif
        csg_change both = csg_choose(
            all ? result.change.before && value.change.before
                : result.change.before || value.change.before,
            all ? result.change.after && value.change.after
                : result.change.after || value.change.after,
            result.change, value.change);
        result.next = starts ? value.next
                      : all  ? max(result.next, value.next)
                             : min(result.next, value.next);
        if (starts)
            result.change = value.change;
        else
            result.change = both;
        span = csg_whole_ray();
        gap = vec2(CSG_KEY_MAX);
    }
    return result;
}

/* From k on in the cell of records [begin, end): moves k to where its tree is true, or to last. */
bool csg_cell_search(int begin, int end, int terms, vec2 d, float last, inout float k,
                     inout ivec2 place)
{
    bool found = false;
    while (!found && k < last && csg_walk_turns < CSG_MAX_WALK_TURNS) {
        csg_cell cell = csg_cell_run(begin, end, terms, d, k);
        csg_walk_turns += 2;
        found = !(cell.next > k);
        place = cell.change.place;
        k = found ? k : min(cell.next, last);
    }
    return found;
}

/* place names the face already. */
ivec2 csg_cell_face(ivec2 place, int terms, vec2 d)
{
    return place;
}
