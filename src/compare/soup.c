/* SPDX-License-Identifier: MIT */
#include "compare/soup.h"

#include "common/array.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool csg_soup_is_ascii_stl(const char *path)
{
    char begin[512] = "";
    FILE *file = fopen(path, "rb");
    if (!file)
        return false;
    const size_t num = fread(begin, 1, sizeof begin - 1, file);
    fclose(file);
    return strncmp(begin, "solid", 5) == 0 && !memchr(begin, 0, num) &&
           (strstr(begin, "facet") || strstr(begin, "endsolid"));
}

static bool read_facets(FILE *file, struct csg_soup *soup, bool *complete)
{
    CSG_ARRAY(struct csg_triangle) triangles = {0};
    struct csg_triangle triangle;
    int num_corners = 0;
    char line[256] = "";
    bool ok = true;
    while (ok && fgets(line, sizeof line, file)) {
        struct csg_vec3 *p = &triangle.corner[num_corners];
        if (sscanf(line, " vertex %lf %lf %lf", &p->x, &p->y, &p->z) != 3)
            continue;
        csg_box_extend(&soup->bounds, *p);
        if (++num_corners < 3)
            continue;
        num_corners = 0;
        ok = csg_array_push(&triangles, triangle);
    }
    soup->triangles = triangles.data;
    soup->num_triangles = triangles.num;
    *complete = num_corners == 0 && strstr(line, "endsolid");
    return ok;
}

bool csg_soup_read(const char *path, struct csg_soup *soup, const struct csg_log *log)
{
    bool complete = false;
    *soup = (struct csg_soup){.bounds = csg_box_empty};
    FILE *file = fopen(path, "r");
    if (!file) {
        csg_log_error(log, CSGCAST_MESSAGE_FILE, "cannot read %s: %s", path, strerror(errno));
        return false;
    }
    const bool ok = read_facets(file, soup, &complete);
    fclose(file);
    if (ok && complete)
        return true;
    if (ok)
        csg_log_error(log, CSGCAST_MESSAGE_FILE, "%s is not a complete ASCII STL file", path);
    else
        csg_log_memory(log);
    csg_soup_finish(soup);
    return false;
}

void csg_soup_finish(struct csg_soup *soup)
{
    free(soup->triangles);
    soup->triangles = NULL;
    soup->num_triangles = 0;
}
