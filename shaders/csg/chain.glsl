/* SPDX-License-Identifier: MIT */
/*
 * A tree without inner stack: a chain of solids, each joined to what is before it by an
 * intersection or a union. Solids have two entry planes, two exit planes and perhaps a quadric at
 * most; the vertex stage hands all of it over, of the longest chain as much as there is room for,
 * and fragments read the rest once. src/shader/chain.c unrolls the chain over these functions.
 */

/* head: flags, record from the object's first, entry planes, planes. */
csg_span csg_chain_planes(vec4 head, vec4 e0, vec4 e1, vec4 x0, vec4 x1, vec2 d)
{
    csg_span span = csg_whole_ray();
    int exits = int(head.z);
    csg_enter(csg_plane(e0, d), 0, span);
    csg_enter(csg_plane(e1, d), 1, span);
    csg_leave(csg_plane(x0, d), exits, span);
    csg_leave(csg_plane(x1, d), exits + 1, span);
    return span;
}

bool csg_chain_is(vec4 head, int flag)
{
    return (int(head.x) & flag) != 0;
}

/* Where the literal is true at the soonest, at k or later. */
float csg_chain_value(vec4 head, csg_span span, float k)
{
    return csg_chain_is(head, CSG_RECORD_NEGATED) ? csg_outside(k, span.key)
                                                  : csg_inside(k, span.key);
}

/* The same of the chain up to this literal, result being that of what is before it. */
float csg_chain_next(vec4 head, csg_span span, float k, float result)
{
    bool all = csg_chain_is(head, CSG_RECORD_AND);
    float value = csg_chain_value(head, span, all ? result : k);
    return all ? value : min(result, value); /* what is asked at result is never before it */
}

csg_change csg_chain_literal(vec4 head, float leaf, csg_span span, int begin, float k)
{
    bool negated = csg_chain_is(head, CSG_RECORD_NEGATED);
    bvec2 around = csg_around(k, span.key);
    return csg_literal(negated ? not(around) : around,
                       int(leaf) + (negated ? CSG_RANK_NEGATED : 0),
                       ivec2(begin + int(head.y), csg_face_at(k, span, !negated)));
}

csg_change csg_chain_change(vec4 head, csg_change result, csg_change value)
{
    bool all = csg_chain_is(head, CSG_RECORD_AND);
    return csg_choose(all ? result.before && value.before : result.before || value.before,
                      all ? result.after && value.after : result.after || value.after, result,
                      value);
}
