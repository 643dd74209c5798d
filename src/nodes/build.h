/* SPDX-License-Identifier: MIT */
#ifndef CSG_NODES_BUILD_H
#define CSG_NODES_BUILD_H

/*
 * From nodes to a scene, in walks over the array of nodes:
 *   meaning.c  what each node is, and which are left out,
 *   dimension.c  which are two-dimensional where solids are wanted, or the other way round,
 *   marks.c    what # and % show,
 *   unsupported.c  which are nothing for us,
 *   leaves.c   the solids, in world space; shares.c  the same on all cores,
 *   build.c    the Boolean trees of the layers.
 */

#include "csg/scene.h"
#include "document/document.h"
#include "nodes/nodes.h"

#define CSG_NO_LEAF UINT32_MAX

/* What a node of the document is. */
struct csg_meaning {
    uint8_t role;      /* enum csg_role */
    uint8_t kind;      /* ROLE_SOLID, ROLE_COMPOUND: enum csg_kind */
    uint8_t dimension; /* 2 or 3; 0: nothing in it says */
    bool shows_marks;  /* # and % directly in it show, though it becomes one mesh */
    bool shows_background, shows_highlight; /* as a whole, in those layers, see marks.c */
    bool holds_shown;                       /* something in it is shown by itself */
    bool is_idle;       /* read with a node around it, and only passed on the way to such a thing */
    bool is_handed_off; /* openscad has evaluated it: a COMPOUND or a FIGURE, see handoff.h */
    bool is_slab;       /* a drawing that no extrusion is around: csg_compound_slab draws it */
    bool is_whole;      /* what is in it is of one colour, its cut faces too */
    bool is_misplaced;  /* two-dimensional among solids or the other way round: no operand */
    /* ROLE_SOLID: the index of its leaf; ROLE_COMPOUND: of its tree's root in the builder's parts;
     * CSG_NO_LEAF when it is empty. */
    uint32_t leaf;
};

struct csg_origins;

struct csg_fonts;
struct csg_text_module;

/* What the first text() has opened; all NULL before. */
struct csg_text_state {
    const struct csg_text_module *module;
    struct csg_fonts *fonts;
};

struct csg_clip_module;
struct csg_repeats;

/* What the first drawing has opened. */
struct csg_clip_state {
    bool is_wanted, was_opened;
    const struct csg_clip_module *module; /* NULL: missing */
};

struct csg_xml_module;

/* What the first import of XML has opened. */
struct csg_xml_state {
    bool was_opened;
    const struct csg_xml_module *module; /* NULL: missing */
};

struct csg_builder {
    const struct csg_document *document;
    const struct csgcast_scene_params *params;
    struct csg_report *report;
    struct csgcast_scene *scene;
    enum csgcast_facets facets;
    bool skip_unsupported;
    struct csg_handoff *handoff;   /* NULL: what is not native is not supported */
    const char *directory;         /* where relative file names in the text start; "." at least */
    int num_threads;               /* that read it, see csg_parallel */
    uint32_t begin, end;           /* the nodes that count: all, or those of the ! node */
    struct csg_meaning *meanings;  /* one for each node of the document */
    size_t num_extrusions;         /* solids made of drawings, among them */
    struct csg_origins *origins;   /* gets where the leaves come from; NULL: not wanted */
    const struct csg_space *space; /* around all nodes; NULL: the world */
    struct csg_text_state *text;
    struct csg_clip_state clip;
    struct csg_xml_state xml;
    struct csg_tree parts;       /* the trees of the compounds, one behind the other */
    struct csg_repeats *repeats; /* NULL: each compound is read by itself */
};

/* What a scene is made of, and with what. */
struct csg_build_source {
    const struct csg_document *document;
    const struct csgcast_scene_params *params;
    const struct csg_space *space; /* around all nodes; NULL: the world */
    struct csg_origins *origins;   /* gets where the leaves come from; NULL: not wanted */
    struct csg_text_state *text;   /* stays open for the next scene; NULL: none follows */
    struct csg_report *report;
};

/*
 * Fills scene's leaves and trees; the trees are not simplified. What handoff is asked for is left
 * out: the scene is then to be built again. All errors are reported; what is wrong is then left out
 * of the scene. false, with a message, when memory is out.
 */
bool csg_build(struct csgcast_scene *scene, const struct csg_build_source *source,
               struct csg_handoff *handoff);

/* The walks. false, with a message, when memory is out. */
bool csg_build_meanings(struct csg_builder *builder);
bool csg_build_dimensions(struct csg_builder *builder);
bool csg_build_marks(struct csg_builder *builder);
bool csg_build_unsupported(struct csg_builder *builder);
bool csg_build_leaves(struct csg_builder *builder);

/* The leaves of the nodes from begin on, wherever that is in the tree, up to end. */
bool csg_build_leaves_in(struct csg_builder *builder, uint32_t begin, uint32_t end);

/* Takes gap from the numbers of the leaves that csg_build_leaves_in has made of the same nodes. */
void csg_build_renumber(struct csg_builder *builder, uint32_t begin, uint32_t end, uint32_t gap);

/*
 * The node cannot be done natively, for that reason ("text: ..."): it is handed to openscad, or
 * where that cannot be, reported as an error or, with skip_unsupported, a warning. In each case it
 * is empty for now.
 */
void csg_unsupported(struct csg_builder *builder, uint32_t node, const char *reason);

/* The same without asking openscad. */
void csg_refuse(struct csg_builder *builder, uint32_t node, const char *reason);

/* Whether node is no operand of the node around it: under * or %, or of the wrong dimension. */
static inline bool csg_is_left_out(const struct csg_builder *builder, uint32_t node)
{
    return (builder->document->nodes.data[node].modifiers &
            (CSG_MODIFIER_DISABLE | CSG_MODIFIER_BACKGROUND)) != 0 ||
           builder->meanings[node].is_misplaced;
}

/*
 * Whether the node is a drawing among solids, or a solid in a drawing, which is the empty set in
 * OpenSCAD 2021.01: an intersection with it is empty.
 */
static inline bool csg_is_empty_operand(const struct csg_builder *builder, uint32_t node)
{
    return (builder->document->nodes.data[node].modifiers &
            (CSG_MODIFIER_DISABLE | CSG_MODIFIER_BACKGROUND)) == 0 &&
           builder->meanings[node].is_misplaced;
}

/* Where the node is a drawing that shows, it does as a slab. */
static inline void csg_make_slab(struct csg_meaning *meaning)
{
    meaning->is_slab = meaning->dimension == 2 &&
                       (meaning->role == CSG_ROLE_FIGURE || meaning->role == CSG_ROLE_FLATTEN ||
                        meaning->role == CSG_ROLE_COMPOUND);
    if (meaning->is_slab)
        meaning->kind = CSG_KIND_DRAWING;
}

/* Whether the node becomes a part. */
static inline bool csg_is_compound(const struct csg_meaning *meaning)
{
    return meaning->role == CSG_ROLE_COMPOUND || meaning->is_slab;
}

/* Whether what is below the node takes part. */
static inline bool csg_has_children(const struct csg_meaning *meaning)
{
    return meaning->role == CSG_ROLE_UNION || meaning->role == CSG_ROLE_DIFFERENCE ||
           meaning->role == CSG_ROLE_INTERSECTION;
}

/* Whether leaves are to be looked for below the node. */
static inline bool csg_has_leaves(const struct csg_meaning *meaning)
{
    return meaning->holds_shown || (csg_has_children(meaning) && !meaning->is_idle);
}

#endif
