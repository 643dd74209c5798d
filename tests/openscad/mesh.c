/* SPDX-License-Identifier: MIT */
#include "mesh.h"

#include "common/array.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/*
 * ASCII STL, since OpenSCAD 2025 writes every digit of its doubles there, but six digits in OFF,
 * OBJ, AMF and VRML, and floats in binary STL. assimp would round to float as well.
 */
bool mesh_read(const char *path, struct mesh *mesh)
{
    CSG_ARRAY(struct triangle) triangles = {0};
    struct triangle triangle;
    int num_corners = 0;
    char line[256] = "";
    bool ok = true;

    FILE *file = fopen(path, "r");
    if (!file) {
        fprintf(stderr, "referee: cannot read the mesh %s\n", path);
        return false;
    }
    mesh->bounds = csg_box_empty;
    while (ok && fgets(line, sizeof line, file)) {
        struct csg_vec3 *p = &triangle.corner[num_corners];
        if (sscanf(line, " vertex %lf %lf %lf", &p->x, &p->y, &p->z) != 3)
            continue;
        csg_box_extend(&mesh->bounds, *p);
        if (++num_corners < 3)
            continue;
        num_corners = 0;
        ok = csg_array_push(&triangles, triangle);
    }
    fclose(file);
    mesh->triangles = triangles.data;
    mesh->num_triangles = triangles.num;
    if (ok && (num_corners != 0 || !strstr(line, "endsolid"))) {
        fprintf(stderr, "referee: %s is not a complete ASCII STL file\n", path);
        ok = false;
    }
    if (!ok)
        mesh_finish(mesh);
    return ok;
}

void mesh_finish(struct mesh *mesh)
{
    free(mesh->triangles);
    mesh->triangles = NULL;
    mesh->num_triangles = 0;
}
