/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_REPORT_MESHES_H
#define CSG_CLI_REPORT_MESHES_H

#include "compare/soup.h"
#include "report.h"

/*
 * Has OpenSCAD make the mesh of item's series and $fn; fills its time, or its note where there is
 * no mesh (false). The caller finishes soup.
 */
bool csg_report_make_mesh(const struct csg_report *report, const char *path,
                          struct csg_report_item *item, struct csg_soup *soup);

/* Whether there is node and OpenSCAD's WebAssembly package, which has the Manifold kernel. */
bool csg_report_find_wasm(const struct csg_cli_options *options);

#endif
