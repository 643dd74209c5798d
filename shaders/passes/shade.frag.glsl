/* SPDX-License-Identifier: MIT */
/* Deferred shading: normal and colour of what csg_visible names. */

uniform usampler2DRect csg_visible;
#ifdef CSG_SHARED
flat in ivec3 csg_object;
#endif

layout(location = 0) out vec4 csg_color;
#ifndef CSG_WANT_BYTES
layout(location = 1) out vec4 csg_geometry; /* normal, distance */
#endif
#ifdef CSG_WANT_LEAF
layout(location = 2) out vec4 csg_leaf;
#endif

void main()
{
#ifdef CSG_SHARED
    if (csg_is_no_number(vec4(csg_object, 0.0)))
        discard;
#endif
    uvec2 visible = texelFetch(csg_visible, ivec2(gl_FragCoord.xy)).xy;
    if (visible.y == 0u || visible.y == CSG_UNFINISHED)
        discard; /* cleared to the background, or what an overlay lies on */
    csg_face face = csg_face_of(int(visible.y) - 1, csg_pixel(), uintBitsToFloat(visible.x));
    csg_color = csg_color_of(face);
#ifdef CSG_WANT_BYTES
    csg_color.rgb = csg_rounded(csg_color.rgb);
#else
    csg_geometry = vec4(face.normal / face.size, csg_distance(face.key));
#endif
#ifdef CSG_WANT_LEAF
    csg_leaf = vec4(csg_texel(face.attributes + CSG_ATTRIBUTE_LEAF).x);
#endif
}
