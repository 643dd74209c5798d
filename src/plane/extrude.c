/* SPDX-License-Identifier: MIT */
#include "plane/extrude.h"

#include <stdlib.h>

#include "plane/prism_surface.h"
#include "solids/facets.h"

/* A node of the drawing that is open in the part. */
struct open {
    uint32_t end; /* in the drawing */
    uint8_t op;
    bool negated;
    uint32_t num_children;
};

struct extruder {
    struct csg_part *part;
    const struct csg_drawing *drawing;
    const struct csg_lift *lift;
    size_t max_pieces; /* more become a surface */
    size_t num_pieces; /* of polygons that a crowd has as surfaces */
    CSG_ARRAY(struct open) open;
    bool too_large;
};

/* The contour of a disc has OpenSCAD's corners. */
static double disc_sagitta(const struct extruder *extruder, const struct csg_figure *figure)
{
    const struct csg_contour *contour = &extruder->drawing->contours.data[figure->begin];
    struct csg_map across = figure->disc;
    across.m[2][2] = 0;
    return csg_facets_sagitta(contour->end - contour->begin,
                              csg_map_stretch(&across) *
                                  fmax(extruder->lift->s0, extruder->lift->s1));
}

static bool add_disc(struct extruder *extruder, const struct csg_figure *figure, bool negated)
{
    const struct csg_box section = csg_figure_written(extruder->drawing, figure);
    struct csg_shape shape = {.frame = csg_map_identity, .rounding = figure->rounding};
    if (!csg_disc_fill(&shape, &figure->disc, extruder->lift)) {
        csg_shape_finish(&shape);
        return false;
    }
    shape.written = csg_lift_box(extruder->lift, &section);
    shape.sagitta = disc_sagitta(extruder, figure);
    return csg_part_add(extruder->part, &shape, negated);
}

static bool add_piece(struct extruder *extruder, const struct csg_figure *figure,
                      const struct csg_pieces *pieces, const struct csg_piece *piece, bool negated)
{
    struct csg_shape shape = {
        .frame = csg_map_identity, .facetted = figure->facetted, .rounding = figure->rounding};
    if (csg_prism_fill(&shape, pieces, piece, extruder->lift))
        return csg_part_add(extruder->part, &shape, negated);
    csg_shape_finish(&shape);
    return false;
}

/* taken: the polygon is there, as one solid. */
static bool add_surface(struct extruder *extruder, uint32_t node, bool negated, bool *taken)
{
    struct csg_shape shape = {0};
    const enum csg_prism_result result =
        csg_prism_surface(&shape, extruder->drawing, node, extruder->lift);
    *taken = result == CSG_PRISM_DONE;
    return *taken ? csg_part_add(extruder->part, &shape, negated) : result == CSG_PRISM_NONE;
}

/* An outline has no fewer convex pieces than that: at each corner that turns to the right a side of
 * pieces begins, which may end at another one, and to cut a ring open takes one more. */
static size_t least_pieces(const struct csg_drawing *drawing, const struct csg_figure *figure)
{
    size_t num_right = 0, num_holes = 0;
    for (uint32_t i = figure->begin; i < figure->end && figure->is_outline; i++) {
        const struct csg_contour *contour = &drawing->contours.data[i];
        const struct csg_vec2 *p = &drawing->points.data[contour->begin];
        const uint32_t num = contour->end - contour->begin;
        for (uint32_t j = 0; j < num; j++) {
            const struct csg_vec2 a = p[(j + num - 1) % num], b = p[j], c = p[(j + 1) % num];
            num_right += (b.x - a.x) * (c.y - b.y) < (b.y - a.y) * (c.x - b.x);
        }
        num_holes += csg_contour_twice_area(drawing, contour) < 0;
    }
    return num_right / 2 > num_holes ? num_right / 2 - num_holes : 0;
}

/* A union of pieces, or, negated, what is in none of them. */
static bool add_polygon(struct extruder *extruder, uint32_t node, bool negated)
{
    const struct csg_figure *figure =
        &extruder->drawing->figures.data[extruder->drawing->nodes.data[node].figure];
    struct csg_pieces pieces = {0};
    bool ok = true, taken = false;
    if (least_pieces(extruder->drawing, figure) > extruder->max_pieces)
        ok = add_surface(extruder, node, negated, &taken);
    if (!ok || taken)
        return ok;
    const enum csg_sweep_result result = csg_pieces_cut(&pieces, extruder->drawing, node);
    ok = result == CSG_SWEEP_DONE;
    extruder->too_large |= result == CSG_SWEEP_TOO_LARGE;
    if (ok && pieces.pieces.num > extruder->max_pieces)
        ok = add_surface(extruder, node, negated, &taken);
    if (!ok || taken) {
        csg_pieces_finish(&pieces);
        return ok;
    }
    if (pieces.pieces.num > CSG_EXTRUDE_ALONE_PIECES)
        extruder->num_pieces += pieces.pieces.num;
    ok = csg_part_open(extruder->part, negated);
    for (size_t i = 0; i < pieces.pieces.num && ok && !extruder->part->is_too_large; i++)
        ok = add_piece(extruder, figure, &pieces, &pieces.pieces.data[i], negated);
    if (ok)
        csg_part_close(extruder->part);
    csg_pieces_finish(&pieces);
    return ok;
}

static void close_nodes(struct extruder *extruder, uint32_t node)
{
    while (extruder->open.num && extruder->open.data[extruder->open.num - 1].end <= node) {
        extruder->open.num--;
        csg_part_close(extruder->part);
    }
}

/* Whether the next child of the innermost open node is complemented; counts it. */
static bool take_child(struct extruder *extruder)
{
    if (extruder->open.num == 0)
        return false;
    struct open *open = &extruder->open.data[extruder->open.num - 1];
    return open->negated != (open->op == CSG_DRAW_DIFFERENCE && open->num_children++ > 0);
}

/* De Morgan, as in nodes/build.c. A node without children is empty. */
static bool open_node(struct extruder *extruder, const struct csg_draw_node *node, uint32_t index,
                      bool negated)
{
    const struct open open = {.end = node->end, .op = node->op, .negated = negated};
    const bool is_union = node->op == CSG_DRAW_UNION || node->end == index + 1;
    return csg_part_open(extruder->part, is_union == negated) &&
           csg_array_push(&extruder->open, open);
}

static bool is_crowded(const struct extruder *extruder)
{
    return extruder->max_pieces == CSG_EXTRUDE_PIECES &&
           extruder->num_pieces > CSG_EXTRUDE_CROWD_PIECES;
}

/* Until they turn out to be a crowd. */
static bool add_nodes(struct extruder *extruder)
{
    const struct csg_drawing *drawing = extruder->drawing;
    bool ok = true;
    for (uint32_t i = 0;
         i < drawing->nodes.num && ok && !extruder->part->is_too_large && !is_crowded(extruder);
         i++) {
        const struct csg_draw_node *node = &drawing->nodes.data[i];
        close_nodes(extruder, i);
        const bool negated = take_child(extruder);
        if (node->op != CSG_DRAW_FIGURE)
            ok = open_node(extruder, node, i, negated);
        else if (drawing->figures.data[node->figure].is_disc)
            ok = add_disc(extruder, &drawing->figures.data[node->figure], negated);
        else
            ok = add_polygon(extruder, i, negated);
    }
    close_nodes(extruder, UINT32_MAX);
    return ok;
}

bool csg_extrude(struct csg_part *part, const struct csg_drawing *drawing,
                 const struct csg_lift *lift, size_t max_pieces, bool *too_large)
{
    struct extruder extruder = {
        .part = part, .drawing = drawing, .lift = lift, .max_pieces = max_pieces};
    bool ok = add_nodes(&extruder);
    if (ok && is_crowded(&extruder)) {
        csg_part_finish(part);
        extruder.max_pieces = CSG_EXTRUDE_ALONE_PIECES;
        ok = add_nodes(&extruder);
    }
    free(extruder.open.data);
    *too_large = extruder.too_large;
    return ok;
}
