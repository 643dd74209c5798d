/* SPDX-License-Identifier: MIT */
/* What C and GLSL must agree on: plain #defines, included by both. */

/* Keys beyond any crossing in view, far inside the range of float. */
#define CSG_KEY_MAX 1e30f

/*
 * A record of the program in the data texture: one header texel
 *     (entry planes, exit planes, flags, attribute block / 4)
 * followed by a texel per plane, entries first, and CSG_QUADRIC_TEXELS where it has a quadric.
 * A plane's texel is c0 cu cv (see src/pack/screen.h) and its face's number + 1, negative for
 * exits. A face's number is the place of its normal behind CSG_ATTRIBUTE_NORMALS; a quadric's is 0.
 */
#define CSG_RECORD_QUADRIC 1  /* has a quadric */
#define CSG_RECORD_GAP 2      /* not convex: the quadric may take a piece out of the middle */
#define CSG_RECORD_NEGATED 4  /* the complement of the leaf */
#define CSG_RECORD_AND 8      /* combine by intersection, else by union */
#define CSG_RECORD_START 16   /* starts a new operand: do not combine */
#define CSG_RECORD_PUSH 32    /* ... and keep the operand before it on the stack */
#define CSG_RECORD_POP 64     /* no leaf: combine with the operand on the stack */
#define CSG_RECORD_SURFACE 128 /* a surface of triangles, see below */
#define CSG_RECORD_BOUND 256  /* no leaf: what follows does not matter before the header's key */
#define CSG_RECORD_MORE 512  /* the next record narrows the same literal: by more faces of the leaf
                              * in a cell, by a solid of a product (csg_node_is_product) in a tile */
#define CSG_RECORD_BANDS 1024 /* with CSG_RECORD_SURFACE: no triangles but bands, see below */

/*
 * Of the records of a tree of clauses, an intersection of unions of literals, or a union of
 * intersections, each also tells for chains (shaders/csg/clauses.glsl): which of the literals, in
 * the order of their records, are in one clause with it, a bit each; how many come before it where
 * several change at once; and whether the clauses are intersections.
 */
#define CSG_RECORD_CLAUSE 2048  /* the first of CSG_CLAUSE_LITERALS bits */
#define CSG_RECORD_ORDER 262144 /* the first of three bits */
#define CSG_RECORD_ANY 2097152

/*
 * A surface's record has lists of faces by cell, a square of pixels; all places count from the
 * header.
 *     header       texels that follow, 0, flags, attribute block / 4
 *     grid         the first pixel's corner, from the reference pixel; cells a pixel; cells a row
 *     start        turns of the surface round the eye; the longest list
 *     cells        place of the list; how many faces in it cover the cell, and how many cut it
 *     normals      of the faces in any list, as in an attribute block
 *     lists        of a face that covers: c0 cu cv of its plane, place of its normal, negative
 *                  where the ray leaves by it; of one that cuts: the same, then three edges
 * An edge is from y and to y, its lower end's x and its slope; from and to are equal where there is
 * none. y and x count from the first pixel's corner.
 */
#define CSG_SURFACE_CELLS 3 /* place of the first */
#define CSG_SURFACE_EDGES 3 /* of a face that cuts */

/*
 * The record of a stack of rings (src/csg/stack.h) has the faces that rays of its tile may meet:
 *     header       texels that follow, 0, flags, 0
 *     place        what conics count pixels from, from the reference pixel
 *     start        whether rays start inside; most crossings; flat bands; all bands
 *     flat bands   head, three terms of conics, a plane
 *     other bands  head, three terms of conics, two planes, a quadric (of 3 terms, or 5 in
 *                  programs with CSG_HAS_STIFF)
 * A band's head: CSG_BAND_..., attribute block / 4, face, 1 for the inner side of a ring. Its
 * conics are negative where the ray passes inside of a circle when it meets the circle's plane:
 * those of a flat band's rims, or those where another band begins and ends, of the first and the
 * second plane.
 */
#define CSG_BAND_WITHIN 1 /* rays start between its planes, and leave by either */
#define CSG_BAND_INSIDE 2 /* ... inside of the quadric */
#define CSG_BAND_PLACE 1  /* of the texels */
#define CSG_BAND_START 2
#define CSG_BAND_FIRST 3
#define CSG_BAND_CONICS 3 /* terms before a band's planes */

/* Operands of different nesting that wait at once. The deepest operand of a node comes first, so
 * this holds trees of 2^32 leaves. */
#define CSG_STACK_SIZE 32

/*
 * An attribute block, aligned to 4 texels: what shading needs of a leaf.
 * Of the normals' texels the fourth component is the block's place / 4 + 1, negative where a
 * quadric's terms n0 nu nv nk begin. The fourth components of nu nv nk are an affine term of the
 * pixel that is to be added to the key of a quadric in the geometry buffer: 0, but for programs in
 * double, which write how far the key is from it.
 */
#define CSG_ATTRIBUTE_COLOR 0
#define CSG_ATTRIBUTE_LEAF 1    /* leaf index */
#define CSG_ATTRIBUTE_NORMALS 2 /* the quadric's terms if any, then one texel a plane */
#define CSG_NORMAL_TERMS 4

/* Texels of the attribute block of a solid with (1) or without (0) a quadric, and planes. */
#define CSG_BLOCK_TEXELS(quadric, planes) ((5 + CSG_NORMAL_TERMS * (quadric) + (planes)) / 4 * 4)

#define CSG_QUADRIC_TEXELS 5

/* What a quadric's crossings bound, and the signs in its conic; the sum is the fourth component
 * of its first texel. */
#define CSG_QUADRIC_BETWEEN 0  /* the solid lies between the two crossings */
#define CSG_QUADRIC_BEFORE 1   /* ... before the first one */
#define CSG_QUADRIC_AFTER 2    /* ... after the second one */
#define CSG_QUADRIC_OUTSIDE 3  /* ... before the first and after the second */
#define CSG_QUADRIC_X_PLUS 4   /* the conic has + x'^2 */
#define CSG_QUADRIC_X_MINUS 32 /* ... - x'^2 */
#define CSG_QUADRIC_STIFF 64   /* the last two texels count: crossings as c / q */

/* Literals of a chain, with quadrics in clauses, and planes of either sense that each may have; more
 * where there are few and none has a quadric. */
#define CSG_CHAIN_LITERALS 5
#define CSG_CLAUSE_LITERALS 7
#define CSG_CHAIN_PLANES 2
#define CSG_CHAIN_FACETED_LITERALS 3
#define CSG_CHAIN_FACETED_PLANES 4

/* In a chain's slot: the complement of a leaf. The rest is the code of its quadric. */
#define CSG_CHAIN_NEGATED 128
/* ... and what of the record's flags tells of clauses: those from CSG_RECORD_CLAUSE on. */
#define CSG_CHAIN_CLAUSE 256

/* The geometry buffer: bits of the key, and the place of the visible face's normal, + 1. */
#define CSG_UNFINISHED 0xffffffffu /* in its place: the program gave up, see csg/turns.glsl */

/* Turns of all loops that llvmpipe grants to a program, see csg/turns.glsl. */
#define CSG_MAX_TURNS 65535

/* How often one look asks an innermost operand of a union anew, see csg/turns.glsl. */
#define CSG_MAX_AGAIN 3

/*
 * An object in cells (src/cells/cells.h) begins with what rays are in the space of its cells:
 * origin and its steps a pixel, direction and its steps, half the size of the box. The first
 * direction's fourth component is the place of the root in the texture of all cells. The leaves'
 * terms follow.
 */
#define CSG_WALK_HEADER 7

/* A bunch of a cell's literals (src/cells/bunch.h): multiples of 4. Of a literal's texel the number
 * is its surfaces by bit, planes from bit 0, quadrics behind them, and whether it is negated. */
#define CSG_BUNCH_LITERALS 8
#define CSG_BUNCH_MANY_PLANES 12 /* of objects without quadrics */
#define CSG_BUNCH_FEW_PLANES 8
#define CSG_BUNCH_QUADRICS 4
#define CSG_BUNCH_NEGATED 0x10000

/* Turns after which a pixel's walk gives up: sixteen pixels, as many as llvmpipe may draw at once,
 * then still keep within CSG_MAX_TURNS together. */
#define CSG_MAX_WALK_TURNS 4000
