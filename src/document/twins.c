/* SPDX-License-Identifier: MIT */
#include "document/twins.h"

#include <stdlib.h>
#include <string.h>

#include "common/hash.h"

/* Bytes of the beginning that is hashed: less than that is as soon read as looked up. */
enum { BEGINNING = 256 };

/* Nodes with the same beginning that are compared, the last ones first. */
enum { MAX_COMPARED = 8 };

void csg_twins_finish(struct csg_twins *twins)
{
    free(twins->all.data);
    free(twins->last.data);
    *twins = (struct csg_twins){0};
}

bool csg_twins_want(size_t length)
{
    return length >= BEGINNING;
}

static uint32_t *place_of(const struct csg_twins *twins, const char *text)
{
    const uint64_t hash = csg_hash(CSG_HASH_START, text, BEGINNING);
    return &twins->last.data[(hash ^ hash >> 32) & (twins->last.num - 1)];
}

const struct csg_twin *csg_twins_find(const struct csg_twins *twins, const struct csg_lexer *lexer,
                                      size_t at)
{
    const size_t rest = lexer->size - at;
    if (twins->all.num == 0 || rest < BEGINNING)
        return NULL;
    uint32_t next = *place_of(twins, lexer->text + at) - 1;
    for (int i = 0; i < MAX_COMPARED && next != UINT32_MAX; i++) {
        const struct csg_twin *twin = &twins->all.data[next];
        if (twin->length <= rest &&
            memcmp(lexer->text + at, lexer->text + twin->at, twin->length) == 0)
            return twin;
        next = twin->before;
    }
    return NULL;
}

/* Twice as many places as nodes, at least. */
static bool make_room(struct csg_twins *twins, const struct csg_lexer *lexer)
{
    const size_t num = twins->last.num ? 2 * twins->last.num : 64;
    if (twins->last.num > 2 * twins->all.num)
        return true;
    if (!csg_array_reserve(&twins->last, num - twins->last.num))
        return false;
    twins->last.num = num;
    memset(twins->last.data, 0, num * sizeof *twins->last.data);
    for (uint32_t i = 0; i < twins->all.num; i++) {
        uint32_t *place = place_of(twins, lexer->text + twins->all.data[i].at);
        twins->all.data[i].before = *place - 1;
        *place = i + 1;
    }
    return true;
}

bool csg_twins_add(struct csg_twins *twins, const struct csg_lexer *lexer,
                   const struct csg_twin *twin)
{
    struct csg_twin added = *twin;
    if (!make_room(twins, lexer))
        return false;
    uint32_t *place = place_of(twins, lexer->text + twin->at);
    added.before = *place - 1;
    if (!csg_array_push(&twins->all, added))
        return false;
    *place = (uint32_t)twins->all.num;
    return true;
}
