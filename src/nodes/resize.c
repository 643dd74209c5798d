/* SPDX-License-Identifier: MIT */
/*
 * resize(newsize, auto) of solids. As the size counts that of OpenSCAD's facets; what is scaled
 * stays as exact as it was.
 */
#include "nodes/resize.h"

#include "nodes/compounds.h"
#include "nodes/parts.h"
#include "plane/resize.h"
#include "polyhedra/evaluate.h"

struct csg_resize csg_resize_read(const struct csg_args *args)
{
    const struct csg_value *newsize = csg_args_find(args, "newsize");
    const struct csg_value *automatic = csg_args_find(args, "auto");
    struct csg_resize resize = {0};
    for (size_t i = 0; i < 3; i++) {
        if (newsize && newsize->type == CSG_VALUE_VECTOR && i < newsize->num &&
            newsize->items[i].type == CSG_VALUE_NUMBER && isfinite(newsize->items[i].number))
            resize.newsize[i] = newsize->items[i].number;
        const struct csg_value *value = automatic;
        if (automatic && automatic->type == CSG_VALUE_VECTOR)
            value = i < automatic->num ? &automatic->items[i] : NULL;
        if (value)
            resize.automatic[i] =
                value->type == CSG_VALUE_BOOL ? value->boolean : value->number != 0;
    }
    return resize;
}

/* The box of OpenSCAD's facets, which it reads. is_there: it has a volume, and nothing was
 * reported.
 */
static bool find_size(struct csg_walk *walk, uint32_t node, bool in_boolean,
                      struct csg_part *facets, double size[3], bool *is_there)
{
    struct csg_clusters clusters = {0};
    struct csg_box box = csg_box_empty;
    bool ok = csg_part_read(walk, node + 1, csg_walk_node(walk, node)->end, in_boolean,
                            CSG_WANT_POINTS, facets);
    enum csg_hull_result result = CSG_HULL_DONE;
    if (ok)
        result = facets->is_too_large ? CSG_HULL_FLAT : csg_part_evaluate(facets, true, &clusters);
    for (size_t i = 0; i < clusters.corners.points.num; i++)
        csg_box_extend(&box, clusters.corners.points.data[i]);
    size[0] = box.hi.x - box.lo.x;
    size[1] = box.hi.y - box.lo.y;
    size[2] = box.hi.z - box.lo.z;
    *is_there = ok && result == CSG_HULL_DONE && size[0] > 0 && size[1] > 0 && size[2] > 0;
    if (ok && result == CSG_HULL_NO_MEMORY)
        ok = csg_walk_no_memory(walk);
    else if (ok && result != CSG_HULL_DONE)
        csg_walk_unsupported(walk, node, "resize: the size of what is in it is hard to find");
    csg_clusters_finish(&clusters);
    return ok;
}

/* Whether it is more than one solid, which OpenSCAD resizes otherwise. */
static bool is_combined(const struct csg_walk *walk, uint32_t node)
{
    for (;;) {
        uint32_t only = node;
        int num = 0;
        for (uint32_t i = node + 1; i < csg_walk_node(walk, node)->end;
             i = csg_walk_node(walk, i)->end)
            if (!csg_is_left_out(walk->builder, i) && walk->builder->meanings[i].dimension == 3) {
                only = i;
                num++;
            }
        if (num != 1 || !csg_has_children(&walk->builder->meanings[only]))
            return num > 1;
        node = only;
    }
}

static void find_factors(const struct csg_walk *walk, uint32_t node,
                         const struct csg_resize *resize, const double size[3], double factors[3])
{
    if (is_combined(walk, node))
        csg_resize_factors_signed(resize->newsize, resize->automatic, size, 3, factors);
    else
        csg_resize_factors(resize->newsize, resize->automatic, size, 3, factors);
}

/* What is scaled. Where only points matter and nothing was cut from them, those that the size was
 * found by will do: read once more at each level, a resize in a resize took twice as long. */
static bool read_children(struct csg_walk *walk, const struct csg_resized *resized, bool in_boolean,
                          struct csg_part *facets, struct csg_part *part)
{
    const uint32_t node = resized->node;
    if (walk->points_only && csg_part_is_union(facets)) {
        *part = *facets;
        *facets = (struct csg_part){.is_too_large = false};
        return true;
    }
    walk->resized = resized;
    const bool ok = csg_part_read(walk, node + 1, csg_walk_node(walk, node)->end, in_boolean,
                                  CSG_WANT_AROUND, part);
    walk->resized = resized->outer;
    return ok;
}

static void scale(struct csg_part *part, const struct csg_map *map, const double factors[3])
{
    for (size_t i = 0; i < part->shapes.num; i++) {
        csg_shape_map(&part->shapes.data[i], map);
        part->shapes.data[i].rounding *=
            fmax(fabs(factors[0]), fmax(fabs(factors[1]), fabs(factors[2])));
    }
}

bool csg_compound_resize(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                         bool in_boolean, struct csg_part *part)
{
    const struct csg_resize resize = csg_resize_read(args);
    struct csg_resized resized = {node, csg_map_identity, walk->resized};
    struct csg_part facets = {.is_too_large = false};
    double size[3], factors[3];
    bool is_there = false;
    bool ok = find_size(walk, node, in_boolean, &facets, size, &is_there);
    if (ok && is_there) {
        find_factors(walk, node, &resize, size, factors);
        for (int i = 0; i < 3; i++)
            resized.map.m[i][i] = factors[i];
        ok = read_children(walk, &resized, in_boolean, &facets, part);
        if (ok)
            scale(part, &resized.map, factors);
    }
    csg_part_finish(&facets);
    return ok;
}
