/* SPDX-License-Identifier: MIT */
/* Which face is visible in a pixel, and at what key. csg_resolve is the variant's. */

flat in ivec3 csg_object; /* begin, end in the data texture; turns of a look, see csg/turns.glsl */

void main()
{
    csg_real k;
    ivec2 place;
    bool inside;
    vec2 d = csg_pixel();
    bool shows = csg_resolve(csg_object, d, k, place, inside);
#ifdef CSG_SHARED
    shows = shows && !csg_is_no_number(vec4(csg_object, 0.0));
#endif
    if (!shows)
        discard;
#ifdef CSG_CAN_GIVE_UP
    if (csg_has_given_up(csg_object.z)) {
        csg_show_unfinished();
        gl_FragDepth = 0.0;
        return;
    }
#endif
#ifdef CSG_KNOWS_NORMALS
    int normal = place.x + place.y;
#else
    vec4 head = csg_texel(place.x);
    bool plane = place.y < int(head.x) + int(head.y);
#ifdef CSG_TEXTBOOK
    int first = (int(head.z) & CSG_RECORD_QUADRIC) != 0 ? CSG_NORMAL_TERMS : 0;
    int face = plane ? first + place.y : 0;
#else
    int face = plane ? int(abs(csg_texel(place.x + 1 + place.y * CSG_TERM_TEXELS).w)) - 1 : 0;
#endif
    int normal = int(head.w) * 4 + CSG_ATTRIBUTE_NORMALS + face;
#ifdef CSG_HAS_SURFACE
    if ((int(head.z) & CSG_RECORD_SURFACE) != 0)
        normal = place.x + place.y;
#endif
#ifdef CSG_HAS_BANDS
    if ((int(head.z) & CSG_RECORD_BANDS) != 0) {
        vec4 band = csg_texel(place.x + place.y);
        plane = band.z != 0.0;
        normal = csg_band_normal(band);
    }
#endif
#endif
    gl_FragDepth = csg_depth(k) - csg_screen_place.z;
#ifdef CSG_DOUBLE
    if (!plane) /* written from near it, so that float keeps it */
        k -= csg_texel(normal + 1).w + (d.x * double(csg_texel(normal + 2).w) +
                                        d.y * double(csg_texel(normal + 3).w));
#endif
    csg_show(d, float(k), normal);
}
