/* SPDX-License-Identifier: MIT */
/*
 * A chain: a solid, and a few solids and complements, that must all be true. They have two entry
 * planes, two exit planes and perhaps a quadric at most, or four of each and no quadric; the vertex
 * stage hands all of it over, of the longest chain as much as there is room for, and fragments read
 * the rest once. Literals stand in the order in which csg_choose prefers them. src/shader/chain.c
 * unrolls the chain over these functions, with CSG_SLOT_PLANES of each.
 */

csg_span csg_chain_planes(vec4 entries[CSG_SLOT_PLANES], vec4 exits[CSG_SLOT_PLANES], vec2 d)
{
    csg_span span = csg_whole_ray();
    for (int i = 0; i < CSG_SLOT_PLANES; i++) {
        csg_enter(csg_plane(entries[i], d), i, span);
        csg_leave(csg_plane(exits[i], d), i, span);
    }
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
