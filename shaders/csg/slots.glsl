/* SPDX-License-Identifier: MIT */
/* Reads the records of a chain, slot by slot; csg/chain.glsl says what a slot is. */

vec4 csg_slot_plane(int p, bool has, float key)
{
    vec4 texel = csg_texel(p);
    return has ? texel : vec4(key, 0.0, 0.0, 0.0);
}

/* The record at p, p moves past it; beyond the last one, a solid that no ray meets. */
void csg_read_slot(inout int p, ivec2 object, out vec4 head, out vec4 e0, out vec4 e1, out vec4 x0,
                   out vec4 x1)
{
    bool has = p < object.y;
    int at = has ? p : object.x;
    vec4 record = csg_texel(at);
    int entries = has ? int(record.x) : 0, exits = has ? int(record.y) : 0;
    head = vec4(has ? record.z : 0.0, float(at - object.x), float(entries), float(entries + exits));
    e0 = csg_slot_plane(at + 1, entries > 0, has ? -CSG_KEY_MAX : CSG_KEY_MAX);
    e1 = csg_slot_plane(at + 2, entries > 1, -CSG_KEY_MAX);
    x0 = csg_slot_plane(at + 1 + entries, exits > 0, CSG_KEY_MAX);
    x1 = csg_slot_plane(at + 2 + entries, exits > 1, CSG_KEY_MAX);
    e0.w = csg_texel(int(record.w) * 4 + CSG_ATTRIBUTE_LEAF).x;
    p += has ? 1 + entries + exits : 0;
}

/* The quadric behind the planes of a record; where there is none, one that bounds nothing. */
void csg_read_slot_quadric(inout int p, vec4 head, out vec4 q0, out vec4 q1, out vec4 q2)
{
    bool has = (int(head.x) & CSG_RECORD_QUADRIC) != 0;
    q0 = has ? csg_texel(p) : vec4(-CSG_KEY_MAX, 0.0, 0.0, float(CSG_QUADRIC_AFTER));
    q1 = has ? csg_texel(p + 1) : vec4(0.0);
    q2 = has ? csg_texel(p + 2) : vec4(0.0);
    p += has ? CSG_QUADRIC_TEXELS : 0;
}
