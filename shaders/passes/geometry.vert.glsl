/* SPDX-License-Identifier: MIT */
/*
 * A rectangle that holds what the object can cover. Drawn as an instance of four vertices or, where
 * it is a square, as one point: the two triangles of a rectangle share the blocks of pixels along
 * their edge, and drivers draw these twice.
 */

layout(location = 0) in vec4 csg_rect;      /* lo x, lo y, hi x, hi y in clip space */
/* Begin, end in the data texture; turns of a look; side of a point, else 0. */
layout(location = 1) in ivec4 csg_records;

flat out ivec3 csg_object;

void main()
{
    csg_hand_screen();
    csg_object = csg_records.xyz;
#ifdef CSG_NUM_HANDED /* and csg_hand_over are put in front by src/shader */
    csg_hand_over(csg_records.x, csg_records.y);
#endif
    vec2 corner = csg_records.w > 0 ? vec2(0.5) : vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_PointSize = float(csg_records.w);
    gl_Position = vec4(mix(csg_rect.xy, csg_rect.zw, corner), 0.0, 1.0);
}
