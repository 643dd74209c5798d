/* SPDX-License-Identifier: MIT */
/* One instance per object: a rectangle that holds what the object can cover. */

layout(location = 0) in vec4 csg_rect;      /* lo x, lo y, hi x, hi y in clip space */
layout(location = 1) in vec2 csg_pixel;     /* the object's reference pixel */
layout(location = 2) in ivec2 csg_records;  /* begin, end in the data texture */

flat out vec2 csg_at;
flat out ivec2 csg_range;

void main()
{
    csg_at = csg_pixel;
    csg_range = csg_records;
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(mix(csg_rect.xy, csg_rect.zw, corner), 0.0, 1.0);
}
