/* SPDX-License-Identifier: MIT */
/*
 * A cell that is an intersection of literals, in bunches (src/cells/bunch.h): so many faces, so
 * many quadrics, and the literals between them. A literal is a set of bits, the surfaces that it
 * has to be inside of. All keys of a bunch are found once and stay in registers; then the ray goes
 * from key to key until all literals hold. Those of the other bunches are asked there, until none
 * moves the ray.
 */

#ifdef CSG_HAS_QUADRIC
#define CSG_BUNCH_PLANES CSG_BUNCH_FEW_PLANES
#define CSG_BUNCH_MASKS (CSG_BUNCH_PLANES / 4 + 1)
#else
#define CSG_BUNCH_PLANES CSG_BUNCH_MANY_PLANES
#define CSG_BUNCH_MASKS (CSG_BUNCH_PLANES / 4)
#endif
#define CSG_BUNCH_PLACES (CSG_BUNCH_MASKS + CSG_BUNCH_LITERALS / 4)
#define CSG_BUNCH_SIZE (CSG_BUNCH_PLACES + CSG_BUNCH_LITERALS / 4)

struct csg_bunch {
    vec4 keys[CSG_BUNCH_PLANES / 4];
    int exits; /* planes by which rays leave, by bit */
#ifdef CSG_HAS_QUADRIC
    vec4 enters, leaves; /* of the quadrics */
#endif
    ivec4 masks[CSG_BUNCH_LITERALS / 4];
    bvec4 negated[CSG_BUNCH_LITERALS / 4];
};

int csg_bunch_bits(bvec4 set, int first)
{
    ivec4 bits = ivec4(set) * (ivec4(1, 2, 4, 8) << first);
    return (bits.x | bits.y) | (bits.z | bits.w);
}

#ifdef CSG_HAS_QUADRIC
/* Where a ray is inside of the quadric behind the planes of the leaf at place. */
vec2 csg_bunch_quadric(int p, vec2 d)
{
    csg_span span = csg_whole_ray();
    csg_crossings at = csg_quadric(csg_texel(p), csg_texel(p + 1), csg_texel(p + 2), d);
#ifdef CSG_HAS_STIFF
    if ((at.code & CSG_QUADRIC_STIFF) != 0)
        at.key = csg_stiff_quadric(p, d);
#endif
    csg_clip_quadric(at, 0, span);
    return span.key;
}
#endif

csg_bunch csg_bunch_read(int p, int terms, vec2 d)
{
    csg_bunch bunch;
    bunch.exits = 0;
    for (int i = 0; i < CSG_BUNCH_PLANES / 4; i++) {
        ivec4 places = terms + ivec4(csg_cell_texel(p + i));
        vec4 a = csg_texel(places.x), b = csg_texel(places.y);
        vec4 e = csg_texel(places.z), f = csg_texel(places.w);
        bunch.keys[i] =
            vec4(csg_plane(a, d), csg_plane(b, d), csg_plane(e, d), csg_plane(f, d));
        bunch.exits |= csg_bunch_bits(lessThan(vec4(a.w, b.w, e.w, f.w), vec4(0.0)), 4 * i);
    }
#ifdef CSG_HAS_QUADRIC
    ivec4 places = terms + ivec4(csg_cell_texel(p + CSG_BUNCH_PLANES / 4));
    vec2 a = csg_bunch_quadric(places.x, d), b = csg_bunch_quadric(places.y, d);
    vec2 e = csg_bunch_quadric(places.z, d), f = csg_bunch_quadric(places.w, d);
    bunch.enters = vec4(a.x, b.x, e.x, f.x);
    bunch.leaves = vec4(a.y, b.y, e.y, f.y);
#endif
    for (int i = 0; i < CSG_BUNCH_LITERALS / 4; i++) {
        ivec4 masks = ivec4(csg_cell_texel(p + CSG_BUNCH_MASKS + i));
        bunch.negated[i] = greaterThanEqual(masks, ivec4(CSG_BUNCH_NEGATED));
        bunch.masks[i] = masks & (CSG_BUNCH_NEGATED - 1);
    }
    return bunch;
}

/* The surfaces that the ray is inside of just behind k. */
int csg_bunch_after(csg_bunch bunch, float k)
{
    int bits = 0;
    for (int i = 0; i < CSG_BUNCH_PLANES / 4; i++)
        bits |= csg_bunch_bits(lessThanEqual(bunch.keys[i], vec4(k)), 4 * i);
    bits ^= bunch.exits;
#ifdef CSG_HAS_QUADRIC
    bits |= csg_bunch_bits(lessThanEqual(bunch.enters, vec4(k)), CSG_BUNCH_PLANES) &
            csg_bunch_bits(lessThan(vec4(k), bunch.leaves), CSG_BUNCH_PLANES);
#endif
    return bits;
}

/* The same just before k. */
int csg_bunch_before(csg_bunch bunch, float k)
{
    int bits = 0;
    for (int i = 0; i < CSG_BUNCH_PLANES / 4; i++)
        bits |= csg_bunch_bits(lessThan(bunch.keys[i], vec4(k)), 4 * i);
    bits ^= bunch.exits;
#ifdef CSG_HAS_QUADRIC
    bits |= csg_bunch_bits(lessThan(bunch.enters, vec4(k)), CSG_BUNCH_PLANES) &
            csg_bunch_bits(lessThanEqual(vec4(k), bunch.leaves), CSG_BUNCH_PLANES);
#endif
    return bits;
}

/* Literals that do not hold where the ray is inside of these surfaces, by bit. */
int csg_bunch_failing(csg_bunch bunch, int inside)
{
    int failing = 0;
    for (int i = 0; i < CSG_BUNCH_LITERALS / 4; i++) {
        bvec4 outside = notEqual(bunch.masks[i] & inside, bunch.masks[i]);
        failing |= csg_bunch_bits(notEqual(outside, bunch.negated[i]), 4 * i);
    }
    return failing;
}

/* The lowest of some bits: of a power of two the exponent as a float has it. */
int csg_bunch_lowest(int bits)
{
    return (floatBitsToInt(float(bits & -bits)) >> 23) - 127;
}

vec4 csg_bunch_behind(vec4 keys, float k, vec4 least)
{
    return min(mix(vec4(CSG_NEVER), keys, greaterThan(keys, vec4(k))), least);
}

/* The next key behind k. */
float csg_bunch_next(csg_bunch bunch, float k)
{
    vec4 least = vec4(CSG_NEVER);
    for (int i = 0; i < CSG_BUNCH_PLANES / 4; i++)
        least = csg_bunch_behind(bunch.keys[i], k, least);
#ifdef CSG_HAS_QUADRIC
    least = csg_bunch_behind(bunch.leaves, k, csg_bunch_behind(bunch.enters, k, least));
#endif
    return min(least.x, min(least.y, min(least.z, least.w)));
}

/*
 * The cell of bunches [begin, end): moves k to where all literals hold, or to last. place: which
 * literal has begun to hold there, for csg_cell_face: of several the first, they are in that order.
 */
bool csg_cell_search(int begin, int end, int terms, vec2 d, float last, inout float k,
                     inout ivec2 place)
{
    int p = begin, left = end - begin; /* texels of the bunches that have not been asked at k */
    int first = end;                   /* the bunch with the literal */
    while (left > 0 && k < last && csg_walk_turns < CSG_MAX_WALK_TURNS) {
        csg_bunch bunch = csg_bunch_read(p, terms, d);
        int failing = csg_bunch_failing(bunch, csg_bunch_after(bunch, k));
        csg_walk_turns += 2;
        while (failing != 0 && k < last) {
            k = csg_bunch_next(bunch, k);
            failing = csg_bunch_failing(bunch, csg_bunch_after(bunch, k));
            left = end - begin;
            first = end;
            csg_walk_turns++;
        }
        int begun = csg_bunch_failing(bunch, csg_bunch_before(bunch, k));
        if (begun != 0 && p <= first) {
            first = p;
            place.x = 4 * (p + CSG_BUNCH_PLACES) + csg_bunch_lowest(begun);
        }
        left -= CSG_BUNCH_SIZE;
        p = p + CSG_BUNCH_SIZE < end ? p + CSG_BUNCH_SIZE : begin;
    }
    k = min(k, last);
    return left <= 0 && k < last;
}

/* The leaf and the face by which the ray enters what place names, at the key that was found. */
ivec2 csg_cell_face(ivec2 place, int terms, vec2 d)
{
    vec4 literals = csg_cell_texel(place.x >> 2);
    int i = place.x & 3;
    int literal = int(i == 0 ? literals.x : i == 1 ? literals.y : i == 2 ? literals.z : literals.w);
    int leaf = terms + abs(literal) - 1;
    csg_span span = csg_whole_ray();
    vec4 head = csg_texel(leaf);
    int num = int(head.x);
    for (int face = 0; face < num; face += 2) {
        int other = min(face + 1, num - 1);
        csg_cell_plane(csg_texel(leaf + 1 + face), d, face, span);
        csg_cell_plane(csg_texel(leaf + 1 + other), d, other, span);
    }
#ifdef CSG_HAS_QUADRIC
    if ((int(head.z) & CSG_RECORD_QUADRIC) != 0) {
        vec2 key = csg_bunch_quadric(leaf + 1 + num, d);
        csg_enter(key.x, num, span);
        csg_leave(key.y, num, span);
    }
#endif
    return ivec2(leaf, literal > 0 ? span.face.x : span.face.y);
}
