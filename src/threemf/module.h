/* SPDX-License-Identifier: MIT */
#ifndef CSG_THREEMF_MODULE_H
#define CSG_THREEMF_MODULE_H

/* The border between libcsgcast and csgcast-3mf.so, which wraps lib3mf. */

#ifdef __cplusplus
extern "C" {
#else
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#endif

/* Takes the mesh objects of a file, one after the other: their points, then their triangles, as
 * indices of points. false ends it. */
struct csg_3mf_sink {
    void *user;
    bool (*begin_mesh)(void *user);
    bool (*add_point)(void *user, float x, float y, float z);
    bool (*add_triangle)(void *user, const uint32_t points[3]);
};

enum csg_3mf_result {
    CSG_3MF_DONE,
    CSG_3MF_MALFORMED, /* nothing was handed over */
    CSG_3MF_ENDED,     /* by the sink, or memory is out */
};

struct csg_3mf_module {
    /* error gets what lib3mf says of a malformed file; size: of it. */
    enum csg_3mf_result (*read)(const char *data, size_t num, const struct csg_3mf_sink *sink,
                                char *error, size_t size);
};

/* The module's one symbol, a const struct csg_3mf_module, named with the version of this border. */
#define CSG_3MF_MODULE csg_3mf_module_1
#define CSG_3MF_MODULE_NAME "csg_3mf_module_1"

#ifdef __cplusplus
}
#endif

#endif
