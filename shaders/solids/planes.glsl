/* SPDX-License-Identifier: MIT */
/* Planes: one affine term of the pixel each. Twin of csg_screen_plane in src/pack/screen.c. */

csg_real csg_plane(csg_real4 texel, vec2 d)
{
    csg_exact csg_real k = texel.x + (texel.y * d.x + texel.z * d.y);
    return k;
}

/* Narrows the leaf by one plane of either sense; texel is csg_plane_sense's. */
void csg_clip_plane(csg_real4 texel, vec2 d, int face, inout csg_span span)
{
    csg_real k = csg_plane(texel, d);
    csg_enter(k - texel.w, face, span);
    csg_leave(k + (CSG_KEY_MAX - texel.w), face, span);
}

/* The same where it is known to be one by which rays leave. */
void csg_clip_exit(csg_real4 texel, vec2 d, int face, inout csg_span span)
{
    csg_leave(csg_plane(texel, d), face, span);
}

/* The planes at texel p: first those where rays enter, then those where they leave. Two a turn:
 * llvmpipe ends all loops of a fragment after 65,535 turns. */
void csg_clip_planes(int p, int num_entries, int num_exits, vec2 d, inout csg_span span)
{
    for (int i = 0; i < num_entries; i += 2) {
        int j = min(i + 1, num_entries - 1);
        csg_enter(csg_plane(csg_term(p, i), d), i, span);
        csg_enter(csg_plane(csg_term(p, j), d), j, span);
    }
    int last = num_entries + num_exits - 1;
    for (int i = num_entries; i <= last; i += 2) {
        int j = min(i + 1, last);
        csg_leave(csg_plane(csg_term(p, i), d), i, span);
        csg_leave(csg_plane(csg_term(p, j), d), j, span);
    }
}
