/* SPDX-License-Identifier: MIT */
/* Turns that a look at records takes of those that llvmpipe grants to a fragment program. */

#include "check.h"
#include "render/turns.h"
#include "shader/source.h"

enum { MAX_TEXELS = 64 };

/* A record's head; its other texels follow. */
static void put(float *texels, int *num, const float head[4], int rest)
{
    for (int i = 0; i < 4; i++)
        texels[4 * *num + i] = head[i];
    *num += 1 + rest;
}

static double look(float *texels, int num, int features)
{
    const struct csg_frame frame = {.texels = {.data = texels, .num = 4 * (size_t)num}};
    const struct csg_draw draw = {.instance.records = {0, num}};
    return csg_turns_of(&frame, &draw, features).look;
}

/* A loop's end is a turn, in programs with loops for surfaces also of records without one, and of
 * what comes behind the last record. */
static void check_ends(void)
{
    float texels[4 * MAX_TEXELS] = {0};
    int num = 0;
    put(texels, &num, (const float[]){3, 24, CSG_RECORD_START, 0}, 27);
    const double alone = look(texels, num, CSG_FEATURE_QUADRIC);
    CHECK(alone >= 1 + (1 + 1 + 1) + 1 + (2 + 1) + (12 + 1), "too few turns");
    CHECK(look(texels, num, CSG_FEATURE_SURFACE) >= alone + 2 * 2, "too few turns");
    CHECK(look(texels, num, CSG_FEATURE_BANDS) >= alone + 2 * 2, "too few turns");
    CHECK(look(texels, num, CSG_FEATURE_SURFACE | CSG_FEATURE_BANDS) >= alone + 2 * 4,
          "too few turns");
}

/* A surface's record: its longest list, and the ends of the loops for planes as well. */
static void check_surface(void)
{
    enum { LONGEST = 20 };
    float texels[4 * MAX_TEXELS] = {0};
    int num = 0;
    put(texels, &num, (const float[]){10, 0, CSG_RECORD_START | CSG_RECORD_SURFACE, 0}, 10);
    texels[4 * 2 + 1] = LONGEST;
    CHECK(look(texels, num, CSG_FEATURE_SURFACE) >= 1 + (1 + 2 + 2) + 1 + 2 + 2 + LONGEST,
          "too few turns");
}

int main(void)
{
    check_ends();
    check_surface();
    return num_failed > 0;
}
