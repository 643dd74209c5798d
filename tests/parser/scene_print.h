/* SPDX-License-Identifier: MIT */
#ifndef CSG_TESTS_SCENE_PRINT_H
#define CSG_TESTS_SCENE_PRINT_H

/* A text that grows, and the printed form of a scene. */

#include <stddef.h>

#include "csg/scene.h"

struct text {
    char *data; /* zero-terminated once something was added */
    size_t num, capacity;
};

/* Ends the program when memory is out. */
void text_add(struct text *text, const char *format, ...) CSG_PRINTF(2, 3);

/* The trees of all layers that are not empty, then the leaves. */
void scene_print(const struct csgcast_scene *scene, struct text *text);

#endif
