/* SPDX-License-Identifier: MIT */
#include "nodes/repeats.h"

#include <stdlib.h>
#include <string.h>

#include "common/hash.h"
#include "nodes/compounds.h"
#include "nodes/handoff.h"
#include "nodes/subtree.h"

/* Bytes of parts that are kept at most. */
#define MAX_BYTES ((size_t)64 << 20)

/* A part that was met: at first only that it was. */
struct entry {
    uint64_t hash;
    bool is_kept;
    struct csg_bytes key;
    struct csg_part part;
};

struct csg_repeats {
    CSG_ARRAY(struct entry) entries;
    CSG_ARRAY(uint32_t) table; /* by hash: entry + 1, or 0; a power of two, at most half full */
    size_t bytes;
};

struct csg_repeats *csg_repeats_create(void)
{
    return calloc(1, sizeof(struct csg_repeats));
}

void csg_repeats_destroy(struct csg_repeats *repeats)
{
    for (size_t i = 0; repeats && i < repeats->entries.num; i++) {
        free(repeats->entries.data[i].key.data);
        csg_part_finish(&repeats->entries.data[i].part);
    }
    if (repeats) {
        free(repeats->entries.data);
        free(repeats->table.data);
    }
    free(repeats);
}

/* ---- keys --------------------------------------------------------------------------------- */

static bool has_children(const struct csg_walk *walk, uint32_t node)
{
    return csg_walk_node(walk, node)->end > node + 1;
}

/* Of a node with a twin that is enough. */
static bool append_text(const struct csg_walk *walk, uint32_t node, struct csg_bytes *key)
{
    const uint32_t twin = csg_walk_node(walk, node)->twin;
    struct csg_subtree subtree = {0};
    if (!has_children(walk, node) && twin != CSG_NO_TWIN)
        return csg_bytes_append(key, (const char *)&twin, sizeof twin);
    const bool ok = csg_subtree_write(&subtree, walk->builder->document, node) &&
                    csg_bytes_append(key, subtree.text.data, subtree.text.num);
    csg_subtree_finish(&subtree);
    return ok;
}

/* All that a part depends on: the text, what the walks before made of its nodes, and what is wanted
 * of it. */
static bool fill_key(const struct csg_walk *walk, uint32_t node, bool in_boolean,
                     struct csg_bytes *key)
{
    const struct csg_builder *builder = walk->builder;
    const uint32_t end = csg_walk_node(walk, node)->end;
    const char wanted[] = {
        (char)in_boolean,           (char)walk->points_only,
        (char)builder->facets,      (char)walk->is_operand,
        (char)walk->is_see_through, (char)(csg_walk_node(walk, node)->twin != CSG_NO_TWIN)};
    bool ok = csg_bytes_append(key, wanted, sizeof wanted);
    for (uint32_t i = node; i < end && ok; i++) {
        const struct csg_meaning *m = &builder->meanings[i];
        const char meaning[] = {(char)m->role, (char)m->kind, (char)m->dimension,
                                (char)(m->is_handed_off + 2 * m->is_slab + 4 * m->is_misplaced)};
        ok = csg_bytes_append(key, meaning, sizeof meaning);
    }
    return ok && append_text(walk, node, key);
}

/* ---- the table ---------------------------------------------------------------------------- */

static uint32_t *place_of(const struct csg_repeats *repeats, uint64_t hash)
{
    const size_t mask = repeats->table.num - 1;
    size_t i = (size_t)hash & mask;
    while (repeats->table.data[i] && repeats->entries.data[repeats->table.data[i] - 1].hash != hash)
        i = (i + 1) & mask;
    return &repeats->table.data[i];
}

static bool make_room(struct csg_repeats *repeats)
{
    const size_t num = repeats->table.num ? 2 * repeats->table.num : 64;
    if (repeats->table.num > 2 * repeats->entries.num)
        return true;
    if (!csg_array_reserve(&repeats->table, num - repeats->table.num))
        return false;
    repeats->table.num = num;
    memset(repeats->table.data, 0, num * sizeof *repeats->table.data);
    for (size_t i = 0; i < repeats->entries.num; i++)
        *place_of(repeats, repeats->entries.data[i].hash) = (uint32_t)i + 1;
    return true;
}

/* The entry of that hash; NULL: there was none, and now there is. */
static struct entry *find_or_add(struct csg_repeats *repeats, uint64_t hash, bool *ok)
{
    *ok = make_room(repeats);
    uint32_t *place = *ok ? place_of(repeats, hash) : NULL;
    if (place && *place)
        return &repeats->entries.data[*place - 1];
    *ok = *ok && csg_array_push(&repeats->entries, (struct entry){.hash = hash});
    if (*ok)
        *place = (uint32_t)repeats->entries.num;
    return NULL;
}

/* ---- copies ------------------------------------------------------------------------------- */

static bool copy_part(struct csg_part *copy, const struct csg_part *part)
{
    *copy = *part;
    copy->shapes.data = NULL;
    copy->tree.data = NULL;
    copy->open.data = NULL;
    copy->shapes.num = copy->tree.num = copy->open.num = 0;
    copy->shapes.capacity = copy->tree.capacity = copy->open.capacity = 0;
    bool ok = csg_array_reserve(&copy->shapes, part->shapes.num) &&
              csg_array_reserve(&copy->tree, part->tree.num);
    for (size_t i = 0; i < part->shapes.num && ok; i++)
        ok = csg_shape_copy(&copy->shapes.data[copy->shapes.num++], &part->shapes.data[i]);
    if (ok && part->tree.num)
        memcpy(copy->tree.data, part->tree.data, part->tree.num * sizeof *part->tree.data);
    copy->tree.num = ok ? part->tree.num : 0;
    return ok;
}

/* Without surfaces, which are shared with the scene. */
static size_t size_of(const struct csg_part *part)
{
    size_t size = part->tree.num * sizeof *part->tree.data;
    for (size_t i = 0; i < part->shapes.num; i++)
        size += sizeof part->shapes.data[i] +
                part->shapes.data[i].num_planes * sizeof(struct csg_plane);
    return size;
}

static bool keep(struct csg_repeats *repeats, struct entry *entry, struct csg_bytes *key,
                 const struct csg_part *part)
{
    const size_t size = size_of(part) + key->num;
    if (repeats->bytes + size > MAX_BYTES)
        return true;
    repeats->bytes += size;
    entry->is_kept = copy_part(&entry->part, part);
    entry->key = *key;
    *key = (struct csg_bytes){0};
    return entry->is_kept;
}

/* ---- reading ------------------------------------------------------------------------------ */

/* Changes where a node was reported, or is to be handed to openscad. */
static size_t count_reports(const struct csg_builder *builder)
{
    size_t num = builder->handoff ? builder->handoff->nodes.num : 0;
    for (int level = 0; level <= CSGCAST_LOG_INFO; level++)
        num += builder->report->num[level];
    return num;
}

static bool read_compound(struct csg_walk *walk, uint32_t node, const struct csg_node_ops *ops,
                          bool in_boolean, struct csg_part *part)
{
    struct csg_args args;
    return csg_walk_args(walk, node, ops->name, ops->parameters, &args) &&
           ops->compound(walk, node, &args, in_boolean, part);
}

/* The same; *is_everywhere: it would be that wherever the node stood, without a word. */
static bool read_and_judge(struct csg_walk *walk, uint32_t node, const struct csg_node_ops *ops,
                           bool in_boolean, struct csg_part *part, bool *is_everywhere)
{
    const size_t reports = count_reports(walk->builder);
    const bool was_placed = walk->was_placed;
    walk->was_placed = false;
    const bool ok = read_compound(walk, node, ops, in_boolean, part);
    *is_everywhere =
        count_reports(walk->builder) == reports && (has_children(walk, node) || !walk->was_placed);
    walk->was_placed |= was_placed;
    return ok;
}

static bool read_or_copy(struct csg_walk *walk, uint32_t node, const struct csg_node_ops *ops,
                         bool in_boolean, struct csg_bytes *key, struct csg_part *part)
{
    struct csg_repeats *repeats = walk->builder->repeats;
    bool ok, is_everywhere;
    const uint64_t hash = csg_hash(CSG_HASH_START, key->data, key->num);
    struct entry *entry = find_or_add(repeats, hash, &ok);
    if (ok && entry && entry->is_kept && entry->key.num == key->num &&
        memcmp(entry->key.data, key->data, key->num) == 0)
        return copy_part(part, &entry->part) || csg_walk_no_memory(walk);
    if (!ok)
        return csg_walk_no_memory(walk);
    const size_t place = entry ? (size_t)(entry - repeats->entries.data) : 0;
    if (!read_and_judge(walk, node, ops, in_boolean, part, &is_everywhere))
        return false;
    if (!entry || !is_everywhere)
        return true;
    entry = &repeats->entries.data[place]; /* what is in the node may have added others */
    return entry->is_kept || keep(repeats, entry, key, part) || csg_walk_no_memory(walk);
}

/* Faces that are not plane are cut in a space outside of the resize() that they are in
 * (cut_space.h), and what has no children, no long text and no file is as soon read as copied. */
static bool depends_on_text(const struct csg_walk *walk, uint32_t node,
                            const struct csg_node_ops *ops)
{
    return !walk->resized && ops->compound != csg_compound_resize &&
           (has_children(walk, node) || csg_walk_node(walk, node)->twin != CSG_NO_TWIN ||
            ops->compound == csg_compound_import || ops->compound == csg_compound_surface);
}

bool csg_repeats_read(struct csg_walk *walk, uint32_t node, const struct csg_node_ops *ops,
                      bool in_boolean, struct csg_part *part)
{
    struct csg_bytes key = {0};
    if (!walk->builder->repeats || !depends_on_text(walk, node, ops))
        return read_compound(walk, node, ops, in_boolean, part);
    const bool ok = fill_key(walk, node, in_boolean, &key)
                        ? read_or_copy(walk, node, ops, in_boolean, &key, part)
                        : csg_walk_no_memory(walk);
    free(key.data);
    return ok;
}
