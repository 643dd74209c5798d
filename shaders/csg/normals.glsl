/* SPDX-License-Identifier: MIT */
/* Where the normals of a leaf's faces are, for programs that know its record: its attribute block
 * and, some bits each, the numbers of its planes' normals, together no more than float holds. Its
 * quadric, behind them, has number 0. */

#ifdef CSG_IS_CHAIN
#define CSG_NORMALS_BITS 6 /* four planes, whose numbers are less than 64 */
#else
#define CSG_NORMALS_BITS 4 /* six planes, less than 16 */
#endif

/* By the vertex stage, from the record. */
vec2 csg_normals_of(int record, int num_planes)
{
    int numbers = 0;
    for (int i = 0; i < num_planes; i++)
        numbers |= (int(abs(csg_texel(record + 1 + i).w)) - 1) << (CSG_NORMALS_BITS * i);
    return vec2(csg_texel(record).w, float(numbers));
}

/* The normal's place of the face at that place in the record: of the first, and from there. */
ivec2 csg_normal_at(vec2 normals, int face)
{
    return ivec2(int(normals.x) * 4 + CSG_ATTRIBUTE_NORMALS,
                 int(normals.y) >> (CSG_NORMALS_BITS * face) & ((1 << CSG_NORMALS_BITS) - 1));
}
