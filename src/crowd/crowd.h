/* SPDX-License-Identifier: MIT */
#ifndef CSG_CROWD_CROWD_H
#define CSG_CROWD_CROWD_H

/*
 * Crowds: objects of the model that are one convex, bounded, opaque solid each. However many there
 * are, each is one instance of a one-solid program (shaders/passes/single.frag.glsl), and those
 * that cannot be seen are left out by arithmetic over plain arrays (crowd/cull.h).
 */

#include <stdint.h>

#include "crowd/outline.h"
#include "csg/scene.h"

/* More planes make an object no member. */
#define CSG_CROWD_MAX_PLANES 6

/* Members whose terms are found alike; one run of the arrays. */
struct csg_crowd_class {
    enum csg_outline outline; /* BALL: a sphere to the noise of double arithmetic */
    bool has_quadric;
    uint32_t num_planes;
    size_t begin, end; /* members, in the order of their objects */
    size_t numbers;    /* of the first member's outline in csg_crowd.numbers */
};

/* By planes and quadric, and those that an outline says all about. */
#define CSG_CROWD_MAX_CLASSES (2 * (CSG_CROWD_MAX_PLANES + 1) + 3)

/* What objects that are drawn one by one do to others: nothing, hide them, or show them, too. */
enum csg_cover { CSG_COVER_NONE, CSG_COVER_HIDES, CSG_COVER_GLASS };

#define CSG_CROWD_NO_KIN UINT32_MAX

/* Fewer members are drawn sooner than compared, and have no picture of owners. */
enum { CSG_MIN_OCCLUDERS = 64 };

/* One entry a member, ordered by class, then by object. */
struct csg_crowd {
    size_t num;
    double *x, *y, *z, *radius; /* a ball around the solid */
    double *numbers;            /* the classes' outlines, csg_outline_size each */
    uint32_t *object, *leaf;
    uint32_t *kin; /* a number that members joined by shared carriers have in common; or NO_KIN */
    float *need;   /* see csg_precision_need */
    float least_need; /* of all */
    uint8_t *opaque;
    struct csg_crowd_class classes[CSG_CROWD_MAX_CLASSES];
    size_t num_classes;
    uint32_t *others; /* the objects that are no members */
    size_t num_others;
    uint8_t *covers; /* per object: enum csg_cover, for crowd/sift.h */
};

/* The scene's objects and carriers are there. NULL: out of memory. */
struct csg_crowd *csg_crowd_create(const struct csgcast_scene *scene);
void csg_crowd_destroy(struct csg_crowd *crowd);

/* Looks at the leaves' colours again. */
void csg_crowd_recolor(struct csg_crowd *crowd, const struct csgcast_scene *scene);

/* Of an object that is no member. */
#define CSG_CROWD_NO_MEMBER UINT32_MAX

/* Fills members, one for each object. */
void csg_crowd_list_members(const struct csg_crowd *crowd, uint32_t *members);

/* Looks at the colours of one object, which is that member, again. */
void csg_crowd_recolor_object(struct csg_crowd *crowd, const struct csgcast_scene *scene,
                              uint32_t object, uint32_t member);

/*
 * After an edit that has changed what these objects look like, but neither their structure nor
 * which of them share carriers: looks at them again. members: of csg_crowd_list_members. false,
 * with nothing changed: one of them belongs into another class.
 */
bool csg_crowd_follow(struct csg_crowd *crowd, const struct csgcast_scene *scene,
                      const uint32_t *objects, size_t num, const uint32_t *members);

#endif
