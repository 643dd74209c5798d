/* SPDX-License-Identifier: MIT */
#include "solids/solid.h"

#include <string.h>

#define CSG_SOLID(kind) extern const struct csg_solid_ops csg_solid_##kind;
#include "solids/solids.def"
#undef CSG_SOLID

const struct csg_solid_ops *const csg_solids[CSG_NUM_KINDS] = {
#define CSG_SOLID(kind) &csg_solid_##kind,
#include "solids/solids.def"
#undef CSG_SOLID
};

enum csg_kind csg_solid_find(const char *name, size_t length)
{
    enum csg_kind kind = 0;
    while (kind < CSG_NUM_KINDS && (strlen(csg_solids[kind]->name) != length ||
                                    memcmp(csg_solids[kind]->name, name, length) != 0))
        kind++;
    return kind;
}

const char *csg_kind_name(enum csg_kind kind)
{
    static const char *const compounds[CSG_NUM_LEAF_KINDS - CSG_NUM_KINDS] = {
        [CSG_KIND_LINEAR_EXTRUDE - CSG_NUM_KINDS] = "linear_extrude",
        [CSG_KIND_ROTATE_EXTRUDE - CSG_NUM_KINDS] = "rotate_extrude",
        [CSG_KIND_POLYHEDRON - CSG_NUM_KINDS] = "polyhedron",
        [CSG_KIND_HULL - CSG_NUM_KINDS] = "hull",
        [CSG_KIND_MINKOWSKI - CSG_NUM_KINDS] = "minkowski",
        [CSG_KIND_RESIZE - CSG_NUM_KINDS] = "resize",
        [CSG_KIND_IMPORT - CSG_NUM_KINDS] = "import",
        [CSG_KIND_SURFACE - CSG_NUM_KINDS] = "surface",
        [CSG_KIND_DRAWING - CSG_NUM_KINDS] = "drawing",
        [CSG_KIND_OPENSCAD - CSG_NUM_KINDS] = "openscad",
    };
    return kind < CSG_NUM_KINDS ? csg_solids[kind]->name : compounds[kind - CSG_NUM_KINDS];
}
