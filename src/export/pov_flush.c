/* SPDX-License-Identifier: MIT */

/*
 * Where a subtracted solid ends in the very face of another, POV-Ray leaves to rounding whether a
 * skin stays. So such faces are moved by a millionth of the scene: outwards where the cut is flush,
 * inwards where the solid only touches from outside.
 */

#include <stdlib.h>

#include "carrier/carrier.h"
#include "export/pov.h"

#define SHIFT 1e-6 /* of the scene's size */

/* Bits of a carrier: solids that are not subtracted lie on this side of it. */
static uint8_t side_bit(bool flipped)
{
    return flipped ? 2 : 1;
}

static uint8_t *find_mark(const struct csg_pov *pov, const struct csg_face *face, bool is_plane)
{
    const size_t first = is_plane ? 0 : pov->scene->carriers->num_planes;
    return &pov->sides[first + face->carrier];
}

static void mark_leaf(const struct csg_pov *pov, uint32_t leaf, bool clear)
{
    const struct csg_carriers *carriers = pov->scene->carriers;
    for (uint32_t i = carriers->face_begin[leaf]; i < carriers->face_begin[leaf + 1]; i++) {
        const struct csg_face *face = &carriers->faces[i];
        if (face->carrier == CSG_NO_CARRIER)
            continue;
        uint8_t *mark = find_mark(pov, face, true);
        *mark = clear ? 0 : *mark | side_bit(face->flipped);
    }
    const struct csg_face *face = &carriers->quadric_faces[leaf];
    if (face->carrier == CSG_NO_CARRIER)
        return;
    uint8_t *mark = find_mark(pov, face, false);
    *mark = clear ? 0 : *mark | side_bit(face->flipped);
}

static void mark_object(const struct csg_pov *pov, const struct csg_object *object, bool clear)
{
    const struct csg_node *nodes = pov->scene->trees[object->layer].data;
    for (uint32_t i = object->begin; i < object->end; i++)
        if (nodes[i].op == CSG_LEAF && !nodes[i].negated)
            mark_leaf(pov, nodes[i].leaf, clear);
}

void csg_pov_flush_begin(const struct csg_pov *pov, const struct csg_object *object)
{
    mark_object(pov, object, false);
}

void csg_pov_flush_end(const struct csg_pov *pov, const struct csg_object *object)
{
    mark_object(pov, object, true);
}

/* 1: out, -1: in, 0: nothing coincides. */
static int direction(const struct csg_pov *pov, const struct csg_face *face, bool is_plane)
{
    const uint8_t mark = *find_mark(pov, face, is_plane);
    if (mark & side_bit(face->flipped))
        return 1;
    return mark ? -1 : 0;
}

static bool move_planes(const struct csg_pov *pov, uint32_t index, struct csg_shape *shape)
{
    const struct csg_carriers *carriers = pov->scene->carriers;
    const struct csg_face *faces = carriers->faces + carriers->face_begin[index];
    struct csg_plane *planes = malloc((shape->num_planes + 1) * sizeof *planes);
    if (!planes)
        return false;
    for (size_t i = 0; i < shape->num_planes; i++) {
        planes[i] = shape->planes[i];
        planes[i].offset += SHIFT * pov->size * direction(pov, &faces[i], true);
    }
    shape->planes = planes;
    return true;
}

/* A larger unit of the axes with positive signs makes f less everywhere: the solid grows. */
static void move_quadric(const struct csg_pov *pov, uint32_t index, struct csg_shape *shape)
{
    const struct csg_face *face = &pov->scene->carriers->quadric_faces[index];
    const int sign = face->carrier == CSG_NO_CARRIER ? 0 : direction(pov, face, false);
    for (int row = 0; row < 3 && sign; row++)
        for (int i = 0; i < 4 && shape->quadric.diag[row] > 0; i++)
            shape->quadric.to_canon.m[row][i] *= 1 - SHIFT * sign;
}

bool csg_pov_flush_move(const struct csg_pov *pov, uint32_t index, struct csg_leaf *leaf)
{
    *leaf = pov->scene->leaves[index];
    move_quadric(pov, index, &leaf->shape);
    return move_planes(pov, index, &leaf->shape);
}
