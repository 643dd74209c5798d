/* SPDX-License-Identifier: MIT */
/* A triangle that covers the picture, at the far end: what is nearer there has been drawn. */

#ifdef CSG_SHARED
flat out ivec3 csg_object; /* as in geometry.vert.glsl, see common/inputs.glsl */
#endif

void main()
{
#ifdef CSG_SHARED
    csg_object = gl_VertexID + ivec3(1, 2, 3);
#endif
    csg_hand_screen();
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(4.0 * corner - 1.0, 1.0, 1.0);
}
