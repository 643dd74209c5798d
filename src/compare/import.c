/* SPDX-License-Identifier: MIT */

/* Meshes through assimp (part of the module csgcast-compare.so). */

#include "compare/soup.h"

#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <stdlib.h>

static struct csg_vec3 corner_of(const struct aiMesh *mesh, const struct aiFace *face, int i)
{
    const struct aiVector3D *p = &mesh->mVertices[face->mIndices[i]];
    return csg_vec3((double)p->x, (double)p->y, (double)p->z);
}

static void add_mesh(struct csg_soup *soup, const struct aiMesh *mesh)
{
    for (unsigned i = 0; i < mesh->mNumFaces; i++) {
        if (mesh->mFaces[i].mNumIndices != 3)
            continue; /* points and lines */
        struct csg_triangle *triangle = &soup->triangles[soup->num_triangles++];
        for (int k = 0; k < 3; k++) {
            triangle->corner[k] = corner_of(mesh, &mesh->mFaces[i], k);
            csg_box_extend(&soup->bounds, triangle->corner[k]);
        }
    }
}

static bool add_scene(struct csg_soup *soup, const struct aiScene *scene)
{
    size_t num = 0;
    for (unsigned i = 0; i < scene->mNumMeshes; i++)
        num += scene->mMeshes[i]->mNumFaces;
    soup->triangles = calloc(num + 1, sizeof *soup->triangles);
    for (unsigned i = 0; soup->triangles && i < scene->mNumMeshes; i++)
        add_mesh(soup, scene->mMeshes[i]);
    return soup->triangles;
}

bool csg_soup_import(const char *path, struct csg_soup *soup, const struct csg_log *log)
{
    *soup = (struct csg_soup){.bounds = csg_box_empty};
    /* The nodes' maps are applied to the vertices: what is left is one list of triangles. */
    const struct aiScene *scene =
        aiImportFile(path, aiProcess_Triangulate | aiProcess_PreTransformVertices);
    if (!scene) {
        csg_log_error(log, CSGCAST_MESSAGE_FILE, "cannot read the mesh %s: %s", path,
                      aiGetErrorString());
        return false;
    }
    const bool ok = add_scene(soup, scene);
    aiReleaseImport(scene);
    if (ok && soup->num_triangles)
        return true;
    if (ok)
        csg_log_error(log, CSGCAST_MESSAGE_FILE, "the mesh %s: assimp finds no triangles in it",
                      path);
    else
        csg_log_memory(log);
    csg_soup_finish(soup);
    return false;
}
