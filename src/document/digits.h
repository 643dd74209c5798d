/* SPDX-License-Identifier: MIT */
#ifndef CSG_DOCUMENT_DIGITS_H
#define CSG_DOCUMENT_DIGITS_H

/*
 * OpenSCAD writes six digits of each number of a .csg. csgcast-digits.so (src/digits/digits.cpp),
 * preloaded into the openscad that flattens a .scad, makes it write all of them, and tells of
 * fonts.
 */

#include <stdbool.h>
#include <stddef.h>

/* The file in that folder to which it writes the names of the fonts that the .scad uses (use
 * <x.ttf>), a line each: the .csg does not have them. */
#define CSG_DIGITS_FONTS "fonts"

/* The file in that folder that is the last one openscad writes; frames of an animation have
 * others. */
#define CSG_DIGITS_STILL "scene.csg"

/* The last line of a text in which no number is rounded, see csg_value.rounding. */
#define CSG_DIGITS_MARK "// all digits\n"

/* Whether the text ends with that line. */
bool csg_digits_are_all(const char *text, size_t size);

/*
 * The environment for an openscad that writes .csg files into the folder: ours, with the module
 * preloaded behind what is preloaded already. NULL: ours will do, as the module is not there or
 * memory is out. The caller frees it with csg_digits_environment_free.
 */
char **csg_digits_environment(const char *folder);
void csg_digits_environment_free(char **environment);

/* The module's file name, which ld.so names where it cannot load it. */
extern const char csg_digits_module[];

#endif
