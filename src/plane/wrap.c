/* SPDX-License-Identifier: MIT */
#include "plane/wrap.h"

#include <stdlib.h>

static int compare_points(const void *a, const void *b)
{
    const struct csg_vec2 *p = a, *q = b;
    if (p->x != q->x)
        return p->x < q->x ? -1 : 1;
    return p->y < q->y ? -1 : p->y > q->y;
}

static double area(struct csg_vec2 a, struct csg_vec2 b, struct csg_vec2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/* Andrew's monotone chains: the lower one from left to right, the upper one back. */
bool csg_flat_points_wrap(struct csg_flat_points *points)
{
    const size_t num = points->list.num;
    struct csg_vec2 *p = points->list.data;
    struct csg_vec2 *hull = malloc((2 * num + 1) * sizeof *hull);
    size_t top = 0;
    if (!hull)
        return false;
    if (num)
        qsort(p, num, sizeof *p, compare_points);
    for (size_t i = 0; i < num; i++) {
        while (top >= 2 && area(hull[top - 2], hull[top - 1], p[i]) <= 0)
            top--;
        hull[top++] = p[i];
    }
    const size_t lower = top + 1;
    for (size_t i = num; num > 1 && i-- > 1;) {
        while (top >= lower && area(hull[top - 2], hull[top - 1], p[i - 1]) <= 0)
            top--;
        hull[top++] = p[i - 1];
    }
    points->list.num = 0;
    for (size_t i = 0; i + (num > 1) < top; i++)
        p[points->list.num++] = hull[i];
    free(hull);
    return true;
}

bool csg_flat_points_draw(struct csg_drawing *drawing, const struct csg_flat_points *points,
                          double rounding)
{
    bool ok = csg_drawing_add_figure(drawing, rounding) && csg_drawing_add_contour(drawing);
    for (size_t i = 0; i < points->list.num && ok; i++)
        ok = csg_drawing_add_point(drawing, points->list.data[i].x, points->list.data[i].y);
    return ok;
}
