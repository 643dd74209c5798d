/* SPDX-License-Identifier: MIT */

/* A plane's texel for csg_clip_plane: w is 0 for an entry, CSG_KEY_MAX for an exit. */
vec4 csg_plane_sense(vec4 texel)
{
#ifdef CSG_TEXTBOOK
    return texel;
#else
    return vec4(texel.xyz, texel.w < 0.0 ? CSG_KEY_MAX : 0.0);
#endif
}
