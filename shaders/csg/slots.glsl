/* SPDX-License-Identifier: MIT */
/* Reads the records of a chain, slot by slot; csg/chain.glsl says what a slot is. */

vec4 csg_slot_plane(int p, bool has, float key)
{
    vec4 texel = csg_texel(p);
    return has ? texel : vec4(key, 0.0, 0.0, 0.0);
}

int csg_slot_number(vec4 plane, int place)
{
    return max(int(abs(plane.w)) - 1, 0) << (CSG_NORMALS_BITS * place);
}

/*
 * The record at p, p moves past it; beyond the last one, the complement of a solid that no ray
 * meets, in the first one's clause. head: flags, and where the normals are, as csg_normals_of has
 * it; of the planes only those have numbers that can show: entries, or exits of a complement.
 */
void csg_read_slot(inout int p, ivec2 object, out vec3 head, out vec4 e[CSG_SLOT_PLANES],
                   out vec4 x[CSG_SLOT_PLANES], out bool has_quadric)
{
#ifdef CSG_HAS_CLAUSES
    p += p < object.y && (int(csg_texel(p).z) & CSG_RECORD_POP) != 0 ? 1 : 0;
#endif
    bool has = p < object.y;
    int at = has ? p : object.x;
    vec4 record = csg_texel(at);
    int entries = has ? int(record.x) : 0, exits = has ? int(record.y) : 0;
    bool negated = !has || (int(record.z) & CSG_RECORD_NEGATED) != 0;
    int numbers = 0;
    for (int i = 0; i < CSG_SLOT_PLANES; i++) {
        e[i] = csg_slot_plane(at + 1 + i, entries > i, has ? -CSG_KEY_MAX : CSG_KEY_MAX);
        x[i] = csg_slot_plane(at + 1 + entries + i, exits > i, CSG_KEY_MAX);
        numbers |= csg_slot_number(negated ? x[i] : e[i], i);
    }
    int clause = int(record.z) / CSG_RECORD_CLAUSE * CSG_CHAIN_CLAUSE;
    head = vec3(float(clause + (negated ? CSG_CHAIN_NEGATED : 0)), record.w, float(numbers));
    has_quadric = has && (int(record.z) & CSG_RECORD_QUADRIC) != 0;
    p += has ? 1 + entries + exits : 0;
}

/* The quadric behind the planes of a record; where there is none, one that bounds nothing. */
void csg_read_slot_quadric(inout int p, bool has, inout vec3 head, out vec4 q0, out vec4 q1,
                           out vec4 q2)
{
    q0 = has ? csg_texel(p) : vec4(-CSG_KEY_MAX, 0.0, 0.0, float(CSG_QUADRIC_AFTER));
    q1 = has ? csg_texel(p + 1) : vec4(0.0);
    q2 = has ? csg_texel(p + 2) : vec4(0.0);
    head.x += q0.w;
    p += has ? CSG_QUADRIC_TEXELS : 0;
}

vec3 csg_slot_color(vec3 head)
{
    return csg_texel(4 * int(head.y) + CSG_ATTRIBUTE_COLOR).rgb;
}

/* What the normal of the quadric, if there is one, gains with the pixel and the key. */
void csg_read_slot_normal(vec3 head, out vec3 u, out vec3 v, out vec3 w)
{
    int place = 4 * int(head.y) + CSG_ATTRIBUTE_NORMALS;
    u = csg_texel(place + 1).xyz;
    v = csg_texel(place + 2).xyz;
    w = csg_texel(place + 3).xyz;
}
