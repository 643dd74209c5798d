/* SPDX-License-Identifier: MIT */
#include "files/threemf.h"

#include <math.h>
#include <stdio.h>

#include "common/module.h"
#include "threemf/module.h"

/* A float is off by at most that part of itself. */
static const double float_rounding = 0x1p-24;

struct reader {
    struct csg_mesh_list *list;
    struct csg_mesh *mesh; /* the last of the list */
    bool is_wrong;         /* a number is not finite, or a triangle has no such point */
};

static bool begin_mesh(void *user)
{
    struct reader *reader = user;
    reader->mesh = csg_mesh_list_add(reader->list);
    return reader->mesh != NULL;
}

static bool add_point(void *user, float x, float y, float z)
{
    struct reader *reader = user;
    const struct csg_vec3 p = {(double)x, (double)y, (double)z};
    reader->is_wrong = !isfinite(p.x + p.y + p.z);
    if (reader->is_wrong || !csg_mesh_add_point(reader->mesh, p))
        return false;
    reader->mesh->rounding = reader->mesh->size * float_rounding;
    return true;
}

static bool add_triangle(void *user, const uint32_t points[3])
{
    struct reader *reader = user;
    bool ok = true;
    for (int i = 0; i < 3 && ok; i++) {
        reader->is_wrong = points[i] >= reader->mesh->points.num;
        ok = !reader->is_wrong && csg_array_push(&reader->mesh->corners, points[i]);
    }
    return ok && csg_mesh_close_face(reader->mesh);
}

static enum csg_3mf_file read_with(const struct csg_3mf_module *module,
                                   const struct csg_bytes *bytes, struct csg_mesh_list *list,
                                   char *error, size_t size)
{
    struct reader reader = {.list = list};
    const struct csg_3mf_sink sink = {&reader, begin_mesh, add_point, add_triangle};
    const enum csg_3mf_result result = module->read(bytes->data, bytes->num, &sink, error, size);
    if (result == CSG_3MF_DONE)
        return CSG_3MF_FILE_DONE;
    csg_mesh_list_finish(list);
    if (reader.is_wrong)
        snprintf(error, size, "a number is not finite, or a triangle has no such point");
    return reader.is_wrong || result == CSG_3MF_MALFORMED ? CSG_3MF_FILE_MALFORMED
                                                          : CSG_3MF_FILE_NO_MEMORY;
}

enum csg_3mf_file csg_3mf_read(const struct csg_bytes *bytes, struct csg_mesh_list *list,
                               char *error, size_t size)
{
    const struct csg_3mf_module *module =
        csg_module_symbol("csgcast-3mf.so", "CSGCAST_3MF_MODULE", CSG_3MF_MODULE_NAME);
    return module ? read_with(module, bytes, list, error, size) : CSG_3MF_FILE_NO_MODULE;
}
