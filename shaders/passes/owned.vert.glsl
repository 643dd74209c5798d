/* SPDX-License-Identifier: MIT */
/* Members of a crowd where they own pixels, one instance for all: struct csg_owned_instance in
 * src/crowd/run.h. */

layout(location = 0) in vec4 csg_rect;   /* lo x, lo y, hi x, hi y in clip space */
layout(location = 1) in ivec4 csg_range; /* begin, end; places of the first one's terms and block */
layout(location = 2) in int csg_width;   /* of the picture of owners */

flat out ivec4 csg_members;
flat out ivec2 csg_row; /* numbers a row, number of the strip's first pixel */

void main()
{
    csg_hand_screen();
    csg_members = csg_range;
    csg_row = ivec2(csg_width, csg_width * int(csg_window.y));
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(mix(csg_rect.xy, csg_rect.zw, corner), 0.0, 1.0);
}
