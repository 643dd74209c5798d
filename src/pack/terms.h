/* SPDX-License-Identifier: MIT */
#ifndef CSG_PACK_TERMS_H
#define CSG_PACK_TERMS_H

/* The leaves of one object as this frame's shaders see them. */

#include "pack/bands.h"
#include "pack/frame.h"
#include "pack/seen.h"
#include "pack/surface.h"

struct csg_leaf_terms {
    uint32_t node; /* of what is seen */
    size_t texels; /* in csg_terms.texels: entry planes, exit planes, the quadric's */
    uint32_t num_entries, num_exits;
    uint32_t flags;       /* CSG_RECORD_NEGATED, _SURFACE, _BANDS, _QUADRIC, _GAP of the leaf */
    uint32_t carrier;     /* of its quadric, CSG_NO_CARRIER: none */
    uint32_t view;        /* of a surface: in csg_terms.views */
    size_t attributes;    /* attribute block / 4, in the frame's texels */
    struct csg_rect rect; /* in pixels: no ray outside of it meets the leaf */
};

struct csg_terms {
    struct csg_frame *frame;
    const struct csgcast_scene *scene;
    const struct csg_frame_params *params;
    struct csg_seen seen;                    /* of the object at hand */
    CSG_ARRAY(struct csg_leaf_terms) leaves; /* of what is seen of it */
    CSG_ARRAY(double) texels;                /* four numbers each */
    struct csg_surface_views views; /* of its leaves that are surfaces; projected for tiles */
    struct csg_stacks stacks; /* of the object, for the tiles; they come last among its leaves */
    struct csg_bands bands;
    uint32_t *index;         /* scene leaf -> leaves; valid for the object's leaves, and stacks */
    uint8_t *known;          /* scene leaf -> enum csg_known, for the tiles to fill */
    bool translucent, stiff; /* of any of the object's leaves */
    bool precise;            /* records hold low parts too, for programs in double */
    double error;            /* largest, of a stiff quadric: see csg_quadric_error */
    uint32_t roughest;       /* the leaf that has it */
};

bool csg_terms_init(struct csg_terms *terms, struct csg_frame *frame,
                    const struct csgcast_scene *scene, const struct csg_frame_params *params);
void csg_terms_finish(struct csg_terms *terms);

/* to gets the leaves of from, an object of which nothing is left out; from may be filled anew.
 * index and known stay there. */
void csg_terms_take(struct csg_terms *to, struct csg_terms *from);

/* Finds what is seen of an object, the next one at hand: with whole all of it. false: out of
 * memory. */
bool csg_terms_see(struct csg_terms *terms, const struct csg_object *object, bool whole);

/* Replaces the leaves by those seen of object, in rect; writes their attribute blocks into the
 * frame. Makes terms precise where a stiff quadric asks for it. */
bool csg_terms_fill(struct csg_terms *terms, const struct csg_object *object,
                    const struct csg_rect *rect);

static inline const struct csg_leaf_terms *csg_terms_of(const struct csg_terms *terms,
                                                        uint32_t leaf)
{
    return &terms->leaves.data[terms->index[leaf]];
}

/* The view of a leaf that is a surface. */
static inline const struct csg_surface_view *csg_terms_view(const struct csg_terms *terms,
                                                            uint32_t leaf)
{
    return &terms->views.data[csg_terms_of(terms, leaf)->view];
}

/* The texel at place i of a leaf's. */
static inline const double *csg_terms_texel(const struct csg_terms *terms,
                                            const struct csg_leaf_terms *leaf, size_t i)
{
    return terms->texels.data + 4 * (leaf->texels + i);
}

/* The texels of the quadric of a leaf: csg_screen_quadric of its carrier, and csg_screen_base where
 * base is not NULL. */
void csg_terms_crossings(const struct csg_frame *frame, const struct csgcast_scene *scene,
                         uint32_t leaf, double texels[CSG_QUADRIC_TEXELS][4], float *base);

#endif
