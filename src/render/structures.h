/* SPDX-License-Identifier: MIT */
#ifndef CSG_RENDER_STRUCTURES_H
#define CSG_RENDER_STRUCTURES_H

/* The structures of a frame's objects that have straight-line programs of their own. */

#include "render/renderer.h"

struct csg_known_structure {
    const struct csg_step *steps; /* of the first object that has it */
    size_t num;
    bool stiff;
    GLuint program;
};

/* Zero-initialise it. */
struct csg_known_structures {
    struct csg_known_structure data[CSG_MAX_STRAIGHT_PROGRAMS];
    size_t num;
};

/* NULL: it is not among them. */
const struct csg_known_structure *csg_structures_find(const struct csg_known_structures *known,
                                                      const struct csg_structure *structure,
                                                      bool stiff);

/* There is room for it. */
void csg_structures_add(struct csg_known_structures *known, const struct csg_structure *structure,
                        bool stiff, GLuint program);

#endif
