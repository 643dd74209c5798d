/* SPDX-License-Identifier: MIT */
/*
 * Surfaces of triangles, from the lists that src/pack/surface_record.c makes. A face is met as
 * often as its edges cross the half-line from the pixel's centre to the right. An edge is asked
 * with the same numbers for both faces that share it, so what it says to one is taken back by the
 * other and the turns of a closed surface add up to zero at every pixel.
 */

struct csg_surface {
    int before, after; /* turns of the surface before k and behind it */
    csg_real next;     /* the first key behind k where a face is met; CSG_NEVER */
    ivec2 face;        /* at k: places of normals, where rays enter and leave by their turns */
};

int csg_edge_turns(vec4 edge, vec2 d)
{
    bool from = edge.x <= d.y, to = edge.y <= d.y;
    csg_exact float x = edge.z + edge.w * (d.y - min(edge.x, edge.y));
    return from != to && d.x < x ? (from ? 1 : -1) : 0;
}

void csg_meet_face(csg_real4 plane, vec2 d, csg_real k, int turns, inout csg_surface surface)
{
    csg_real key = csg_plane(plane, d);
    int face = int(abs(plane.w));
    surface.before += key < k ? turns : 0;
    surface.after += key <= k ? turns : 0;
    surface.next = key > k && turns != 0 ? min(surface.next, key) : surface.next;
    surface.face.x = key == k && turns > 0 ? face : surface.face.x;
    surface.face.y = key == k && turns < 0 ? face : surface.face.y;
}

/* The list of a pixel's cell: texels [begin, covers) of faces that cover it, then [covers, cuts) of
 * faces that cut it; and the pixel as edges count it. */
struct csg_list {
    int begin, covers, cuts;
    vec2 at;
};

csg_list csg_surface_list(int p, vec2 d)
{
    vec4 grid = csg_texel(p + 1);
    vec2 at = d - grid.xy;
    ivec2 place = ivec2(at * grid.z);
    vec4 cell = csg_texel(p + CSG_SURFACE_CELLS + place.y * int(grid.w) + place.x);
    int begin = p + int(cell.x), covers = begin + CSG_TERM_TEXELS * int(cell.y);
    return csg_list(begin, covers,
                    covers + (CSG_TERM_TEXELS + CSG_SURFACE_EDGES) * int(cell.z), at);
}

/* Turns of the face whose edges begin at texel p. */
int csg_face_turns(int p, vec2 at)
{
    return csg_edge_turns(csg_texel(p), at) + csg_edge_turns(csg_texel(p + 1), at) +
           csg_edge_turns(csg_texel(p + 2), at);
}

/* The surface whose record is at p, around k. */
csg_surface csg_surface_at(int p, vec2 d, csg_real k)
{
    int turns = int(csg_texel(p + 2).x);
    csg_surface surface = csg_surface(turns, turns, CSG_NEVER, ivec2(0));
    csg_list list = csg_surface_list(p, d);
    int i = list.begin;
    for (; i < list.covers; i += CSG_TERM_TEXELS) {
        csg_real4 plane = csg_term(i, 0);
        csg_meet_face(plane, d, k, plane.w < 0.0 ? -1 : 1, surface);
    }
    for (; i < list.cuts; i += CSG_TERM_TEXELS + CSG_SURFACE_EDGES)
        csg_meet_face(csg_term(i, 0), d, k, csg_face_turns(i + CSG_TERM_TEXELS, list.at), surface);
    return surface;
}

/* What a surface does where a ray next meets it. */
struct csg_surface_first {
    csg_real key;
    int turns;  /* of all faces there; 0: they cancel */
    ivec2 face; /* places of normals, where rays enter and leave by their turns */
};

void csg_meet_first(csg_real4 plane, vec2 d, csg_real k, int turns, inout csg_surface_first first)
{
    csg_real key = csg_plane(plane, d);
    int face = int(abs(plane.w));
    bool counts = turns != 0 && key > k && key <= first.key;
    bool sooner = counts && key < first.key;
    first.turns = (sooner ? 0 : first.turns) + (counts ? turns : 0);
    first.face.x = counts && turns > 0 ? face : first.face.x;
    first.face.y = counts && turns < 0 ? face : first.face.y;
    first.key = counts ? key : first.key;
}

/* Where behind k the ray meets the surface whose record is at p. */
csg_surface_first csg_surface_behind(int p, vec2 d, csg_real k)
{
    csg_surface_first first = csg_surface_first(CSG_NEVER, 0, ivec2(0));
    csg_list list = csg_surface_list(p, d);
    int i = list.begin;
    for (; i < list.covers; i += CSG_TERM_TEXELS) {
        csg_real4 plane = csg_term(i, 0);
        csg_meet_first(plane, d, k, plane.w < 0.0 ? -1 : 1, first);
    }
    for (; i < list.cuts; i += CSG_TERM_TEXELS + CSG_SURFACE_EDGES)
        csg_meet_first(csg_term(i, 0), d, k, csg_face_turns(i + CSG_TERM_TEXELS, list.at), first);
    return first;
}

/* As csg_inside and csg_outside: where, at k or later, can the literal be true at the soonest? */
csg_real csg_surface_next(int p, vec2 d, csg_real k, bool negated)
{
    csg_surface surface = csg_surface_at(p, d, k);
    return (surface.after != 0) != negated ? k : surface.next;
}

/* Membership just before and after k, and the place of the normal of a face there. */
bvec2 csg_surface_around(int p, vec2 d, csg_real k, out int face)
{
    csg_surface surface = csg_surface_at(p, d, k);
    bool enters = surface.after > surface.before;
    face = enters ? surface.face.x : surface.face.y;
    return bvec2(surface.before != 0, surface.after != 0);
}
