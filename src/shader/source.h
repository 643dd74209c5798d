/* SPDX-License-Identifier: MIT */
#ifndef CSG_SHADER_SOURCE_H
#define CSG_SHADER_SOURCE_H

/* Shader texts, put together from shaders/ and from what the objects at hand need. */

#include "crowd/run.h"
#include "csg/structure.h"
#include "pack/frame.h"

/* How an object's first visible point is found; docs/pipeline.md compares them. */
enum csg_resolver {
    CSG_RESOLVER_STRAIGHT,   /* structure compiled in: straight-line code for one small tree */
    CSG_RESOLVER_CHAIN,      /* a few solids in a row, from flat inputs: what most tiles are */
    CSG_RESOLVER_LOOP,       /* any tree, read from the data texture, no array of crossings */
    CSG_RESOLVER_CELLS,      /* from cell to cell, each with a small tree */
    CSG_RESOLVER_ALGORITHM4, /* Ranta et al. 2006, Algorithm 4: crossings collected and sorted */
    CSG_RESOLVER_DOUBLE,     /* the loop in double precision, for what float does not hold */
    CSG_NUM_RESOLVERS,
    CSG_RESOLVER_REAR = CSG_NUM_RESOLVERS, /* the far side, by the loop; not a variant */
    CSG_RESOLVER_SURFACE,                  /* one surface, seen from outside; not a variant */
    CSG_RESOLVER_CPU                       /* leaves every pixel to the CPU; not a variant */
};

/* The variants that are no resolver. The best of them without programs for one structure: what
 * compiles is the same for all scenes, and in the driver's cache since the first of them. */
#define CSG_SHARED_NAME "shared"

/* Any of them over CSG_FEATURE_TEXTBOOK. */
#define CSG_TEXTBOOK_NAME "textbook"

extern const char *const csg_resolver_names[CSG_NUM_RESOLVERS];

/* What a program must be able to do, besides its resolver. */
enum csg_feature {
    CSG_FEATURE_QUADRIC = 1,  /* some leaf has a quadric */
    CSG_FEATURE_GAP = 2,      /* some leaf is not convex */
    CSG_FEATURE_STIFF = 4,    /* some quadric is stiff in this view, see src/pack/quadric.c */
    CSG_FEATURE_DOUBLE = 8,   /* keys and terms in double: records hold low parts too */
    CSG_FEATURE_SURFACE = 16, /* some leaf is a surface of triangles */
    CSG_FEATURE_NESTED = 32,  /* cells: some of their trees are no chains */
    CSG_FEATURE_BUNCHES = 64, /* cells: see src/cells/bunch.h */
    CSG_FEATURE_BANDS = 128,  /* some record is that of a stack of rings */
    CSG_NUM_FEATURE_SETS = 256,
    /* All of a frame's programs or none: */
    CSG_FEATURE_TEXTBOOK = 256, /* crossings of textbooks */
    CSG_FEATURE_DIRECT = 512,   /* colours, instead of what the shading pass reads */
    /* The same flat inputs, see shaders/common/inputs.glsl; nothing where there are more: */
    CSG_FEATURE_SHARED = 1024
};

/* Crossings that Algorithm 4's array holds; larger objects go to the loop. */
#define CSG_ALGORITHM4_MAX_CROSSINGS 192

/* A program for chains, intersections of a few solids and complements, see shaders/csg/chain.glsl.
 */
struct csg_chain {
    int slots;            /* solids at most */
    int handed;           /* ... that the vertex stage reads; fragments read the others */
    int planes;           /* of each solid at most, by which rays enter, or leave */
    bool quadrics;        /* whether they may have one */
    bool flat;            /* ... but not the first: what holes are cut out of */
    bool colors, normals; /* there is room for the solids' colours, and the terms of their quadrics'
                           * normals */
    bool clauses;         /* unions of some of them, or intersections of a union: see
                           * shaders/csg/clauses.glsl */
};

#define CSG_NUM_CHAINS 14
extern const struct csg_chain csg_chains[CSG_NUM_CHAINS];

/* Chain i as programs have it: those that write no colours ask for none. */
struct csg_chain csg_chain_of(int i, bool direct);

/* Flat inputs that its programs take, and those of them in csg_handed. */
size_t csg_chain_size(int i, bool direct);
size_t csg_chain_handed(const struct csg_chain *chain);

/* Whether chain i has what is needed. The smallest ones come first. */
bool csg_chain_fits(int i, const struct csg_chain_need *needed);

/* Whether what chain i draws is drawn by no other one. */
bool csg_chain_is_general(int i);

struct csg_text {
    char *data; /* zero-terminated; NULL when memory ran out */
    size_t num, capacity;
    bool failed;
};

void csg_text_add(struct csg_text *text, const char *format, ...) CSG_PRINTF(2, 3);

int csg_structure_features(const struct csg_structure *structure);
size_t csg_structure_crossings(const struct csg_structure *structure);

/* The stages of a geometry program. Equal structures give equal texts: together they are the key
 * under which programs are cached. NULL where memory ran out. */
struct csg_stages {
    char *vertex, *fragment;
};

/*
 * structure is only looked at by STRAIGHT. Up to max_handed of its texels are read by the vertex
 * stage and handed on as flat inputs, which costs an object what fetching costs every fragment.
 */
struct csg_stages csg_source_geometry(enum csg_resolver resolver, int features,
                                      const struct csg_structure *structure, size_t max_handed);

/* One-solid programs for crowds, see crowd/run.h; direct: as CSG_FEATURE_DIRECT. */
struct csg_stages csg_source_single(const struct csg_crowd_run *run, bool direct);

/* The same for chain i; features: DIRECT and SHARED. */
struct csg_stages csg_source_geometry_chain(int i, int features);

/* The shading pass; features: TEXTBOOK and SHARED. */
struct csg_stages csg_source_shade(bool want_leaf, bool want_bytes, int features);

/* Straight-line code: csg_hand_over for the vertex stage, and csg_resolve. */
void csg_source_straight(struct csg_text *vertex, struct csg_text *fragment,
                         const struct csg_structure *structure, int features, size_t max_handed);

/* The search for the first true point in what some solids have in common, vec2 whole, less holes:
 * spans that format and a number name. Returns false from csg_resolve where there is none. */
void csg_text_add_passing(struct csg_text *text, const char *format, const size_t *holes,
                          size_t num);

/* The end of the search for the first true point, a loop whose body has left in r0 what the whole
 * tree says at k: a ray that meets nothing stays beyond all keys. */
void csg_text_end_search(struct csg_text *text);

/* A chain's csg_hand_over, and csg_resolve. */
void csg_source_chain(struct csg_text *vertex, struct csg_text *fragment,
                      const struct csg_chain *chain);

#endif
