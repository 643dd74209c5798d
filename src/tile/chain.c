/* SPDX-License-Identifier: MIT */
#include "tile/chain.h"

#include <math.h>

/* Numbers of normals that shaders/csg/normals.glsl has bits for. */
#define MAX_NUMBER 63

#define NOT_IN_CHAINS (CSG_RECORD_GAP | CSG_RECORD_BOUND | CSG_RECORD_SURFACE)

/* What follows one another without clauses, but for the complement that does not come first. */
#define NOT_IN_ROWS (CSG_RECORD_POP | CSG_RECORD_PUSH | CSG_RECORD_MORE)

/* Whether a slot with so many planes of either sense has room for the record. */
static bool fits_slot(const float *head, int planes)
{
    const int entries = (int)head[0], exits = (int)head[1], flags = (int)head[2];
    if (flags & NOT_IN_CHAINS || entries > planes || exits > planes)
        return false;
    for (int i = 0; i < entries + exits; i++)
        if (fabsf(head[4 * (1 + i) + 3]) > MAX_NUMBER + 1)
            return false;
    return true;
}

/* Whether the record of an intersection may come behind those that are there. */
static bool is_link(const struct csg_chain_finder *finder, const struct csg_step *step)
{
    return !(step->flags & NOT_IN_ROWS) && step->flags & (CSG_RECORD_START | CSG_RECORD_AND) &&
           csg_step_rank(step) >= finder->rank &&
           (finder->need.slots > 0 || !(step->flags & CSG_RECORD_NEGATED));
}

void csg_chain_add(struct csg_chain_finder *finder, const struct csg_step *step, const float *head)
{
    struct csg_chain_need *need = &finder->need;
    const int flags = (int)head[2];
    const float most = head[0] > head[1] ? head[0] : head[1];
    if (most > need->planes)
        need->planes = most < UINT8_MAX ? (uint8_t)most : UINT8_MAX;
    need->clauses |= need->slots == 0 && flags >= CSG_RECORD_CLAUSE;
    if (finder->broken || (need->clauses && flags & CSG_RECORD_POP))
        return;
    const int planes = finder->faceted ? CSG_CHAIN_FACETED_PLANES : CSG_CHAIN_PLANES;
    const int most_slots = need->clauses ? CSG_CLAUSE_LITERALS : CSG_CHAIN_LITERALS;
    finder->broken = need->slots == most_slots || !fits_slot(head, planes) ||
                     (!need->clauses && !is_link(finder, step));
    finder->rank = csg_step_rank(step);
    need->flat |= need->slots == 0 && !(flags & CSG_RECORD_QUADRIC);
    need->quadrics |= (flags & CSG_RECORD_QUADRIC) != 0;
    need->slots++;
}

/* Whether there is a program for that many literals and planes. */
static bool has_program(const struct csg_chain_need *need)
{
    if (need->slots > CSG_CHAIN_LITERALS && !need->quadrics)
        return false;
    return need->planes <= CSG_CHAIN_PLANES ||
           (need->slots <= CSG_CHAIN_FACETED_LITERALS && !need->quadrics && !need->clauses);
}

struct csg_chain_need csg_chain_end(const struct csg_chain_finder *finder)
{
    struct csg_chain_need need = finder->need;
    need.slots = finder->broken || !has_program(&need) ? 0 : need.slots;
    return need;
}
