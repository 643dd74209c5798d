/* SPDX-License-Identifier: MIT */
#ifndef CSG_CSG_SCENE_H
#define CSG_CSG_SCENE_H

/* The scene as built from text (scene/) and finished for rendering (prepare/). */

#include "common/log.h"
#include "csg/tree.h"
#include "solids/solid.h"

struct csg_leaf {
    struct csg_shape shape; /* in world space */
    struct csg_box box;     /* in world space; filled by csg_scene_finish */
    enum csg_kind kind;
    bool is_empty;         /* an edit left nothing of it: shape means nothing */
    bool is_hole;          /* taken away within its own node: its faces are not cut faces */
    float color[4];        /* of csg_leaf_set_color: r g b < 0 are the scheme's; a is 0 or more */
    uint32_t line, column; /* of the node in the text */
};

/* What is behind it shows. */
static inline bool csg_leaf_is_translucent(const struct csg_leaf *leaf)
{
    return leaf->color[3] < 1;
}

/* Which of the pictures a tree is part of. */
enum csg_layer {
    CSG_LAYER_MODEL,      /* the geometry */
    CSG_LAYER_BACKGROUND, /* %: not part of the geometry, drawn translucent grey */
    CSG_LAYER_HIGHLIGHT,  /* #: drawn once more, translucent red */
    CSG_NUM_LAYERS
};

/* A node that openscad has evaluated. */
struct csg_handed_off_node {
    char name[32], reason[160];
    uint32_t line, column;
    double seconds;
    bool is_cached;
};

struct csg_scene_ways {
    struct csgcast_scene_way *data;
    size_t num, capacity;
};

/* The leaves from begin on, below end, are in one render() node. */
struct csg_whole {
    uint32_t begin, end;
    bool negated; /* the node is subtracted */
};

struct csg_objects;
struct csg_carriers;
struct csg_before;
struct csg_cells_store;
struct csg_crowd;
struct csg_edits;
struct csg_follower;
struct csg_plan;
struct csg_sharpnesses;

struct csgcast_scene {
    struct csg_log log;
    char *name;                   /* for messages */
    struct csg_source *source;    /* scene/: the text it was read from */
    struct csg_edits *edits;      /* scene/: NULL until the first edit */
    int num_threads;              /* that may work on it, see csg_parallel */
    bool keeps_structure;         /* small objects keep what boxes show to be irrelevant */
    struct csgcast_camera camera; /* that the file asks for; kind DEFAULT: none */
    bool is_distributed;          /* objects were, see prepare/distribute.h */
    bool has_surfaces;            /* some leaf is one of triangles, see prepare/surfaces.h */
    uint64_t number;              /* which scene of the process it is; not 0 */
    uint64_t revision;            /* grows with each edit */
    double load_ms, csg_ms;       /* spent reading it and on csg_scene_finish, for the statistics */
    struct csg_leaf *leaves;      /* in file order: the public leaf index */
    size_t num_leaves, leaves_capacity;
    struct csg_tree trees[CSG_NUM_LAYERS];
    CSG_ARRAY(struct csg_handed_off_node) handed_off;
    CSG_ARRAY(struct csg_whole) wholes; /* by leaf, see csg/wholes.h */

    /* Filled by csg_scene_finish: */
    struct csg_objects *objects;       /* drawn one by one */
    struct csg_carriers *carriers;     /* distinct surfaces */
    struct csg_crowd *crowd;           /* objects of one solid each */
    struct csg_plan *plan;             /* the objects as steps of the shaders' machine */
    struct csg_sharpnesses *sharpness; /* of objects: what their geometry asks of numbers */
    struct csg_cells_store *cells;     /* cells/: of objects, on demand */
    struct csg_follower *follower;     /* of the edits since; or NULL */
    struct csg_box box;                /* of the model */
    struct csg_box drawn;              /* of the model, % and # */
    struct csg_box written;            /* what OpenSCAD's viewall frames */
    struct csgcast_scene_info info;
    struct csgcast_kind_count kinds[CSG_NUM_LEAF_KINDS];
    struct csg_scene_ways ways;
};

#endif
