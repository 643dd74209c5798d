/* SPDX-License-Identifier: MIT */
#include "carrier/probe.h"

#define NO_ENTRY UINT32_MAX

/* Before its first cell. */
static void rewind_probe(struct csg_index_probe *probe)
{
    probe->without = 0;
    probe->is_placed = false;
    probe->key = -1;
    probe->entry = NO_ENTRY;
}

void csg_index_probe_parallel(const struct csg_carrier_index *index, const struct csg_plane *plane,
                              struct csg_index_probe *probe)
{
    rewind_probe(probe);
    probe->num_keys = csg_parallel_keys(&index->space, plane, probe->keys);
}

void csg_index_probe_normals(const struct csg_carrier_index *index, int width,
                             const struct csg_plane *plane, struct csg_index_probe *probe)
{
    rewind_probe(probe);
    probe->without = csg_direction_number(plane->normal);
    probe->num_keys = csg_directions_nearly_agree(&index->directions, plane->normal)
                          ? csg_normal_keys(&index->space, width, plane, probe->keys)
                          : 0;
}

void csg_index_probe_quadric(const struct csg_carrier_index *index,
                             const struct csg_quadric *quadric, struct csg_index_probe *probe)
{
    rewind_probe(probe);
    probe->is_placed = true;
    probe->num_keys = csg_quadric_keys(&index->space, quadric, probe->keys, probe->place);
}

static bool is_asked_for(const struct csg_index_probe *probe, const struct csg_index_entry *entry)
{
    if (entry->key != probe->keys[probe->key])
        return false;
    if (probe->is_placed)
        return csg_is_near_place(probe->place, entry->place);
    return probe->without == 0 || entry->normal != probe->without;
}

uint32_t csg_index_next(const struct csg_carrier_index *index, struct csg_index_probe *probe)
{
    for (;;) {
        while (probe->entry == NO_ENTRY) {
            if (++probe->key >= probe->num_keys)
                return UINT32_MAX;
            probe->entry = index->buckets.data[csg_index_bucket(index, probe->keys[probe->key])];
        }
        const struct csg_index_entry *entry = &index->entries.data[probe->entry];
        probe->entry = entry->next;
        if (is_asked_for(probe, entry))
            return entry->carrier;
    }
}

uint32_t csg_index_next_member(const struct csg_carrier_index *index, int width, uint32_t carrier)
{
    return index->members.data[csg_index_member(index, width, carrier)];
}
