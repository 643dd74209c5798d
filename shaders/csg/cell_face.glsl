/* SPDX-License-Identifier: MIT */
/* What both forms of cells need, csg/cell.glsl and csg/bunch.glsl. */

/* The cells of all objects: they stay on the GPU as long as the scene does not change. */
uniform samplerBuffer csg_cells;

vec4 csg_cell_texel(int i)
{
    return texelFetch(csg_cells, i);
}

/* Turns of loops so far, see CSG_MAX_WALK_TURNS. */
int csg_walk_turns = 0;

/* Of faces that leave at the same key the last one counts, as in records that have them backwards.
 */
void csg_cell_plane(vec4 texel, vec2 d, int face, inout csg_span span)
{
    float k = csg_plane(texel, d), exit = texel.w < 0.0 ? k : CSG_KEY_MAX;
    csg_enter(texel.w < 0.0 ? -CSG_KEY_MAX : k, face, span);
    span.face.y = exit <= span.key.y ? face : span.face.y;
    span.key.y = min(exit, span.key.y);
}
