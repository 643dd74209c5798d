/* SPDX-License-Identifier: MIT */
#include "files/mesh_list.h"

#include <stdlib.h>

void csg_mesh_list_finish(struct csg_mesh_list *list)
{
    for (size_t i = 0; i < list->meshes.num; i++)
        csg_mesh_finish(&list->meshes.data[i]);
    free(list->meshes.data);
    *list = (struct csg_mesh_list){0};
}

struct csg_mesh *csg_mesh_list_add(struct csg_mesh_list *list)
{
    return csg_array_push(&list->meshes, (struct csg_mesh){0})
               ? &list->meshes.data[list->meshes.num - 1]
               : NULL;
}
