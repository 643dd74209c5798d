/* SPDX-License-Identifier: MIT */
#include "files/amf.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/number.h"

/* Six digits of a text are off by at most that part of the number. */
static const double text_rounding = 5e-7;

struct reader {
    struct csg_mesh_list *list;
    struct csg_bytes path; /* of the elements around, each behind a '/'; ends with a 0 */
    struct csg_mesh mesh;  /* the object at hand */
    bool in_object;
    double point[3], triangle[3]; /* as they were last set */
    char wrong[60];               /* what ended it; empty: memory is out */
};

/* ---- what elements mean --------------------------------------------------------------------- */

static bool begin_object(struct reader *reader)
{
    csg_mesh_finish(&reader->mesh);
    reader->mesh = (struct csg_mesh){0};
    reader->in_object = true;
    return true;
}

static bool end_object(struct reader *reader)
{
    struct csg_mesh *mesh = reader->in_object ? csg_mesh_list_add(reader->list) : NULL;
    if (!reader->in_object)
        return true;
    if (!mesh)
        return false;
    reader->mesh.rounding = reader->mesh.size * text_rounding;
    *mesh = reader->mesh;
    reader->mesh = (struct csg_mesh){0};
    reader->in_object = false;
    return true;
}

static bool end_point(struct reader *reader)
{
    const double *p = reader->point;
    return csg_mesh_add_point(&reader->mesh, csg_vec3_of(p));
}

static bool end_triangle(struct reader *reader)
{
    bool ok = true;
    for (int i = 0; i < 3 && ok; i++) {
        const double index = reader->triangle[i];
        if (!(index >= 0 && index < (double)reader->mesh.points.num)) {
            snprintf(reader->wrong, sizeof reader->wrong, "a triangle has no point %.0f", index);
            return false;
        }
        ok = csg_array_push(&reader->mesh.corners, (uint32_t)index);
    }
    return ok && csg_mesh_close_face(&reader->mesh);
}

#define POINT "/amf/object/mesh/vertices/vertex/coordinates"
#define TRIANGLE "/amf/object/mesh/volume/triangle"

static const struct {
    const char *path;
    bool (*begin)(struct reader *reader);
    bool (*end)(struct reader *reader);
} elements[] = {{"/amf/object", begin_object, end_object},
                {POINT, NULL, end_point},
                {TRIANGLE, NULL, end_triangle}};

enum { num_elements = sizeof elements / sizeof *elements };

static const char *const coordinates[] = {POINT "/x", POINT "/y", POINT "/z"};
static const char *const corners[] = {TRIANGLE "/v1", TRIANGLE "/v2", TRIANGLE "/v3"};

/* ---- the sink ------------------------------------------------------------------------------- */

static bool is_path(const struct reader *reader, const char *path)
{
    return reader->path.num > 0 && strcmp(reader->path.data, path) == 0;
}

/* As OpenSCAD does, <name/> is never left again. */
static bool begin_element(void *user, const char *name, const struct csg_xml_attribute *attributes,
                          size_t num, bool is_empty)
{
    struct reader *reader = user;
    (void)attributes, (void)num, (void)is_empty;
    if (reader->path.num > 0)
        reader->path.num--; /* its 0 */
    bool ok = csg_bytes_append_text(&reader->path, "/") &&
              csg_bytes_append_text(&reader->path, name) && csg_bytes_append(&reader->path, "", 1);
    for (int i = 0; i < num_elements && ok; i++)
        if (elements[i].begin && is_path(reader, elements[i].path))
            ok = elements[i].begin(reader);
    return ok;
}

/* Takes the last name away. */
static void leave(struct reader *reader)
{
    size_t i = reader->path.num;
    while (i > 0 && reader->path.data[i - 1] != '/')
        i--;
    if (i > 0) {
        reader->path.data[i - 1] = '\0';
        reader->path.num = i;
    }
}

static bool end_element(void *user, const char *name)
{
    struct reader *reader = user;
    bool ok = true;
    (void)name;
    for (int i = 0; i < num_elements && ok; i++)
        if (is_path(reader, elements[i].path))
            ok = elements[i].end(reader);
    leave(reader);
    return ok;
}

/* Blanks around it make it none. */
static bool is_whole(const char *text)
{
    return text[strspn(text, "+-0123456789")] == '\0';
}

static bool take_text(void *user, const char *text)
{
    struct reader *reader = user;
    for (int i = 0; i < 3; i++) {
        const bool is_coordinate = is_path(reader, coordinates[i]);
        if (!is_coordinate && !is_path(reader, corners[i]))
            continue;
        double *number = is_coordinate ? &reader->point[i] : &reader->triangle[i];
        if ((is_coordinate || is_whole(text)) && csg_number_read_signed(text, strlen(text), number))
            return true;
        snprintf(reader->wrong, sizeof reader->wrong, "'%.40s' is no number", text);
        return false;
    }
    return true;
}

enum csg_amf_result csg_amf_read(const struct csg_bytes *bytes, const char *archived,
                                 const struct csg_xml_module *xml, struct csg_mesh_list *list,
                                 struct csg_xml_error *error)
{
    struct reader reader = {.list = list};
    const struct csg_xml_sink sink = {&reader, begin_element, end_element, take_text};
    const enum csg_xml_result result = xml->read(bytes->data, bytes->num, archived, &sink, error);
    csg_mesh_finish(&reader.mesh);
    free(reader.path.data);
    if (result == CSG_XML_ENDED && reader.wrong[0]) {
        snprintf(error->text, sizeof error->text, "%s", reader.wrong);
        return CSG_AMF_MALFORMED;
    }
    if (result == CSG_XML_ENTITY)
        return CSG_AMF_ENTITY;
    if (result == CSG_XML_MALFORMED)
        return CSG_AMF_MALFORMED;
    return result == CSG_XML_DONE ? CSG_AMF_DONE : CSG_AMF_NO_MEMORY;
}
