/* SPDX-License-Identifier: MIT */

/* The public edits: checked, made as patches of single leaves, and put in all at once. */

#include <stdlib.h>
#include <string.h>

#include "csg/wholes.h"
#include "prepare/follow.h"
#include "prepare/framing.h"
#include "scene/edits.h"

/* The changes of one call. */
struct session {
    struct csgcast_scene *scene;
    CSG_ARRAY(struct csg_patch) patches;
    bool moves;    /* some edit changes more than a colour that lets nothing through */
    bool regroups; /* a node of several solids becomes translucent, or opaque again */
};

size_t csgcast_scene_num_leaves(const struct csgcast_scene *scene)
{
    return scene ? scene->num_leaves : 0;
}

static bool has_leaf(const struct csgcast_scene *scene, size_t leaf)
{
    if (leaf < scene->num_leaves)
        return true;
    csg_log_error(&scene->log, CSGCAST_MESSAGE_ARGUMENT, "%s: there is no leaf %zu of %zu",
                  scene->name, leaf, scene->num_leaves);
    return false;
}

static void copy_matrix(const struct csg_map *map, double matrix[16])
{
    static const double last[4] = {0, 0, 0, 1};
    memcpy(matrix, map->m, sizeof map->m);
    memcpy(matrix + 12, last, sizeof last);
}

bool csgcast_scene_get_leaf(struct csgcast_scene *scene, size_t index, struct csgcast_leaf *info)
{
    if (!scene || !has_leaf(scene, index) || !csg_edits_of(scene))
        return false;
    const struct csg_leaf *leaf = &scene->leaves[index];
    const struct csg_origin *origin = &scene->edits->origins.data[index];
    *info = (struct csgcast_leaf){.kind = csg_kind_name(leaf->kind),
                                  .line = leaf->line,
                                  .column = leaf->column,
                                  .first = origin->first,
                                  .num = origin->num,
                                  .empty = leaf->is_empty,
                                  .parameters = origin->parameters ? origin->parameters : ""};
    copy_matrix(&origin->space.map, info->matrix);
    memcpy(info->color, leaf->color, sizeof info->color);
    return true;
}

/* ---- what an edit may say ------------------------------------------------------------------ */

static bool wrong(const struct session *session, size_t leaf, const char *text)
{
    csg_log_error(&session->scene->log, CSGCAST_MESSAGE_ARGUMENT, "<edit of leaf %zu>: %s", leaf,
                  text);
    return false;
}

static bool check_matrix(const struct session *session, size_t leaf, const double *matrix)
{
    for (int i = 0; i < 12; i++)
        if (!isfinite(matrix[i]))
            return wrong(session, leaf, "the matrix has an entry that is not finite");
    if (matrix[12] != 0 || matrix[13] != 0 || matrix[14] != 0 || matrix[15] != 1)
        return wrong(session, leaf, "the matrix's last row must be 0 0 0 1; matrices are by rows");
    return true;
}

static bool check_color(const struct session *session, size_t leaf, const float *color)
{
    for (int i = 0; i < 4; i++)
        if (!isfinite(color[i]))
            return wrong(session, leaf, "the colour has a component that is not finite");
    return true;
}

static bool check(const struct session *session, const struct csgcast_edit *edit)
{
    return has_leaf(session->scene, edit->leaf) &&
           (!edit->matrix || check_matrix(session, edit->leaf, edit->matrix)) &&
           (!edit->color || check_color(session, edit->leaf, edit->color));
}

/* ---- the patches --------------------------------------------------------------------------- */

/* The leaf's patch; the next edit may move it. NULL, with a message, when memory is out. */
static struct csg_patch *patch_of(struct session *session, uint32_t leaf)
{
    uint32_t *place = &session->scene->edits->patches[leaf];
    if (*place)
        return &session->patches.data[*place - 1];
    struct csg_patch patch;
    if (!csg_patch_init(&patch, session->scene, leaf) ||
        !csg_array_push(&session->patches, patch)) {
        csg_patch_finish(&patch);
        csg_log_memory(&session->scene->log);
        return NULL;
    }
    *place = (uint32_t)session->patches.num;
    return &session->patches.data[*place - 1];
}

static bool add_to_leaf(struct session *session, const struct csgcast_edit *edit, uint32_t leaf)
{
    struct csg_patch *patch = patch_of(session, leaf);
    if (!patch)
        return false;
    if (edit->matrix)
        csg_patch_set_matrix(patch, edit->matrix);
    return !edit->parameters || csg_patch_set_parameters(patch, session->scene, edit->parameters);
}

static bool add_color(struct session *session, const float *color, uint32_t begin, uint32_t end)
{
    for (uint32_t i = begin; i < end; i++) {
        struct csg_patch *patch = patch_of(session, i);
        if (!patch)
            return false;
        csg_patch_set_color(patch, color);
    }
    return true;
}

/* An edit of one of a node's leaves is one of all of them; what is in a render() has one colour. */
static bool add_edit(struct session *session, const struct csgcast_edit *edit)
{
    if (!check(session, edit))
        return false;
    const struct csg_origin *origin = &session->scene->edits->origins.data[edit->leaf];
    const struct csg_whole *whole = csg_find_whole(session->scene, (uint32_t)edit->leaf);
    const uint32_t first = (uint32_t)origin->first, end = first + (uint32_t)origin->num;
    session->moves |= edit->matrix || edit->parameters;
    for (uint32_t i = first; i < end; i++)
        if (!add_to_leaf(session, edit, i))
            return false;
    return !edit->color ||
           add_color(session, edit->color, whole ? whole->begin : first, whole ? whole->end : end);
}

static void swap_all(struct session *session)
{
    for (size_t i = 0; i < session->patches.num; i++)
        csg_patch_swap(&session->patches.data[i], session->scene);
}

/* What lets others show through is drawn by other rules. */
static void note_translucency(struct session *session)
{
    const struct csgcast_scene *scene = session->scene;
    for (size_t i = 0; i < session->patches.num; i++) {
        const struct csg_patch *patch = &session->patches.data[i];
        const struct csg_leaf *leaf = &scene->leaves[patch->index];
        if (csg_leaf_is_translucent(leaf) == csg_leaf_is_translucent(&patch->leaf))
            continue;
        session->moves = true;
        session->regroups |=
            scene->edits->origins.data[patch->index].num > 1 || scene->wholes.num > 0;
    }
}

/* Makes anew what follows from the patches, which are in. */
static bool refinish(struct session *session, const uint32_t *leaves)
{
    const size_t num = session->patches.num;
    const struct csg_shape **shapes = malloc((num + 1) * sizeof *shapes);
    if (!shapes)
        return csg_log_memory(&session->scene->log);
    for (size_t i = 0; i < num; i++)
        shapes[i] = &session->patches.data[i].leaf.shape;
    const bool ok = csg_edits_refinish(session->scene, shapes, leaves, num, session->regroups);
    free(shapes);
    return ok;
}

/* Puts the patches of these leaves in. false, with nothing changed, when memory is out. */
static bool put_in(struct session *session, const uint32_t *leaves)
{
    for (size_t i = 0; i < session->patches.num && session->moves; i++)
        if (!csg_patch_place(&session->patches.data[i]))
            return csg_log_memory(&session->scene->log);
    swap_all(session);
    if (session->moves && !refinish(session, leaves)) {
        swap_all(session);
        return false;
    }
    if (!session->moves)
        csg_follow_colors(session->scene, leaves, session->patches.num);
    session->scene->revision++;
    return true;
}

static bool commit(struct session *session)
{
    const size_t num = session->patches.num;
    uint32_t *leaves = malloc((num + 1) * sizeof *leaves);
    if (!leaves)
        return csg_log_memory(&session->scene->log);
    for (size_t i = 0; i < num; i++)
        leaves[i] = session->patches.data[i].index;
    note_translucency(session);
    const bool ok = put_in(session, leaves);
    free(leaves);
    return ok;
}

bool csgcast_scene_edit(struct csgcast_scene *scene, const struct csgcast_edit *edits,
                        size_t num_edits)
{
    struct session session = {.scene = scene};
    if (scene && !edits && num_edits > 0) {
        csg_log_error(&scene->log, CSGCAST_MESSAGE_ARGUMENT, "an edit needs the edits");
        return false;
    }
    bool ok = scene && csg_edits_of(scene);
    for (size_t i = 0; i < num_edits && ok; i++)
        ok = add_edit(&session, &edits[i]);
    ok = ok && commit(&session);
    for (size_t i = 0; i < session.patches.num; i++) {
        scene->edits->patches[session.patches.data[i].index] = 0;
        csg_patch_finish(&session.patches.data[i]);
    }
    free(session.patches.data);
    return ok;
}

bool csgcast_scene_set_matrix(struct csgcast_scene *scene, size_t leaf, const double matrix[16])
{
    const struct csgcast_edit edit = {.leaf = leaf, .matrix = matrix};
    return csgcast_scene_edit(scene, &edit, 1);
}

bool csgcast_scene_set_parameters(struct csgcast_scene *scene, size_t leaf, const char *parameters)
{
    const struct csgcast_edit edit = {.leaf = leaf, .parameters = parameters};
    return csgcast_scene_edit(scene, &edit, 1);
}

bool csgcast_scene_set_color(struct csgcast_scene *scene, size_t leaf, const float color[4])
{
    const struct csgcast_edit edit = {.leaf = leaf, .color = color};
    return csgcast_scene_edit(scene, &edit, 1);
}
