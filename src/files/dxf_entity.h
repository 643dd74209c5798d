/* SPDX-License-Identifier: MIT */
#ifndef CSG_FILES_DXF_ENTITY_H
#define CSG_FILES_DXF_ENTITY_H

/* The entities of a DXF file: what their groups say, and the lines that they become. */

#include <stdint.h>
#include <string.h>

#include "files/dxf.h"
#include "files/dxf_lines.h"

/* A word of the file. */
struct csg_dxf_word {
    const char *at;
    size_t length;
};

/* A line of a block, in the order of the file. */
struct csg_dxf_block_line {
    struct csg_dxf_line line;
    uint32_t next; /* of the same block, + 1; 0: none */
};

struct csg_dxf_block {
    struct csg_dxf_word name;
    uint32_t first, last; /* of its lines, + 1 */
    uint32_t num;
    uint32_t next; /* with the same hash, + 1 */
};

enum { CSG_DXF_BUCKETS = 4096, CSG_DXF_MAX_STRANGE = 16 };

/* What the groups of the entity at hand have said; OpenSCAD lets entities share them. */
struct csg_dxf_entity {
    struct csg_dxf_word type, layer, name;
    CSG_ARRAY(double) x;
    CSG_ARRAY(double) y;
    double radius;             /* ELLIPSE: the minor axis as a share of the major one */
    double start, stop;        /* ARC: degrees; INSERT: start is its turn */
    double factor_x, factor_y; /* INSERT; ELLIPSE: from and to that parameter */
    int flags;
};

struct csg_dxf_reader {
    const struct csg_dxf_params *params;
    const struct csg_dxf_warnings *warnings;
    const char *at, *end;
    size_t line; /* of the value at hand */
    struct csg_dxf_entity entity;
    bool in_entities, in_blocks;
    uint32_t block; /* the one that is open, + 1; 0: none */
    CSG_ARRAY(struct csg_dxf_block) blocks;
    CSG_ARRAY(struct csg_dxf_block_line) block_lines;
    uint32_t buckets[CSG_DXF_BUCKETS];
    struct csg_dxf_word strange[CSG_DXF_MAX_STRANGE]; /* kinds of entities that were warned of */
    size_t num_strange;
    struct csg_dxf_lines lines;
    enum csg_dxf_result result;
};

static inline bool csg_dxf_is_same(struct csg_dxf_word a, struct csg_dxf_word b)
{
    return a.length == b.length && (a.length == 0 || memcmp(a.at, b.at, a.length) == 0);
}

static inline bool csg_dxf_is_text(struct csg_dxf_word word, const char *text)
{
    return csg_dxf_is_same(word, (struct csg_dxf_word){text, strlen(text)});
}

static inline void csg_dxf_fail(struct csg_dxf_reader *reader, enum csg_dxf_result result)
{
    if (reader->result == CSG_DXF_DONE)
        reader->result = result;
}

/* Whether the entity is on the layer that is asked for. */
bool csg_dxf_is_wanted(const struct csg_dxf_reader *reader);

/* A kind of entity that becomes lines. */
struct csg_dxf_shape {
    const char *type;
    bool (*end)(struct csg_dxf_reader *reader); /* adds them; false: points are missing */
};

/* NULL: entities of that type are no shapes. */
const struct csg_dxf_shape *csg_dxf_find_shape(struct csg_dxf_word type);

/* The block of the entity's name, to which lines go from now on. */
void csg_dxf_open_block(struct csg_dxf_reader *reader);

#endif
