/* SPDX-License-Identifier: MIT */
/*
 * A chain: a few solids and complements that must all be true. Solids have two entry planes, two
 * exit planes and perhaps a quadric at most; the vertex stage hands all of it over, of the longest
 * chain as much as there is room for, and fragments read the rest once. Literals stand in the order
 * in which csg_choose prefers them. src/shader/chain.c unrolls the chain over these functions.
 */

csg_span csg_chain_planes(vec4 e0, vec4 e1, vec4 x0, vec4 x1, vec2 d)
{
    csg_span span = csg_whole_ray();
    csg_enter(csg_plane(e0, d), 0, span);
    csg_enter(csg_plane(e1, d), 1, span);
    csg_leave(csg_plane(x0, d), 2, span);
    csg_leave(csg_plane(x1, d), 3, span);
    return span;
}

/* What a literal asks of keys: before the first number for at least the second, from there on for
 * at least the third. These are csg_inside and csg_outside, whichever the literal is. */
vec3 csg_chain_asks(float flags, csg_span span)
{
    return flags >= float(CSG_CHAIN_NEGATED) ? vec3(span.key.x, -CSG_KEY_MAX, span.key.y)
                                      : vec3(span.key.y, span.key.x, CSG_NEVER);
}

/* Where the literal is true at the soonest, at k or later. */
float csg_chain_next(vec3 asks, float k)
{
    return max(k, k < asks.x ? asks.y : asks.z);
}

/* All being true just after k: the place of this one's face if it was not so before, else of those
 * that come behind it. */
ivec2 csg_chain_place(vec3 head, csg_span span, float k, ivec2 place)
{
    bool negated = head.x >= float(CSG_CHAIN_NEGATED);
    bool changes = negated ? csg_ends(k, span.key) : csg_begins(k, span.key);
    return changes ? csg_normal_at(head.yz, negated ? span.face.y : span.face.x) : place;
}
