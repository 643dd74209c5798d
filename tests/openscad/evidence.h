/* SPDX-License-Identifier: MIT */
#ifndef TESTS_OPENSCAD_EVIDENCE_H
#define TESTS_OPENSCAD_EVIDENCE_H

#include "compare/compare.h"

/* Prints the first few pixels that count against csgcast. */
void evidence_print(const struct csg_mesh_view *reference, const struct csgcast_image *image,
                    const struct csg_comparison *comparison);

/*
 * Writes STEM.out.png (csgcast), STEM.ref.png (the mesh) and STEM.diff.png: grey where they agree,
 * yellow at edges that may differ, blue for thin, red for hit against miss, magenta for depth.
 */
void evidence_write(const char *stem, const struct csg_mesh_view *reference,
                    const struct csgcast_image *image, const struct csg_comparison *comparison);

#endif
