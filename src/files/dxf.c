/* SPDX-License-Identifier: MIT */
#include "files/dxf.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/number.h"
#include "files/dxf_entity.h"

/* ---- words ---------------------------------------------------------------------------------- */

static bool is_blank(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/* The next line without the blanks around it. */
static struct csg_dxf_word next_word(struct csg_dxf_reader *reader)
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
    return (struct csg_dxf_word){begin, (size_t)(end - begin)};
}

static bool read_integer(struct csg_dxf_word word, int *value)
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

static void warn(const struct csg_dxf_reader *reader, const char *format, struct csg_dxf_word word)
{
    char text[160];
    snprintf(text, sizeof text, format, (int)(word.length < 40 ? word.length : 40),
             word.length ? word.at : "");
    reader->warnings->add(reader->warnings->user, reader->line, text);
}

/* ---- groups --------------------------------------------------------------------------------- */

static void warn_of_strange(struct csg_dxf_reader *reader)
{
    const struct csg_dxf_word type = reader->entity.type;
    if (csg_dxf_is_text(type, "ENDSEC") || csg_dxf_is_text(type, "DIMENSION") ||
        !(reader->in_blocks || (reader->in_entities && csg_dxf_is_wanted(reader))))
        return;
    for (size_t i = 0; i < reader->num_strange; i++)
        if (csg_dxf_is_same(reader->strange[i], type))
            return;
    if (reader->num_strange == CSG_DXF_MAX_STRANGE)
        return;
    reader->strange[reader->num_strange++] = type;
    warn(reader, "unsupported DXF entity '%.*s'; it is left out", type);
}

/* What the entity at hand adds, now that all of its groups are known. */
static bool end_entity(struct csg_dxf_reader *reader)
{
    const struct csg_dxf_entity *entity = &reader->entity;
    const struct csg_dxf_shape *shape = csg_dxf_find_shape(entity->type);
    if (shape)
        return shape->end(reader);
    if (csg_dxf_is_text(entity->type, "SECTION")) {
        reader->in_entities = csg_dxf_is_text(entity->name, "ENTITIES");
        reader->in_blocks = csg_dxf_is_text(entity->name, "BLOCKS");
    } else if (csg_dxf_is_text(entity->type, "BLOCK")) {
        csg_dxf_open_block(reader);
    } else if (csg_dxf_is_text(entity->type, "ENDBLK")) {
        reader->block = 0;
    } else {
        warn_of_strange(reader);
    }
    return true;
}

static void begin_entity(struct csg_dxf_entity *entity, struct csg_dxf_word type)
{
    const double factor = csg_dxf_is_text(type, "INSERT") ? 1 : 0;
    entity->x.num = entity->y.num = 0;
    entity->type = type;
    entity->layer = entity->name = (struct csg_dxf_word){NULL, 0};
    entity->radius = entity->start = entity->stop = 0;
    entity->factor_x = entity->factor_y = factor;
    entity->flags = 0;
}

static void read_coordinate(struct csg_dxf_reader *reader, int id, double value)
{
    const int axis = id >= 20;
    if (!reader->in_blocks)
        value = (value - reader->params->origin[axis]) * reader->params->scale;
    if (!(axis ? csg_array_push(&reader->entity.y, value)
               : csg_array_push(&reader->entity.x, value)))
        csg_dxf_fail(reader, CSG_DXF_NO_MEMORY);
}

/* Groups of numbers. Points of other ids matter to dimensions only. */
static void read_number(struct csg_dxf_reader *reader, int id, double value)
{
    struct csg_dxf_entity *entity = &reader->entity;
    switch (id) {
    case 10:
    case 11:
    case 20:
    case 21:
        read_coordinate(reader, id, value);
        break;
    case 40:
        entity->radius = reader->in_blocks ? value : value * reader->params->scale;
        break;
    case 41:
        entity->factor_x = value;
        break;
    case 42:
        entity->factor_y = value;
        break;
    case 50:
        entity->start = value;
        break;
    case 51:
        entity->stop = value;
        break;
    default:
        break;
    }
}

static bool is_number(int id)
{
    return (id >= 10 && id <= 16) || (id >= 20 && id <= 26) || (id >= 40 && id <= 42) || id == 50 ||
           id == 51;
}

static void read_group(struct csg_dxf_reader *reader, int id, struct csg_dxf_word value)
{
    struct csg_dxf_entity *entity = &reader->entity;
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

static void read_groups(struct csg_dxf_reader *reader)
{
    while (reader->at < reader->end && reader->result == CSG_DXF_DONE) {
        const struct csg_dxf_word id_word = next_word(reader);
        const size_t id_line = reader->line;
        int id;
        const struct csg_dxf_word value =
            reader->at < reader->end ? next_word(reader) : (struct csg_dxf_word){NULL, 0};
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
    struct csg_dxf_reader *reader = calloc(1, sizeof *reader);
    if (!reader)
        return CSG_DXF_NO_MEMORY;
    reader->params = params;
    reader->warnings = warnings;
    reader->at = bytes->data;
    reader->end = bytes->data + bytes->num;
    read_groups(reader);
    if (reader->result == CSG_DXF_DONE && !csg_dxf_lines_join(&reader->lines, drawing))
        csg_dxf_fail(reader, CSG_DXF_NO_MEMORY);
    const enum csg_dxf_result result = reader->result;
    csg_dxf_lines_finish(&reader->lines);
    free(reader->entity.x.data);
    free(reader->entity.y.data);
    free(reader->blocks.data);
    free(reader->block_lines.data);
    free(reader);
    return result;
}
