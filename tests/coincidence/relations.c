/* SPDX-License-Identifier: MIT */
#include "relations.h"

#include <math.h>
#include <string.h>

const char *const relation_names[NUM_RELATIONS] = {"flush",  "through", "abut",  "grow",
                                                   "plug",   "parts",   "inner", "undo",
                                                   "absorb", "equal",   "twice", "skin"};
const char *const placement_names[NUM_PLACEMENTS] = {"rest",      "outer",      "each",    "far",
                                                     "six outer", "six nested", "six each"};

/* a is 1, the unit that tolerances are shares of, to a few times. */
#define SKIN 1e-4

struct recipe {
    const char *text; /* a, b: the solids; others as they are */
    const char *rule;
};

static const struct recipe recipes[NUM_RELATIONS] = {
    [RELATION_FLUSH] = {"difference() { a b }", "ab-"},
    [RELATION_THROUGH] = {"difference() { a b }", "ab-"},
    [RELATION_ABUT] = {"union() { a b }", "ab+"},
    [RELATION_GROW] = {"union() { a b }", "ab+"},
    [RELATION_PLUG] = {"union() { difference() { a b } b }", "ab+"},
    [RELATION_PARTS] = {"union() { difference() { a b } intersection() { a b } }", "a"},
    [RELATION_INNER] = {"difference() { a difference() { a b } }", "ab*"},
    [RELATION_UNDO] = {"difference() { union() { a b } b }", "ab-"},
    [RELATION_ABSORB] = {"intersection() { union() { a b } a }", "a"},
    [RELATION_EQUAL] = {"difference() { a b }", "ab-"},
    [RELATION_TWICE] = {"intersection() { a union() { b a } }", "a"},
    [RELATION_SKIN] = {"difference() { a b }", "ab-"},
};

bool relation_has_b(enum relation relation)
{
    return relation != RELATION_GROW && relation != RELATION_EQUAL && relation != RELATION_TWICE;
}

/* Multiples of 1/64: sums and products are exact, and six digits round many of them. */
static double on_grid(struct dice *dice, double lo, double hi)
{
    return floor(64 * dice_between(dice, lo, hi)) / 64;
}

/* A turn, often about one axis by a round angle, and a move of some reach. */
static struct map random_map(struct dice *dice, double reach)
{
    const double degree = 3.14159265358979323846 / 180;
    struct map map = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
    if (dice_pick(dice, 2))
        map_turn_by(&map, dice_pick(dice, 3), 15 * dice_pick(dice, 24) * degree);
    else
        for (int i = 0; i < 3; i++)
            map_turn_by(&map, i, dice_between(dice, 0, 6.28));
    for (int i = 0; i < 3; i++)
        map.m[i][3] = dice_between(dice, -reach, reach);
    return map;
}

static void place(struct pair *pair, struct dice *dice, enum placement placement, struct map *map,
                  struct style *style, bool *outer)
{
    const double far = 1e5 * (double)pair->ideal.size;
    pair->six = placement >= PLACE_SIX_OUTER;
    *outer = placement == PLACE_OUTER || placement == PLACE_SIX_OUTER ||
             (placement == PLACE_FAR && dice_pick(dice, 2));
    *map = random_map(dice, placement == PLACE_FAR ? far : 50);
    style->digits = pair->six ? TEXT_SIX : TEXT_EXACT;
    style->nested = placement == PLACE_SIX_NESTED || dice_pick(dice, 2);
    if (placement == PLACE_SIX_EACH)
        style->nested = false;
    style->each = *outer || placement == PLACE_REST ? NULL : map;
    ideal_scene_rest(&pair->ideal);
    if (placement == PLACE_REST)
        return;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            pair->ideal.rotation[i][j] = map->m[i][j];
    pair->ideal.move = ideal_vec(map->m[0][3], map->m[1][3], map->m[2][3]);
}

static struct flat random_a(struct dice *dice, enum kind kind)
{
    return (struct flat){.kind = kind, .size = on_grid(dice, 6, 9), .height = on_grid(dice, 5, 8)};
}

static struct flat random_b(struct dice *dice, enum kind kind, const struct flat *a)
{
    return (struct flat){.kind = kind,
                         .size = on_grid(dice, 1.5, 4),
                         .height = on_grid(dice, 1.5, 4),
                         .x = on_grid(dice, -2, 2),
                         .y = on_grid(dice, -2, 2),
                         .alias = a->alias};
}

/* What the relation wants of b. */
static void relate(struct dice *dice, enum relation relation, enum placement placement,
                   const struct flat *a, struct flat *b)
{
    switch (relation) {
    case RELATION_THROUGH:
        b->height = a->height;
        break;
    case RELATION_ABUT:
        b->up = true;
        break;
    case RELATION_GROW:
        *b = *a;
        b->up = true;
        break;
    case RELATION_EQUAL:
    case RELATION_TWICE:
        *b = *a;
        b->alias = placement < PLACE_SIX_OUTER && dice_pick(dice, 2);
        break;
    case RELATION_SKIN:
        b->z = -SKIN * a->size;
        break;
    default:
        b->up = false;
    }
}

static void put_recipe(struct text *text, const struct recipe *recipe, const struct flat *a,
                       const struct flat *b, const struct style *style)
{
    for (const char *c = recipe->text; *c; c++) {
        const bool alone = (c == recipe->text || c[-1] == ' ') && (c[1] == ' ' || !c[1]);
        if (*c == 'a' && alone)
            flat_put(text, a, style);
        else if (*c == 'b' && alone)
            flat_put(text, b, style);
        else
            text_put(text, "%c", *c);
    }
    text_put(text, "\n");
}

void pair_make(struct pair *pair, struct dice *dice, enum relation relation, enum kind a_kind,
               enum kind b_kind, enum placement placement)
{
    struct map map;
    struct style style;
    bool outer;
    memset(pair, 0, sizeof *pair);
    const struct flat a = random_a(dice, a_kind);
    struct flat b = random_b(dice, b_kind, &a);
    relate(dice, relation, placement, &a, &b);
    pair->ideal.num_solids = 2;
    pair->ideal.solids[0] = flat_ideal(&a);
    pair->ideal.solids[1] = flat_ideal(&b);
    pair->ideal.rule = recipes[relation].rule;
    pair->ideal.size = 10;
    pair->target = ideal_vec(b.x, b.y, 0);
    place(pair, dice, placement, &map, &style, &outer);
    if (outer) {
        map_put(&pair->text, &map, style.digits);
        text_put(&pair->text, "{\n");
    }
    put_recipe(&pair->text, &recipes[relation], &a, &b, &style);
    if (outer)
        text_put(&pair->text, "}\n");
}
