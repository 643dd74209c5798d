/* SPDX-License-Identifier: MIT */
/* Where the normals of a leaf's faces are, for programs that know its record: its attribute block and,
 * four bits each, the numbers of its planes' normals. Its quadric, behind them, has number 0. */

#define CSG_NORMALS_MAX_PLANES 6 /* 24 bits, which float holds */

/* By the vertex stage, from the record. */
vec2 csg_normals_of(int record, int num_planes)
{
    int numbers = 0;
    for (int i = 0; i < num_planes; i++)
        numbers |= (int(abs(csg_texel(record + 1 + i).w)) - 1) << (4 * i);
    return vec2(csg_texel(record).w, float(numbers));
}

/* The normal's place of the face at that place in the record: of the first, and from there. */
ivec2 csg_normal_at(vec2 normals, int face)
{
    return ivec2(int(normals.x) * 4 + CSG_ATTRIBUTE_NORMALS, int(normals.y) >> (4 * face) & 15);
}
