/* SPDX-License-Identifier: MIT */
/*
 * Faces of a twisted extrusion: those that a parallel face of another solid comes near are compared
 * with it, the others have their own carriers. Of two surfaces those are compared that come near a
 * triangle. One that folds over itself has none that is known to be apart.
 */
#include <stdio.h>
#include <string.h>

#include "carrier/carrier.h"
#include "check.h"
#include "csg/scene.h"
#include "mesh/surface.h"

static struct csgcast_scene *scene_of(const char *text)
{
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), NULL);
    CHECK(scene, "%s", text);
    return scene;
}

static const struct csg_surface *surface_of(const struct csgcast_scene *scene, size_t *leaf)
{
    for (*leaf = 0; *leaf < scene->num_leaves; (*leaf)++)
        if (scene->leaves[*leaf].shape.surface)
            return scene->leaves[*leaf].shape.surface;
    return NULL;
}

/* Faces of the surface on the carrier of a face of another leaf. */
static size_t count_shared(const struct csgcast_scene *scene, size_t leaf)
{
    const struct csg_carriers *carriers = scene->carriers;
    size_t num = 0;
    for (uint32_t i = carriers->face_begin[leaf]; i < carriers->face_begin[leaf + 1]; i++) {
        bool is_shared = false;
        for (uint32_t k = 0; k < carriers->face_begin[scene->num_leaves]; k++)
            is_shared |= (k < carriers->face_begin[leaf] || k >= carriers->face_begin[leaf + 1]) &&
                         carriers->faces[k].carrier == carriers->faces[i].carrier;
        num += is_shared && carriers->faces[i].carrier != CSG_NO_CARRIER;
    }
    return num;
}

/* The cap has 38 triangles: a polygon of 40 corners. */
static void test_flush(const char *second, size_t num_shared)
{
    char text[600];
    snprintf(text, sizeof text,
             "difference() { linear_extrude(height = 20, twist = 60, slices = 100)"
             " circle(r = 10, $fn = 40); %s }",
             second);
    struct csgcast_scene *scene = scene_of(text);
    size_t leaf;
    if (!scene)
        return;
    const struct csg_surface *surface = surface_of(scene, &leaf);
    CHECK(surface && surface->is_simple, "%s: no simple surface", second);
    if (surface) {
        const size_t num = count_shared(scene, leaf);
        CHECK(num == num_shared, "%s: %zu faces shared, not %zu", second, num, num_shared);
        CHECK(scene->carriers->num_planes + scene->carriers->num_own + num_shared >=
                  surface->planes.num - 2 * 38,
              "%s: %zu carriers for %zu faces", second, scene->carriers->num_planes,
              surface->planes.num);
    }
    csgcast_scene_destroy(scene);
}

/* Its faces are within the box, or cross its sides at an angle. */
static void test_crossed(void)
{
    struct csgcast_scene *scene = scene_of(
        "difference() { cube([60, 60, 15]); multmatrix([[1,0,0,30],[0,1,0,30],[0,0,1,5],[0,0,0,1]])"
        " linear_extrude(height = 20, twist = 60, slices = 100) circle(r = 10, $fn = 40); }");
    size_t leaf;
    if (!scene)
        return;
    CHECK(surface_of(scene, &leaf), "no surface");
    CHECK(scene->carriers->face_begin[leaf] == scene->carriers->face_begin[leaf + 1],
          "faces that cross others at an angle are compared with them");
    csgcast_scene_destroy(scene);
}

/* Two surfaces, one within the other: of their faces only caps come near, which are flush. The
 * inner one's are 38 triangles each. */
static void test_nested(void)
{
    struct csgcast_scene *scene =
        scene_of("difference() { linear_extrude(height = 20, twist = 60, slices = 100)"
                 " circle(r = 10, $fn = 40); linear_extrude(height = 20, twist = 60, slices = 100)"
                 " circle(r = 5, $fn = 40); }");
    if (!scene)
        return;
    const struct csg_carriers *carriers = scene->carriers;
    const uint32_t *begin = carriers->face_begin;
    size_t num_near = 0;
    for (uint32_t i = begin[0]; i < begin[1]; i++)
        num_near += carriers->faces[i].carrier != CSG_NO_CARRIER;
    CHECK(num_near > 0 && 20 * num_near < begin[1], "%zu of %u faces are compared", num_near,
          begin[1]);
    CHECK(begin[2] > begin[1] && count_shared(scene, 1) == 2 * 38, "%zu faces are shared",
          count_shared(scene, 1));
    csgcast_scene_destroy(scene);
}

static void test_folded(void)
{
    struct csgcast_scene *scene =
        scene_of("linear_extrude(height = 20, twist = 180, slices = 1) circle(r = 10, $fn = 200);");
    size_t leaf;
    if (!scene)
        return;
    const struct csg_surface *surface = surface_of(scene, &leaf);
    CHECK(surface && !surface->is_simple, "a surface that folds over itself is none");
    csgcast_scene_destroy(scene);
}

int main(void)
{
    test_flush("multmatrix([[1,0,0,-20],[0,1,0,-20],[0,0,1,10],[0,0,0,1]]) cube([40, 40, 10]);",
               38);
    test_flush("multmatrix([[1,0,0,-20],[0,1,0,-20],[0,0,1,10],[0,0,0,1]]) cube([40, 40, 11]);", 0);
    /* Touches it from below: left out. */
    test_flush("multmatrix([[1,0,0,-20],[0,1,0,-20],[0,0,1,-5],[0,0,0,1]]) cube([40, 40, 5]);", 0);
    /* Flush but for the rounding of six digits; and nearly. */
    test_flush("multmatrix([[1,0,0,-20],[0,1,0,-20],[0,0,1,9.99997],[0,0,0,1]])"
               " cube([40, 40, 10.0000345]);",
               38);
    test_flush("multmatrix([[1,0,0,-20],[0,1,0,-20],[0,0,1,9.99997],[0,0,0,1]])"
               " cube([40, 40, 10.001]);",
               0);
    test_crossed();
    test_nested();
    test_folded();
    return num_failed > 0;
}
