/* SPDX-License-Identifier: MIT */
/*
 * What # and % show, by the rules of OpenSCAD's preview (CSGTreeEvaluator.cc of 2021.01). A mark
 * climbs: a union or an intersection of nothing but highlighted operands is highlighted itself, and
 * so is a difference whose first operand is; a node with nothing but background in it is
 * background. Where it climbs no further the node shows, but directly in a node that becomes one
 * mesh (an extrusion, a render()) it is lost. Of hulls, sums and resize() it shows what is in them.
 */
#include <stdlib.h>

#include "nodes/walk.h"

/* What is known of a node. */
enum { EXISTS = 1, HIGHLIGHT = 2, BACKGROUND = 4, LOST = 8 };

/* Meshes inside of each other in which # and % show. Each is read with all that is in it, so that
 * without bound the work would grow with the square of the text. */
enum { max_nested = 8 };

struct marker {
    struct csg_builder *builder;
    uint8_t *flags;  /* by node */
    uint8_t *nested; /* by node: the meshes around it, at most max_nested + 1 */
    bool was_warned;
};

/* The operands of a node: those that are no background, and how many of them are highlighted. */
struct operands {
    uint32_t num, num_highlighted, num_background;
    bool first_highlighted;
};

static struct operands count_operands(const struct marker *marker, uint32_t node)
{
    const struct csg_parsed_node *nodes = marker->builder->document->nodes.data;
    struct operands operands = {0};
    for (uint32_t i = node + 1; i < nodes[node].end; i = nodes[i].end) {
        const uint8_t flags = marker->flags[i];
        if (!(flags & EXISTS))
            continue;
        if (flags & BACKGROUND) {
            operands.num_background++;
            continue;
        }
        operands.first_highlighted |= operands.num == 0 && flags & HIGHLIGHT;
        operands.num_highlighted += (flags & HIGHLIGHT) != 0;
        operands.num++;
    }
    return operands;
}

static bool is_opaque(const struct csg_meaning *meaning)
{
    return meaning->is_handed_off || meaning->role == CSG_ROLE_SOLID ||
           meaning->role == CSG_ROLE_UNSUPPORTED || meaning->role == CSG_ROLE_UNKNOWN;
}

/* Whether a mark of an operand goes no further than the node. */
static bool is_end(const struct csg_meaning *meaning)
{
    return meaning->is_whole || !csg_has_children(meaning);
}

static uint8_t own_flags(const struct csg_parsed_node *parsed)
{
    return (uint8_t)((parsed->modifiers & CSG_MODIFIER_HIGHLIGHT ? HIGHLIGHT : 0) |
                     (parsed->modifiers & CSG_MODIFIER_BACKGROUND ? BACKGROUND : 0));
}

static void show_operands(struct marker *marker, uint32_t node, bool all)
{
    const struct csg_parsed_node *nodes = marker->builder->document->nodes.data;
    for (uint32_t i = node + 1; i < nodes[node].end; i = nodes[i].end)
        if ((marker->flags[i] & (EXISTS | HIGHLIGHT)) == (EXISTS | HIGHLIGHT) &&
            (all || marker->flags[i] & BACKGROUND))
            marker->builder->meanings[i].shows_highlight = true;
}

/* Which operands show, and the node's own flags. Its operands' are known. */
static void resolve(struct marker *marker, uint32_t node)
{
    const struct csg_parsed_node *parsed = &marker->builder->document->nodes.data[node];
    const struct csg_meaning *meaning = &marker->builder->meanings[node];
    const bool is_difference = meaning->role == CSG_ROLE_DIFFERENCE;
    const struct operands operands = count_operands(marker, node);
    uint8_t flags = own_flags(parsed);
    if (parsed->modifiers & CSG_MODIFIER_DISABLE || meaning->is_misplaced)
        return;
    if (is_end(meaning)) {
        marker->flags[node] = EXISTS | flags;
        if (meaning->shows_marks && !meaning->is_handed_off)
            show_operands(marker, node, true);
        return;
    }
    const bool climbs = is_difference
                            ? operands.first_highlighted
                            : operands.num > 0 && operands.num_highlighted == operands.num;
    /* A highlighted union shows with all that is in it. */
    const bool is_covering = climbs || (meaning->role == CSG_ROLE_UNION && flags & HIGHLIGHT);
    show_operands(marker, node, !is_covering);
    flags |= operands.num + operands.num_background > 0 ? EXISTS : 0;
    flags |= climbs ? HIGHLIGHT : 0;
    flags |= operands.num == 0 && operands.num_background > 0 ? BACKGROUND : 0;
    marker->flags[node] = flags;
}

static bool is_too_deep(struct marker *marker, uint32_t node)
{
    if (marker->nested[node] <= max_nested)
        return false;
    if (!marker->was_warned)
        csg_report_warning(marker->builder->report, CSGCAST_MESSAGE_SCENE,
                           marker->builder->document->nodes.data[node].place,
                           "'#' and '%%' in more than %d meshes inside of each other are left out",
                           max_nested);
    return marker->was_warned = true;
}

/* From the outside: what is lost, and what is only passed on the way to what shows. */
static void spread(struct marker *marker, uint32_t node)
{
    const struct csg_parsed_node *nodes = marker->builder->document->nodes.data;
    struct csg_meaning *meanings = marker->builder->meanings;
    const struct csg_meaning *meaning = &meanings[node];
    const bool is_lost = is_end(meaning) ? !meaning->shows_marks
                                         : marker->flags[node] & LOST &&
                                               !(nodes[node].modifiers & CSG_MODIFIER_BACKGROUND);
    const bool is_deeper = !csg_has_children(meaning) && marker->nested[node] <= max_nested;
    for (uint32_t i = node + 1; i < nodes[node].end; i = nodes[i].end) {
        const bool is_background = (nodes[i].modifiers & CSG_MODIFIER_BACKGROUND) != 0;
        marker->nested[i] = (uint8_t)(marker->nested[node] + is_deeper);
        if (is_lost && marker->flags[i] & BACKGROUND)
            marker->flags[i] |= LOST;
        meanings[i].shows_background = is_background && !(marker->flags[i] & LOST);
        if ((meanings[i].shows_background || meanings[i].shows_highlight) && is_too_deep(marker, i))
            meanings[i].shows_background = meanings[i].shows_highlight = false;
        meanings[i].is_idle = (meaning->is_idle || !csg_has_children(meaning)) &&
                              !meanings[i].shows_background && !meanings[i].shows_highlight;
    }
}

static void hold(struct csg_builder *builder, uint32_t node)
{
    const struct csg_parsed_node *nodes = builder->document->nodes.data;
    struct csg_meaning *meaning = &builder->meanings[node];
    for (uint32_t i = node + 1; i < nodes[node].end && !meaning->holds_shown; i = nodes[i].end) {
        const struct csg_meaning *child = &builder->meanings[i];
        meaning->holds_shown =
            !is_opaque(meaning) &&
            (child->shows_background || child->shows_highlight || child->holds_shown);
    }
}

/* The outermost nodes are operands of a union that shows all of them. */
static void show_roots(struct marker *marker)
{
    const struct csg_builder *builder = marker->builder;
    const struct csg_parsed_node *nodes = builder->document->nodes.data;
    for (uint32_t i = builder->begin; i < builder->end; i = nodes[i].end) {
        const uint8_t flags = marker->flags[i];
        builder->meanings[i].shows_background = (nodes[i].modifiers & CSG_MODIFIER_BACKGROUND) != 0;
        builder->meanings[i].shows_highlight = (flags & EXISTS) && flags & HIGHLIGHT;
    }
}

/* Drawings in what shows. */
static void draw_slabs(struct csg_builder *builder)
{
    uint32_t end = 0;
    for (uint32_t i = builder->begin; i < builder->end; i++) {
        struct csg_meaning *meaning = &builder->meanings[i];
        if ((meaning->shows_background || meaning->shows_highlight) && meaning->dimension == 2 &&
            builder->document->nodes.data[i].end > end)
            end = builder->document->nodes.data[i].end;
        if (i < end && !meaning->is_idle)
            csg_make_slab(meaning);
    }
}

static bool has_marks(const struct csg_builder *builder)
{
    bool found = false;
    for (uint32_t i = builder->begin; i < builder->end && !found; i++)
        found = own_flags(&builder->document->nodes.data[i]) != 0;
    return found;
}

static void mark(struct marker *marker)
{
    struct csg_builder *builder = marker->builder;
    for (uint32_t i = builder->end; i-- > builder->begin;)
        resolve(marker, i);
    show_roots(marker);
    for (uint32_t i = builder->begin; i < builder->end; i++)
        spread(marker, i);
    for (uint32_t i = builder->end; i-- > builder->begin;)
        hold(builder, i);
    draw_slabs(builder);
}

bool csg_build_marks(struct csg_builder *builder)
{
    struct marker marker = {.builder = builder};
    if (!has_marks(builder))
        return true;
    marker.flags = calloc(builder->document->nodes.num + 1, sizeof *marker.flags);
    marker.nested = calloc(builder->document->nodes.num + 1, sizeof *marker.nested);
    const bool ok = marker.flags && marker.nested;
    if (ok)
        mark(&marker);
    free(marker.flags);
    free(marker.nested);
    return ok || csg_log_memory(&builder->report->log);
}
