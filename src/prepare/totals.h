/* SPDX-License-Identifier: MIT */
#ifndef CSG_PREPARE_TOTALS_H
#define CSG_PREPARE_TOTALS_H

/*
 * What a scene's boxes are united from: sums over runs of objects. After an edit only the runs of
 * the objects that changed are added up anew.
 */

#include "csg/object.h"

/* Of a run of objects. */
struct csg_sum {
    /* As in csgcast_scene, but written without what is in render() nodes. */
    struct csg_box box, drawn, written;
    double sagitta;
};

struct csg_totals {
    struct csg_sum *sums;
    size_t num;
};

/* false: out of memory. */
bool csg_totals_init(struct csg_totals *totals, const struct csgcast_scene *scene);
void csg_totals_finish(struct csg_totals *totals);

/* Adds up the runs of objects that have changed; those of one run had better stand together. */
void csg_totals_renew(struct csg_totals *totals, const struct csgcast_scene *scene,
                      const uint32_t *objects, size_t num);

/* Of all objects. */
struct csg_sum csg_totals_sum(const struct csg_totals *totals);

/* Gives the scene its box, drawn and sagitta: those that csg_scene_finish finds. */
void csg_totals_put(const struct csg_totals *totals, struct csgcast_scene *scene);

#endif
