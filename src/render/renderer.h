/* SPDX-License-Identifier: MIT */
#ifndef CSG_RENDER_RENDERER_H
#define CSG_RENDER_RENDERER_H

#include "pack/frame.h"
#include "render/buffer.h"
#include "render/programs.h"
#include "render/targets.h"

struct csg_start;

/* Texture units: 0 the frame's texels, 1 what the geometry pass has found, */
enum { CSG_CELLS_UNIT = 2, CSG_OWNERS_UNIT };

/* The cells that the GPU has. */
struct csg_resident_cells {
    GLuint texture;
    struct csg_buffer buffer;
    CSG_ARRAY(uint64_t) hashes; /* of csg_cells, one after the other */
};

struct csgcast_renderer {
    struct csg_log log;
    struct csg_start *start; /* what makes gl meanwhile; NULL: it is there */
    struct csg_gl *gl;       /* NULL: the reference ray caster, */
    bool lost;               /* ... or this: it could not be made */
    struct csg_programs programs;
    struct csg_targets targets;
    GLuint data_texture;
    struct csg_buffer data_buffer; /* its texels */
    GLuint owners_texture;         /* a crowd's owners of pixels */
    struct csg_buffer owners_buffer;
    struct csg_resident_cells cells;
    int num_threads; /* see csg_parallel */
    int tile_size;   /* from $CSGCAST_TILE_SIZE, for tests; 0: as it is best */
    GLuint vertex_array, point_array, empty_array, crowd_array;
    struct csg_buffer instance_buffer, crowd_buffer;
    uint64_t thin_scene;    /* the number of what is_thin in direct.c was last asked of, */
    bool thin;              /* ... and what it said */
    uint64_t last_scene;    /* the number of that of the last frame, if it is one that is edited, */
    uint64_t last_revision; /* ... as it was then */
    bool has_drawn;         /* some picture, with OpenGL */
    struct csg_frame frame;
    struct csgcast_stats stats;
};

/* What one csgcast_render call asks for, resolved. */
struct csg_request {
    const struct csgcast_scene *scene;
    const struct csgcast_view *view;
    struct csgcast_frustum frustum;
    const struct csg_colorscheme *scheme;
    int width, height;
    int resolver;     /* enum csg_resolver, or -1 for the best */
    bool textbook;    /* crossings as textbooks have them */
    bool shared;      /* no straight-line programs but those of single solids, and few others */
    bool first;       /* ... but those of structures that much of the scene has */
    bool same_inputs; /* on llvmpipe, that compiles code for each set of flat inputs, see
                       * shaders/common/inputs.glsl. Other drivers may allow fewer than that is. */
    int tile_size;    /* as in csg_frame_params */
    bool settled;     /* no first frame of a scene that may be edited: it has programs for most */
    bool after_edit;  /* ... the first since then: it makes do with the programs that there are */
    const struct csgcast_image *image;
};

/* Draws with OpenGL; the renderer's context is current. false, with a message, on failure. */
bool csg_picture_render(struct csgcast_renderer *renderer, const struct csg_request *request);

/* Draws one pixel of nothing, so that the driver has made what every picture needs. */
void csg_warm_up(struct csgcast_renderer *renderer);

/* csgcast_renderer_warm; the renderer's context is current. */
bool csg_warm_programs(struct csgcast_renderer *renderer);

/* Whether an object is drawn in one piece; user is the struct csg_request. */
bool csg_draws_whole(size_t object, double area, const void *user);

/* Objects of enum csg_resolver's kinds drawn, for the statistics. */
struct csg_batch {
    GLuint program;
    GLuint rear; /* draws the far sides; 0 where they do not show */
    uint8_t layer, paint;
    bool translucent;
    bool points;         /* instances are squares, each drawn as one */
    uint32_t object;     /* of the first instance; of all where an object is drawn alone */
    uint32_t first, num; /* instances, numbered as csg_batches.order has them */
    const struct csg_crowd_run *run; /* NULL: other objects than a crowd's */
};

struct csg_batches {
    struct csg_batch *data;
    size_t num, capacity;
    CSG_ARRAY(uint32_t) order;     /* the frame's draws, one batch's after the other's */
    bool together[CSG_NUM_LAYERS]; /* by paint: what is not simply opaque is drawn at once */
    size_t drawn[CSG_NUM_RESOLVERS];
    size_t on_cpu; /* objects in double without a driver that has it */
    size_t drawn_single;
    bool may_give_up; /* some program may run out of turns, see CSG_MAX_TURNS */
    bool direct;      /* set before: programs write colours, see render/direct.h */
};

/* Fills precise_objects and numerics of stats from the renderer's frame. */
void csg_numerics_describe(const struct csgcast_renderer *renderer,
                           const struct csgcast_scene *scene, struct csgcast_stats *stats);

/* Makes the frame's cells resident; *uploaded grows by what had to be handed over, in bytes. false,
 * with a message, on failure. */
bool csg_cells_upload(struct csgcast_renderer *renderer, size_t *uploaded);
void csg_cells_drop(struct csgcast_renderer *renderer);

/* Hands the frame's texels and instances to the driver. keeps: as in csg_buffer_fill. false, with a
 * message, on failure. */
bool csg_upload_frame(struct csgcast_renderer *renderer, const struct csg_batches *batches,
                      bool keeps);

/* Casts the pixels of the strip at first_row (from the bottom) that visible marks as
 * CSG_UNFINISHED on the CPU. visible: two words a pixel; NULL where colours were drawn directly, of
 * which the unfinished ones have an alpha of 0. false: out of memory. */
bool csg_unfinished_fill(struct csgcast_renderer *renderer, const struct csg_request *request,
                         const uint32_t *visible, int first_row, int num_rows);

/* Chooses a program for every draw of the frame; runs of equal ones become batches, file order
 * kept. false, with a message, on failure. */
bool csg_batches_fill(struct csg_batches *batches, struct csgcast_renderer *renderer,
                      const struct csg_request *request);
void csg_batches_finish(struct csg_batches *batches);

#endif
