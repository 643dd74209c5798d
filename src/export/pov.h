/* SPDX-License-Identifier: MIT */
#ifndef CSG_EXPORT_POV_H
#define CSG_EXPORT_POV_H

/*
 * Scenes for POV-Ray 3.7: the same solids, not meshes of them, under the same Booleans, and the
 * same camera, light and colours.
 */

#include "csg/object.h"
#include "export/text.h"
#include "look/colorscheme.h"

/* What a face looks like: a texture that the scene text declares once. */
struct csg_pov_paint {
    float rgba[4];
};

struct csg_pov_paints {
    struct csg_pov_paint *data; /* distinct, sorted */
    size_t num, capacity;
};

struct csg_pov {
    struct csg_text *text;
    const struct csgcast_scene *scene;
    const struct csgcast_view *view;
    const struct csg_colorscheme *scheme;
    struct csgcast_frustum frustum;
    struct csg_pov_paints paints;
    double size;    /* of the scene's box; 0 where it is empty or unbounded */
    double unit;    /* POV-Ray's coordinates are the scene's times this */
    uint8_t *sides; /* per carrier, planes first: see pov_flush.c */
};

/* Writes the whole scene. false: out of memory. */
bool csg_pov_write(struct csg_text *text, const struct csgcast_scene *scene,
                   const struct csgcast_view *view, const struct csg_colorscheme *scheme,
                   const struct csgcast_frustum *frustum);

/* Writes an object: its Boolean tree with paints. false: out of memory. */
bool csg_pov_object(struct csg_pov *pov, const struct csg_object *object);

/* One leaf, or its complement; tail is put inside its braces, at the end. false: out of memory. */
bool csg_pov_leaf(struct csg_text *text, const struct csg_leaf *leaf, const char *tail);

/* A convex polyhedron, or a surface of triangles, as a mesh. false: out of memory. */
bool csg_pov_polygons(struct csg_text *text, const struct csg_shape *shape, const char *tail);
void csg_pov_triangles(struct csg_text *text, const struct csg_shape *shape, const char *tail);

/*
 * Between begin and end, subtracted leaves can be moved: move gives a leaf of its own, its planes
 * to be freed, whose faces do not coincide with the object's other faces. false: out of memory.
 */
void csg_pov_flush_begin(const struct csg_pov *pov, const struct csg_object *object);
void csg_pov_flush_end(const struct csg_pov *pov, const struct csg_object *object);
bool csg_pov_flush_move(const struct csg_pov *pov, uint32_t index, struct csg_leaf *leaf);

/* Fills paints with all that the objects' leaves need. false: out of memory. */
bool csg_pov_paints_fill(struct csg_pov *pov);

/* The number of the paint of a leaf's node in an object. */
size_t csg_pov_paint_find(const struct csg_pov *pov, const struct csg_object *object,
                          const struct csg_node *node);

#endif
