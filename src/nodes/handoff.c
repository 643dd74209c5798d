/* SPDX-License-Identifier: MIT */
#include "nodes/handoff.h"

#include <stdio.h>
#include <stdlib.h>

#include "nodes/handoff_mesh.h"
#include "nodes/polyhedron.h"
#include "nodes/subtree.h"
#include "nodes/transforms.h"

void csg_handoff_init(struct csg_handoff *handoff, const struct csgcast_scene_params *params,
                      const struct csg_document *document)
{
    *handoff = (struct csg_handoff){.params = params, .document = document};
}

void csg_handoff_finish(struct csg_handoff *handoff)
{
    for (size_t i = 0; i < handoff->results.num; i++) {
        csg_mesh_finish(&handoff->results.data[i].mesh);
        free(handoff->results.data[i].text.data);
    }
    free(handoff->results.data);
    free(handoff->nodes.data);
}

const struct csg_handed_off *csg_handoff_find(const struct csg_handoff *handoff, uint32_t node)
{
    size_t low = 0, high = handoff->num_evaluated;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (handoff->nodes.data[middle].node < node)
            low = middle + 1;
        else
            high = middle;
    }
    const bool is_there = low < handoff->num_evaluated && handoff->nodes.data[low].node == node;
    return is_there ? &handoff->nodes.data[low] : NULL;
}

bool csg_handoff_want(struct csg_handoff *handoff, uint32_t node, uint8_t dimension,
                      const char *reason)
{
    const uint32_t end = handoff->document->nodes.data[node].end;
    struct csg_handed_off wanted = {.node = node, .end = end, .dimension = dimension};
    if (handoff->params->no_handoff || dimension == 0 || csg_handoff_find(handoff, node) ||
        csg_subtree_find_foreign(handoff->document, node) < end)
        return false;
    snprintf(wanted.reason, sizeof wanted.reason, "%s", reason);
    return csg_array_push(&handoff->nodes, wanted);
}

static struct csg_handed_off_node describe(const struct csg_handoff *handoff,
                                           const struct csg_handed_off *handed_off)
{
    const struct csg_parsed_node *parsed = &handoff->document->nodes.data[handed_off->node];
    const struct csg_handoff_result *result = &handoff->results.data[handed_off->result];
    struct csg_handed_off_node node = {.line = parsed->place.line,
                                       .column = parsed->place.column,
                                       .seconds = result->seconds,
                                       .is_cached = result->is_cached};
    const size_t length = sizeof node.name - 1;
    snprintf(node.name, sizeof node.name, "%.*s",
             (int)(parsed->name_length < length ? parsed->name_length : length),
             handoff->document->text + parsed->at);
    snprintf(node.reason, sizeof node.reason, "%s", handed_off->reason);
    return node;
}

bool csg_handoff_note(const struct csg_handoff *handoff, struct csgcast_scene *scene)
{
    bool ok = true;
    for (size_t i = 0; i < handoff->num_evaluated && ok; i++)
        ok = csg_array_push(&scene->handed_off, describe(handoff, &handoff->nodes.data[i]));
    return ok || csg_log_memory(&scene->log);
}

/* ---- in the place of the node --------------------------------------------------------------- */

static bool copy_mesh(const struct csg_mesh *from, struct csg_mesh *mesh)
{
    bool ok = true;
    for (size_t i = 0; i < from->points.num && ok; i++)
        ok = csg_mesh_add_point(mesh, from->points.data[i]);
    for (size_t i = 0; i < from->faces.num && ok; i++) {
        const struct csg_mesh_face *face = &from->faces.data[i];
        for (uint32_t k = face->begin; k < face->end && ok; k++)
            ok = csg_array_push(&mesh->corners, from->corners.data[k]);
        ok = ok && csg_mesh_close_face(mesh);
    }
    mesh->rounding = from->rounding;
    mesh->keeps_dents = true; /* a result of its kernel */
    return ok;
}

static const struct csg_mesh *mesh_of(const struct csg_builder *builder, uint32_t node)
{
    const struct csg_handed_off *handed_off = csg_handoff_find(builder->handoff, node);
    return &builder->handoff->results.data[handed_off->result].mesh;
}

static bool compound(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                     bool in_boolean, struct csg_part *part)
{
    struct csg_mesh mesh = {0};
    const bool ok = (copy_mesh(mesh_of(walk->builder, node), &mesh) || csg_log_memory(args->log)) &&
                    csg_polyhedron_add(walk, node, in_boolean, &mesh, part);
    csg_mesh_finish(&mesh);
    return ok;
}

static bool figure(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                   const struct csg_space *space, struct csg_drawing *drawing)
{
    const struct csg_mesh *mesh = mesh_of(walk->builder, node);
    struct csg_box box = csg_box_empty;
    struct csg_map inverse;
    for (size_t i = 0; i < mesh->points.num; i++)
        csg_box_extend(&box, mesh->points.data[i]);
    if (space->is_empty || !csg_map_invert(&space->map, &inverse) || mesh->faces.num == 0)
        return csg_drawing_open(drawing, CSG_DRAW_UNION) || csg_log_memory(args->log);
    const double rounding =
        mesh->rounding * csg_space_stretch(space) + csg_space_rounding(space, &box);
    return csg_stl_outline(mesh, &space->map, rounding, drawing) || csg_log_memory(args->log);
}

static const struct csg_node_ops solid_ops = {
    .name = "openscad",
    .role = CSG_ROLE_COMPOUND,
    .dimension = 3,
    .kind = CSG_KIND_OPENSCAD,
    .compound = compound,
};

static const struct csg_node_ops drawing_ops = {
    .name = "openscad",
    .role = CSG_ROLE_FIGURE,
    .dimension = 2,
    .kind = CSG_KIND_OPENSCAD,
    .figure = figure,
};

const struct csg_node_ops *csg_handoff_ops(uint8_t dimension)
{
    return dimension == 2 ? &drawing_ops : &solid_ops;
}
