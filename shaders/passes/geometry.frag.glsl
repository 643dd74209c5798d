/* SPDX-License-Identifier: MIT */
/* Which face is visible in a pixel, and at what key. csg_resolve is the variant's. */

flat in ivec2 csg_object; /* begin, end in the data texture */

uniform vec2 csg_window;      /* of the band that is drawn, in the whole picture */
uniform vec2 csg_at;          /* the reference pixel */
uniform float csg_depth_bias; /* overlays win over what they repeat */

layout(location = 0) out uvec2 csg_visible;

void main()
{
    float k;
    ivec2 place;
    bool inside;
    vec2 d = gl_FragCoord.xy + csg_window - csg_at;
    if (!csg_resolve(csg_object, d, k, place, inside))
        discard;
    int attributes = int(csg_texel(place.x).w) * 4;
    csg_visible = uvec2(floatBitsToUint(k), uint(attributes + CSG_ATTRIBUTE_NORMALS + place.y + 1));
    gl_FragDepth = csg_depth(k) - csg_depth_bias;
}
