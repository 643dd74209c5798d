/* SPDX-License-Identifier: MIT */
#ifndef CSG_RENDER_CHOOSER_PARTS_H
#define CSG_RENDER_CHOOSER_PARTS_H

/* For chooser*.c: chooser.c decides, chooser_few.c for a picture alone, chooser_programs.c has the
 * programs made, chooser_spares.c those that only edits may ask for. */

#include "render/chooser.h"
#include "render/structures.h"

/* Which program draws something. */
struct csg_way {
    enum csg_resolver resolver;
    int features;
    int chain; /* of CSG_RESOLVER_CHAIN */
};

/* What a picture alone is drawn by, so that it takes few programs. */
struct csg_few {
    CSG_ARRAY(struct csg_few_way {
        struct csg_way way;
        GLuint structure; /* of CSG_RESOLVER_STRAIGHT: its number, from 1 on */
        double pixels;    /* that it draws */
    })
    ways;
    struct csg_known_structures structures; /* their programs are their numbers */
    int features;                           /* of the loop that draws what has few pixels, or -1 */
    bool no_points;                         /* squares are drawn as other rectangles are */
};

struct csg_chooser {
    struct csgcast_renderer *renderer;
    const struct csg_request *request;
    struct csg_known_structures straight, missing; /* missing: after an edit, without a program */
    GLuint surfaces[CSG_NUM_FEATURE_SETS];
    GLuint loops[CSG_NUM_FEATURE_SETS], sorted[CSG_NUM_FEATURE_SETS], rears[CSG_NUM_FEATURE_SETS];
    GLuint cells[CSG_NUM_FEATURE_SETS];
    GLuint cpu;                     /* for what needs double without having it */
    GLuint chains[CSG_NUM_CHAINS];  /* 0: not compiled */
    bool may_chain[CSG_NUM_CHAINS]; /* the driver allows their inputs */
    double compiled_ms;             /* of the renderer's compile_ms, before this frame */
    int common_chain;               /* that all tiles take which are chains; -1: each its own */
    bool tiles_prepared, direct;
    uint32_t prepared;       /* the object whose cells' program is there, + 1 */
    uint32_t prepared_whole; /* ... whose programs for tiles and for all of it are */
    size_t max_handed;       /* flat inputs that the driver allows */
    int max_point;           /* pixels of a point's side */
    struct csg_few few;
};

/* ---- chooser.c ---- */

struct csg_structure csg_chooser_structure(const struct csg_request *request, uint32_t object);

/* Whether a small structure with a program of its own is drawn in one piece only where it covers
 * few pixels. */
bool csg_chooser_may_tile(const struct csg_request *request, const struct csg_structure *structure);

/* What a draw's program must do because of this view; and one that walks through cells. */
int csg_view_features(const struct csg_draw *draw);
int csg_walk_features(const struct csg_chooser *chooser, const struct csg_draw *draw);

/* Without regard to what csg_few_way says. */
struct csg_way csg_chooser_way(struct csg_chooser *chooser, const struct csg_draw *draw);

/* ---- chooser_few.c ---- */

/* Looks at the frame; false: out of memory. */
bool csg_few_find(struct csg_chooser *chooser);

/* way, or the loop where that would draw few pixels of the picture. */
struct csg_way csg_few_way(const struct csg_chooser *chooser, const struct csg_draw *draw,
                           struct csg_way way);

/* ---- chooser_programs.c; 0, with a message: a program does not compile ---- */

/* The program of a structure of its own, straight-line code. 0 without a message: after an edit, as
 * there is none. */
GLuint csg_chooser_straight(struct csg_chooser *chooser, const struct csg_structure *structure,
                            bool stiff, int features);

/* Whether a structure can have a program of its own: there is one, or room for one. */
bool csg_chooser_has_room(const struct csg_chooser *chooser, const struct csg_structure *structure,
                          bool stiff);

/* A program that any structure with these features can use. After an edit it may be one that can do
 * more. */
GLuint csg_chooser_shared(struct csg_chooser *chooser, enum csg_resolver resolver, int features,
                          enum csg_resolver *chosen);

/* What leaves its pixels to the CPU. */
GLuint csg_chooser_cpu(struct csg_chooser *chooser, enum csg_resolver *resolver);

GLuint csg_chooser_chain(struct csg_chooser *chooser, int chain);

/* Whether it need not be compiled. */
bool csg_chooser_knows(const struct csg_chooser *chooser, enum csg_resolver resolver, int features);

/* A chain's program; 0: it would have to be compiled. */
GLuint csg_chooser_known_chain(const struct csg_chooser *chooser, int chain);

/* ---- chooser_spares.c; false, with a message: a program does not compile ---- */

bool csg_chooser_prepare_tiles(struct csg_chooser *chooser);
bool csg_chooser_prepare_cells(struct csg_chooser *chooser, const struct csg_draw *draw);
bool csg_chooser_prepare_whole(struct csg_chooser *chooser, const struct csg_draw *draw);

#endif
