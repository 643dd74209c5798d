/* SPDX-License-Identifier: MIT */
#ifndef CSG_REFERENCE_REFERENCE_H
#define CSG_REFERENCE_REFERENCE_H

/*
 * The oracle: a ray caster in double precision that shares nothing with the shaders but the
 * carriers. Rays are lines in world space, a leaf's crossings are solved in its canonical space,
 * and every node of the tree merges its operands' lists of crossings into its own (Roth 1982).
 */

#include "look/colorscheme.h"

struct csg_ray {
    struct csg_vec3 org, dir;
    double tnear; /* crossings at tnear and before have happened already */
};

struct csg_hit {
    double t;
    uint32_t leaf;
    bool cut; /* the leaf is subtracted here */
    uint8_t layer;
    struct csg_vec3 normal; /* unit, out of the solid */
};

struct csg_ray_scratch;
struct csg_tree_bounds;

/* bounds: of the scene, to leave subtrees out, and to stay as long; NULL: all is asked. */
struct csg_ray_scratch *csg_ray_scratch_create(const struct csg_tree_bounds *bounds);
void csg_ray_scratch_destroy(struct csg_ray_scratch *scratch);

/*
 * The first surface of the layer's objects that the ray crosses. Of crossings at the same t the
 * first object's counts; in an object, that of a literal whose whole path to the root changes, not
 * subtracted before subtracted, then in file order. false: none, or out of memory (*failed).
 */
bool csg_reference_trace(const struct csgcast_scene *scene, uint8_t layer,
                         const struct csg_ray *ray, struct csg_ray_scratch *scratch,
                         struct csg_hit *hit, bool *failed);

struct csg_reference_params {
    const struct csgcast_frustum *frustum;
    int width, height;
    const struct csg_colorscheme *scheme;
    enum csgcast_cut_color cut_color;
    int num_threads; /* see csg_parallel */
};

/* The pixels to cast: those of these rows that are wanted (called on any thread); NULL: all. */
struct csg_reference_part {
    int first_row, num_rows;
    bool (*wants)(const void *user, int x, int y);
    const void *user;
    bool culls; /* asks only subtrees whose boxes a ray meets; the oracle asks all */
};

/* Fills these pixels of image. false: out of memory. */
bool csg_reference_render(const struct csgcast_scene *scene,
                          const struct csg_reference_params *params,
                          const struct csg_reference_part *part, const struct csgcast_image *image);

#endif
