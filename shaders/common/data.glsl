/* SPDX-License-Identifier: MIT */
/* The float texture with all parameters and programs of a frame. */

uniform sampler2D csg_data;

vec4 csg_texel(int i)
{
    return texelFetch(csg_data, ivec2(i & CSG_DATA_MASK, i >> CSG_DATA_SHIFT), 0);
}
