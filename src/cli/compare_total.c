/* SPDX-License-Identifier: MIT */

/* All views of `csgcast compare` together. */

#include "compare.h"

#include <math.h>

/* Takes b into a; num: pixels of either. */
static void add_errors(struct csg_errors *a, size_t num_a, const struct csg_errors *b, size_t num_b)
{
    const double num = (double)(num_a + num_b);
    a->mean = num > 0 ? (a->mean * (double)num_a + b->mean * (double)num_b) / num : 0;
    a->p99 = fmax(a->p99, b->p99);
    a->p999 = fmax(a->p999, b->p999);
    if (b->max > a->max) {
        a->max = b->max;
        a->x = b->x;
        a->y = b->y;
    }
}

static void add_view(struct csg_compared_total *total, const struct csg_compared_view *view)
{
    const struct csg_comparison *r = &view->result;
    const size_t before = total->num_compared;
    add_errors(&total->depth, before, &r->depth, r->num_compared);
    add_errors(&total->normal, before, &r->normal, r->num_compared);
    add_errors(&total->relative, before, &r->relative, r->num_compared);
    add_errors(&total->offset, before, &r->offset, r->num_compared);
    total->num_compared += r->num_compared;
    total->num_hits += r->num_hits;
    total->num_missing += r->num_missing;
    total->num_extra += r->num_extra;
    total->num_wrong += view->num_wrong;
    total->facets = fmax(total->facets, view->facets);
}

void csg_compared_sum_up(struct csg_compared *compared)
{
    struct csg_compared_total *total = &compared->total;
    for (int i = 0; i < compared->num_views; i++)
        add_view(total, &compared->views[i]);
    const size_t either = total->num_hits + total->num_extra;
    total->iou = either ? (double)(total->num_hits - total->num_missing) / (double)either : 1;
    total->wrong = total->num_hits    ? (double)total->num_wrong / (double)total->num_hits
                   : total->num_wrong ? 1
                                      : 0;
}

struct csg_vec3 csg_compared_position(const struct csg_compared_view *view, int x, int y)
{
    const struct csg_mesh_view *mesh = &view->mesh;
    const struct csg_mesh_ray ray =
        csg_frustum_ray(&mesh->frustum, mesh->width, mesh->height, x + 0.5, y + 0.5);
    return csg_add(ray.org, csg_scale(mesh->hits[y * mesh->width + x].t, ray.dir));
}
