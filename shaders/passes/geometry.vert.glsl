/* SPDX-License-Identifier: MIT */
/* One instance per object: a rectangle that holds what the object can cover. */

layout(location = 0) in vec4 csg_rect;      /* lo x, lo y, hi x, hi y in clip space */
layout(location = 1) in ivec3 csg_records;  /* begin, end in the data texture; turns of a look */

flat out ivec3 csg_object;

void main()
{
    csg_hand_screen();
    csg_object = csg_records;
#ifdef CSG_SHARED
    csg_hand_spare();
#endif
#ifdef CSG_NUM_HANDED /* and csg_hand_over are put in front by src/shader */
    csg_hand_over(csg_records.x, csg_records.y);
#endif
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(mix(csg_rect.xy, csg_rect.zw, corner), 0.0, 1.0);
}
