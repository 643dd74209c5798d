/* SPDX-License-Identifier: MIT */
/* The float texture with all parameters and programs of a frame. It is a buffer's: where a texture
 * may have levels, llvmpipe asks for the level lane by lane, which costs more than the fetch. */

uniform samplerBuffer csg_data;

vec4 csg_texel(int i)
{
    return texelFetch(csg_data, i);
}
