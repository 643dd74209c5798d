/* SPDX-License-Identifier: MIT */
#ifndef CSG_COMPARE_MODULE_H
#define CSG_COMPARE_MODULE_H

/*
 * The border between the tool and csgcast-compare.so, which wraps Embree and assimp: what only
 * `csgcast compare` needs is loaded when it runs.
 */

#include "compare/caster.h"

struct csg_compare_module {
    struct csg_caster *(*caster_create)(const struct csg_soup *soup, const struct csg_log *log);
    bool (*import)(const char *path, struct csg_soup *soup, const struct csg_log *log);
};

/* What the module exports, named with the version of this border. */
#define CSG_COMPARE_MODULE_ENTRY csg_compare_module_1
#define CSG_COMPARE_MODULE_ENTRY_NAME "csg_compare_module_1"
typedef void csg_compare_module_fn(struct csg_compare_module *module);

/* Looks beside the tool and where it was installed, or where the environment variable
 * CSGCAST_COMPARE_MODULE says. It stays loaded. false, with a message that names the packages. */
bool csg_compare_module_load(struct csg_compare_module *module, const struct csg_log *log);

#endif
