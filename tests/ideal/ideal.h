/* SPDX-License-Identifier: MIT */
#ifndef IDEAL_IDEAL_H
#define IDEAL_IDEAL_H

/*
 * What a scene is by construction: a ray caster in long double that knows nothing of the library.
 * A solid is a list of quadratic inequalities; a ray's crossings with all of them are sorted and
 * the Boolean is evaluated by point membership in the middle of every interval between two
 * crossings. Slow, and simple enough to be believed.
 */

#include <csgcast/csgcast.h>

#include <stdbool.h>

typedef long double real;

struct ideal_vec {
    real x, y, z;
};

/* (p, 1) q (p, 1) <= 0 inside; q is symmetric. */
struct ideal_form {
    real q[4][4];
};

#define IDEAL_MAX_FORMS 16
#define IDEAL_MAX_SOLIDS 8

/* The points that satisfy all forms. */
struct ideal_solid {
    int num;
    struct ideal_form forms[IDEAL_MAX_FORMS];
};

struct ideal_scene {
    int num_solids;
    struct ideal_solid solids[IDEAL_MAX_SOLIDS];
    const char *rule;    /* postfix over solids a, b, ... with + - * for the Booleans */
    real rotation[3][3]; /* from the space of the solids to the world */
    struct ideal_vec move;
    real size; /* of the scene, in its own space */
};

/* In the space of the solids. A point of the ray is org + t dir, t along the view axis. */
struct ideal_ray {
    struct ideal_vec org, dir;
    real tnear; /* nearly 0, or -infinity */
};

struct ideal_hit {
    bool hit, from_inside;
    real t;
    struct ideal_vec point, normal; /* the normal faces the ray */
    const struct ideal_form *form;
};

struct ideal_vec ideal_vec(real x, real y, real z);
struct ideal_vec ideal_add(struct ideal_vec a, struct ideal_vec b);
struct ideal_vec ideal_scale(real s, struct ideal_vec a);
real ideal_dot(struct ideal_vec a, struct ideal_vec b);
real ideal_length(struct ideal_vec a);

/* normal.p <= offset. */
struct ideal_form ideal_plane(real x, real y, real z, real offset);
/* xx x^2 + yy y^2 + zz z^2 + constant <= 0, about center. */
struct ideal_form ideal_quadric(struct ideal_vec center, real xx, real yy, real zz, real constant);
void ideal_solid_add(struct ideal_solid *solid, struct ideal_form form);
/* Replaces p by (x, y, sign z) + move: the solid's image under that map. */
void ideal_solid_place(struct ideal_solid *solid, struct ideal_vec move, bool mirrored);

/* The image under an affine map, rows of 3x4, of any condition. */
void ideal_solid_map(struct ideal_solid *solid, const double map[3][4]);

real ideal_form_value(const struct ideal_form *form, struct ideal_vec p);
struct ideal_vec ideal_form_gradient(const struct ideal_form *form, struct ideal_vec p);
/* Distance of p from the form's surface, to first order. */
real ideal_form_distance(const struct ideal_form *form, struct ideal_vec p);

/* No rotation, no move. */
void ideal_scene_rest(struct ideal_scene *scene);
struct ideal_vec ideal_to_world(const struct ideal_scene *scene, struct ideal_vec p);

/* The ray through pixel coordinates (x, y), row 0 on top, centres at .5. */
struct ideal_ray ideal_ray(const struct ideal_scene *scene, const struct csgcast_frustum *frustum,
                           int width, int height, real x, real y);
struct ideal_hit ideal_trace(const struct ideal_scene *scene, const struct ideal_ray *ray);

/* Pixels from the centre of a pixel to where hits turn to misses, up to 1, to a factor of 2;
 * 2: further. */
double ideal_silhouette(const struct ideal_scene *scene, const struct csgcast_frustum *frustum,
                        int width, int height, int x, int y);

/* Another surface, or none, shows within a pixel of this one. */
bool ideal_is_edge(const struct ideal_scene *scene, const struct csgcast_frustum *frustum,
                   int width, int height, int x, int y);

#endif
