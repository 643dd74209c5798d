/* SPDX-License-Identifier: MIT */
/* Normal, colour and light of what is visible. */

#define CSG_HAS_LIGHT
flat in vec4 csg_lit; /* direction of the light in world space, ambient part */

/* What is visible at pixel d, key k: place is that of its face's normal in the data texture. */
struct csg_face {
    vec3 normal;    /* times size */
    float size;
    float key;      /* of an object in double: put right */
    int attributes; /* place of its block */
};

csg_face csg_face_of(int place, vec2 d, float k)
{
    vec4 face = csg_texel(place);
    vec3 normal = face.xyz;
    float size = 1.0;
#ifndef CSG_ONLY_PLANES
    if (face.w < 0.0) {
#ifdef CSG_TEXTBOOK
        vec3 at = csg_ray_org(d) + k * csg_ray_dir(d);
        normal += at.x * csg_texel(place + 1).xyz + at.y * csg_texel(place + 2).xyz +
                  at.z * csg_texel(place + 3).xyz;
#else
#ifdef CSG_KNOWS_BENDS
        vec4 u = vec4(csg_bend_u, 0.0), v = vec4(csg_bend_v, 0.0), w = vec4(csg_bend_w, 0.0);
#else
        vec4 u = csg_texel(place + 1), v = csg_texel(place + 2), w = csg_texel(place + 3);
#endif
        normal += d.x * u.xyz + d.y * v.xyz + k * w.xyz;
        k += u.w + (d.x * v.w + d.y * w.w);
#endif
        size = length(normal);
        if (!(size > 0.0)) {
            normal = vec3(0.0, 0.0, 1.0);
            size = 1.0;
        }
    }
#endif
    return csg_face(normal, size, k, (int(abs(face.w)) - 1) * 4);
}

vec4 csg_color_of(csg_face face)
{
#ifdef CSG_KNOWS_COLORS
    vec4 base = vec4(csg_tint, 1.0);
#else
    vec4 base = csg_texel(face.attributes + CSG_ATTRIBUTE_COLOR);
#endif
    float light = csg_lit.w + abs(dot(face.normal, csg_lit.xyz)) / face.size;
    return vec4(min(base.rgb * light, 1.0), base.a);
}

/* To what a byte holds, as csg_color_bytes rounds. What is written becomes the nearest byte, so
 * this need not be a division to the last bit. */
vec3 csg_rounded(vec3 color)
{
    return floor(color * 255.0 + 0.5) * (1.0 / 255.0);
}
