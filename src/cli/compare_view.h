/* SPDX-License-Identifier: MIT */
#ifndef CSG_CLI_COMPARE_VIEW_H
#define CSG_CLI_COMPARE_VIEW_H

/* One view of the scene, drawn and cast at its mesh, and which of the pixels are wrong. */

#include "compare.h"

/* What all views have in common. */
struct csg_comparer {
    struct csgcast_scene *scene, *written; /* written: with OpenSCAD's facets, NULL: not needed */
    struct csgcast_renderer *renderer;
    struct csg_caster *caster; /* the mesh */
    double reach;              /* its largest coordinate */
};

/* Fills compared->views[number]; compared->num_views says how many there will be. false, with a
 * message. */
bool csg_compare_view(const struct csg_comparer *comparer, struct csg_compared *compared,
                      int number);

void csg_compared_view_finish(struct csg_compared_view *view);

#endif
