/* SPDX-License-Identifier: MIT */
#include "shot.h"

#include <math.h>
#include <string.h>

const struct map map_identity = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

struct map map_scale(double x, double y, double z)
{
    return (struct map){{{x, 0, 0, 0}, {0, y, 0, 0}, {0, 0, z, 0}}};
}

struct map map_move(double x, double y, double z)
{
    return (struct map){{{1, 0, 0, x}, {0, 1, 0, y}, {0, 0, 1, z}}};
}

struct map map_turn(struct dice *dice)
{
    struct map map = map_identity;
    for (int i = 0; i < 3; i++)
        map_turn_by(&map, i, dice_between(dice, 0, 6.28));
    return map;
}

void shot_begin(struct shot *shot, double size)
{
    memset(shot, 0, sizeof *shot);
    ideal_scene_rest(&shot->ideal);
    shot->ideal.size = size;
    shot->extent = 10;
}

static void add_ideal(struct shot *shot, struct ideal_solid *solid, const struct map *map)
{
    ideal_solid_map(solid, map->m);
    if (shot->ideal.num_solids < IDEAL_MAX_SOLIDS)
        shot->ideal.solids[shot->ideal.num_solids++] = *solid;
}

void shot_part(struct shot *shot, const struct part *part)
{
    const struct flat flat = {.kind = part->kind, .size = part->size, .height = part->height};
    const struct style style = {TEXT_EXACT, &part->map, true};
    struct ideal_solid solid = flat_ideal(&flat);
    flat_put(&shot->text, &flat, &style);
    add_ideal(shot, &solid, &part->map);
}

void shot_quadric(struct shot *shot, const double terms[5], const struct map *map)
{
    struct ideal_solid solid = {0};
    struct ideal_form form =
        ideal_quadric(ideal_vec(0, 0, 0), terms[0], terms[1], terms[2], terms[4]);
    form.q[2][3] = form.q[3][2] = terms[3];
    ideal_solid_add(&solid, form);
    map_put(&shot->text, map, TEXT_EXACT);
    text_put(&shot->text,
             "quadric(coefficients = [%.17g, 0, 0, 0, %.17g, 0, 0, %.17g, %.17g, "
             "%.17g]);\n",
             terms[0], terms[1], terms[2], terms[3], terms[4]);
    add_ideal(shot, &solid, map);
}

/* The Booleans go in front of the solids: the rules used here combine from the left. */
void shot_end(struct shot *shot, const char *rule)
{
    struct text solids = shot->text;
    shot->text = (struct text){0};
    shot->ideal.rule = rule;
    const size_t length = strlen(rule);
    for (size_t i = length; i-- > 0;)
        if (rule[i] < 'a')
            text_put(&shot->text, "%s() {\n",
                     rule[i] == '+'   ? "union"
                     : rule[i] == '*' ? "intersection"
                                      : "difference");
    /* After the second solid each Boolean closes: solids are one line each, in order. */
    const char *line = solids.data ? solids.data : "";
    for (size_t i = 0; i < length; i++) {
        if (rule[i] < 'a') {
            text_put(&shot->text, "}\n");
            continue;
        }
        const size_t end = strcspn(line, "\n");
        text_put(&shot->text, "%.*s\n", (int)end, line);
        line += end + (line[end] != 0);
    }
    text_free(&solids);
}

static void store(double out[3], struct ideal_vec v)
{
    out[0] = (double)v.x;
    out[1] = (double)v.y;
    out[2] = (double)v.z;
}

void shot_look(struct shot *shot, struct ideal_vec target, struct ideal_vec away, double distance,
               double reach, bool orthographic)
{
    struct csgcast_camera *camera = &shot->view.camera;
    const real length = ideal_length(away);
    memset(camera, 0, sizeof *camera);
    camera->kind = CSGCAST_CAMERA_VECTOR;
    camera->projection = orthographic ? CSGCAST_ORTHOGRAPHIC : CSGCAST_PERSPECTIVE;
    camera->fov = 2 * atan(reach / distance) * 180 / 3.14159265358979323846;
    store(camera->center, target);
    store(camera->eye, ideal_add(target, ideal_scale(distance / length, away)));
}

struct ideal_vec random_direction(struct dice *dice)
{
    for (;;) {
        const struct ideal_vec v = ideal_vec(dice_between(dice, -1, 1), dice_between(dice, -1, 1),
                                             dice_between(dice, -1, 1));
        const real length = ideal_length(v);
        if (length > 0.1L && length <= 1)
            return ideal_scale(1 / length, v);
    }
}
