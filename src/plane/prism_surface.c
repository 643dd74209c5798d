/* SPDX-License-Identifier: MIT */
#include "plane/prism_surface.h"

#include "plane/outline.h"
#include "plane/twist.h"

/* A drawing of that figure alone. */
static bool copy_figure(struct csg_drawing *copy, const struct csg_drawing *drawing,
                        const struct csg_figure *figure)
{
    bool ok = csg_drawing_add_figure(copy, figure->rounding);
    for (uint32_t i = figure->begin; i < figure->end && ok; i++) {
        const struct csg_contour *contour = &drawing->contours.data[i];
        ok = csg_drawing_add_contour(copy);
        for (uint32_t j = contour->begin; j < contour->end && ok; j++)
            ok = csg_drawing_add_point(copy, drawing->points.data[j].x, drawing->points.data[j].y);
    }
    if (ok)
        copy->figures.data[0].is_outline = figure->is_outline;
    return ok;
}

static enum csg_prism_result fill(struct csg_mesh *mesh, struct csg_drawing *drawing,
                                  const struct csg_lift *lift)
{
    const struct csg_twist twist = {
        .z0 = lift->z0, .z1 = lift->z1, .scale = {lift->s1, lift->s1}, .slices = 1};
    struct csg_mesh_gaps gaps;
    enum csg_sweep_result result = csg_drawing_evaluate(drawing, 0);
    if (result == CSG_SWEEP_DONE)
        result = csg_twist_fill(mesh, drawing, &twist);
    if (result != CSG_SWEEP_DONE)
        return result == CSG_SWEEP_TOO_LARGE ? CSG_PRISM_NONE : CSG_PRISM_NO_MEMORY;
    if (!csg_mesh_orient(mesh, &gaps))
        return CSG_PRISM_NO_MEMORY;
    return gaps.num || mesh->faces.num == 0 ? CSG_PRISM_NONE : CSG_PRISM_DONE;
}

enum csg_prism_result csg_prism_surface(struct csg_shape *shape, const struct csg_drawing *drawing,
                                        uint32_t node, const struct csg_lift *lift)
{
    const struct csg_figure *figure = &drawing->figures.data[drawing->nodes.data[node].figure];
    struct csg_drawing copy = {0};
    struct csg_mesh mesh = {.rounding = figure->rounding};
    enum csg_prism_result result = CSG_PRISM_NONE;
    if (lift->s0 == 1 && lift->s1 > 0)
        result =
            copy_figure(&copy, drawing, figure) ? fill(&mesh, &copy, lift) : CSG_PRISM_NO_MEMORY;
    if (result == CSG_PRISM_DONE && !csg_mesh_to_shape(&mesh, false, shape))
        result = CSG_PRISM_NO_MEMORY;
    if (result == CSG_PRISM_DONE)
        shape->facetted = figure->facetted;
    csg_mesh_finish(&mesh);
    csg_drawing_finish(&copy);
    return result;
}
