/* SPDX-License-Identifier: MIT */
/* A triangle that covers the picture, at the far end: what is nearer there has been drawn. */

void main()
{
    csg_hand_screen();
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(4.0 * corner - 1.0, 1.0, 1.0);
}
