/* SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "export/pov.h"

static int compare(const void *a, const void *b)
{
    const struct csg_pov_paint *p = a, *q = b;
    for (int i = 0; i < 4; i++)
        if (p->rgba[i] != q->rgba[i])
            return p->rgba[i] < q->rgba[i] ? -1 : 1;
    return 0;
}

static struct csg_pov_paint paint_of(const struct csg_pov *pov, const struct csg_object *object,
                                     const struct csg_node *node)
{
    struct csg_pov_paint paint;
    const struct csg_leaf *minuend =
        pov->view->cut_color == CSGCAST_CUT_MINUEND ? csg_object_minuend(pov->scene, object) : NULL;
    csg_face_color(pov->scheme, &pov->scene->leaves[node->leaf], minuend, object->paint,
                   node->negated, paint.rgba);
    return paint;
}

static void make_distinct(struct csg_pov_paints *paints)
{
    size_t num = 0;
    if (paints->num)
        qsort(paints->data, paints->num, sizeof *paints->data, compare);
    for (size_t i = 0; i < paints->num; i++)
        if (i == 0 || compare(&paints->data[i], &paints->data[num - 1]))
            paints->data[num++] = paints->data[i];
    paints->num = num;
}

static bool add_object(struct csg_pov *pov, const struct csg_object *object)
{
    const struct csg_node *nodes = pov->scene->trees[object->layer].data;
    for (uint32_t i = object->begin; i < object->end; i++) {
        if (nodes[i].op != CSG_LEAF)
            continue;
        const struct csg_pov_paint paint = paint_of(pov, object, &nodes[i]);
        const struct csg_pov_paints *paints = &pov->paints;
        if (paints->num && !compare(&paints->data[paints->num - 1], &paint))
            continue; /* the usual case: the same as before */
        if (!csg_array_push(&pov->paints, paint))
            return false;
    }
    return true;
}

bool csg_pov_paints_fill(struct csg_pov *pov)
{
    const struct csg_objects *objects = pov->scene->objects;
    for (size_t i = 0; i < objects->num; i++)
        if (!objects->data[i].hidden && !add_object(pov, &objects->data[i]))
            return false;
    make_distinct(&pov->paints);
    return true;
}

size_t csg_pov_paint_find(const struct csg_pov *pov, const struct csg_object *object,
                          const struct csg_node *node)
{
    const struct csg_pov_paint paint = paint_of(pov, object, node);
    const struct csg_pov_paint *found =
        bsearch(&paint, pov->paints.data, pov->paints.num, sizeof paint, compare);
    return (size_t)(found - pov->paints.data);
}
