/* SPDX-License-Identifier: MIT */
#ifndef CSG_FILES_DXF_LINES_H
#define CSG_FILES_DXF_LINES_H

/* Lines between cells of a grid, and how they are joined to contours. */

#include <stdint.h>

#include "plane/drawing.h"

/* Of the grid: points within a step of each other become one. */
#define CSG_DXF_STEP 0x1p-10

struct csg_dxf_cell {
    int64_t x, y; /* in steps */
};

struct csg_dxf_line {
    uint32_t cells[2]; /* of its ends */
};

/* A line was entered in a cell, under the number that the next line of the drawing would get. */
struct csg_dxf_entry {
    uint32_t cell, line;
};

/* Zero-initialise it. */
struct csg_dxf_lines {
    CSG_ARRAY(struct csg_dxf_cell) cells;
    CSG_ARRAY(uint32_t) slots; /* a hash table: 0 or the index of a cell + 1 */
    CSG_ARRAY(struct csg_dxf_line) list;
    CSG_ARRAY(struct csg_dxf_entry) entries;
};

void csg_dxf_lines_finish(struct csg_dxf_lines *lines);

/* The cell of a point: an occupied one next to it, or a new one. false: out of memory. */
bool csg_dxf_lines_align(struct csg_dxf_lines *lines, double x, double y, uint32_t *cell);

/* Enters a line in the cells of its ends. The lines of blocks are entered as well, although they
 * are no lines of the drawing: OpenSCAD takes the next line that is one for them. */
bool csg_dxf_lines_enter(struct csg_dxf_lines *lines, struct csg_dxf_line line);

/* Joins the lines and adds the contours to the drawing's last figure. false: out of memory. */
bool csg_dxf_lines_join(const struct csg_dxf_lines *lines, struct csg_drawing *drawing);

#endif
