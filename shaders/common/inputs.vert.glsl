/* SPDX-License-Identifier: MIT */
/* What common/inputs.glsl takes. All numbers differ: the driver unites inputs that are equal. */

#ifndef CSG_HAS_REST
flat out int csg_rest;
#endif

void csg_hand_spare()
{
    float first = float(gl_VertexID);
#ifndef CSG_HAS_REST
    csg_rest = gl_VertexID;
#endif
#if CSG_NUM_SPARE > 0
    for (int i = 0; i < CSG_NUM_SPARE; i++)
        csg_spare[i] = first + float(4 * i) + vec4(1.0, 2.0, 3.0, 4.0);
#endif
}
