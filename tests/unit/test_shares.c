/* SPDX-License-Identifier: MIT */
/*
 * A large scene is read in shares, side by side; where there is something to say, by one thread. A
 * warning at its end must change nothing else: leaves and trees are the same to the last bit.
 */
#define DICE_SEED 11

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "csg/scene.h"
#include "dice.h"

enum { NUM_STATEMENTS = 40000, ROOM = 1 << 23 };

#define PUT(text, ...)                                                                             \
    ((text)->num += (size_t)snprintf((text)->data + (text)->num, ROOM - (text)->num, __VA_ARGS__))

struct text {
    char *data;
    size_t num;
};

static void put_solid(struct text *text)
{
    const unsigned a = random_below(9), b = 1 + random_below(9);
    switch (random_below(4)) {
    case 0:
        PUT(text, "sphere(r = %u);\n", a); /* nothing where it is 0 */
        break;
    case 1:
        PUT(text, "cylinder(h = %u, r1 = %u, r2 = %u);\n", b, a, b);
        break;
    case 2:
        PUT(text, "group();\n");
        break;
    default:
        PUT(text, "cube([%u.12345, %u, %u]);\n", b, b, a);
    }
}

static void put_opening(struct text *text)
{
    static const char *const modifiers[60] = {"*", "#", "%"};
    static const char *const nodes[4] = {"group()", "union()", "difference()", "intersection()"};
    const unsigned a = random_below(20);
    const char *modifier = modifiers[random_below(60)];
    PUT(text, "%s", modifier ? modifier : "");
    if (a < 8)
        PUT(text, "multmatrix([[1, 0, 0, %u.23456], [0, %u, 0, 1], [0, 0, 1, 0]]) {\n", a, a + 1);
    else if (a < 12)
        PUT(text, "color([0.%u, 0.5, 1, 1]) {\n", a);
    else
        PUT(text, "%s {\n", nodes[a % 4]);
}

/* Up to 40 levels deep; some braces stay open over many shares. */
static char *make_text(void)
{
    struct text text = {malloc(ROOM), 0};
    int depth = 0;
    PUT(&text, "color([1, 0, 0, 1]) translate([1, 2, 3]) {\n"); /* around all shares */
    for (int i = 0; i < NUM_STATEMENTS; i++) {
        const unsigned what = random_below(8);
        if (what < 2 && depth < 40) {
            put_opening(&text);
            depth++;
        } else if (what < 4 && depth > 0) {
            PUT(&text, "}\n");
            depth--;
        } else {
            put_solid(&text);
        }
    }
    for (; depth >= 0; depth--)
        PUT(&text, "}\n");
    return text.data;
}

static void count(void *user, enum csgcast_log_level level, enum csgcast_message id,
                  const char *text)
{
    (void)level, (void)id, (void)text;
    ++*(int *)user;
}

static bool same_leaf(const struct csg_leaf *a, const struct csg_leaf *b)
{
    const struct csg_shape *x = &a->shape, *y = &b->shape;
    return a->kind == b->kind && a->line == b->line && a->column == b->column &&
           memcmp(a->color, b->color, sizeof a->color) == 0 && x->num_planes == y->num_planes &&
           x->has_quadric == y->has_quadric && memcmp(&x->frame, &y->frame, sizeof x->frame) == 0 &&
           memcmp(&x->bounds, &y->bounds, sizeof x->bounds) == 0 && x->rounding == y->rounding;
}

static bool same_tree(const struct csg_tree *a, const struct csg_tree *b)
{
    bool same = a->num == b->num;
    for (size_t i = 0; i < a->num && same; i++)
        same = a->data[i].op == b->data[i].op && a->data[i].leaf == b->data[i].leaf &&
               a->data[i].negated == b->data[i].negated && a->data[i].end == b->data[i].end;
    return same;
}

static struct csgcast_scene *parse(const char *text, int *num_said)
{
    const struct csgcast_scene_params params = {
        .log = count, .log_user = num_said, .num_threads = 3};
    return csgcast_scene_parse(text, strlen(text), &params);
}

int main(void)
{
    char *text = make_text();
    int num_said[2] = {0, 0};
    struct csgcast_scene *shared = parse(text, &num_said[0]);
    strcat(text, "group(strange = 1);\n");
    struct csgcast_scene *alone = parse(text, &num_said[1]);
    CHECK(shared && alone, "the scenes are read");
    CHECK(num_said[0] == 0 && num_said[1] == 1, "%d and %d messages", num_said[0], num_said[1]);
    const size_t num = shared && alone ? shared->num_leaves : 0;
    CHECK(num > NUM_STATEMENTS / 8 && num == alone->num_leaves, "%zu leaves", num);
    for (size_t i = 0; i < num && num_failed == 0; i++)
        CHECK(same_leaf(&shared->leaves[i], &alone->leaves[i]), "leaf %zu", i);
    for (int layer = 0; layer < CSG_NUM_LAYERS && num_failed == 0; layer++)
        CHECK(same_tree(&shared->trees[layer], &alone->trees[layer]), "layer %d", layer);
    CHECK(num_failed || shared->info.num_dropped == alone->info.num_dropped, "dropped");
    csgcast_scene_destroy(shared);
    csgcast_scene_destroy(alone);
    free(text);
    return num_failed > 0;
}
