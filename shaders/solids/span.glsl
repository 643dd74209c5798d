/* SPDX-License-Identifier: MIT */
/* A leaf along the ray: inside on [key.x, key.y), and the faces at either end, by their place in
 * the record: planes from 0, then the quadric. */

struct csg_span {
    csg_real2 key;
    ivec2 face;
};

csg_span csg_whole_ray()
{
    return csg_span(csg_real2(-CSG_KEY_MAX, CSG_KEY_MAX), ivec2(0));
}

void csg_enter(csg_real k, int face, inout csg_span span)
{
    span.face.x = k > span.key.x ? face : span.face.x;
    span.key.x = max(k, span.key.x);
}

void csg_leave(csg_real k, int face, inout csg_span span)
{
    span.face.y = k < span.key.y ? face : span.face.y;
    span.key.y = min(k, span.key.y);
}
