/* SPDX-License-Identifier: MIT */
/* Which record is visible in a pixel, and at what key. csg_resolve is the variant's. */

flat in vec2 csg_at;
flat in ivec2 csg_range;

uniform vec2 csg_window;      /* of the band that is drawn, in the whole picture */
uniform float csg_depth_bias; /* overlays win over what they repeat */

layout(location = 0) out uvec2 csg_visible;

void main()
{
    float k;
    int record;
    bool inside;
    if (!csg_resolve(csg_range.x, csg_range.y, gl_FragCoord.xy + csg_window - csg_at, k, record,
                     inside))
        discard;
    csg_visible = uvec2(floatBitsToUint(k), uint(2 * record + (inside ? 2 : 1)));
    gl_FragDepth = csg_depth(k) - csg_depth_bias;
}
