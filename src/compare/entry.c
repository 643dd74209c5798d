/* SPDX-License-Identifier: MIT */

/* What csgcast-compare.so exports. */

#include "compare/module.h"

#if defined(__GNUC__)
__attribute__((visibility("default")))
#endif
void CSG_COMPARE_MODULE_ENTRY(struct csg_compare_module *module);

void CSG_COMPARE_MODULE_ENTRY(struct csg_compare_module *module)
{
    module->caster_create = csg_caster_create;
    module->import = csg_soup_import;
}
