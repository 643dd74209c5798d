/* SPDX-License-Identifier: MIT */
/* One convex solid seen from outside: what geometry.frag.glsl finds, without a Boolean. It is an
 * instance, or the one that owns the pixel. */

#ifdef CSG_OWNED
flat in ivec4 csg_members;
flat in ivec2 csg_row;
uniform isamplerBuffer csg_owners;

int csg_normals;
vec4 csg_handed[CSG_NUM_TEXELS];

/* false: nobody owns the pixel, or a member of another class. */
bool csg_find_owner()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    int number = texelFetch(csg_owners, at.x + csg_row.x * at.y + csg_row.y).x;
    if (number < csg_members.x || number >= csg_members.y)
        return false;
    number -= csg_members.x;
    csg_normals = csg_members.w + CSG_ATTRIBUTE_NORMALS + CSG_MEMBER_BLOCK * number;
    for (int i = 0; i < CSG_NUM_TEXELS; i++)
        csg_handed[i] = csg_texel(csg_members.z + CSG_NUM_TEXELS * number + i);
    return true;
}
#else
flat in int csg_normals;
flat in vec4 csg_handed[CSG_NUM_TEXELS]; /* the quadric's, then the planes' */
#endif

#ifdef CSG_IS_BALL
/* The crossings of a ball, by those operations of csg_quadric that are not idle for it. */
vec2 csg_ball(vec2 d)
{
    vec4 t0 = csg_handed[0], t1 = csg_handed[1], t2 = csg_handed[2];
    csg_exact float m = t0.x + (t0.y * d.x + t0.z * d.y);
    csg_exact float x = t1.x + (t1.y * d.x + t1.z * d.y);
    csg_exact float y = t2.x + (t1.y * d.y - t1.z * d.x);
    csg_exact float h = (t1.w + y * (y * t2.w)) - x * x;
    float root = sqrt(max(h, 0.0));
    return vec2(m - root, m + root);
}
#endif

void main()
{
#ifdef CSG_OWNED
    if (!csg_find_owner())
        discard;
#endif
    vec2 d = csg_pixel();
    int normal = csg_normals;
#ifdef CSG_IS_BALL
    vec2 key = csg_ball(d);
#else
    csg_span span = csg_whole_ray();
    for (int i = 0; i < CSG_NUM_PLANES; i++)
        csg_clip_plane(csg_handed[CSG_NUM_TEXELS - CSG_NUM_PLANES + i], d, i, span);
#ifdef CSG_HAS_QUADRIC
    csg_clip_quadric(csg_quadric(csg_handed[0], csg_handed[1], csg_handed[2], d), CSG_NUM_PLANES,
                     span);
    normal += span.face.x == CSG_NUM_PLANES ? 0 : CSG_NORMAL_TERMS + span.face.x;
#else
    normal += span.face.x;
#endif
    vec2 key = span.key;
#endif
    if (!(key.x < key.y) || key.x >= csg_screen_key.z)
        discard;
    csg_show(d, key.x, normal);
    gl_FragDepth = csg_depth(key.x);
}
