/* SPDX-License-Identifier: MIT */
#ifndef CSG_PACK_FRAME_H
#define CSG_PACK_FRAME_H

/*
 * Everything the shaders read for one frame: the texels of the float texture (records and
 * attributes, shaders/common/layout.glsl) and the draws, one per object in view or, for large
 * objects, one per tile.
 */

#include "crowd/run.h"
#include "csg/program.h"
#include "look/colorscheme.h"
#include "pack/precision.h"
#include "pack/screen.h"
#include "pack/singles.h"

struct csg_cells;

/* One instance: the vertex shader's attributes. */
struct csg_instance {
    float rect[4];      /* clip space */
    int32_t records[2]; /* begin, end in the data texture */
    int32_t turns;      /* of the loops of one look at them, at most; see CSG_MAX_TURNS */
    int32_t side; /* of rect, in pixels, where it is a square of whole ones that can be drawn as
                   * one point; else 0 */
};

/* What a program for chains must have to draw a tile: see struct csg_chain in shader/source.h. */
struct csg_chain_need {
    uint8_t slots;  /* 0: it is no chain */
    uint8_t planes; /* of either sense, that one record has; 255: or more */
    bool quadrics, flat, clauses;
};

struct csg_draw {
    struct csg_instance instance;
    struct csg_chain_need chain;
    uint32_t object;
    uint8_t layer, paint; /* as in csg_object */
    bool single;          /* one convex leaf */
    bool translucent;     /* drawn after the opaque objects */
    bool has_rear;        /* its far side shows through: nothing behind its front is left out */
    bool around_eye;      /* the eye can be inside */
    bool stiff;           /* some quadric needs the other form in this view */
    bool precise;         /* drawn in double: the records hold low parts */
    bool surface;         /* some record is that of a surface of triangles */
    bool surface_alone;   /* there is no other, and the eye is outside of it */
    bool bands;           /* some record is that of a stack of rings */
    bool walk;            /* in cells: records begin with CSG_WALK_HEADER */
    bool may_walk;        /* it may be in cells in another frame */
    bool nested, bunched; /* walk: see csg_cells; may_walk: what these may be */
    bool tile;            /* a tile of the object: its records differ from the object's steps */
};

struct csg_frame {
    struct csg_screen screen;
    struct csg_pixel at;     /* the reference pixel of all objects */
    int num_threads;         /* that fill it; 0: as many as there are cores */
    CSG_ARRAY(float) texels; /* four floats each */
    CSG_ARRAY(struct csg_draw) draws;
    CSG_ARRAY(struct csg_frame_cells {
        const struct csg_cells *cells; /* of the scene, alive as long as that */
        size_t first;                  /* texel in the texture of all cells */
    })
    cells;                                      /* of the draws that walk */
    CSG_ARRAY(struct csg_precision) precisions; /* by object, of the listed ones */
    size_t proxy_pixels;
    size_t solid_tests; /* see csgcast_stats */
    size_t tiles_empty, tiles_opaque, tiles_mixed;
    double tile_ms;
    CSG_ARRAY(uint32_t) listed; /* objects drawn one by one, in file order: all but the crowd's */
    struct csg_frame_crowd crowd;
    struct csg_singles singles;        /* counted where leaves are wanted */
    CSG_ARRAY(struct csg_frame) parts; /* of it, while it is filled: their memory is used again */
};

/* Objects drawn in cells: none, those that tiles make too little of, all that can be. */
enum csg_cells_use { CSG_CELLS_NEVER, CSG_CELLS_WHERE_BETTER, CSG_CELLS_ALWAYS };

struct csg_frame_params {
    const struct csgcast_frustum *frustum;
    int width, height;
    int num_threads; /* see csg_parallel */
    const struct csg_colorscheme *scheme;
    enum csgcast_cut_color cut_color;
    /* Whether an object is drawn in one piece, by its number and the pixels of its rectangle; the
     * others are drawn in tiles. */
    bool (*whole)(size_t object, double area, const void *user);
    const void *user;
    bool textbook;   /* carriers as pack/textbook.h has them */
    bool precise;    /* everything in double */
    bool leaves;     /* it matters which of two leaves in one place shows, whatever their colours */
    int tile_size;   /* pixels, 0: CSG_TILE_SIZE; else tests have everything drawn in tiles of that
                        size */
    bool has_double; /* else what needs it is cast on the CPU, in the model's layer */
    enum csg_cells_use cells; /* what is drawn in cells */
    bool few_programs;        /* a program less is worth some more tiles */
    bool crowds;              /* single solids are drawn as crowd/crowd.h has them, */
    uint32_t crowds_without;  /* ... but those of runs with these csg_crowd_run_bit, */
    size_t max_owners;        /* ... with a picture of owners of at most so many pixels */
};

/* The index of draws that stand for a whole layer instead of one object. */
#define CSG_WHOLE_LAYER UINT32_MAX

/* Puts a rectangle in pixels into the draw's instance: in clip space, and its side. */
void csg_draw_set_rect(struct csg_draw *draw, const struct csg_screen *screen,
                       const struct csg_rect *rect);

/* Room for num texels behind the frame's; NULL: out of memory. */
float *csg_frame_reserve_texels(struct csg_frame *frame, size_t num);

/* The same at the end of the frame's, zeroed. */
float *csg_frame_add_texels(struct csg_frame *frame, size_t num);

/* Counts the pixels of a rectangle in which a draw's program has this many solids. */
void csg_frame_count(struct csg_frame *frame, const struct csg_rect *rect, size_t num_leaves);

/* Empties the frame of texels, draws and counts. */
void csg_frame_clear(struct csg_frame *frame);

/* Adds the draws, texels and counts of part, a frame of the same screen whose draws look up its own
 * texels only but for attribute blocks. false: out of memory. */
bool csg_frame_append(struct csg_frame *frame, const struct csg_frame *part);

/* Makes part, zeroed before its first use, an empty frame of the same screen. */
void csg_frame_start_part(struct csg_frame *part, const struct csg_frame *whole);

/* The same of the first num of the frame's own parts. false: out of memory. */
bool csg_frame_start_parts(struct csg_frame *frame, size_t num);

/* Where that is not much, the memory of a part that is done with stays for the next frame. */
void csg_frame_end_part(struct csg_frame *frame, size_t part);

/* Refills frame (zeroed before the first use). false: out of memory. */
bool csg_frame_fill(struct csg_frame *frame, const struct csgcast_scene *scene,
                    const struct csg_frame_params *params);
void csg_frame_finish(struct csg_frame *frame);

#endif
