/* SPDX-License-Identifier: MIT */
/* Hands over how rays walk through an object's cells. */

#define CSG_NUM_HANDED CSG_WALK_HEADER
flat out vec4 csg_handed[CSG_WALK_HEADER];

void csg_hand_over(int begin, int end)
{
    for (int i = 0; i < CSG_WALK_HEADER; i++)
        csg_handed[i] = csg_texel(begin + i);
}
