/* SPDX-License-Identifier: MIT */
/* One instance per object of one solid, all of it in attributes: src/crowd/run.h. */

layout(location = 0) in vec4 csg_rect; /* lo x, lo y, hi x, hi y in clip space */
layout(location = 1) in int csg_first; /* place of its normals in the data texture */
layout(location = 2) in vec4 csg_texels[CSG_NUM_TEXELS];

flat out int csg_normals;
flat out vec4 csg_handed[CSG_NUM_TEXELS];

void main()
{
    csg_hand_screen();
    csg_normals = csg_first;
    for (int i = 0; i < CSG_NUM_TEXELS; i++)
        csg_handed[i] = csg_texels[i];
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(mix(csg_rect.xy, csg_rect.zw, corner), 0.0, 1.0);
}
