/* SPDX-License-Identifier: MIT */
#ifndef IDEAL_JUDGE_H
#define IDEAL_JUDGE_H

/* Pictures, and their pixels against what the scene is by construction. */

#include <stddef.h>

#include "ideal.h"

struct picture {
    int width, height;
    float *z, *normal, *id;
};

struct picture picture_create(int width, int height);
void picture_free(struct picture *picture);
bool picture_render(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                    const struct csgcast_view *view, struct picture *picture);

/* Degrees between two vectors of three. */
double picture_angle(const float *a, const float *b);

/* Whether another surface shows within a pixel: none, one that is further away or nearer by a
 * hundredth, or one turned by more than so many degrees. */
bool picture_is_edge(const struct picture *p, int x, int y, double degrees);

/* What the rays through the pixels' centres meet by construction: found once for all pictures of a
 * view. */
struct ideal_view {
    const struct ideal_scene *scene;
    const struct csgcast_frustum *frustum;
    int width, height;
    struct ideal_pixel {
        struct ideal_ray ray;
        struct ideal_hit hit;
    } * pixels;
};

struct ideal_view ideal_view_create(const struct ideal_scene *scene,
                                    const struct csgcast_frustum *frustum, int width, int height);
void ideal_view_free(struct ideal_view *view);
bool ideal_view_is_edge(const struct ideal_view *view, int x, int y);

struct tolerance {
    double surface; /* share of the scene: how far a hit may be off the right surface */
    double normal;  /* degrees */
};

struct verdict {
    size_t rays;
    size_t wrong; /* another surface, or none where there is one, or one where there is none */
    size_t edge;  /* of these, those within a pixel of a silhouette or crease: not in wrong */
    int x, y;     /* the first wrong pixel */
};

/* Adds to verdict. */
void judge_picture(const struct picture *picture, const struct ideal_view *view,
                   const struct tolerance *tolerance, struct verdict *verdict);

#endif
