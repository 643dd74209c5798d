/* SPDX-License-Identifier: MIT */
/* One convex solid seen from outside: what geometry.frag.glsl finds, without a Boolean. */

flat in int csg_normals;
flat in vec4 csg_handed[CSG_NUM_TEXELS]; /* the quadric's, then the planes' */

uniform vec2 csg_window; /* of the band that is drawn, in the whole picture */
uniform vec2 csg_at;     /* the reference pixel */

layout(location = 0) out uvec2 csg_visible;

void main()
{
    vec2 d = gl_FragCoord.xy + csg_window - csg_at;
    csg_span span = csg_whole_ray();
    int normal = csg_normals;
    for (int i = 0; i < CSG_NUM_PLANES; i++)
        csg_clip_plane(csg_handed[CSG_NUM_TEXELS - CSG_NUM_PLANES + i], d, i, span);
#ifdef CSG_HAS_QUADRIC
    csg_clip_quadric(csg_quadric(csg_handed[0], csg_handed[1], csg_handed[2], d), CSG_NUM_PLANES, span);
    normal += span.face.x == CSG_NUM_PLANES ? 0 : CSG_NORMAL_TERMS + span.face.x;
#else
    normal += span.face.x;
#endif
    if (!(span.key.x < span.key.y) || span.key.x >= csg_screen_key.z)
        discard;
    csg_visible = uvec2(floatBitsToUint(span.key.x), uint(normal + 1));
    gl_FragDepth = csg_depth(span.key.x);
}
