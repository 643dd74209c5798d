/* SPDX-License-Identifier: MIT */
/* Deferred shading: normal and colour of what csg_visible names. */

uniform usampler2DRect csg_visible;
flat in vec4 csg_lit; /* direction of the light in world space, ambient part */

layout(location = 0) out vec4 csg_color;
#ifndef CSG_WANT_BYTES
layout(location = 1) out vec4 csg_geometry; /* normal, distance */
#endif
#ifdef CSG_WANT_LEAF
layout(location = 2) out vec4 csg_leaf;
#endif

void main()
{
    uvec2 visible = texelFetch(csg_visible, ivec2(gl_FragCoord.xy)).xy;
    if (visible.y == 0u || visible.y == CSG_UNFINISHED)
        discard; /* cleared to the background, or what an overlay lies on */
    float k = uintBitsToFloat(visible.x);
    int p = int(visible.y) - 1;
    vec4 face = csg_texel(p);
    vec3 normal = face.xyz;
    if (face.w < 0.0) {
        vec2 d = csg_pixel();
#ifdef CSG_TEXTBOOK
        vec3 at = csg_ray_org(d) + k * csg_ray_dir(d);
        normal += at.x * csg_texel(p + 1).xyz + at.y * csg_texel(p + 2).xyz + at.z * csg_texel(p + 3).xyz;
#else
        vec4 u = csg_texel(p + 1), v = csg_texel(p + 2), w = csg_texel(p + 3);
        normal += d.x * u.xyz + d.y * v.xyz + k * w.xyz;
        k += u.w + (d.x * v.w + d.y * w.w);
#endif
        float size = length(normal);
        normal = size > 0.0 ? normal / size : vec3(0.0, 0.0, 1.0);
    }
    int attributes = (int(abs(face.w)) - 1) * 4;
    vec4 base = csg_texel(attributes + CSG_ATTRIBUTE_COLOR);
    float light = csg_lit.w + abs(dot(normal, csg_lit.xyz));
    csg_color = vec4(min(base.rgb * light, 1.0), base.a);
#ifdef CSG_WANT_BYTES
    csg_color = floor(csg_color * 255.0 + 0.5) / 255.0; /* as csg_color_bytes rounds */
#else
    csg_geometry = vec4(normal, csg_distance(k));
#endif
#ifdef CSG_WANT_LEAF
    csg_leaf = vec4(csg_texel(attributes + CSG_ATTRIBUTE_LEAF).x);
#endif
}
