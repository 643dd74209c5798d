/* SPDX-License-Identifier: MIT */

/* The public edits: checked, made as patches of single leaves, and put in all at once. */

#include <stdlib.h>
#include <string.h>

#include "common/clock.h"
#include "csg/wholes.h"
#include "prepare/follow.h"
#include "prepare/framing.h"
#include "scene/parameters.h"
#include "scene/reading.h"

/* Arguments of a node, as they were. */
struct old_text {
    uint32_t node;
    char *arguments;
};

/* The changes of one call. */
struct session {
    struct csgcast_scene *scene;
    CSG_ARRAY(struct csg_patch) patches;
    CSG_ARRAY(struct old_text) old_texts;
    CSG_ARRAY(uint32_t) compounds;          /* first leaves of nodes that are read anew */
    CSG_ARRAY(struct csg_reading) readings; /* of those that get another tree */
    bool moves;    /* some edit changes more than a colour that lets nothing through */
    bool regroups; /* a node of several solids becomes translucent, or opaque again */
};

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
    return csg_edits_has_leaf(session->scene, edit->leaf) &&
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

static bool add_matrix(struct session *session, const double *matrix, uint32_t begin, uint32_t end)
{
    for (uint32_t i = begin; i < end; i++) {
        struct csg_patch *patch = patch_of(session, i);
        if (!patch)
            return false;
        csg_patch_set_matrix(patch, matrix);
    }
    return true;
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

/* ---- parameters ---------------------------------------------------------------------------- */

/* What # and % show of what is in a node is read with the node and once more by itself. */
static bool check_node(const struct session *session, const struct csgcast_edit *edit)
{
    const struct csgcast_scene *scene = session->scene;
    const struct csg_origin *origins = scene->edits->origins.data, *origin = &origins[edit->leaf];
    const size_t behind = (size_t)origin->first + origin->num;
    const uint32_t end = origin->node + csg_edits_count_nodes(scene, origin);
    if (!csg_edits_has_node(scene, edit->leaf, edit->node))
        return false;
    if (origin->is_inside ||
        (edit->node > 0 && behind < scene->num_leaves && origins[behind].node < end))
        return wrong(session, edit->leaf,
                     "# or % shows part of what is in this node by itself: parameters of that "
                     "cannot be set; load the changed text instead");
    return true;
}

/* The text gets the node's new arguments. */
static bool set_text(struct session *session, uint32_t node, const char *arguments)
{
    char **text = &session->scene->edits->texts.arguments[node];
    const struct old_text old = {node, *text};
    const size_t size = strlen(arguments) + 1;
    char *copy = malloc(size);
    if (!copy || !csg_array_push(&session->old_texts, old)) {
        free(copy);
        return csg_log_memory(&session->scene->log);
    }
    memcpy(copy, arguments, size);
    *text = copy;
    return true;
}

/* Those that are not the scene's in the end. */
static void finish_texts(struct session *session, bool ok)
{
    for (size_t i = session->old_texts.num; i-- > 0;) {
        struct old_text *old = &session->old_texts.data[i];
        char **text = &session->scene->edits->texts.arguments[old->node];
        if (!ok) {
            char *arguments = *text;
            *text = old->arguments;
            old->arguments = arguments;
        }
        free(old->arguments);
    }
    free(session->old_texts.data);
}

/* Whether the arguments of a node that becomes a part are well formed. */
static bool check_parameters(const struct session *session, const struct csgcast_edit *edit,
                             uint32_t node)
{
    struct csg_parameters parameters;
    const bool ok = csg_parameters_read(&parameters, session->scene, (uint32_t)edit->leaf,
                                        csg_node_texts_name(&session->scene->edits->texts, node),
                                        edit->parameters);
    return csg_parameters_finish(&parameters) && ok;
}

static bool add_compound(struct session *session, uint32_t first)
{
    struct csg_patch *patch = patch_of(session, first);
    if (!patch || patch->is_read)
        return patch != NULL;
    patch->is_read = true;
    return csg_array_push(&session->compounds, first) || csg_log_memory(&session->scene->log);
}

static bool add_parameters(struct session *session, const struct csgcast_edit *edit)
{
    if (!check_node(session, edit))
        return false;
    const struct csg_origin *origin = &session->scene->edits->origins.data[edit->leaf];
    const uint32_t node = origin->node + (uint32_t)edit->node;
    if (origin->is_compound)
        return check_parameters(session, edit, node) && set_text(session, node, edit->parameters) &&
               add_compound(session, origin->first);
    struct csg_patch *patch = patch_of(session, (uint32_t)edit->leaf);
    return patch && csg_patch_set_parameters(patch, session->scene, edit->parameters) &&
           set_text(session, node, edit->parameters);
}

/* The shapes of a node that has the tree that it had, or of which nothing is left. */
static bool put_shapes(struct session *session, struct csg_reading *reading)
{
    for (uint32_t i = 0; i < reading->num_before; i++) {
        struct csg_patch *patch = patch_of(session, reading->first + i);
        if (!patch)
            return false;
        if (reading->num > 0)
            csg_patch_set_shape(patch, reading->scene->leaves[reading->begin + i].kind,
                                &reading->origins.data[reading->begin + i].shape);
        else
            patch->origin.is_nothing = true;
    }
    return true;
}

/* Once all changes of what is in it are known. */
static bool read_compound(struct session *session, uint32_t first)
{
    struct csg_reading reading;
    const struct csg_patch *patch = patch_of(session, first);
    bool ok = patch && csg_reading_init(&reading, session->scene, patch);
    if (ok && !reading.is_alike && csg_array_push(&session->readings, reading))
        return true;
    if (ok)
        ok =
            reading.is_alike ? put_shapes(session, &reading) : csg_log_memory(&session->scene->log);
    if (patch)
        csg_reading_finish(&reading);
    return ok;
}

/* ---- edits --------------------------------------------------------------------------------- */

/* An edit of one of a node's leaves is one of all of them; what is in a render() has one colour. */
static bool add_edit(struct session *session, const struct csgcast_edit *edit)
{
    if (!check(session, edit))
        return false;
    const struct csg_origin *origin = &session->scene->edits->origins.data[edit->leaf];
    const struct csg_whole *whole = csg_find_whole(session->scene, (uint32_t)edit->leaf);
    const uint32_t first = (uint32_t)origin->first, end = first + (uint32_t)origin->num;
    session->moves |= edit->matrix || edit->parameters;
    return (!edit->matrix || add_matrix(session, edit->matrix, first, end)) &&
           (!edit->parameters || add_parameters(session, edit)) &&
           (!edit->color || add_color(session, edit->color, whole ? whole->begin : first,
                                      whole ? whole->end : end));
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

static bool follow(struct session *session, const uint32_t *leaves)
{
    return session->readings.num > 0
               ? csg_edits_regrow(session->scene, session->readings.data, session->readings.num)
               : refinish(session, leaves);
}

static void recolor(struct session *session, const uint32_t *leaves)
{
    const double start = csg_clock_ms();
    csg_follow_colors(session->scene, leaves, session->patches.num);
    session->scene->csg_ms = csg_clock_ms() - start;
}

/* Puts the patches of these leaves in. false, with nothing changed, when memory is out. */
static bool put_in(struct session *session, const uint32_t *leaves)
{
    for (size_t i = 0; i < session->patches.num && session->moves; i++)
        if (!csg_patch_place(&session->patches.data[i]))
            return csg_log_memory(&session->scene->log);
    swap_all(session);
    if (session->moves && !follow(session, leaves)) {
        swap_all(session);
        return false;
    }
    if (!session->moves)
        recolor(session, leaves);
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

static void finish(struct session *session, bool ok)
{
    struct csgcast_scene *scene = session->scene;
    for (size_t i = 0; i < session->patches.num; i++) {
        const uint32_t leaf = session->patches.data[i].index;
        if (leaf < scene->num_leaves) /* there may be fewer now */
            scene->edits->patches[leaf] = 0;
        csg_patch_finish(&session->patches.data[i]);
    }
    for (size_t i = 0; i < session->readings.num; i++)
        csg_reading_finish(&session->readings.data[i]);
    finish_texts(session, ok);
    free(session->readings.data);
    free(session->compounds.data);
    free(session->patches.data);
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
    for (size_t i = 0; i < session.compounds.num && ok; i++)
        ok = read_compound(&session, session.compounds.data[i]);
    ok = ok && commit(&session);
    finish(&session, ok);
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
