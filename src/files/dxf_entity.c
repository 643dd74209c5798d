/* SPDX-License-Identifier: MIT */
#include "files/dxf_entity.h"

#include <math.h>

#include "common/hash.h"

/* ---- lines ---------------------------------------------------------------------------------- */

static bool add_to_block(struct csg_dxf_reader *reader, struct csg_dxf_line line)
{
    if (!csg_array_push(&reader->block_lines, ((struct csg_dxf_block_line){.line = line})))
        return false;
    struct csg_dxf_block *block = &reader->blocks.data[reader->block - 1];
    const uint32_t number = (uint32_t)reader->block_lines.num;
    if (block->last)
        reader->block_lines.data[block->last - 1].next = number;
    else
        block->first = number;
    block->last = number;
    block->num++;
    return true;
}

bool csg_dxf_is_wanted(const struct csg_dxf_reader *reader)
{
    const char *layer = reader->params->layer;
    return !*layer || csg_dxf_is_text(reader->entity.layer, layer);
}

static void add_line(struct csg_dxf_reader *reader, struct csg_vec2 a, struct csg_vec2 b)
{
    struct csg_dxf_line line;
    if (reader->result != CSG_DXF_DONE || !isfinite(a.x + a.y + b.x + b.y) ||
        (!reader->in_entities && !reader->in_blocks) ||
        (reader->in_entities && !csg_dxf_is_wanted(reader)))
        return;
    if (reader->lines.entries.num / 2 >= CSG_DXF_MAX_LINES) {
        csg_dxf_fail(reader, CSG_DXF_TOO_LARGE);
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
        csg_dxf_fail(reader, CSG_DXF_NO_MEMORY);
}

/* ---- shapes: false where points are missing ----------------------------------------------- */

static bool point_at(const struct csg_dxf_entity *entity, size_t i, struct csg_vec2 *p)
{
    if (i >= entity->x.num || i >= entity->y.num)
        return false;
    *p = (struct csg_vec2){entity->x.data[i], entity->y.data[i]};
    return true;
}

static bool add_segment(struct csg_dxf_reader *reader, size_t from, size_t to)
{
    struct csg_vec2 a, b;
    if (!point_at(&reader->entity, from, &a) || !point_at(&reader->entity, to, &b))
        return false;
    add_line(reader, a, b);
    return true;
}

static bool end_line(struct csg_dxf_reader *reader)
{
    return add_segment(reader, 0, 1);
}

static bool end_polyline(struct csg_dxf_reader *reader)
{
    const struct csg_dxf_entity *entity = &reader->entity;
    const size_t num = entity->x.num > entity->y.num ? entity->x.num : entity->y.num;
    bool ok = true;
    for (size_t i = 1; i < num && ok; i++)
        ok = add_segment(reader, i - 1, i);
    return ok && ((entity->flags & 1) == 0 || (num > 0 && add_segment(reader, num - 1, 0)));
}

/* The curve's point for a parameter. */
typedef struct csg_vec2 curve_fn(const struct csg_dxf_entity *entity, const double *shape,
                                 double t);

static void add_curve(struct csg_dxf_reader *reader, curve_fn *curve, const double *shape,
                      double from, double sweep, double num)
{
    struct csg_vec2 before = curve(&reader->entity, shape, from);
    for (double i = 1; i <= num && reader->result == CSG_DXF_DONE; i++) {
        const struct csg_vec2 next = curve(&reader->entity, shape, from + sweep * i / num);
        add_line(reader, before, next);
        before = next;
    }
}

static struct csg_vec2 circle_at(const struct csg_dxf_entity *entity, const double *shape,
                                 double degrees)
{
    (void)shape;
    return (struct csg_vec2){csg_cos_degrees(degrees) * entity->radius + entity->x.data[0],
                             csg_sin_degrees(degrees) * entity->radius + entity->y.data[0]};
}

static bool end_circle(struct csg_dxf_reader *reader)
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

static bool end_arc(struct csg_dxf_reader *reader)
{
    struct csg_dxf_entity *entity = &reader->entity;
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
static struct csg_vec2 ellipse_at(const struct csg_dxf_entity *entity, const double *shape,
                                  double t)
{
    const double x = cos(t) * shape[0], y = sin(t) * shape[1];
    return (struct csg_vec2){shape[2] * x - shape[3] * y + entity->x.data[0],
                             shape[3] * x + shape[2] * y + entity->y.data[0]};
}

static bool end_ellipse(struct csg_dxf_reader *reader)
{
    struct csg_dxf_entity *entity = &reader->entity;
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

static uint32_t bucket_of(struct csg_dxf_word name)
{
    return (uint32_t)(csg_hash(CSG_HASH_START, name.at, name.length) % CSG_DXF_BUCKETS);
}

/* The block's index + 1; 0: there is none. */
static uint32_t find_block(const struct csg_dxf_reader *reader, struct csg_dxf_word name)
{
    uint32_t i = reader->buckets[bucket_of(name)];
    while (i > 0 && !csg_dxf_is_same(reader->blocks.data[i - 1].name, name))
        i = reader->blocks.data[i - 1].next;
    return i;
}

void csg_dxf_open_block(struct csg_dxf_reader *reader)
{
    const struct csg_dxf_word name = reader->entity.name;
    uint32_t *bucket = &reader->buckets[bucket_of(name)];
    reader->block = name.length > 0 ? find_block(reader, name) : 0;
    if (reader->block || name.length == 0)
        return;
    if (!csg_array_push(&reader->blocks, ((struct csg_dxf_block){.name = name, .next = *bucket}))) {
        csg_dxf_fail(reader, CSG_DXF_NO_MEMORY);
        return;
    }
    reader->block = *bucket = (uint32_t)reader->blocks.num;
}

static struct csg_vec2 inserted(const struct csg_dxf_reader *reader, uint32_t cell)
{
    const struct csg_dxf_entity *entity = &reader->entity;
    const struct csg_dxf_cell *at = &reader->lines.cells.data[cell];
    const double x = (double)at->x * CSG_DXF_STEP * entity->factor_x;
    const double y = (double)at->y * CSG_DXF_STEP * entity->factor_y;
    const double c = csg_cos_degrees(entity->start), s = csg_sin_degrees(entity->start);
    const double scale = reader->params->scale;
    return (struct csg_vec2){(c * x - s * y) * scale + entity->x.data[0],
                             (s * x + c * y) * scale + entity->y.data[0]};
}

/* A block may be inserted in itself: its lines up to now. */
static bool end_insert(struct csg_dxf_reader *reader)
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

/* ---- all of them ---------------------------------------------------------------------------- */

static const struct csg_dxf_shape shapes[] = {
    {"LINE", end_line}, {"LWPOLYLINE", end_polyline}, {"CIRCLE", end_circle},
    {"ARC", end_arc},   {"ELLIPSE", end_ellipse},     {"INSERT", end_insert},
};

const struct csg_dxf_shape *csg_dxf_find_shape(struct csg_dxf_word type)
{
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++)
        if (csg_dxf_is_text(type, shapes[i].type))
            return &shapes[i];
    return NULL;
}
