/* SPDX-License-Identifier: MIT */
/*
 * Literals along the ray. A leaf is true on [key.x, key.y) less [gap.x, gap.y). The functions
 * answer: where, at k or later, is the literal true at the soonest? With min for a union and max
 * for an intersection that becomes the same question for the whole tree, a bound that
 * csg_resolve iterates to the first true point: interval jumping, for any tree
 * (docs/pipeline.md). Ends are half-open, so crossings at the same k are one event and an
 * interval without length does not exist.
 */

#define CSG_NEVER (2.0 * CSG_KEY_MAX)

csg_real csg_inside(csg_real k, csg_real2 span)
{
    return k < span.y ? max(k, span.x) : CSG_NEVER;
}

csg_real csg_outside(csg_real k, csg_real2 span)
{
    return k < span.x ? k : max(k, span.y);
}

csg_real csg_inside_gap(csg_real k, csg_real2 span, csg_real2 gap)
{
    csg_real at = csg_outside(max(k, span.x), gap);
    return at < span.y ? at : CSG_NEVER;
}

csg_real csg_outside_gap(csg_real k, csg_real2 span, csg_real2 gap)
{
    if (k < span.x || k >= span.y || (k >= gap.x && k < gap.y))
        return k;
    return k < gap.x ? min(gap.x, span.y) : span.y;
}

/* The face at k of a leaf that the ray enters or leaves there. A gap's ends are on the quadric. */
int csg_face_at(csg_real k, csg_span span, bool enters)
{
    return enters ? span.face.x : span.face.y;
}

int csg_face_at_gap(csg_real k, csg_span span, csg_real2 gap, int quadric, bool enters)
{
    return k == (enters ? gap.y : gap.x) ? quadric : csg_face_at(k, span, enters);
}

/* Whether a leaf that is inside just after k was not so before, and one that is outside. */
bool csg_begins(csg_real k, csg_real2 span)
{
    return k == span.x;
}

bool csg_ends(csg_real k, csg_real2 span)
{
    return k == span.y && span.x < k;
}

/* Membership just before (x) and just after (y) k. */
bvec2 csg_around(csg_real k, csg_real2 span)
{
    return bvec2(span.x < k && k <= span.y, span.x <= k && k < span.y);
}

bvec2 csg_around_gap(csg_real k, csg_real2 span, csg_real2 gap)
{
    bvec2 outer = csg_around(k, span), inner = csg_around(k, gap);
    return bvec2(outer.x && !inner.x, outer.y && !inner.y);
}
