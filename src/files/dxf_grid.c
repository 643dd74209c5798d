/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/hash.h"
#include "files/dxf_lines.h"

/* Beyond, steps are no longer whole in a double; such points stay where they are in the grid. */
static const double max_steps = 0x1p62;

enum { first_slots = 256 }; /* a power of 2, as all sizes of the table are */

void csg_dxf_lines_finish(struct csg_dxf_lines *lines)
{
    free(lines->cells.data);
    free(lines->slots.data);
    free(lines->list.data);
    free(lines->entries.data);
}

static size_t hash_of(struct csg_dxf_cell cell)
{
    return (size_t)csg_hash_number(csg_hash_number(0, (uint64_t)cell.x), (uint64_t)cell.y);
}

/* The slot that has the cell, or an empty one that would. */
static uint32_t *slot_of(const struct csg_dxf_lines *lines, struct csg_dxf_cell cell)
{
    const size_t mask = lines->slots.num - 1;
    for (size_t i = hash_of(cell) & mask;; i = (i + 1) & mask) {
        uint32_t *slot = &lines->slots.data[i];
        if (*slot == 0)
            return slot;
        const struct csg_dxf_cell *other = &lines->cells.data[*slot - 1];
        if (other->x == cell.x && other->y == cell.y)
            return slot;
    }
}

/* Keeps at least half of the slots empty. */
static bool make_room(struct csg_dxf_lines *lines)
{
    const size_t num = lines->slots.num;
    if (num > 0 && 2 * (lines->cells.num + 1) <= num)
        return true;
    const size_t wanted = num > 0 ? 2 * num : (size_t)first_slots;
    if (!csg_array_reserve(&lines->slots, wanted - num))
        return false;
    memset(lines->slots.data, 0, wanted * sizeof *lines->slots.data);
    lines->slots.num = wanted;
    for (size_t i = 0; i < lines->cells.num; i++)
        *slot_of(lines, lines->cells.data[i]) = (uint32_t)(i + 1);
    return true;
}

static bool is_occupied(const struct csg_dxf_lines *lines, int64_t x, int64_t y)
{
    return *slot_of(lines, (struct csg_dxf_cell){x, y}) != 0;
}

/*
 * OpenSCAD's Grid2d::align: the search moves its own middle to what it finds, and with it the end
 * of what it still looks at. Steps and distances are ints there.
 */
static struct csg_dxf_cell find_near(const struct csg_dxf_lines *lines, struct csg_dxf_cell at)
{
    int64_t best = 10; /* more than any */
    for (int64_t x = at.x - 1; x <= at.x + 1; x++) {
        for (int64_t y = at.y - 1; y <= at.y + 1; y++) {
            const int64_t distance = llabs(at.x - x) + llabs(at.y - y);
            if (distance < best && is_occupied(lines, x, y)) {
                best = distance;
                at = (struct csg_dxf_cell){x, y};
            }
        }
    }
    return at;
}

static int64_t steps_of(double coordinate)
{
    return (int64_t)fmax(-max_steps, fmin(max_steps, round(coordinate / CSG_DXF_STEP)));
}

bool csg_dxf_lines_align(struct csg_dxf_lines *lines, double x, double y, uint32_t *cell)
{
    struct csg_dxf_cell at = {steps_of(x), steps_of(y)};
    if (!make_room(lines))
        return false;
    if (!is_occupied(lines, at.x, at.y))
        at = find_near(lines, at);
    uint32_t *slot = slot_of(lines, at);
    if (*slot == 0) {
        if (!csg_array_push(&lines->cells, at))
            return false;
        *slot = (uint32_t)lines->cells.num;
    }
    *cell = *slot - 1;
    return true;
}

bool csg_dxf_lines_enter(struct csg_dxf_lines *lines, struct csg_dxf_line line)
{
    const uint32_t number = (uint32_t)lines->list.num;
    return csg_array_push(&lines->entries, ((struct csg_dxf_entry){line.cells[0], number})) &&
           csg_array_push(&lines->entries, ((struct csg_dxf_entry){line.cells[1], number}));
}
