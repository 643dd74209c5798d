/* SPDX-License-Identifier: MIT */
/*
 * What changes at k: membership just before and just after, and the literal that is responsible,
 * the one whose whole path to the root changes with it. Of several, one that is not subtracted;
 * of those, the first in the file.
 */

#define CSG_RANK_NEGATED 0x20000000
#define CSG_RANK_NONE 0x7fffffff

struct csg_change {
    bool before, after;
    int rank;     /* of the literal; CSG_RANK_NONE where nothing turns true */
    ivec2 place;  /* its record and face */
};

csg_change csg_literal(bvec2 around, int rank, ivec2 place)
{
    return csg_change(around.x, around.y, !around.x && around.y ? rank : CSG_RANK_NONE, place);
}

csg_change csg_choose(bool before, bool after, csg_change a, csg_change b)
{
    int rank = !before && after ? min(a.rank, b.rank) : CSG_RANK_NONE;
    return csg_change(before, after, rank, b.rank < a.rank ? b.place : a.place);
}

csg_change csg_all(csg_change a, csg_change b)
{
    return csg_choose(a.before && b.before, a.after && b.after, a, b);
}

csg_change csg_any(csg_change a, csg_change b)
{
    return csg_choose(a.before || b.before, a.after || b.after, a, b);
}
