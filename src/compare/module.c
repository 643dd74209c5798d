/* SPDX-License-Identifier: MIT */
#include "compare/module.h"

#include <dlfcn.h>
#include <string.h>

#include "common/module.h"

#define MODULE_NAME "csgcast-compare.so"

bool csg_compare_module_load(struct csg_compare_module *module, const struct csg_log *log)
{
    void *const address =
        csg_module_symbol(MODULE_NAME, "CSGCAST_COMPARE_MODULE", CSG_COMPARE_MODULE_ENTRY_NAME);
    csg_compare_module_fn *entry;
    memcpy(&entry, &address, sizeof entry);
    if (address) {
        entry(module);
        return true;
    }
    const char *reason = dlerror();
    csg_log_error(log, CSGCAST_MESSAGE_FILE,
                  "meshes need " MODULE_NAME " with Embree and assimp (%s): on Debian apt-get "
                  "install libembree3-3 libassimp5, to build it libembree-dev libassimp-dev, or "
                  "set CSGCAST_COMPARE_MODULE",
                  reason ? reason : "it is not beside csgcast, nor where it is installed");
    return false;
}
