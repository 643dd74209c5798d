/* SPDX-License-Identifier: MIT */
/*
 * Faces on one plane, to the last bit, have one carrier, whatever else they nearly coincide with:
 * two bends that meet, with the numbers of a flattened file. What lies between two carriers of one
 * plane would be drawn as a skin.
 */
#include <stdlib.h>
#include <string.h>

#include "carrier/carrier.h"
#include "check.h"
#include "csg/scene.h"

#define BEND(angle)                                                                                \
    "rotate_extrude(angle = " angle ", $fn = 0, $fa = 2, $fs = 2) {"                               \
    " multmatrix([[1, 0, 0, 171.5], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) { difference() {"   \
    "  circle($fn = 0, $fa = 2, $fs = 2, r = 31); circle($fn = 0, $fa = 2, $fs = 2, r = 28.5174);" \
    "}}}"

static const char text[] =
    BEND("20") "multmatrix([[0.939693, 0, 0.34202, 0], [0.34202, 0, -0.939693, 0], [0, 1, 0, 0],"
               " [0, 0, 0, 1]]) { multmatrix([[0.984607, 0.174782, 0, 0], [0, 0, -1, 0],"
               " [-0.174782, 0.984607, 0, 0], [0, 0, 0, 1]]) {" BEND("10.066") "}}";

struct face {
    double numbers[4]; /* of the plane, turned to one side */
    uint32_t carrier;
    bool flipped;
};

static int compare(const void *a, const void *b)
{
    const double *p = ((const struct face *)a)->numbers, *q = ((const struct face *)b)->numbers;
    for (int i = 0; i < 4; i++)
        if (p[i] != q[i])
            return p[i] < q[i] ? -1 : 1;
    return 0;
}

static struct face face_of(const struct csg_plane *plane, const struct csg_face *face)
{
    const double n[4] = {plane->normal.x, plane->normal.y, plane->normal.z, plane->offset};
    const bool is_turned = n[0] != 0 ? n[0] < 0 : n[1] != 0 ? n[1] < 0 : n[2] < 0;
    struct face result = {.carrier = face->carrier, .flipped = face->flipped != is_turned};
    for (int i = 0; i < 4; i++)
        result.numbers[i] = is_turned ? -n[i] : n[i];
    return result;
}

static size_t collect(const struct csgcast_scene *scene, struct face *faces)
{
    const struct csg_carriers *carriers = scene->carriers;
    size_t num = 0;
    for (size_t leaf = 0; leaf < scene->num_leaves; leaf++)
        for (size_t i = 0; i < scene->leaves[leaf].shape.num_planes; i++)
            faces[num++] = face_of(&scene->leaves[leaf].shape.planes[i],
                                   &carriers->faces[carriers->face_begin[leaf] + i]);
    return num;
}

int main(void)
{
    const struct csgcast_scene_params params = {.facets = CSGCAST_FACETS_EXACT};
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), &params);
    CHECK(scene, "the scene");
    struct face *faces =
        scene ? malloc((scene->carriers->face_begin[scene->num_leaves] + 1) * sizeof *faces) : NULL;
    CHECK(faces, "memory");
    const size_t num = faces ? collect(scene, faces) : 0;
    size_t num_equal = 0;
    if (num)
        qsort(faces, num, sizeof *faces, compare);
    for (size_t i = 1; i < num; i++) {
        if (compare(&faces[i - 1], &faces[i]) != 0)
            continue;
        num_equal++;
        CHECK(faces[i].carrier == faces[i - 1].carrier && faces[i].flipped == faces[i - 1].flipped,
              "two carriers of one plane: %u and %u", (unsigned)faces[i - 1].carrier,
              (unsigned)faces[i].carrier);
    }
    CHECK(num_equal > 500, "the test tests little: %zu faces are equal", num_equal);
    free(faces);
    csgcast_scene_destroy(scene);
    return num_failed > 0;
}
