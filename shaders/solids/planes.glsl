/* SPDX-License-Identifier: MIT */
/* Planes: one affine term of the pixel each. Twin of csg_screen_plane in src/pack/screen.c. */

float csg_plane(vec4 texel, vec2 d)
{
    return texel.x + (texel.y * d.x + texel.z * d.y);
}

/* Narrows span (entry, exit) by one plane; texel.w is 0 for an entry, CSG_KEY_MAX for an exit. */
void csg_clip_plane(vec4 texel, vec2 d, inout vec2 span)
{
    float k = csg_plane(texel, d);
    span.x = max(span.x, k - texel.w);
    span.y = min(span.y, k + (CSG_KEY_MAX - texel.w));
}

/* Narrows span by planes at texel p: first those where rays enter, then those where they leave. */
void csg_clip_planes(int p, int num_entries, int num_exits, vec2 d, inout vec2 span)
{
    for (int i = 0; i < num_entries; i++)
        span.x = max(span.x, csg_plane(csg_texel(p + i), d));
    for (int i = num_entries; i < num_entries + num_exits; i++)
        span.y = min(span.y, csg_plane(csg_texel(p + i), d));
}
