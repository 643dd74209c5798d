/* SPDX-License-Identifier: MIT */
/* Quadrics: crossings from an affine term and a conic. Twin of src/pack/quadric.c. */

/*
 * The crossings k.x <= k.y; false when the ray has none. t0 t1 t2 are the quadric's first texels,
 * p the place of the first; code: see layout.glsl.
 */
bool csg_quadric(vec4 t0, vec4 t1, vec4 t2, int p, vec2 d, out vec2 k, out int code)
{
    code = int(t0.w);
    float m = t0.x + (t0.y * d.x + t0.z * d.y);
    float x = t1.x + (t1.y * d.x + t1.z * d.y);
    float y = t2.x + (t2.y * d.x + t2.z * d.y);
    float xx = (code & CSG_QUADRIC_X_MINUS) != 0 ? -x : (code & CSG_QUADRIC_X_PLUS) != 0 ? x : 0.0;
    float yy = (code & CSG_QUADRIC_Y_MINUS) != 0 ? -y : (code & CSG_QUADRIC_Y_PLUS) != 0 ? y : 0.0;
    float h = (t1.w + y * (t2.w + yy)) + x * xx;
    float root = sqrt(max(h, 0.0));
    k = vec2(m - root, m + root);
    /* A loop, since llvmpipe skips those and runs both sides of a branch. */
    for (int stiff = code & CSG_QUADRIC_STIFF; stiff != 0; stiff = 0) {
        vec4 t3 = csg_texel(p + 3), t4 = csg_texel(p + 4);
        float c = t3.x + x * (t3.y + t4.x * x + t4.y * y) + y * (t3.z + t4.z * y);
        float q = m < 0.0 ? root - m : -root - m; /* -(b + sign(b) sqrt(S)), never cancels */
        float k0 = clamp(q * t3.w, -CSG_KEY_MAX, CSG_KEY_MAX);
        float k1 = clamp(c / (q != 0.0 ? q : 1e-30), -CSG_KEY_MAX, CSG_KEY_MAX);
        k = vec2(min(k0, k1), max(k0, k1));
    }
    return h >= 0.0;
}

/* Narrows a convex leaf by its quadric, its face number face. */
void csg_clip_quadric(vec4 t0, vec4 t1, vec4 t2, int p, vec2 d, int face, inout csg_span span)
{
    vec2 k;
    int code;
    bool hit = csg_quadric(t0, t1, t2, p, d, k, code);
    int region = code & 3;
    float entry = region == CSG_QUADRIC_BETWEEN ? (hit ? k.x : CSG_KEY_MAX)
                  : region == CSG_QUADRIC_AFTER ? k.y
                                                : -CSG_KEY_MAX;
    float exit = region == CSG_QUADRIC_BETWEEN  ? k.y
                 : region == CSG_QUADRIC_BEFORE ? k.x
                                                : CSG_KEY_MAX;
    csg_enter(entry, face, span);
    csg_leave(exit, face, span);
}

/* The same for a leaf that is not convex: what is taken out of its middle comes back as gap. */
void csg_gap_quadric(vec4 t0, vec4 t1, vec4 t2, int p, vec2 d, int face, inout csg_span span,
                     out vec2 gap)
{
    vec2 k;
    int code;
    bool hit = csg_quadric(t0, t1, t2, p, d, k, code);
    bool between = (code & 3) == CSG_QUADRIC_BETWEEN;
    gap = !between && hit ? k : vec2(CSG_KEY_MAX);
    csg_enter(!between ? -CSG_KEY_MAX : hit ? k.x : CSG_KEY_MAX, face, span);
    csg_leave(between ? k.y : CSG_KEY_MAX, face, span);
}
