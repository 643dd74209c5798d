/* SPDX-License-Identifier: MIT */
/* Deferred shading: normal and colour of what csg_visible names. */

uniform usampler2D csg_visible;
uniform vec3 csg_light;      /* direction in world space */
uniform vec4 csg_ambient;    /* ambient part; 1: an overlay, which leaves missed pixels alone */
uniform vec4 csg_background;
uniform vec2 csg_window;

layout(location = 0) out vec4 csg_color;
layout(location = 1) out vec4 csg_geometry; /* normal, distance */
layout(location = 2) out vec4 csg_leaf;

/* Of the record's faces that a ray passes in this sense, the one whose crossing is k. */
vec3 csg_normal(int record, vec2 pixel, float k, bool leaves)
{
    vec4 head = csg_texel(record);
    int entries = int(head.x), exits = int(head.y), flags = int(head.z);
    int attributes = int(head.w) * 4;
    vec2 d = pixel - csg_texel(attributes + CSG_ATTRIBUTE_ORIGIN).xy;
    int first = leaves ? entries : 0, last = leaves ? entries + exits : entries;
    int face = -1;
    float nearest = 3e38;
    for (int i = first; i < last; i++) {
        float miss = abs(csg_plane(csg_texel(record + 1 + i), d) - k);
        face = miss < nearest ? i : face;
        nearest = min(miss, nearest);
    }
    int normals = attributes + CSG_ATTRIBUTE_NORMALS;
    if ((flags & CSG_RECORD_QUADRIC) != 0) {
        vec2 crossings;
        int code;
        bool hit = csg_quadric(record + 1 + entries + exits, d, crossings, code);
        float miss = min(abs(crossings.x - k), abs(crossings.y - k));
        if ((hit && miss < nearest) || face < 0) {
            int p = normals + entries + exits;
            return csg_texel(p).xyz + d.x * csg_texel(p + 1).xyz + d.y * csg_texel(p + 2).xyz +
                   k * csg_texel(p + 3).xyz;
        }
    }
    return csg_texel(normals + face).xyz;
}

void main()
{
    uvec2 visible = texelFetch(csg_visible, ivec2(gl_FragCoord.xy), 0).xy;
    if (visible.y == 0u) {
        if (csg_ambient.y != 0.0)
            discard;
        csg_color = csg_background;
        csg_geometry = vec4(0.0, 0.0, 0.0, uintBitsToFloat(0x7f800000u));
        csg_leaf = vec4(-1.0);
        return;
    }
    float k = uintBitsToFloat(visible.x);
    int record = int(visible.y - 1u) >> 1;
    bool inside = ((visible.y - 1u) & 1u) != 0u;
    vec4 head = csg_texel(record);
    bool negated = (int(head.z) & CSG_RECORD_NEGATED) != 0;
    int attributes = int(head.w) * 4;
    vec3 normal = csg_normal(record, gl_FragCoord.xy + csg_window, k, negated != inside);
    float size = length(normal);
    normal = size > 0.0 ? normal / size : vec3(0.0, 0.0, 1.0);
    vec4 base = csg_texel(attributes + CSG_ATTRIBUTE_COLOR);
    float light = csg_ambient.x + abs(dot(normal, csg_light));
    csg_color = vec4(min(base.rgb * light, 1.0), base.a);
    csg_geometry = vec4(normal, csg_distance(k));
    csg_leaf = vec4(csg_texel(attributes + CSG_ATTRIBUTE_ORIGIN).z);
}
