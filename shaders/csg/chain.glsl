/* SPDX-License-Identifier: MIT */
/*
 * A chain: a solid, and a few solids and complements, that must all be true. They have two entry
 * planes, two exit planes and perhaps a quadric at most; the vertex stage hands all of it over, of
 * the longest chain as much as there is room for, and fragments read the rest once. Literals stand
 * in the order in which csg_choose prefers them. src/shader/chain.c unrolls the chain over these
 * functions.
 */

/* CSG_ONE_PLANE_A_SIDE: e1 and x1 are none. */
csg_span csg_chain_planes(vec4 e0, vec4 e1, vec4 x0, vec4 x1, vec2 d)
{
    csg_span span = csg_whole_ray();
    csg_enter(csg_plane(e0, d), 0, span);
    csg_leave(csg_plane(x0, d), 2, span);
#ifndef CSG_ONE_PLANE_A_SIDE
    csg_enter(csg_plane(e1, d), 1, span);
    csg_leave(csg_plane(x1, d), 3, span);
#endif
    return span;
}

/*
 * All literals hold within what the solids have in common, whole.x to whole.y, less what the
 * complements take away: of this literal that, or nothing.
 */
vec2 csg_chain_hole(bool negated, csg_span span, inout vec2 whole)
{
    whole.x = max(whole.x, negated ? -CSG_KEY_MAX : span.key.x);
    whole.y = min(whole.y, negated ? CSG_NEVER : span.key.y);
    return negated ? span.key : vec2(CSG_NEVER);
}

/* All being true just after k: whether this one was not so before. */
bool csg_chain_changes(bool negated, csg_span span, float k)
{
    return negated ? csg_ends(k, span.key) : csg_begins(k, span.key);
}

/* Of the face that it has changed at. */
ivec2 csg_chain_place(bool negated, vec3 head, csg_span span)
{
    return csg_normal_at(head.yz, negated ? span.face.y : span.face.x);
}
