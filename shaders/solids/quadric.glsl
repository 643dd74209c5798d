/* SPDX-License-Identifier: MIT */
/* Quadrics: crossings from an affine term and a conic. Twin of src/pack/quadric.c. */

struct csg_crossings {
    csg_real2 key; /* key.x <= key.y */
    int code;      /* CSG_QUADRIC_..., see layout.glsl */
    bool hit;
};

/* What both forms of the crossings start from: m or b, and the conic at its principal axes. */
struct csg_terms {
    csg_real m, x, y, h;
};

csg_terms csg_quadric_terms(csg_real4 t0, csg_real4 t1, csg_real4 t2, vec2 d)
{
    int code = int(t0.w);
    csg_exact csg_real m = t0.x + (t0.y * d.x + t0.z * d.y);
    csg_exact csg_real x = t1.x + (t1.y * d.x + t1.z * d.y);
    csg_exact csg_real y = t2.x + (t1.y * d.y - t1.z * d.x);
    csg_real xx = (code & CSG_QUADRIC_X_MINUS) != 0  ? -x
                  : (code & CSG_QUADRIC_X_PLUS) != 0 ? x
                                                     : 0.0;
    csg_exact csg_real h = (t1.w + y * (t2.z + y * t2.w)) + x * (t2.y + xx);
    return csg_terms(m, x, y, h);
}

/* From the quadric's first three texels: right unless its code says CSG_QUADRIC_STIFF. */
csg_crossings csg_quadric(csg_real4 t0, csg_real4 t1, csg_real4 t2, vec2 d)
{
    csg_terms terms = csg_quadric_terms(t0, t1, t2, d);
    csg_real root = sqrt(max(terms.h, 0.0));
    return csg_crossings(csg_real2(terms.m - root, terms.m + root), int(t0.w), terms.h >= 0.0);
}

/* The crossings of the quadric at texel p in the form that does not divide by a. */
csg_real2 csg_stiff_quadric(int p, vec2 d)
{
    csg_terms terms = csg_quadric_terms(csg_term(p, 0), csg_term(p, 1), csg_term(p, 2), d);
    csg_real4 t3 = csg_term(p, 3), t4 = csg_term(p, 4);
    csg_real x = terms.x, y = terms.y, root = sqrt(max(terms.h, 0.0));
    csg_exact csg_real c = t3.x + x * (t3.y + t4.x * x + t4.y * y) + y * (t3.z + t4.z * y);
    csg_real q = terms.m < 0.0 ? root - terms.m : -root - terms.m; /* never cancels */
    csg_real k0 = clamp(q * t3.w, -CSG_KEY_MAX, CSG_KEY_MAX);
    csg_real k1 = clamp(c / (q != 0.0 ? q : 1e-30), -CSG_KEY_MAX, CSG_KEY_MAX);
    return csg_real2(min(k0, k1), max(k0, k1));
}

/* Narrows a convex leaf by its quadric, which is face number face. */
void csg_clip_quadric(csg_crossings at, int face, inout csg_span span)
{
    int region = at.code & 3;
    csg_real entry = region == CSG_QUADRIC_BETWEEN ? (at.hit ? at.key.x : CSG_KEY_MAX)
                  : region == CSG_QUADRIC_AFTER ? at.key.y
                                                : -CSG_KEY_MAX;
    csg_real exit = region == CSG_QUADRIC_BETWEEN  ? at.key.y
                 : region == CSG_QUADRIC_BEFORE ? at.key.x
                                                : CSG_KEY_MAX;
    csg_enter(entry, face, span);
    csg_leave(exit, face, span);
}

/* The same for a leaf that is not convex: what is taken out of its middle is returned. */
csg_real2 csg_gap_quadric(csg_crossings at, int face, inout csg_span span)
{
    bool between = (at.code & 3) == CSG_QUADRIC_BETWEEN;
    csg_enter(!between ? -CSG_KEY_MAX : at.hit ? at.key.x : CSG_KEY_MAX, face, span);
    csg_leave(between ? at.key.y : CSG_KEY_MAX, face, span);
    return !between && at.hit ? at.key : csg_real2(CSG_KEY_MAX);
}
