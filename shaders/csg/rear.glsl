/* SPDX-License-Identifier: MIT */
/* One convex leaf's far side, which shows through its front where it is translucent. */

bool csg_resolve(ivec3 object, vec2 d, out csg_real k, out ivec2 place, out bool inside)
{
    int p = object.x;
    csg_span span;
    csg_real2 gap;
    csg_read_leaf(p, csg_texel(p), d, span, gap);
    inside = true;
    k = span.key.y;
    place = ivec2(object.x, span.face.y);
    return span.key.x < k && k < csg_screen_key.z;
}
