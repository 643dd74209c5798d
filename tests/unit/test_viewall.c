/* SPDX-License-Identifier: MIT */
/* What is taken away is not framed, neither its outside nor the holes that it has itself. */
#include <string.h>

#include "check.h"
#include "csgcast/csgcast.h"

static struct csgcast_frustum frame(const char *text)
{
    struct csgcast_frustum frustum = {.half_width = 0};
    struct csgcast_scene *scene = csgcast_scene_parse(text, strlen(text), NULL);
    CHECK(scene && csgcast_view_resolve(scene, NULL, &frustum), "%s", text);
    csgcast_scene_destroy(scene);
    return frustum;
}

static void test_alike(const char *text, const char *other)
{
    const struct csgcast_frustum one = frame(text), two = frame(other);
    CHECK(memcmp(one.eye, two.eye, sizeof one.eye) == 0, "%s is framed as %g %g %g", text,
          one.eye[0], one.eye[1], one.eye[2]);
}

#define AT "multmatrix([[1,0,0,40], [0,1,0,0], [0,0,1,0], [0,0,0,1]]) "

int main(void)
{
    const char cube[] = "cube(10);";
    test_alike("difference() { cube(10); " AT "sphere(r = 3); }", cube);
    test_alike("difference() { cube(10); rotate_extrude() " AT "square(3); }", cube);
    test_alike("difference() { cube(10); rotate_extrude($fn = 20) " AT "circle(r = 3, $fn = 6); }",
               cube);
    test_alike("difference() { cube(10); linear_extrude(height = 50) difference() {"
               "square(90); square(80); } }",
               cube);
    test_alike("difference() { cube(10); render() difference() { cube(90); cube(80); } }", cube);
    /* Taken away twice, the ring is there again, and is framed as a ring. */
    test_alike("difference() { cube(200); difference() { cube(200); rotate_extrude() " AT
               "square(3); } }",
               "difference() { union() { cube(200); rotate_extrude() " AT "square(3); }"
               "cube(0); }");
    return num_failed > 0;
}
