/* SPDX-License-Identifier: MIT */
#include "files/dxf.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/hash.h"
#include "common/number.h"
#include "files/dxf_lines.h"

/* A word of the file. */
struct word {
    const char *at;
    size_t length;
};

/* A line of a block, in the order of the file. */
struct block_line {
    struct csg_dxf_line line;
    uint32_t next; /* of the same block, + 1; 0: none */
};

struct block {
    struct word name;
    uint32_t first, last; /* of its lines, + 1 */
    uint32_t num;
    uint32_t next; /* with the same hash, + 1 */
};

enum { num_buckets = 4096, max_strange = 16 };

/* What the groups of the entity at hand have said; OpenSCAD lets entities share them. */
struct entity {
    struct word type, layer, name;
    CSG_ARRAY(double) x;
    CSG_ARRAY(double) y;
    double radius;             /* ELLIPSE: the minor axis as a share of the major one */
    double start, stop;        /* ARC: degrees; INSERT: start is its turn */
    double factor_x, factor_y; /* INSERT; ELLIPSE: from and to that parameter */
    int flags;
};

struct reader {
    const struct csg_dxf_params *params;
    const struct csg_dxf_warnings *warnings;
    const char *at, *end;
    size_t line; /* of the value at hand */
    struct entity entity;
    bool in_entities, in_blocks;
    uint32_t block; /* the one that is open, + 1; 0: none */
    CSG_ARRAY(struct block) blocks;
    CSG_ARRAY(struct block_line) block_lines;
    uint32_t buckets[num_buckets];
    struct word strange[max_strange]; /* kinds of entities that were warned of */
    size_t num_strange;
    struct csg_dxf_lines lines;
    enum csg_dxf_result result;
};

/* ---- words ---------------------------------------------------------------------------------- */

static bool is_blank(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/* The next line without the blanks around it. */
static struct word next_word(struct reader *reader)
{
    const char *begin = reader->at;
    const char *newline = memchr(begin, '\n', (size_t)(reader->end - begin));
    const char *end = newline ? newline : reader->end;
    reader->at = newline ? newline + 1 : reader->end;
    reader->line++;
    while (begin < end && is_blank(*begin))
        begin++;
    while (end > begin && is_blank(end[-1]))
        end--;
    return (struct word){begin, (size_t)(end - begin)};
}

static bool is_same(struct word a, struct word b)
{
    return a.length == b.length && (a.length == 0 || memcmp(a.at, b.at, a.length) == 0);
}

static bool is_text(struct word word, const char *text)
{
    return is_same(word, (struct word){text, strlen(text)});
}

static bool read_integer(struct word word, int *value)
{
    double number;
    for (size_t i = 0; i < word.length; i++)
        if ((word.at[i] < '0' || word.at[i] > '9') &&
            !(i == 0 && (word.at[i] == '-' || word.at[i] == '+')))
            return false;
    if (!csg_number_read_signed(word.at, word.length, &number) || number < INT_MIN ||
        number > INT_MAX)
        return false;
    *value = (int)number;
    return true;
}

static void warn(const struct reader *reader, const char *format, struct word word)
{
    char text[160];
    snprintf(text, sizeof text, format, (int)(word.length < 40 ? word.length : 40),
             word.length ? word.at : "");
    reader->warnings->add(reader->warnings->user, reader->line, text);
}

/* ---- lines ---------------------------------------------------------------------------------- */

static void fail(struct reader *reader, enum csg_dxf_result result)
{
    if (reader->result == CSG_DXF_DONE)
        reader->result = result;
}

static bool add_to_block(struct reader *reader, struct csg_dxf_line line)
{
    if (!csg_array_push(&reader->block_lines, ((struct block_line){.line = line})))
        return false;
    struct block *block = &reader->blocks.data[reader->block - 1];
    const uint32_t number = (uint32_t)reader->block_lines.num;
    if (block->last)
        reader->block_lines.data[block->last - 1].next = number;
    else
        block->first = number;
    block->last = number;
    block->num++;
    return true;
}

static bool is_wanted(const struct reader *reader)
{
    const char *layer = reader->params->layer;
    return !*layer || is_text(reader->entity.layer, layer);
}

static void add_line(struct reader *reader, struct csg_vec2 a, struct csg_vec2 b)
{
    struct csg_dxf_line line;
    if (reader->result != CSG_DXF_DONE || !isfinite(a.x + a.y + b.x + b.y) ||
        (!reader->in_entities && !reader->in_blocks) ||
        (reader->in_entities && !is_wanted(reader)))
        return;
    if (reader->lines.entries.num / 2 >= CSG_DXF_MAX_LINES) {
        fail(reader, CSG_DXF_TOO_LARGE);
        return;
    }
    bool ok = csg_dxf_lines_align(&reader->lines, a.x, a.y, &line.cells[0]) &&
              csg_dxf_lines_align(&reader->lines, b.x, b.y, &line.cells[1]) &&
              csg_dxf_lines_enter(&reader->lines, line);
    if (ok && reader->in_entities)
        ok = csg_array_push(&reader->lines.list, line);
    if (ok && reader->in_blocks && reader->block)
        ok = add_to_block(reader, line);
    if (!ok)
        fail(reader, CSG_DXF_NO_MEMORY);
}

/* ---- entities: false where points are missing ----------------------------------------------- */

static bool point_at(const struct entity *entity, size_t i, struct csg_vec2 *p)
{
    if (i >= entity->x.num || i >= entity->y.num)
        return false;
    *p = (struct csg_vec2){entity->x.data[i], entity->y.data[i]};
    return true;
}

static bool add_segment(struct reader *reader, size_t from, size_t to)
{
    struct csg_vec2 a, b;
    if (!point_at(&reader->entity, from, &a) || !point_at(&reader->entity, to, &b))
        return false;
    add_line(reader, a, b);
    return true;
}

static bool end_line(struct reader *reader)
{
    return add_segment(reader, 0, 1);
}

static bool end_polyline(struct reader *reader)
{
    const struct entity *entity = &reader->entity;
    const size_t num = entity->x.num > entity->y.num ? entity->x.num : entity->y.num;
    bool ok = true;
    for (size_t i = 1; i < num && ok; i++)
        ok = add_segment(reader, i - 1, i);
    return ok && ((entity->flags & 1) == 0 || (num > 0 && add_segment(reader, num - 1, 0)));
}

/* The curve's point for a parameter. */
typedef struct csg_vec2 curve_fn(const struct entity *entity, const double *shape, double t);

static void add_curve(struct reader *reader, curve_fn *curve, const double *shape, double from,
                      double sweep, double num)
{
    struct csg_vec2 before = curve(&reader->entity, shape, from);
    for (double i = 1; i <= num && reader->result == CSG_DXF_DONE; i++) {
        const struct csg_vec2 next = curve(&reader->entity, shape, from + sweep * i / num);
        add_line(reader, before, next);
        before = next;
    }
}

static struct csg_vec2 circle_at(const struct entity *entity, const double *shape, double degrees)
{
    (void)shape;
    return (struct csg_vec2){csg_cos_degrees(degrees) * entity->radius + entity->x.data[0],
                             csg_sin_degrees(degrees) * entity->radius + entity->y.data[0]};
}

static bool end_circle(struct reader *reader)
{
    struct csg_vec2 center;
    if (!point_at(&reader->entity, 0, &center))
        return false;
    const int num = csg_facets_count(&reader->params->facets, reader->entity.radius);
    add_curve(reader, circle_at, NULL, 0, 360, num);
    return true;
}

/* Whole turns are added until stop is not below start; a few one by one, which rounds as OpenSCAD
 * does. */
static double turned(double start, double stop, double turn)
{
    for (int i = 0; i < 64 && start > stop; i++)
        stop += turn;
    return start > stop ? stop + turn * ceil((start - stop) / turn) : stop;
}

static bool end_arc(struct reader *reader)
{
    struct entity *entity = &reader->entity;
    struct csg_vec2 center;
    if (!point_at(entity, 0, &center))
        return false;
    entity->stop = turned(entity->start, entity->stop, 360);
    const double sweep = entity->stop - entity->start;
    const int num = csg_facets_count(&reader->params->facets, entity->radius);
    add_curve(reader, circle_at, NULL, entity->start, sweep, ceil(num * sweep / 360));
    return true;
}

/* shape: the half axes, cosine and sine of the major one. */
static struct csg_vec2 ellipse_at(const struct entity *entity, const double *shape, double t)
{
    const double x = cos(t) * shape[0], y = sin(t) * shape[1];
    return (struct csg_vec2){shape[2] * x - shape[3] * y + entity->x.data[0],
                             shape[3] * x + shape[2] * y + entity->y.data[0]};
}

static bool end_ellipse(struct reader *reader)
{
    struct entity *entity = &reader->entity;
    struct csg_vec2 center, axis;
    if (!point_at(entity, 0, &center) || !point_at(entity, 1, &axis))
        return false;
    const double pi = acos(-1.0);
    entity->factor_y = turned(entity->factor_x, entity->factor_y, 2 * pi);
    const double major = sqrt(axis.x * axis.x + axis.y * axis.y);
    double angle = acos(fmax(-1, fmin(1, axis.x / major)));
    if (axis.y < 0)
        angle = 2 * pi - angle;
    const double shape[] = {major, major * entity->radius, cos(angle), sin(angle)};
    const double sweep = entity->factor_y - entity->factor_x;
    const int num = csg_facets_count(&reader->params->facets, major);
    add_curve(reader, ellipse_at, shape, entity->factor_x, sweep, ceil(num * sweep / (2 * pi)));
    return true;
}

/* ---- blocks --------------------------------------------------------------------------------- */

static uint32_t bucket_of(struct word name)
{
    return (uint32_t)(csg_hash(CSG_HASH_START, name.at, name.length) % num_buckets);
}

/* The block's index + 1; 0: there is none. */
static uint32_t find_block(const struct reader *reader, struct word name)
{
    uint32_t i = reader->buckets[bucket_of(name)];
    while (i > 0 && !is_same(reader->blocks.data[i - 1].name, name))
        i = reader->blocks.data[i - 1].next;
    return i;
}

static void open_block(struct reader *reader)
{
    const struct word name = reader->entity.name;
    uint32_t *bucket = &reader->buckets[bucket_of(name)];
    reader->block = name.length > 0 ? find_block(reader, name) : 0;
    if (reader->block || name.length == 0)
        return;
    if (!csg_array_push(&reader->blocks, ((struct block){.name = name, .next = *bucket}))) {
        fail(reader, CSG_DXF_NO_MEMORY);
        return;
    }
    reader->block = *bucket = (uint32_t)reader->blocks.num;
}

static struct csg_vec2 inserted(const struct reader *reader, uint32_t cell)
{
    const struct entity *entity = &reader->entity;
    const struct csg_dxf_cell *at = &reader->lines.cells.data[cell];
    const double x = (double)at->x * CSG_DXF_STEP * entity->factor_x;
    const double y = (double)at->y * CSG_DXF_STEP * entity->factor_y;
    const double c = csg_cos_degrees(entity->start), s = csg_sin_degrees(entity->start);
    const double scale = reader->params->scale;
    return (struct csg_vec2){(c * x - s * y) * scale + entity->x.data[0],
                             (s * x + c * y) * scale + entity->y.data[0]};
}

/* A block may be inserted in itself: its lines up to now. */
static bool end_insert(struct reader *reader)
{
    const uint32_t found = find_block(reader, reader->entity.name);
    const uint32_t num = found ? reader->blocks.data[found - 1].num : 0;
    uint32_t number = found ? reader->blocks.data[found - 1].first : 0;
    struct csg_vec2 at;
    if (num > 0 && !point_at(&reader->entity, 0, &at))
        return false;
    for (uint32_t i = 0; i < num && reader->result == CSG_DXF_DONE; i++) {
        const struct csg_dxf_line line = reader->block_lines.data[number - 1].line;
        add_line(reader, inserted(reader, line.cells[0]), inserted(reader, line.cells[1]));
        number = reader->block_lines.data[number - 1].next;
    }
    return true;
}

/* ---- groups --------------------------------------------------------------------------------- */

static const struct {
    const char *type;
    bool (*end)(struct reader *reader);
} shapes[] = {
    {"LINE", end_line}, {"LWPOLYLINE", end_polyline}, {"CIRCLE", end_circle},
    {"ARC", end_arc},   {"ELLIPSE", end_ellipse},     {"INSERT", end_insert},
};

static void warn_of_strange(struct reader *reader)
{
    const struct word type = reader->entity.type;
    if (is_text(type, "ENDSEC") || is_text(type, "DIMENSION") ||
        !(reader->in_blocks || (reader->in_entities && is_wanted(reader))))
        return;
    for (size_t i = 0; i < reader->num_strange; i++)
        if (is_same(reader->strange[i], type))
            return;
    if (reader->num_strange == max_strange)
        return;
    reader->strange[reader->num_strange++] = type;
    warn(reader, "unsupported DXF entity '%.*s'; it is left out", type);
}

/* What the entity at hand adds, now that all of its groups are known. */
static bool end_entity(struct reader *reader)
{
    const struct entity *entity = &reader->entity;
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++)
        if (is_text(entity->type, shapes[i].type))
            return shapes[i].end(reader);
    if (is_text(entity->type, "SECTION")) {
        reader->in_entities = is_text(entity->name, "ENTITIES");
        reader->in_blocks = is_text(entity->name, "BLOCKS");
    } else if (is_text(entity->type, "BLOCK")) {
        open_block(reader);
    } else if (is_text(entity->type, "ENDBLK")) {
        reader->block = 0;
    } else {
        warn_of_strange(reader);
    }
    return true;
}

static void begin_entity(struct entity *entity, struct word type)
{
    const double factor = is_text(type, "INSERT") ? 1 : 0;
    entity->x.num = entity->y.num = 0;
    entity->type = type;
    entity->layer = entity->name = (struct word){NULL, 0};
    entity->radius = entity->start = entity->stop = 0;
    entity->factor_x = entity->factor_y = factor;
    entity->flags = 0;
}

static void read_coordinate(struct reader *reader, int id, double value)
{
    const int axis = id >= 20;
    if (!reader->in_blocks)
        value = (value - reader->params->origin[axis]) * reader->params->scale;
    if (!(axis ? csg_array_push(&reader->entity.y, value)
               : csg_array_push(&reader->entity.x, value)))
        fail(reader, CSG_DXF_NO_MEMORY);
}

/* Groups of numbers. Points of other ids matter to dimensions only. */
static void read_number(struct reader *reader, int id, double value)
{
    struct entity *entity = &reader->entity;
    switch (id) {
    case 10: case 11: case 20: case 21: read_coordinate(reader, id, value); break;
    case 40: entity->radius = reader->in_blocks ? value : value * reader->params->scale; break;
    case 41: entity->factor_x = value; break;
    case 42: entity->factor_y = value; break;
    case 50: entity->start = value; break;
    case 51: entity->stop = value; break;
    default: break;
    }
}

static bool is_number(int id)
{
    return (id >= 10 && id <= 16) || (id >= 20 && id <= 26) || (id >= 40 && id <= 42) ||
           id == 50 || id == 51;
}

static void read_group(struct reader *reader, int id, struct word value)
{
    struct entity *entity = &reader->entity;
    double number;
    if (id == 0 && !end_entity(reader)) {
        warn(reader, "'%.*s': the entity before has too few points", value);
    } else if (id == 0) {
        begin_entity(entity, value);
    } else if (id == 2) {
        entity->name = value;
    } else if (id == 8) {
        entity->layer = value;
    } else if (is_number(id) && csg_number_read_signed(value.at, value.length, &number)) {
        read_number(reader, id, number);
    } else if (is_number(id) || (id == 70 && !read_integer(value, &entity->flags))) {
        warn(reader, "'%.*s' is no number; it is left out", value);
    }
}

static void read_groups(struct reader *reader)
{
    while (reader->at < reader->end && reader->result == CSG_DXF_DONE) {
        const struct word id_word = next_word(reader);
        const size_t id_line = reader->line;
        int id;
        const struct word value =
            reader->at < reader->end ? next_word(reader) : (struct word){NULL, 0};
        if (!read_integer(id_word, &id)) {
            reader->line = id_line;
            if (reader->at < reader->end)
                warn(reader, "'%.*s' is no group code; the rest is left out", id_word);
            return;
        }
        read_group(reader, id, value);
    }
}

enum csg_dxf_result csg_dxf_read(const struct csg_bytes *bytes, const struct csg_dxf_params *params,
                                 const struct csg_dxf_warnings *warnings,
                                 struct csg_drawing *drawing)
{
    struct reader *reader = calloc(1, sizeof *reader);
    if (!reader)
        return CSG_DXF_NO_MEMORY;
    reader->params = params;
    reader->warnings = warnings;
    reader->at = bytes->data;
    reader->end = bytes->data + bytes->num;
    read_groups(reader);
    if (reader->result == CSG_DXF_DONE && !csg_dxf_lines_join(&reader->lines, drawing))
        fail(reader, CSG_DXF_NO_MEMORY);
    const enum csg_dxf_result result = reader->result;
    csg_dxf_lines_finish(&reader->lines);
    free(reader->entity.x.data);
    free(reader->entity.y.data);
    free(reader->blocks.data);
    free(reader->block_lines.data);
    free(reader);
    return result;
}
