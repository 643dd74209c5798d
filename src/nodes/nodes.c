/* SPDX-License-Identifier: MIT */
#include "nodes/nodes.h"

#include <string.h>

#include "common/spelling.h"
#include "nodes/compounds.h"
#include "nodes/figures.h"
#include "nodes/flatten.h"
#include "nodes/text.h"
#include "nodes/transforms.h"
#include "solids/solid.h"

const struct csg_space csg_space_world = {
    .map = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}},
    .color = {-1, -1, -1, 1},
};

static const struct csg_node_ops nodes[] = {
    {.name = "group", .role = CSG_ROLE_UNION},
    {.name = "union", .role = CSG_ROLE_UNION},
    {.name = "difference", .role = CSG_ROLE_DIFFERENCE},
    {.name = "intersection", .role = CSG_ROLE_INTERSECTION},
    {.name = "render",
     .role = CSG_ROLE_UNION,
     .parameters = "convexity",
     .is_whole = true,
     .enter = csg_enter_render},
    {.name = "color", .role = CSG_ROLE_UNION, .parameters = "c alpha", .enter = csg_enter_color},
    {.name = "multmatrix",
     .role = CSG_ROLE_UNION,
     .parameters = "m",
     .enter = csg_enter_multmatrix},
    {.name = "translate", .role = CSG_ROLE_UNION, .parameters = "v", .enter = csg_enter_translate},
    {.name = "rotate", .role = CSG_ROLE_UNION, .parameters = "a v", .enter = csg_enter_rotate},
    {.name = "scale", .role = CSG_ROLE_UNION, .parameters = "v", .enter = csg_enter_scale},
    {.name = "mirror", .role = CSG_ROLE_UNION, .parameters = "v", .enter = csg_enter_mirror},
    {.name = "square",
     .role = CSG_ROLE_FIGURE,
     .parameters = "size center",
     .dimension = 2,
     .figure = csg_figure_square},
    {.name = "circle",
     .role = CSG_ROLE_FIGURE,
     .parameters = "r d",
     .dimension = 2,
     .figure = csg_figure_circle},
    {.name = "polygon",
     .role = CSG_ROLE_FIGURE,
     .parameters = "points paths",
     .dimension = 2,
     .figure = csg_figure_polygon},
    {.name = "linear_extrude",
     .role = CSG_ROLE_COMPOUND,
     .parameters = "height v center convexity twist slices scale segments h file layer origin "
                   "timestamp",
     .dimension = 3,
     .wants = 2,
     .kind = CSG_KIND_LINEAR_EXTRUDE,
     .compound = csg_compound_linear_extrude},
    {.name = "polyhedron",
     .role = CSG_ROLE_COMPOUND,
     .parameters = "points faces convexity triangles",
     .dimension = 3,
     .kind = CSG_KIND_POLYHEDRON,
     .compound = csg_compound_polyhedron},
    {.name = "rotate_extrude",
     .role = CSG_ROLE_COMPOUND,
     .parameters = "angle start file layer origin scale timestamp",
     .dimension = 3,
     .wants = 2,
     .kind = CSG_KIND_ROTATE_EXTRUDE,
     .compound = csg_compound_rotate_extrude},
    {.name = "hull",
     .role = CSG_ROLE_COMPOUND,
     .parameters = "convexity",
     .kind = CSG_KIND_HULL,
     .shows_marks = true,
     .flatten = csg_flatten_hull,
     .compound = csg_compound_hull},
    {.name = "minkowski",
     .role = CSG_ROLE_COMPOUND,
     .parameters = "convexity",
     .kind = CSG_KIND_MINKOWSKI,
     .shows_marks = true,
     .flatten = csg_flatten_minkowski,
     .compound = csg_compound_minkowski},
    {.name = "resize",
     .role = CSG_ROLE_COMPOUND,
     .parameters = "newsize auto convexity",
     .kind = CSG_KIND_RESIZE,
     .shows_marks = true,
     .flatten = csg_flatten_resize,
     .compound = csg_compound_resize},
    {.name = "projection",
     .role = CSG_ROLE_FIGURE,
     .parameters = "cut convexity",
     .dimension = 2,
     .wants = 3,
     .figure = csg_figure_projection},
    {.name = "offset",
     .role = CSG_ROLE_FLATTEN,
     .parameters = "r delta chamfer",
     .dimension = 2,
     .flatten = csg_flatten_offset},
    {.name = "import",
     .role = CSG_ROLE_UNSUPPORTED, /* or FIGURE, or COMPOUND: the file decides */
     .parameters = "file layer convexity origin scale width height center dpi timestamp id",
     .kind = CSG_KIND_IMPORT,
     .figure = csg_figure_import,
     .compound = csg_compound_import},
    {.name = "surface",
     .role = CSG_ROLE_COMPOUND,
     .parameters = "file center invert convexity timestamp",
     .dimension = 3,
     .kind = CSG_KIND_SURFACE,
     .compound = csg_compound_surface},
    {.name = "text",
     .role = CSG_ROLE_FIGURE,
     .parameters = "text size font direction language script halign valign spacing",
     .dimension = 2,
     .figure = csg_figure_text},
    {.name = "fill", .role = CSG_ROLE_FLATTEN, .dimension = 2, .flatten = csg_flatten_fill},
    {.name = "roof", .role = CSG_ROLE_UNSUPPORTED, .dimension = 3},
    {.name = "import_dxf", .role = CSG_ROLE_UNSUPPORTED, .dimension = 2},
    {.name = "import_stl", .role = CSG_ROLE_UNSUPPORTED, .dimension = 3},
    {.name = "import_off", .role = CSG_ROLE_UNSUPPORTED, .dimension = 3},
    {.name = "dxf_linear_extrude", .role = CSG_ROLE_UNSUPPORTED, .dimension = 3},
    {.name = "dxf_rotate_extrude", .role = CSG_ROLE_UNSUPPORTED, .dimension = 3},
};

enum { num_nodes = sizeof nodes / sizeof nodes[0] };

const struct csg_node_ops *csg_node_find(const char *name, size_t length)
{
    for (size_t i = 0; i < num_nodes; i++)
        if (nodes[i].name[0] == name[0] && strncmp(nodes[i].name, name, length) == 0 &&
            nodes[i].name[length] == '\0')
            return &nodes[i];
    return NULL;
}

/* ---- suggestions ------------------------------------------------------------------------ */

/* Keeps candidate in best when it is nearer to name than distance, which is updated. */
static void consider(const char *candidate, const char *name, size_t length, size_t *distance,
                     const char **best)
{
    const size_t candidate_distance =
        csg_spelling_distance(name, length, candidate, strlen(candidate));
    if (candidate_distance < *distance) {
        *distance = candidate_distance;
        *best = candidate;
    }
}

const char *csg_node_suggest(const char *name, size_t length)
{
    const char *best = NULL;
    size_t distance = length / 3 + 2; /* a third of the letters and one may be wrong */
    for (size_t i = 0; i < CSG_NUM_KINDS; i++)
        consider(csg_solids[i]->name, name, length, &distance, &best);
    for (size_t i = 0; i < num_nodes; i++)
        consider(nodes[i].name, name, length, &distance, &best);
    return best;
}
