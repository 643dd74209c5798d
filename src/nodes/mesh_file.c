/* SPDX-License-Identifier: MIT */
#include "nodes/mesh_file.h"

#include <math.h>
#include <string.h>
#include <strings.h>

#include "common/number.h"

/* A float is off by at most that part of itself; six digits of a text by at most that part. */
static const double float_rounding = 0x1p-24, text_rounding = 5e-7;

/* ---- words -------------------------------------------------------------------------------- */

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

bool csg_words_next(struct csg_words *words, const char **word, size_t *length)
{
    while (words->at < words->end && is_blank(*words->at))
        words->at++;
    *word = words->at;
    while (words->at < words->end && *words->at != '\n' && !is_blank(*words->at))
        words->at++;
    *length = (size_t)(words->at - *word);
    return *length > 0;
}

bool csg_words_next_line(struct csg_words *words)
{
    const char *newline = memchr(words->at, '\n', (size_t)(words->end - words->at));
    words->at = newline ? newline + 1 : words->end;
    words->line++;
    return newline != NULL && words->at < words->end;
}

bool csg_words_number(struct csg_words *words, double *value)
{
    const char *word;
    size_t length;
    return csg_words_next(words, &word, &length) && csg_number_read_signed(word, length, value);
}

static bool is_word(const char *word, size_t length, const char *text)
{
    return length == strlen(text) && memcmp(word, text, length) == 0;
}

static struct csg_words words_of(const struct csg_bytes *bytes)
{
    return (struct csg_words){.at = bytes->data, .end = bytes->data + bytes->num, .line = 1};
}

static bool read_point(struct csg_words *words, struct csg_vec3 *p)
{
    return csg_words_number(words, &p->x) && csg_words_number(words, &p->y) &&
           csg_words_number(words, &p->z);
}

/* ---- STL ---------------------------------------------------------------------------------- */

uint32_t csg_stl_uint32(const char *bytes)
{
    unsigned char raw[4];
    memcpy(raw, bytes, sizeof raw);
    return (uint32_t)raw[0] | (uint32_t)raw[1] << 8 | (uint32_t)raw[2] << 16 |
           (uint32_t)raw[3] << 24;
}

struct csg_vec3 csg_stl_point(const char *bytes)
{
    float p[3];
    for (int i = 0; i < 3; i++) {
        const uint32_t bits = csg_stl_uint32(bytes + 4 * i);
        memcpy(&p[i], &bits, sizeof p[i]);
    }
    return csg_vec3((double)p[0], (double)p[1], (double)p[2]);
}

static bool add_triangle(struct csg_mesh *mesh, const struct csg_vec3 corners[3], bool *is_left_out)
{
    const uint32_t first = (uint32_t)mesh->points.num;
    bool ok = true;
    *is_left_out = false;
    for (int i = 0; i < 3; i++)
        *is_left_out |= !csg_vec3_is_finite(corners[i]);
    if (*is_left_out)
        return true;
    for (uint32_t i = 0; i < 3 && ok; i++)
        ok = csg_mesh_add_point(mesh, corners[i]) && csg_array_push(&mesh->corners, first + i);
    return ok && csg_mesh_close_face(mesh);
}

bool csg_stl_add(struct csg_mesh *mesh, const char *bytes, bool *is_left_out)
{
    struct csg_vec3 corners[3];
    for (size_t i = 0; i < 3; i++)
        corners[i] = csg_stl_point(bytes + CSG_STL_POINT * i);
    return add_triangle(mesh, corners, is_left_out);
}

void csg_stl_end(struct csg_mesh *mesh)
{
    mesh->rounding = mesh->size * float_rounding;
}

static enum csg_mesh_file read_binary(const struct csg_bytes *bytes, struct csg_mesh *mesh)
{
    bool ok = true, is_whole = true;
    for (size_t at = CSG_STL_HEADER + CSG_STL_COUNT; at < bytes->num && ok; at += CSG_STL_RECORD) {
        bool is_left_out;
        ok = csg_stl_add(mesh, bytes->data + at + CSG_STL_POINT, &is_left_out);
        is_whole &= !is_left_out;
    }
    csg_stl_end(mesh);
    if (!ok)
        return CSG_MESH_FILE_NO_MEMORY;
    return is_whole ? CSG_MESH_FILE_DONE : CSG_MESH_FILE_PARTLY;
}

/* What C writes for numbers that are not finite is read as nan. */
static bool read_any_number(struct csg_words *words, double *value)
{
    static const char *const names[] = {"nan", "inf", "infinity"};
    const char *word;
    size_t length;
    if (!csg_words_next(words, &word, &length))
        return false;
    if (csg_number_read_signed(word, length, value))
        return true;
    const size_t sign = word[0] == '-' || word[0] == '+';
    *value = NAN;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (length - sign == strlen(names[i]) &&
            strncasecmp(word + sign, names[i], length - sign) == 0)
            return true;
    return false;
}

/* Of a text only the lines with a vertex matter; each three are a triangle, and a fourth one before
 * the next loop begins is an error. */
static enum csg_mesh_file read_text(const struct csg_bytes *bytes, struct csg_mesh *mesh,
                                    size_t *line)
{
    struct csg_words words = words_of(bytes);
    struct csg_vec3 loop[3];
    int in_loop = 0;
    bool ok = true, is_whole = true;
    for (bool more = true; more && ok; more = csg_words_next_line(&words)) {
        const char *word;
        size_t length;
        if (!csg_words_next(&words, &word, &length))
            continue;
        if (is_word(word, length, "outer"))
            in_loop = 0; /* less than three corners are no triangle */
        if (!is_word(word, length, "vertex"))
            continue;
        struct csg_vec3 *p = &loop[in_loop];
        if (in_loop == 3 || !read_any_number(&words, &p->x) || !read_any_number(&words, &p->y) ||
            !read_any_number(&words, &p->z)) {
            *line = words.line;
            return CSG_MESH_FILE_MALFORMED;
        }
        if (!csg_vec3_is_finite(*p) && *line == 0)
            *line = words.line;
        if (++in_loop < 3)
            continue;
        bool is_left_out;
        ok = add_triangle(mesh, loop, &is_left_out);
        is_whole &= !is_left_out;
    }
    mesh->rounding = mesh->size * text_rounding;
    if (!ok)
        return CSG_MESH_FILE_NO_MEMORY;
    return is_whole ? CSG_MESH_FILE_DONE : CSG_MESH_FILE_PARTLY;
}

enum csg_mesh_file csg_stl_file_read(const struct csg_bytes *bytes, struct csg_mesh *mesh,
                                     size_t *line)
{
    *line = 0;
    if (bytes->num / CSG_STL_RECORD > UINT32_MAX / 3)
        return CSG_MESH_FILE_FOREIGN;
    const size_t begin = CSG_STL_HEADER + CSG_STL_COUNT;
    if (bytes->num >= begin &&
        bytes->num == begin + (size_t)CSG_STL_RECORD * csg_stl_uint32(bytes->data + CSG_STL_HEADER))
        return read_binary(bytes, mesh);
    if (bytes->num < 5 || memcmp(bytes->data, "solid", 5) != 0)
        return CSG_MESH_FILE_MALFORMED;
    return read_text(bytes, mesh, line);
}

/* ---- OFF ---------------------------------------------------------------------------------- */

/* The next line that has something on it but a comment. */
static bool next_content(struct csg_words *words)
{
    while (csg_words_next_line(words)) {
        struct csg_words ahead = *words;
        const char *word;
        size_t length;
        if (csg_words_next(&ahead, &word, &length) && word[0] != '#')
            return true;
    }
    return false;
}

static bool read_face(struct csg_words *words, struct csg_mesh *mesh, bool *ok)
{
    double num, index;
    if (!csg_words_number(words, &num) || !(num >= 1 && num < 1e6))
        return false;
    for (double i = 0; i < num && *ok; i++) {
        if (!csg_words_number(words, &index) ||
            !(index >= 0 && index < (double)mesh->points.num && index == floor(index)))
            return false;
        *ok = csg_array_push(&mesh->corners, (uint32_t)index);
    }
    *ok = *ok && csg_mesh_close_face(mesh);
    return true;
}

enum csg_mesh_file csg_off_file_read(const struct csg_bytes *bytes, struct csg_mesh *mesh,
                                     size_t *line)
{
    struct csg_words words = words_of(bytes);
    const char *word;
    size_t length;
    double points, faces;
    bool ok = true;
    *line = 0;
    if (!csg_words_next(&words, &word, &length) || !is_word(word, length, "OFF"))
        return CSG_MESH_FILE_FOREIGN;
    /* The counts may follow on the same line. */
    if (!csg_words_number(&words, &points) &&
        (!next_content(&words) || !csg_words_number(&words, &points)))
        return CSG_MESH_FILE_MALFORMED;
    if (!csg_words_number(&words, &faces) || !(points >= 0 && points < 4e9 && faces >= 0))
        return CSG_MESH_FILE_MALFORMED;
    for (double i = 0; i < points && ok; i++) {
        struct csg_vec3 p;
        const bool is_there = next_content(&words) && read_point(&words, &p);
        *line = words.line;
        if (!is_there)
            return CSG_MESH_FILE_MALFORMED;
        ok = csg_mesh_add_point(mesh, p);
    }
    for (double i = 0; i < faces && ok; i++) {
        const bool is_there = next_content(&words) && read_face(&words, mesh, &ok);
        *line = words.line;
        if (!is_there)
            return CSG_MESH_FILE_MALFORMED;
    }
    mesh->rounding = mesh->size * text_rounding;
    return ok ? CSG_MESH_FILE_DONE : CSG_MESH_FILE_NO_MEMORY;
}
