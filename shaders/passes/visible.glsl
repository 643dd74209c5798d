/* SPDX-License-Identifier: MIT */
/* What a geometry program writes of the visible face: what the shading pass needs, or, where there
 * is none (src/render/direct.h), its colour. */

#ifdef CSG_DIRECT
layout(location = 0) out vec4 csg_color;
#else
layout(location = 0) out uvec2 csg_visible;
#endif

/* place: of the face's normal in the data texture. */
void csg_show(vec2 d, float k, int place)
{
#ifdef CSG_DIRECT
    csg_color = vec4(csg_rounded(csg_color_of(csg_face_of(place, d, k)).rgb), 1.0);
#else
    csg_visible = uvec2(floatBitsToUint(k), uint(place + 1));
#endif
}

/* The program gave up: all that is finished has an alpha of 1. */
void csg_show_unfinished()
{
#ifdef CSG_DIRECT
    csg_color = vec4(0.0);
#else
    csg_visible = uvec2(0u, CSG_UNFINISHED);
#endif
}
