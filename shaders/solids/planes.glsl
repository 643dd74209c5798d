/* SPDX-License-Identifier: MIT */
/* Planes: one affine term of the pixel each. Twin of csg_screen_plane in src/pack/screen.c. */

float csg_plane(vec4 texel, vec2 d)
{
    return texel.x + (texel.y * d.x + texel.z * d.y);
}

/* Narrows the leaf by its plane number face; texel.w is 0 for an entry, CSG_KEY_MAX for an exit. */
void csg_clip_plane(vec4 texel, vec2 d, int face, inout csg_span span)
{
    float k = csg_plane(texel, d);
    csg_enter(k - texel.w, face, span);
    csg_leave(k + (CSG_KEY_MAX - texel.w), face, span);
}

/* The planes at texel p: first those where rays enter, then those where they leave. */
void csg_clip_planes(int p, int num_entries, int num_exits, vec2 d, inout csg_span span)
{
    for (int i = 0; i < num_entries; i++)
        csg_enter(csg_plane(csg_texel(p + i), d), i, span);
    for (int i = num_entries; i < num_entries + num_exits; i++)
        csg_leave(csg_plane(csg_texel(p + i), d), i, span);
}
