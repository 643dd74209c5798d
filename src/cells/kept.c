/* SPDX-License-Identifier: MIT */
#include "cells/kept.h"

#include <stdlib.h>
#include <string.h>

#include "carrier/carrier.h"
#include "common/hash.h"

struct csg_kept {
    size_t num;
    struct kept_part {
        uint64_t key;
        bool taken;
        struct csg_cell_builder cells; /* branches, texels and whether they are nested */
    } parts[];
};

static uint64_t add_doubles(uint64_t hash, const double *numbers, size_t num)
{
    for (size_t i = 0; i < num; i++)
        hash = csg_hash_double(hash, numbers[i]);
    return hash;
}

static uint64_t add_vector(uint64_t hash, struct csg_vec3 a)
{
    const double numbers[3] = {a.x, a.y, a.z};
    return add_doubles(hash, numbers, 3);
}

static uint64_t add_box(uint64_t hash, const struct csg_box *box)
{
    return add_vector(add_vector(hash, box->lo), box->hi);
}

static uint64_t add_planes(uint64_t hash, const struct csg_carriers *carriers, uint32_t leaf)
{
    for (uint32_t i = carriers->face_begin[leaf]; i < carriers->face_begin[leaf + 1]; i++) {
        const struct csg_face face = carriers->faces[i];
        const struct csg_plane *plane = &carriers->planes[face.carrier];
        hash = add_doubles(add_vector(hash, plane->normal), &plane->offset, 1);
        hash = csg_hash_number(hash, face.flipped);
    }
    return hash;
}

static uint64_t add_quadric(uint64_t hash, const struct csgcast_scene *scene, uint32_t leaf)
{
    const struct csg_carriers *carriers = scene->carriers;
    const struct csg_face face = carriers->quadric_faces[leaf];
    const struct csg_quadric *quadric = csg_carrier_quadric(scene, carriers, face.carrier);
    const double form[5] = {quadric->diag[0], quadric->diag[1], quadric->diag[2], quadric->diag[3],
                            quadric->linear};
    hash = add_doubles(hash, form, 5);
    hash =
        add_doubles(hash, &quadric->to_canon.m[0][0], sizeof quadric->to_canon.m / sizeof(double));
    return csg_hash_number(csg_hash_number(hash, face.flipped),
                           (uint64_t)(carriers->sheets[leaf] + 1));
}

uint64_t csg_kept_leaf_key(const struct csg_cell_builder *top, uint32_t leaf)
{
    const struct csg_leaf *own = &top->scene->leaves[leaf];
    uint64_t hash = csg_hash_number(csg_hash_number(0, leaf), top->places[leaf]);
    hash = csg_hash_number(hash, (uint64_t)(4 * top->leaves[leaf].is_box +
                                            2 * own->shape.has_quadric + own->shape.convex));
    hash = add_planes(add_box(hash, &own->box), top->scene->carriers, leaf);
    return own->shape.has_quadric ? add_quadric(hash, top->scene, leaf) : hash;
}

uint64_t csg_kept_key(const struct csg_cell_builder *top, const struct csg_work *work,
                      const uint64_t *leaf_keys)
{
    uint64_t hash = add_box(csg_hash_number(0, work->depth), &work->box);
    hash = add_doubles(hash, &top->margin, 1);
    hash = csg_hash_number(hash, (uint64_t)(2 * top->bunched + top->bunches.quadrics));
    for (size_t i = 0; i < work->tree.num; i++) {
        const struct csg_node *node = &work->tree.data[i];
        hash = csg_hash_number(hash,
                               (uint64_t)node->end << 8 | (uint64_t)(2 * node->op + node->negated));
        if (node->op == CSG_LEAF)
            hash = csg_hash_number(hash, leaf_keys[node->leaf]);
    }
    return hash;
}

/* What follows a part's making, from one builder to another. */
static void move_cells(struct csg_cell_builder *to, struct csg_cell_builder *from)
{
    memcpy(&to->branches, &from->branches, sizeof to->branches);
    memcpy(&to->records, &from->records, sizeof to->records);
    memcpy(&to->bunches.texels, &from->bunches.texels, sizeof to->bunches.texels);
    memset(&from->branches, 0, sizeof from->branches);
    memset(&from->records, 0, sizeof from->records);
    memset(&from->bunches.texels, 0, sizeof from->bunches.texels);
    to->nested = from->nested;
    to->bunched = from->bunched;
}

struct csg_kept *csg_kept_create(struct csg_cell_builder *parts, const uint64_t *keys, size_t num)
{
    struct csg_kept *kept = calloc(1, sizeof *kept + num * sizeof *kept->parts);
    if (!kept)
        return NULL;
    kept->num = num;
    for (size_t i = 0; i < num; i++) {
        kept->parts[i].key = keys[i];
        move_cells(&kept->parts[i].cells, &parts[i]);
    }
    return kept;
}

void csg_kept_destroy(struct csg_kept *kept)
{
    for (size_t i = 0; kept && i < kept->num; i++)
        csg_cell_builder_finish(&kept->parts[i].cells);
    free(kept);
}

bool csg_kept_take(struct csg_kept *kept, uint64_t key, struct csg_cell_builder *part)
{
    for (size_t i = 0; kept && i < kept->num; i++) {
        struct kept_part *own = &kept->parts[i];
        if (own->key != key || own->taken)
            continue;
        own->taken = true;
        move_cells(part, &own->cells);
        return true;
    }
    return false;
}
