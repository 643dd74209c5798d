/* SPDX-License-Identifier: MIT */
/*
 * Stacks of rings, from the lists that src/tile/bands.c makes. Where a band of a cone is crossed is
 * decided by the circles in which it ends, and they are asked with the same numbers for both bands
 * that end there. Keys are kept between those of the band's planes, so that rays leave a stack as
 * often as they enter it, and in turn.
 */

struct csg_bands {
    bool before, after; /* inside just before k, and behind it */
    csg_real next;      /* the first key behind k where a band is crossed; CSG_NEVER */
    int band;           /* crossed at k: place of its head, from the record */
};

bool csg_is_in_circle(csg_real3 c, csg_real3 cc, vec2 at)
{
    csg_exact csg_real sum = c.x + (c.y * at.x + c.z * at.y) +
                             (cc.x * at.x * at.x + cc.y * at.x * at.y + cc.z * at.y * at.y);
    return sum < 0.0;
}

/* Whether the ray passes inside of the circles of the band whose head is at p. */
bvec2 csg_band_circles(int p, vec2 at)
{
    csg_real4 c0 = csg_term(p + 1, 0), c1 = csg_term(p + 1, 1), c2 = csg_term(p + 1, 2);
    return bvec2(csg_is_in_circle(c0.xyz, csg_real3(c0.w, c1.xy), at),
                 csg_is_in_circle(csg_real3(c1.zw, c2.x), c2.yzw, at));
}

void csg_cross_band(csg_real key, bool crosses, csg_real k, int band, inout csg_bands bands)
{
    bands.before = bands.before != (crosses && key < k);
    bands.after = bands.after != (crosses && key <= k);
    bands.next = crosses && key > k ? min(bands.next, key) : bands.next;
    bands.band = crosses && key == k ? band : bands.band;
}

/* The two crossings of a band of a cone, and whether the ray has them. */
csg_real2 csg_band_crossings(int p, vec2 d, vec2 at, out bvec2 crosses)
{
    int code = int(csg_texel(p).x), terms = p + 1 + CSG_BAND_CONICS * CSG_TERM_TEXELS;
    bvec2 circles = csg_band_circles(p, at);
    csg_real first = csg_plane(csg_term(terms, 0), d), second = csg_plane(csg_term(terms, 1), d);
    bool within = (code & CSG_BAND_WITHIN) != 0, by_first = within && first < second;
    csg_real from = within ? -CSG_KEY_MAX : first, to = by_first ? first : second;
    bool starts = within ? (code & CSG_BAND_INSIDE) != 0 : circles.x;
    bool ends = by_first ? circles.x : circles.y;
    int quadric = terms + 2 * CSG_TERM_TEXELS;
    csg_crossings cone =
        csg_quadric(csg_term(quadric, 0), csg_term(quadric, 1), csg_term(quadric, 2), d);
#ifdef CSG_HAS_STIFF
    if ((cone.code & CSG_QUADRIC_STIFF) != 0)
        cone.key = csg_stiff_quadric(quadric, d);
#endif
    int region = cone.code & 3;
    csg_real entry = region == CSG_QUADRIC_AFTER ? cone.key.y : cone.key.x;
    csg_real exit = region == CSG_QUADRIC_BEFORE ? cone.key.x : cone.key.y;
    bool bulges = !starts && !ends && region == CSG_QUADRIC_BETWEEN && cone.hit && entry > from &&
                  exit < to;
    crosses = bvec2(bulges || (!starts && ends), bulges || (starts && !ends));
    return csg_real2(min(max(entry, from), to), min(max(exit, from), to));
}

/* The stack whose record is at p, around k. */
csg_bands csg_bands_at(int p, vec2 d, csg_real k)
{
    vec4 start = csg_texel(p + CSG_BAND_START);
    vec2 at = d - csg_texel(p + CSG_BAND_PLACE).xy;
    int begin = p + CSG_BAND_FIRST;
    int num_flat = int(start.z), num_curved = int(start.w) - num_flat;
    int planes = 1 + CSG_BAND_CONICS * CSG_TERM_TEXELS, flats = planes + CSG_TERM_TEXELS;
#ifdef CSG_HAS_STIFF
    int curved = planes + (2 + CSG_QUADRIC_TEXELS) * CSG_TERM_TEXELS;
#else
    int curved = planes + 5 * CSG_TERM_TEXELS;
#endif
    csg_bands bands = csg_bands(start.x != 0.0, start.x != 0.0, CSG_NEVER, CSG_BAND_FIRST);
    for (int i = 0; i < num_flat; i++) {
        int band = begin + i * flats;
        bvec2 circles = csg_band_circles(band, at);
        csg_cross_band(csg_plane(csg_term(band + planes, 0), d), circles.x != circles.y, k,
                       band - p, bands);
    }
    begin += num_flat * flats;
    for (int i = 0; i < num_curved; i++) {
        int band = begin + i * curved;
        bvec2 crosses;
        csg_real2 keys = csg_band_crossings(band, d, at, crosses);
        csg_cross_band(keys.x, crosses.x, k, band - p, bands);
        csg_cross_band(keys.y, crosses.y, k, band - p, bands);
    }
    return bands;
}

/* As csg_inside and csg_outside: where, at k or later, can the literal be true at the soonest? */
csg_real csg_bands_next(int p, vec2 d, csg_real k, bool negated)
{
    csg_bands bands = csg_bands_at(p, d, k);
    return bands.after != negated ? k : bands.next;
}

/* Membership just before and after k, and the place of a band there. */
bvec2 csg_bands_around(int p, vec2 d, csg_real k, out int band)
{
    csg_bands bands = csg_bands_at(p, d, k);
    band = bands.band;
    return bvec2(bands.before, bands.after);
}

/* Of a band, head is the texel at its place: its leaf's attribute block, and the face's normal. */
int csg_band_block(vec4 head)
{
    return int(head.y);
}

int csg_band_normal(vec4 head)
{
    return int(head.y) * 4 + CSG_ATTRIBUTE_NORMALS + int(head.z);
}
