/* SPDX-License-Identifier: MIT */
#include "nodes/mesh_file.h"

#include <math.h>
#include <string.h>

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

static bool add_corner(struct csg_mesh *mesh, struct csg_vec3 p)
{
    const uint32_t index = (uint32_t)mesh->points.num;
    return csg_mesh_add_point(mesh, p) && csg_array_push(&mesh->corners, index);
}

bool csg_stl_add(struct csg_mesh *mesh, const char *corners)
{
    bool ok = true;
    for (size_t i = 0; i < 3 && ok; i++)
        ok = add_corner(mesh, csg_stl_point(corners + CSG_STL_POINT * i));
    return ok && csg_mesh_close_face(mesh);
}

bool csg_stl_end(struct csg_mesh *mesh)
{
    bool is_finite = true;
    for (size_t i = 0; i < mesh->points.num; i++) {
        const struct csg_vec3 p = mesh->points.data[i];
        is_finite &= isfinite(p.x + p.y + p.z) != 0;
    }
    mesh->rounding = mesh->size * float_rounding;
    return is_finite;
}

static enum csg_mesh_file read_binary(const struct csg_bytes *bytes, struct csg_mesh *mesh)
{
    bool ok = true;
    for (size_t at = CSG_STL_HEADER + CSG_STL_COUNT; at < bytes->num && ok; at += CSG_STL_RECORD)
        ok = csg_stl_add(mesh, bytes->data + at + CSG_STL_POINT);
    if (!csg_stl_end(mesh))
        return CSG_MESH_FILE_MALFORMED;
    return ok ? CSG_MESH_FILE_DONE : CSG_MESH_FILE_NO_MEMORY;
}

/* Of a text only the lines with a vertex matter; each three are a triangle, and a fourth one before
 * the next loop begins is an error. */
static enum csg_mesh_file read_text(const struct csg_bytes *bytes, struct csg_mesh *mesh,
                                    size_t *line)
{
    struct csg_words words = words_of(bytes);
    int in_loop = 0;
    bool ok = true;
    for (bool more = true; more && ok; more = csg_words_next_line(&words)) {
        const char *word;
        size_t length;
        struct csg_vec3 p;
        if (!csg_words_next(&words, &word, &length))
            continue;
        if (is_word(word, length, "outer")) {
            in_loop = 0;
            ok = csg_mesh_close_face(mesh); /* of less than three corners: none */
        }
        if (!is_word(word, length, "vertex"))
            continue;
        *line = words.line;
        if (in_loop++ == 3 || !read_point(&words, &p))
            return CSG_MESH_FILE_MALFORMED;
        ok = ok && add_corner(mesh, p) && (in_loop < 3 || csg_mesh_close_face(mesh));
    }
    ok = ok && csg_mesh_close_face(mesh);
    mesh->rounding = mesh->size * text_rounding;
    return ok ? CSG_MESH_FILE_DONE : CSG_MESH_FILE_NO_MEMORY;
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
