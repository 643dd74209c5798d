/* SPDX-License-Identifier: MIT */
/* The far side of one convex solid, seen from outside: what csg_resolve of resolve.glsl finds of it
 * by five looks at its record, by one. */

bool csg_resolve(ivec3 object, vec2 d, out csg_real k, out ivec2 place, out bool inside)
{
    int p = object.x;
    csg_span span = csg_whole_ray();
    csg_real2 gap; /* it has none */
    csg_read_leaf(p, csg_texel(p), d, span, gap);
    k = span.key.y;
    place = ivec2(object.x, span.face.y);
    inside = true;
    return span.key.x > csg_screen_depth.z && span.key.x < k && k < csg_screen_key.z;
}
