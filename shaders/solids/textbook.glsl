/* SPDX-License-Identifier: MIT */
/*
 * What a textbook has: the ray in world space, a plane's distance, and the quadratic formula with
 * b^2 - 4ac, all in float32. The variant "textbook" takes this file in place of planes.glsl and
 * quadric.glsl, to show what the terms of src/pack gain (docs/numerics.md). A key is t itself.
 * Parameters are src/pack/textbook.c's.
 */

uniform vec3 csg_ray_origin[3];    /* in the picture's middle; steps per pixel */
uniform vec3 csg_ray_direction[3];
uniform float csg_ray_start;       /* t of the eye; orthographic: -CSG_KEY_MAX */

vec3 csg_ray_org(vec2 d)
{
    return csg_ray_origin[0] + d.x * csg_ray_origin[1] + d.y * csg_ray_origin[2];
}

vec3 csg_ray_dir(vec2 d)
{
    return csg_ray_direction[0] + d.x * csg_ray_direction[1] + d.y * csg_ray_direction[2];
}

/* What is behind the eye has happened before the ray begins. */
float csg_ray_key(float t)
{
    return t <= csg_ray_start ? -CSG_KEY_MAX : min(t, CSG_KEY_MAX);
}

/* The plane dot(texel.xyz, p) <= texel.w. */
void csg_clip_plane(vec4 texel, vec2 d, int face, inout csg_span span)
{
    float along = dot(texel.xyz, csg_ray_dir(d));
    float height = texel.w - dot(texel.xyz, csg_ray_org(d));
    float t = csg_ray_key(height / along);
    if (along < 0.0)
        csg_enter(t, face, span);
    else if (along > 0.0)
        csg_leave(t, face, span);
    else if (height < 0.0)
        csg_enter(CSG_KEY_MAX, face, span);
}

void csg_clip_exit(vec4 texel, vec2 d, int face, inout csg_span span)
{
    csg_clip_plane(texel, d, face, span);
}

/* There are no exits here: which a plane is depends on the ray. */
void csg_clip_planes(int p, int num, int no_exits, vec2 d, inout csg_span span)
{
    for (int i = 0; i < num; i += 2) {
        int j = min(i + 1, num - 1);
        csg_clip_plane(csg_texel(p + i), d, i, span);
        csg_clip_plane(csg_texel(p + j), d, j, span);
    }
}

#ifdef CSG_HAS_QUADRIC
struct csg_crossings {
    vec2 key;     /* key.x <= key.y */
    bool between; /* the solid lies between the crossings, else before and after */
    bool hit;
};

/* t^2 a + t b + c <= 0 for p.Ap + 2 q.p + r along the ray. The texels have Axx Axy Axz 0, Ayy Ayz
 * Azz r, q. */
csg_crossings csg_quadric(vec4 t0, vec4 t1, vec4 t2, vec2 d)
{
    mat3 m = mat3(t0.x, t0.y, t0.z, t0.y, t1.x, t1.y, t0.z, t1.y, t1.z);
    vec3 o = csg_ray_org(d), v = csg_ray_dir(d), mo = m * o;
    float a = dot(v, m * v);
    float b = 2.0 * (dot(v, mo) + dot(v, t2.xyz));
    float c = dot(o, mo) + 2.0 * dot(o, t2.xyz) + t1.w;
    if (a == 0.0) {
        float t = csg_ray_key(-c / b);
        return b > 0.0   ? csg_crossings(vec2(-CSG_KEY_MAX, t), true, true)
               : b < 0.0 ? csg_crossings(vec2(t, CSG_KEY_MAX), true, true)
                         : csg_crossings(vec2(0.0), c > 0.0, false);
    }
    float root = sqrt(max(b * b - 4.0 * a * c, 0.0));
    float k0 = csg_ray_key((-b - root) / (2.0 * a)), k1 = csg_ray_key((-b + root) / (2.0 * a));
    return csg_crossings(vec2(min(k0, k1), max(k0, k1)), a > 0.0, b * b - 4.0 * a * c >= 0.0);
}

/* Narrows a convex leaf, whose planes come before. Of two parts they leave the one that counts. */
void csg_clip_quadric(csg_crossings at, int face, inout csg_span span)
{
    if (at.between) {
        csg_enter(at.hit ? at.key.x : CSG_KEY_MAX, face, span);
        csg_leave(at.key.y, face, span);
    } else if (at.hit && at.key.x <= span.key.x) {
        csg_enter(at.key.y, face, span);
    } else if (at.hit) {
        csg_leave(at.key.x, face, span);
    }
}

/* A leaf that is not convex: what is taken out of its middle is returned. */
vec2 csg_gap_quadric(csg_crossings at, int face, inout csg_span span)
{
    if (at.between)
        csg_clip_quadric(at, face, span);
    return !at.between && at.hit ? at.key : vec2(CSG_KEY_MAX);
}
#endif
