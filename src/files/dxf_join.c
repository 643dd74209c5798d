/* SPDX-License-Identifier: MIT */
/*
 * From lines to contours, as OpenSCAD 2021.01 walks them: first from each end that no other line
 * meets, the lowest line first, as far as it goes; then round what is left. It looks at all lines
 * for each such end; here a heap keeps those that may have become one.
 */
#include "files/dxf_lines.h"

#include <math.h>
#include <stdlib.h>

/* Lists of numbers, one behind the other: list i is items [begin[i], begin[i + 1]). */
struct lists {
    uint32_t *begin, *items;
};

struct joiner {
    const struct csg_dxf_lines *lines;
    struct csg_drawing *drawing;
    struct lists in_cell;           /* the lines entered in each cell, in the order of the file */
    struct lists of_line;           /* the cells that each line was entered in */
    uint32_t *num_left;             /* of each cell's entries, whose lines are not used yet */
    uint32_t *first_left;           /* of each cell: the lines entered before are used */
    bool *is_crowded;               /* a cell where some line was entered more than twice */
    bool *is_used;                  /* of each line */
    CSG_ARRAY(uint32_t) candidates; /* a heap, the lowest line on top */
    CSG_ARRAY(uint32_t) path;       /* the cells of the one at hand */
    bool has_open;                  /* some path was open */
};

/* ---- lists ---------------------------------------------------------------------------------- */

static void finish_lists(struct lists *lists)
{
    free(lists->begin);
    free(lists->items);
}

/* by_cell: the lines in each of num cells, else the cells of each of num lines. Entries of lines
 * that the drawing has not are left out. */
static bool make_lists(struct lists *lists, const struct csg_dxf_lines *lines, size_t num,
                       bool by_cell)
{
    const struct csg_dxf_entry *entries = lines->entries.data;
    lists->begin = calloc(num + 2, sizeof *lists->begin);
    lists->items = malloc((lines->entries.num + 1) * sizeof *lists->items);
    if (!lists->begin || !lists->items)
        return false;
    uint32_t *end = lists->begin + 1; /* while they are filled: where list i goes on */
    for (size_t i = 0; i < lines->entries.num; i++)
        if (entries[i].line < lines->list.num)
            end[(by_cell ? entries[i].cell : entries[i].line) + 1]++;
    for (size_t i = 1; i <= num; i++)
        end[i] += end[i - 1];
    for (size_t i = 0; i < lines->entries.num; i++)
        if (entries[i].line < lines->list.num)
            lists->items[end[by_cell ? entries[i].cell : entries[i].line]++] =
                by_cell ? entries[i].line : entries[i].cell;
    return true;
}

/* ---- candidates ----------------------------------------------------------------------------- */

static bool push_candidate(struct joiner *joiner, uint32_t line)
{
    if (!csg_array_push(&joiner->candidates, line))
        return false;
    uint32_t *heap = joiner->candidates.data;
    size_t i = joiner->candidates.num - 1;
    for (; i > 0 && heap[(i - 1) / 2] > line; i = (i - 1) / 2)
        heap[i] = heap[(i - 1) / 2];
    heap[i] = line;
    return true;
}

static uint32_t pop_candidate(struct joiner *joiner)
{
    uint32_t *heap = joiner->candidates.data;
    const uint32_t top = heap[0], last = heap[--joiner->candidates.num];
    size_t i = 0;
    for (size_t child = 1; child < joiner->candidates.num; child = 2 * i + 1) {
        if (child + 1 < joiner->candidates.num && heap[child + 1] < heap[child])
            child++;
        if (heap[child] >= last)
            break;
        heap[i] = heap[child];
        i = child;
    }
    heap[i] = last;
    return top;
}

/* ---- walks ---------------------------------------------------------------------------------- */

static bool has_end_in(const struct joiner *joiner, uint32_t line, uint32_t cell)
{
    const struct csg_dxf_line *it = &joiner->lines->list.data[line];
    return it->cells[0] == cell || it->cells[1] == cell;
}

/* Whether nothing but the line itself is left in the cell. */
static bool is_alone(const struct joiner *joiner, uint32_t line, uint32_t cell)
{
    uint32_t num = 0;
    for (uint32_t i = joiner->of_line.begin[line]; i < joiner->of_line.begin[line + 1]; i++)
        num += joiner->of_line.items[i] == cell;
    return joiner->num_left[cell] == num;
}

/* Those that may be alone in the cell now. */
static bool push_neighbours(struct joiner *joiner, uint32_t cell)
{
    bool ok = true;
    if (joiner->num_left[cell] > 2 && !joiner->is_crowded[cell])
        return true;
    for (uint32_t i = joiner->first_left[cell]; i < joiner->in_cell.begin[cell + 1] && ok; i++) {
        const uint32_t line = joiner->in_cell.items[i];
        ok = joiner->is_used[line] || !has_end_in(joiner, line, cell) ||
             push_candidate(joiner, line);
    }
    return ok;
}

static bool use(struct joiner *joiner, uint32_t line)
{
    const struct lists *cells = &joiner->of_line;
    bool ok = true;
    joiner->is_used[line] = true;
    for (uint32_t i = cells->begin[line]; i < cells->begin[line + 1]; i++)
        joiner->num_left[cells->items[i]]--;
    for (uint32_t i = cells->begin[line]; i < cells->begin[line + 1] && ok; i++)
        ok = push_neighbours(joiner, cells->items[i]);
    return ok;
}

/* The next line that ends in the cell; UINT32_MAX: there is none. */
static uint32_t find_next(struct joiner *joiner, uint32_t cell)
{
    const uint32_t end = joiner->in_cell.begin[cell + 1];
    uint32_t *first = &joiner->first_left[cell];
    while (*first < end && joiner->is_used[joiner->in_cell.items[*first]])
        ++*first;
    for (uint32_t i = *first; i < end; i++) {
        const uint32_t line = joiner->in_cell.items[i];
        if (!joiner->is_used[line] && has_end_in(joiner, line, cell))
            return line;
    }
    return UINT32_MAX;
}

static bool add_point(const struct joiner *joiner, uint32_t cell)
{
    const struct csg_dxf_cell *at = &joiner->lines->cells.data[cell];
    return csg_drawing_add_point(joiner->drawing, (double)at->x * CSG_DXF_STEP,
                                 (double)at->y * CSG_DXF_STEP);
}

/* The cells on the way from one end of a line on; a closed one comes back to where it began. */
static bool walk(struct joiner *joiner, uint32_t line, int end)
{
    joiner->path.num = 0;
    bool ok = csg_array_push(&joiner->path, joiner->lines->list.data[line].cells[end]);
    while (ok && line != UINT32_MAX) {
        const uint32_t cell = joiner->lines->list.data[line].cells[!end];
        ok = csg_array_push(&joiner->path, cell) && use(joiner, line);
        line = ok ? find_next(joiner, cell) : UINT32_MAX;
        if (line != UINT32_MAX)
            end = joiner->lines->list.data[line].cells[0] != cell;
    }
    return ok;
}

static double angle_between(const struct csg_dxf_cell *from, const struct csg_dxf_cell *to)
{
    return atan2((double)(to->x - from->x), (double)(to->y - from->y));
}

/* Whether OpenSCAD turns a closed path round, by how it goes on at its first leftmost corner. */
static bool is_turned(const struct joiner *joiner)
{
    const struct csg_dxf_cell *cells = joiner->lines->cells.data;
    const uint32_t *path = joiner->path.data;
    const size_t num = joiner->path.num;
    size_t left = 0;
    for (size_t i = 1; i < num; i++)
        if (cells[path[i]].x < cells[path[left]].x)
            left = i;
    const struct csg_dxf_cell *before = &cells[path[left == 0 ? num - 2 : left - 1]];
    const struct csg_dxf_cell *behind = &cells[path[left == num - 1 ? 1 : left + 1]];
    const struct csg_dxf_cell *at = &cells[path[left]];
    return angle_between(at, before) < angle_between(at, behind);
}

/* Clipper's result may depend on where a contour begins, so that is OpenSCAD's: the end, and of a
 * closed one the last corner is its first. */
static bool add_contour(struct joiner *joiner, bool is_closed)
{
    const uint32_t *path = joiner->path.data;
    const size_t num = joiner->path.num;
    const bool is_reversed = is_closed && !joiner->has_open && is_turned(joiner);
    bool ok = csg_drawing_add_contour(joiner->drawing);
    for (size_t i = is_closed; i < num && ok; i++)
        ok = add_point(joiner, path[is_reversed ? i - is_closed : num - 1 - (i - is_closed)]);
    return ok;
}

static bool add_open(struct joiner *joiner)
{
    bool ok = true;
    while (ok && joiner->candidates.num > 0) {
        const uint32_t line = pop_candidate(joiner);
        const uint32_t *cells = joiner->lines->list.data[line].cells;
        if (joiner->is_used[line])
            continue;
        const bool is_end = is_alone(joiner, line, cells[0]);
        if (!is_end && !is_alone(joiner, line, cells[1]))
            continue;
        joiner->has_open = true;
        ok = walk(joiner, line, !is_end) && add_contour(joiner, false);
    }
    return ok;
}

static bool init(struct joiner *joiner)
{
    const struct csg_dxf_lines *lines = joiner->lines;
    const size_t num_cells = lines->cells.num, num_lines = lines->list.num;
    joiner->num_left = calloc(num_cells + 1, sizeof *joiner->num_left);
    joiner->first_left = calloc(num_cells + 1, sizeof *joiner->first_left);
    joiner->is_crowded = calloc(num_cells + 1, sizeof *joiner->is_crowded);
    joiner->is_used = calloc(num_lines + 1, sizeof *joiner->is_used);
    bool ok = joiner->num_left && joiner->first_left && joiner->is_crowded && joiner->is_used &&
              make_lists(&joiner->in_cell, lines, num_cells, true) &&
              make_lists(&joiner->of_line, lines, num_lines, false);
    for (size_t i = 0; i < num_cells && ok; i++) {
        joiner->first_left[i] = joiner->in_cell.begin[i];
        joiner->num_left[i] = joiner->in_cell.begin[i + 1] - joiner->in_cell.begin[i];
    }
    for (uint32_t i = 0; i < num_lines && ok; i++) {
        const struct lists *cells = &joiner->of_line;
        const bool has_more = cells->begin[i + 1] - cells->begin[i] > 2; /* than its own ends */
        for (uint32_t k = cells->begin[i]; k < cells->begin[i + 1]; k++)
            joiner->is_crowded[cells->items[k]] |= has_more;
        ok = push_candidate(joiner, i);
    }
    return ok;
}

bool csg_dxf_lines_join(const struct csg_dxf_lines *lines, struct csg_drawing *drawing)
{
    struct joiner joiner = {.lines = lines, .drawing = drawing};
    bool ok = init(&joiner) && add_open(&joiner);
    for (uint32_t i = 0; i < lines->list.num && ok; i++)
        if (!joiner.is_used[i])
            ok = walk(&joiner, i, 0) && add_contour(&joiner, true);
    finish_lists(&joiner.in_cell);
    finish_lists(&joiner.of_line);
    free(joiner.num_left);
    free(joiner.first_left);
    free(joiner.is_crowded);
    free(joiner.is_used);
    free(joiner.candidates.data);
    free(joiner.path.data);
    return ok;
}
