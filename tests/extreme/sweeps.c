/* SPDX-License-Identifier: MIT */
#include "sweeps.h"

#include <math.h>

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

/* Solids of the sweeps: 8 in half width, 6 deep. */
#define SIZE 8.0
#define DEPTH 6.0

static const struct ideal_vec middle = {0, 0, -DEPTH / 2};

static enum kind any_kind(struct dice *dice)
{
    return (enum kind)dice_pick(dice, NUM_KINDS);
}

static void add(struct shot *shot, enum kind kind, double size, double height,
                const struct map *map)
{
    shot_part(shot, &(struct part){kind, size, height, *map});
}

/* Two solids: one cut by another kind. */
static void add_cut(struct shot *shot, struct dice *dice, enum kind kind)
{
    const struct map turned = map_turn(dice), moved = map_move(5, 2, 0);
    const struct map map = map_multiply(&moved, &turned);
    shot_begin(shot, 10);
    add(shot, kind, SIZE, DEPTH, &map_identity);
    add(shot, any_kind(dice), 4, 5, &map);
    shot_end(shot, "ab-");
}

static void add_one(struct shot *shot, enum kind kind, const struct map *map, double size)
{
    shot_begin(shot, size);
    add(shot, kind, SIZE, DEPTH, map);
    shot_end(shot, "a");
}

/* ---- distance / radius ---- */

static const double distances[] = {2, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6};

static void make_distance(struct shot *shot, struct dice *dice, double value, int index)
{
    add_cut(shot, dice, (enum kind)(index % NUM_KINDS));
    shot_look(shot, middle, random_direction(dice), 10 * value, 11, index / NUM_KINDS % 2);
}

/* ---- needles and discs ---- */

static const double aspects[] = {1e1, 1e2, 1e3, 1e4, 1e5, 1e6};

static void make_aspect(struct shot *shot, struct dice *dice, double value, int index)
{
    const bool needle = index & 1, zoom = index & 2;
    const double thin = 1 / value;
    const struct map turned = map_turn(dice);
    const struct map scaled = needle ? map_scale(thin, thin, 1) : map_scale(1, 1, thin);
    const struct map map = map_multiply(&turned, &scaled);
    add_one(shot, (enum kind)(index / 4 % NUM_KINDS), &map, 10 * thin);
    const struct ideal_vec inside =
        ideal_vec(map.m[0][2] * -DEPTH / 2, map.m[1][2] * -DEPTH / 2, map.m[2][2] * -DEPTH / 2);
    const double reach = zoom ? 12 * thin : 11;
    shot_look(shot, inside, random_direction(dice), index & 4 ? 4 * reach : 40, reach,
              dice_pick(dice, 2));
}

/* ---- near-singular and mirrored maps ---- */

static const double conditions[] = {1e0, 1e2, 1e4, 1e6, 1e8};

static void make_map(struct shot *shot, struct dice *dice, double value, int index)
{
    const struct map a = map_turn(dice), b = map_turn(dice);
    const double side = index & 1 ? -1 : 1;
    struct map c = map_scale(side, 1 / sqrt(value), 1 / value);
    if (index & 2) { /* a shear of that size instead, brought back to the scene's */
        c = map_scale(side / fmax(1, sqrt(value) / 10), 1, 1);
        c.m[0][1] = side;
    }
    const struct map half = map_multiply(&a, &c), map = map_multiply(&half, &b);
    add_one(shot, any_kind(dice), &map, index & 2 ? 10 / sqrt(value) : 10 / value);
    const struct ideal_vec inside =
        ideal_vec(map.m[0][2] * -DEPTH / 2, map.m[1][2] * -DEPTH / 2, map.m[2][2] * -DEPTH / 2);
    shot_look(shot, inside, random_direction(dice), 40, 11, dice_pick(dice, 2));
}

/* ---- scale ---- */

static const double scales[] = {1e-6, 1e-3, 1, 1e3, 1e6};

static void make_scale(struct shot *shot, struct dice *dice, double value, int index)
{
    const struct map scaled = map_scale(value, value, value);
    const struct map turned = map_turn(dice), moved = map_move(5, 2, 0);
    const struct map place = map_multiply(&moved, &turned), other = map_multiply(&scaled, &place);
    shot_begin(shot, 10 * value);
    shot->extent = 10 * value;
    add(shot, (enum kind)(index % NUM_KINDS), SIZE, DEPTH, &scaled);
    add(shot, any_kind(dice), 4, 5, &other);
    shot_end(shot, "ab-");
    shot_look(shot, ideal_scale(value, middle), random_direction(dice), 40 * value, 11 * value,
              dice_pick(dice, 2));
}

/* ---- sliver tetrahedra ---- */

static const double heights[] = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6};

static void make_sliver(struct shot *shot, struct dice *dice, double value, int index)
{
    const struct map flat = map_scale(1, index & 1 ? value : 1, 1);
    shot_begin(shot, 10 * value);
    add(shot, KIND_TETRAHEDRON, SIZE, index & 1 ? DEPTH : DEPTH * value, &flat);
    shot_end(shot, "a");
    const double reach = index & 2 ? 20 * value : 10;
    shot_look(shot, ideal_vec(0, 0, index & 1 ? -1 : -value), random_direction(dice), 40, reach,
              dice_pick(dice, 2));
}

/* ---- rays along axes, faces and generators; hits on edges, vertices and apexes ---- */

static const double offsets[] = {0, 1e-9, 1e-6, 1e-3};

static void make_along(struct shot *shot, struct dice *dice, double value, int index)
{
    static const struct ideal_vec ways[] = {{1, 0, 0},        {0, -1, 0}, {0, 0, 1},
                                            {0, 0, -1},       {1, 1, 0},  {SIZE, 0, DEPTH},
                                            {0, SIZE, -DEPTH}};
    static const struct ideal_vec targets[] = {
        {0, 0, 0}, {0, 0, -DEPTH}, {SIZE, 0, 0}, {0, SIZE, 0}, {0, 0, -DEPTH / 2}};
    add_one(shot, (enum kind)(index % NUM_KINDS), &map_identity, 10);
    struct ideal_vec way = ways[dice_pick(dice, COUNT(ways))];
    way = ideal_add(way, ideal_scale(value, random_direction(dice)));
    shot_look(shot, targets[dice_pick(dice, COUNT(targets))], way, dice_pick(dice, 2) ? 40 : 12, 10,
              dice_pick(dice, 2));
}

/* ---- near-parabolic, near-degenerate quadrics ---- */

static const double ratios[] = {1e0, 1e2, 1e4, 1e6, 1e8};

static void make_eigen(struct shot *shot, struct dice *dice, double value, int index)
{
    const double e = 1 / value;
    const double forms[][5] = {
        {1, 1, e, 0, -25},     {1, 1, -e, 0, -25}, {1, 1, -e, 0, 4},   {1, 1, e, 2, -9},
        {1, 1, -e, 2, -9},     {1, e, 0, 2, -9},   {1, -e, 0, 2, -9},  {1, e, e, 0, -16},
        {1, -e, -e, 0, -16},   {1, e, 0, 0, -16},  {1, -e, 0, 0, -16}, {1, -1, e, 1, -9},
        {e, 1, 1, -2, -9 * e}, {1, 1, -e, 0, 0},
    };
    const struct map turned = map_turn(dice), box = map_move(0, 0, SIZE);
    shot_begin(shot, 10);
    shot_quadric(shot, forms[index % COUNT(forms)], &turned);
    add(shot, KIND_CUBE, SIZE, 2 * SIZE, &box);
    shot_end(shot, "ab*");
    shot_look(shot, ideal_vec(0, 0, 0), random_direction(dice), index / COUNT(forms) % 2 ? 18 : 400,
              14, dice_pick(dice, 2));
}

/* ---- shells ---- */

static const double shells[] = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6};

static void make_shell(struct shot *shot, struct dice *dice, double value, int index)
{
    const double s = 1 - value;
    struct map inner = map_scale(s, s, s);
    inner.m[2][3] = (s - 1) * DEPTH / 2;
    const struct map cut = map_move(SIZE, 0, 5);
    const enum kind kind = (enum kind)(index % NUM_KINDS);
    shot_begin(shot, 10 * value);
    add(shot, kind, SIZE, DEPTH, &map_identity);
    add(shot, kind, SIZE, DEPTH, &inner);
    add(shot, KIND_CUBE, SIZE, 20, &cut);
    shot_end(shot, "ab-c-");
    const bool zoom = index / NUM_KINDS % 2;
    struct ideal_vec away = random_direction(dice);
    away.x = fabsl(away.x) + 0.2L;
    shot_look(shot, ideal_vec(0, 0, -DEPTH / 2), away, 40, zoom ? 60 * value : 11,
              dice_pick(dice, 2));
}

/* ---- tangent solids ---- */

static const double gaps[] = {0, 1e-7, -1e-7, 1e-5, -1e-5, 1e-3, -1e-3};

static void make_tangent(struct shot *shot, struct dice *dice, double value, int index)
{
    /* spheres are cut in z = 0: their middles are at -size / 2 */
    const struct map turned = map_turn(dice);
    const struct map beside = map_move(7 + value, 0, 0), above = map_move(0, 0, 6.5 + value),
                     within = map_move(2 + value, 0, 0);
    static const char *const rules[] = {"ab+", "ab-"};
    const int pair = index % 4;
    shot_begin(shot, 10);
    struct map map = turned;
    if (pair == 0) { /* two spheres side by side */
        add(shot, KIND_SPHERE, 4, 0, &turned);
        map = map_multiply(&turned, &beside);
        add(shot, KIND_SPHERE, 3, 0, &map);
    } else if (pair == 1) { /* a sphere, 1.5 radii deep, on a box */
        add(shot, KIND_CUBE, SIZE, 2, &turned);
        map = map_multiply(&turned, &above);
        add(shot, KIND_SPHERE, 6.5 / 1.5, 0, &map);
    } else if (pair == 2) { /* a cylinder in a cylinder */
        add(shot, KIND_CYLINDER, 6, 5, &turned);
        map = map_multiply(&turned, &within);
        add(shot, KIND_CYLINDER, 4, 5, &map);
    } else { /* a ball in a cylinder */
        add(shot, KIND_CYLINDER, 4, 5, &turned);
        add(shot, KIND_SPHERE, 4 - value, 0, &turned);
    }
    shot_end(shot, rules[index / 4 % 2]);
    shot_look(shot, ideal_vec(0, 0, 0), random_direction(dice), 40, 11, dice_pick(dice, 2));
}

/* ---- the eye inside and on the surface ---- */

static const double nears[] = {1, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 0};

static void make_eye(struct shot *shot, struct dice *dice, double value, int index)
{
    const enum kind kind = (enum kind)(index % NUM_KINDS);
    const double side = index / NUM_KINDS % 2 ? 1 : -1;
    add_cut(shot, dice, kind);
    /* The face z = 0 is everybody's. */
    const struct ideal_vec eye = ideal_vec(-1, -0.5, side * 2 * value);
    const struct ideal_vec way = random_direction(dice);
    const double reach = tan(dice_between(dice, 20, 60) * 3.14159265358979323846 / 180);
    shot_look(shot, ideal_add(eye, way), ideal_scale(-1, way), 1, reach, false);
}

/* ---- field of view ---- */

static const double fovs[] = {0.1, 1, 10, 45, 90, 120, 150, 170};

static void make_fov(struct shot *shot, struct dice *dice, double value, int index)
{
    const double reach = 11, tangent = tan(0.5 * value * 3.14159265358979323846 / 180);
    add_cut(shot, dice, (enum kind)(index % NUM_KINDS));
    shot_look(shot, middle, random_direction(dice), fmax(reach / tangent, 7), reach, false);
    shot->view.camera.fov = value;
}

/* ---- the eye on any surface, to the rounding of its coordinates ---- */

static const double turns[] = {20, 45, 60};

static void make_surface(struct shot *shot, struct dice *dice, double value, int index)
{
    add_cut(shot, dice, (enum kind)(index % NUM_KINDS));
    struct ideal_hit hit = {.hit = false};
    for (int i = 0; i < 100 && !hit.hit; i++) {
        const struct ideal_vec away = random_direction(dice);
        const struct ideal_ray ray = {ideal_add(middle, ideal_scale(-20, away)), away, 0};
        hit = ideal_trace(&shot->ideal, &ray);
    }
    const struct ideal_vec way = random_direction(dice);
    shot_look(shot, ideal_add(hit.point, way), ideal_scale(-1, way), 1,
              tan(value * 3.14159265358979323846 / 180), false);
    shot->view.camera.eye[0] = (double)hit.point.x;
    shot->view.camera.eye[1] = (double)hit.point.y;
    shot->view.camera.eye[2] = (double)hit.point.z;
}

/* ---- a solid less the same, turned a little ---- */

static const double wedges[] = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6};

static void make_wedge(struct shot *shot, struct dice *dice, double value, int index)
{
    const double c = cos(value), s = sin(value);
    const struct map turned = {{{1, 0, 0, 0}, {0, c, -s, 0}, {0, s, c, 0}}};
    const enum kind kind = (enum kind)(index % NUM_KINDS);
    shot_begin(shot, 10);
    add(shot, kind, SIZE, DEPTH, &map_identity);
    add(shot, kind, SIZE, DEPTH, &turned);
    shot_end(shot, index / NUM_KINDS % 2 ? "ab-" : "ab+");
    shot_look(shot, middle, random_direction(dice), 40, 11, dice_pick(dice, 2));
}

/* ---- a small part of a large scene fills the picture ---- */

static const double zooms[] = {1e1, 1e2, 1e3, 1e4, 1e5, 1e6};

static void make_zoom(struct shot *shot, struct dice *dice, double value, int index)
{
    static const struct ideal_vec targets[] = {{-1, -0.5L, 0}, {SIZE, 0, 0}, {0, 0, -DEPTH}};
    add_cut(shot, dice, (enum kind)(index % NUM_KINDS));
    shot->ideal.size = 10 / value;
    struct ideal_vec away = random_direction(dice);
    away.z = index & 1 ? fabsl(away.z) + 0.2L : away.z;
    shot_look(shot, targets[dice_pick(dice, COUNT(targets))], away,
              index / NUM_KINDS % 2 ? 400 : 40, 11 / value, dice_pick(dice, 2));
}

/* ---- a small solid on a large one ---- */

static const double sizes[] = {1e1, 1e2, 1e3, 1e4, 1e5, 1e6};

static void make_mixed(struct shot *shot, struct dice *dice, double value, int index)
{
    const double s = 1 / value;
    const struct map small = {{{s, 0, 0, -1}, {0, s, 0, -0.5}, {0, 0, s, DEPTH * s}}};
    shot_begin(shot, 10 * s);
    shot->extent = 10;
    add(shot, any_kind(dice), SIZE, DEPTH, &map_identity);
    add(shot, (enum kind)(index % NUM_KINDS), SIZE, DEPTH, &small);
    shot_end(shot, "ab+");
    struct ideal_vec away = random_direction(dice);
    away.z = fabsl(away.z) + 0.1L;
    shot_look(shot, ideal_vec(-1, -0.5L, 3 * s), away, index / NUM_KINDS % 2 ? 40 : 40 * s, 14 * s,
              dice_pick(dice, 2));
}

/* ---- far from the origin ---- */

static const double places[] = {1e1, 1e2, 1e3, 1e4, 1e5};

static void make_place(struct shot *shot, struct dice *dice, double value, int index)
{
    const struct map moved = map_move(10 * value, -7 * value, 4 * value), turned = map_turn(dice);
    const struct map shift = map_move(5, 2, 0), other = map_multiply(&shift, &turned);
    const struct map map = map_multiply(&moved, &other);
    shot_begin(shot, 10);
    add(shot, (enum kind)(index % NUM_KINDS), SIZE, DEPTH, &moved);
    add(shot, any_kind(dice), 4, 5, &map);
    shot_end(shot, "ab-");
    const struct ideal_vec place = ideal_vec(10 * value, -7 * value, 4 * value);
    shot_look(shot, ideal_add(place, middle), random_direction(dice), 40, 11, dice_pick(dice, 2));
}

#define VALUES(array) array, COUNT(array)

const struct sweep sweeps[] = {
    {"distance", "distance / radius", VALUES(distances), 2 * NUM_KINDS, false, make_distance},
    {"aspect", "length / width", VALUES(aspects), 8 * NUM_KINDS, false, make_aspect},
    {"map", "condition", VALUES(conditions), 8, false, make_map},
    {"scale", "unit", VALUES(scales), NUM_KINDS, false, make_scale},
    {"sliver", "height / width", VALUES(heights), 4, false, make_sliver},
    {"along", "turned by", VALUES(offsets), 2 * NUM_KINDS, false, make_along},
    {"eigenvalues", "ratio", VALUES(ratios), 28, false, make_eigen},
    {"shell", "thickness / size", VALUES(shells), 2 * NUM_KINDS, false, make_shell},
    {"tangent", "gap", VALUES(gaps), 8, true, make_tangent},
    {"eye", "height over a face", VALUES(nears), 2 * NUM_KINDS, false, make_eye},
    {"surface", "half field of view", VALUES(turns), NUM_KINDS, false, make_surface},
    {"wedge", "radians", VALUES(wedges), 2 * NUM_KINDS, false, make_wedge},
    {"zoom", "times", VALUES(zooms), 2 * NUM_KINDS, false, make_zoom},
    {"mixed", "size / size", VALUES(sizes), 2 * NUM_KINDS, false, make_mixed},
    {"place", "radii from the origin", VALUES(places), NUM_KINDS, false, make_place},
    {"field of view", "degrees", VALUES(fovs), NUM_KINDS, false, make_fov},
};
const int num_sweeps = COUNT(sweeps);
