/* SPDX-License-Identifier: MIT */
#ifndef CSG_SHARPNESS_SURVEYOR_H
#define CSG_SHARPNESS_SURVEYOR_H

/* Finds the sharpness of one object after the other. */

#include "sharpness/recall.h"
#include "sharpness/rounds.h"
#include "sharpness/sharpness.h"

/* Room that all objects share. */
struct csg_surveyor {
    struct csg_flats planes;
    struct csg_rounds quadrics;
    uint8_t *marks; /* by leaf: CSG_WALL_*, CSG_RECALL_MOVED, of an object */
    struct csg_recall recall;
};

/* As of an object without any geometry. */
extern const struct csg_sharpness csg_sharpness_blunt;

/* false: out of memory; finish is due all the same. */
bool csg_surveyor_init(struct csg_surveyor *surveyor, const struct csgcast_scene *scene);
void csg_surveyor_finish(struct csg_surveyor *surveyor);

/* Notes in sharp what the object's geometry asks of numbers. false: out of memory. */
bool csg_surveyor_note(struct csg_surveyor *surveyor, struct csg_sharpness *sharp,
                       const struct csgcast_scene *scene, const struct csg_object *object);

/* Whether the object is one solid of few planes, and the same of these, without room. */
bool csg_sharpness_is_of_one(const struct csgcast_scene *scene, const struct csg_object *object);
bool csg_sharpness_note_one(struct csg_sharpness *sharp, const struct csgcast_scene *scene,
                            const struct csg_object *object);

#endif
