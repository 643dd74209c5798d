/* SPDX-License-Identifier: MIT */
/*
 * Compounds inside of compounds: any number of levels, and a time that does not double with each.
 */
#include <csgcast/csgcast.h>
#include <stdio.h>
#include <stdlib.h>

#include "check.h"

enum { NUM_LEVELS = 300, ROOM = NUM_LEVELS * 200 };

struct text {
    char *data;
    size_t num;
};

static void put(struct text *text, const char *what)
{
    text->num += (size_t)snprintf(text->data + text->num, ROOM - text->num, "%s", what);
}

/* Each level moves what is in it by one. */
static void check(const char *name, const char *levels[2], const double sides[3])
{
    struct text text = {malloc(ROOM), 0};
    double lo[3] = {0}, hi[3] = {0};
    CHECK(text.data, "memory");
    if (!text.data)
        return;
    for (int i = 0; i < NUM_LEVELS; i++) {
        put(&text, levels[i % 2]);
        put(&text, "multmatrix([[1,0,0,1],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) {");
    }
    put(&text, "cube([3, 4, 5]);");
    for (int i = 0; i < 2 * NUM_LEVELS; i++)
        put(&text, "}");
    struct csgcast_scene *scene = csgcast_scene_parse(text.data, text.num, NULL);
    CHECK(scene, "%s", name);
    CHECK(scene && csgcast_scene_get_bounds(scene, lo, hi), "%s: nothing", name);
    for (int i = 0; i < 3; i++) {
        const double at = i == 0 ? NUM_LEVELS : 0;
        CHECK(lo[i] > at - 1e-6 && lo[i] < at + 1e-6 && hi[i] > at + sides[i] - 1e-6 &&
                  hi[i] < at + sides[i] + 1e-6,
              "%s: from %g to %g along axis %d", name, lo[i], hi[i], i);
    }
    csgcast_scene_destroy(scene);
    free(text.data);
}

int main(void)
{
    static const double sides[3] = {3, 4, 5};
    check("hull", (const char *[]){"hull() {", "hull() {"}, sides);
    check("minkowski", (const char *[]){"minkowski() {", "hull() {"}, sides);
    check("resize", (const char *[]){"resize([3, 4, 5]) {", "hull() {"}, sides);
    check("resize alone", (const char *[]){"resize([3, 4, 5]) {", "resize([3, 0, 5]) {"}, sides);
    return num_failed > 0;
}
