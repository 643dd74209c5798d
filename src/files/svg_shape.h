/* SPDX-License-Identifier: MIT */
#ifndef CSG_FILES_SVG_SHAPE_H
#define CSG_FILES_SVG_SHAPE_H

#include "files/svg_path.h"

/* The attributes of an element. */
struct csg_svg_attributes {
    const struct csg_xml_attribute *list;
    size_t num;
};

/* The value of that name; "" where there is none. */
const char *csg_svg_find(const struct csg_svg_attributes *attributes, const char *name);

/* Adds the paths of a shape, its pen set from the attributes. false: the name is that of none. */
bool csg_svg_add_shape(struct csg_svg_paths *paths, const char *name,
                       const struct csg_svg_attributes *attributes);

#endif
