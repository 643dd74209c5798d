/* SPDX-License-Identifier: MIT */
#ifndef CSG_SOLIDS_SOLID_H
#define CSG_SOLIDS_SOLID_H

/*
 * The kinds of solid. A kind is one folder src/solids/<kind>/ with one row in solids.def; the row
 * names its csg_solid_ops. Nothing else in the house knows the kinds.
 */

#include <stdint.h>

#include "common/log.h"
#include "solids/shape.h"
#include "solids/value.h"

enum csg_read_result {
    CSG_READ_OK,
    CSG_READ_EMPTY, /* no volume, as OpenSCAD has it: contributes nothing, no message */
    CSG_READ_ERROR, /* a message was logged */
};

struct csg_solid_ops {
    const char *name;       /* as written in a scene */
    const char *parameters; /* their names in positional order: "h r1 r2 center $fn $fa $fs" */
    /* Fills shape (zeroed by the caller, frame identity) in the node's own space. */
    enum csg_read_result (*read)(const struct csg_args *args, struct csg_shape *shape);
};

enum csg_kind {
#define CSG_SOLID(kind) CSG_KIND_##kind,
#include "solids/solids.def"
#undef CSG_SOLID
    CSG_NUM_KINDS,
    /* Nodes that become several shapes (nodes/compounds.h): */
    CSG_KIND_LINEAR_EXTRUDE = CSG_NUM_KINDS,
    CSG_KIND_ROTATE_EXTRUDE,
    CSG_KIND_POLYHEDRON,
    CSG_KIND_HULL,
    CSG_KIND_MINKOWSKI,
    CSG_KIND_RESIZE,
    CSG_KIND_IMPORT,
    CSG_KIND_SURFACE,
    CSG_KIND_DRAWING,  /* by itself, as a slab */
    CSG_KIND_OPENSCAD, /* what only openscad can evaluate, as a mesh */
    CSG_NUM_LEAF_KINDS
};

/* Indexed by enum csg_kind. */
extern const struct csg_solid_ops *const csg_solids[CSG_NUM_KINDS];

/* As written in a scene; compounds included. */
const char *csg_kind_name(enum csg_kind kind);

/* The kind with that name; CSG_NUM_KINDS when there is none. */
enum csg_kind csg_solid_find(const char *name, size_t length);

#endif
