/* SPDX-License-Identifier: MIT */
#include "crowd/owners.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

bool csg_owners_init(struct csg_owners *owners, int width, int height, size_t num_members,
                     atomic_bool *rivals)
{
    *owners = (struct csg_owners){.width = width,
                                  .height = height,
                                  .stride = (size_t)width + CSG_CAST_LANES,
                                  .rivals = rivals};
    const size_t num = owners->stride * (size_t)height;
    owners->who = malloc((num + 1) * sizeof *owners->who);
    owners->least = malloc((num + 1) * sizeof *owners->least);
    owners->owns = calloc(num_members + 1, sizeof *owners->owns);
    return owners->who && owners->least && owners->owns;
}

void csg_owners_clear(const struct csg_owners *owners, int begin, int end)
{
    const size_t first = (size_t)begin * owners->stride, last = (size_t)end * owners->stride;
    for (size_t i = first; i < last; i++) {
        owners->who[i] = CSG_NOBODY;
        owners->least[i] = INFINITY;
    }
}

void csg_owners_finish(struct csg_owners *owners)
{
    free(owners->who);
    free(owners->least);
    free(owners->owns);
    *owners = (struct csg_owners){0};
}

static void set(atomic_bool *flags, uint32_t member)
{
    atomic_store_explicit(&flags[member], true, memory_order_relaxed);
}

bool csg_owners_contend(const struct csg_owners *owners, const struct csg_cast *cast, uint32_t who,
                        int x, int y, float dx, float dy, int num, float *keys)
{
    const size_t at = (size_t)y * owners->stride + (size_t)x;
    uint32_t before[CSG_CAST_LANES];
    memcpy(before, owners->who + at, sizeof before);
    const struct csg_contest contest = {keys, owners->least + at, owners->who + at};
    const struct csg_contested result = csg_cast_contend(cast, dx, dy, num, who, &contest);
    if (result.with_others)
        set(owners->rivals, who);
    for (int i = 0; i < num && result.with_others >> i; i++)
        if (result.with_others >> i & 1 && before[i] < CSG_SEVERAL)
            set(owners->rivals, before[i]);
    return result.shows != 0;
}

unsigned csg_owners_contested(const struct csg_owners *owners, int x, int y, int num)
{
    const uint32_t *who = owners->who + (size_t)y * owners->stride + (size_t)x;
    unsigned contested = 0;
    for (int i = 0; i < num; i++)
        contested |= (who[i] == CSG_SEVERAL ? 1u : 0u) << i;
    return contested;
}

static void note_pixel(const struct csg_owners *owners, int x, int y, uint32_t who,
                       struct csg_owned *owned)
{
    set(owners->owns, who);
    owned->num++;
    owned->lo[0] = x < owned->lo[0] ? x : owned->lo[0];
    owned->hi[0] = x > owned->hi[0] ? x : owned->hi[0];
    owned->lo[1] = y < owned->lo[1] ? y : owned->lo[1];
    owned->hi[1] = y;
}

struct csg_owned csg_owners_note(const struct csg_owners *owners, int begin, int end,
                                 const float *keys)
{
    struct csg_owned owned = {0, {INT_MAX, INT_MAX}, {-1, -1}};
    for (int y = begin; y < end; y++) {
        const size_t row = (size_t)y * owners->stride;
        uint32_t *who = owners->who + row;
        for (int x = 0; x < owners->width; x++) {
            if (who[x] >= CSG_SEVERAL)
                continue;
            if (owners->least[row + (size_t)x] > keys[row + (size_t)x])
                who[x] = CSG_NOBODY;
            else
                note_pixel(owners, x, y, who[x], &owned);
        }
    }
    return owned;
}
