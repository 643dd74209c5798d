/* SPDX-License-Identifier: MIT */
#ifndef CSG_TESTS_EDIT_BENCH_H
#define CSG_TESTS_EDIT_BENCH_H

/* Two renderers side by side: one draws a scene that is edited, one the text that it has become. */

#include <csgcast/csgcast.h>

#define CHECK_TOGETHER
#include "../unit/check.h"
#include "model.h"

#define SIZE 72
#define PIXELS (SIZE * SIZE)
#define NUM_EDITS 5

struct picture {
    float rgba[4 * PIXELS], z[PIXELS], normal[3 * PIXELS], id[PIXELS];
};

struct bench {
    enum csgcast_backend backend;
    struct csgcast_renderer *edited, *fresh; /* one each, so that programs can be counted */
    int num_drawn;                           /* frames of the edited scene */
    struct picture got, expected;
    char text[MODEL_MAX_TEXT];
};

extern const char *bench_forced; /* variant of the pictures; NULL: none */
extern char bench_last_message[512];

/* A fixed scene. Ends the program where the text is none. */
struct csgcast_scene *bench_parse(const char *text);
void bench_draw(struct csgcast_renderer *renderer, const struct csgcast_scene *scene,
                const struct csgcast_camera *camera, struct picture *picture);

/* A scene that will be edited, and a renderer of its own for it, which has no program yet. */
struct csgcast_scene *bench_begin(struct bench *bench, const char *text);

/* A frame of it, into got. Only the first one may compile a program. */
void bench_draw_edited(struct bench *bench, const struct csgcast_scene *scene,
                       const struct csgcast_camera *camera);
struct csgcast_renderer *bench_create_renderer(const struct bench *bench);

/* By turns auto and the others, but for textbook: what that gets wrong depends on the structure. */
const char *bench_next_variant(size_t *name);

/* To the last bit, as the checks of tests/unit/check.h. */
void bench_compare_pictures(const struct bench *bench, const char *what, bool with_id);
void bench_compare_info(const struct csgcast_scene *a, const struct csgcast_scene *b,
                        const char *what);

/* Draws the edited scene and the bench's text, or that of its model, and compares both. */
void bench_compare_text(struct bench *bench, const struct csgcast_scene *scene, const char *what,
                        bool with_id);
void bench_compare(struct bench *bench, const struct csgcast_scene *scene,
                   const struct model *model, const char *what, bool with_id);

/* Random edits of random scenes (random.c, many.c), and cases by hand (cases.c). */
void check_random(struct bench *bench, uint64_t seed, int max_leaves);
void check_programs(struct bench *bench, uint64_t seed, int max_leaves);
void check_series(struct bench *bench, uint64_t seed);
void check_many(struct bench *bench, uint64_t seed, bool marked, bool has_surfaces);
void check_upload(struct bench *bench);
void check_shading(struct bench *bench);
void check_batch(struct bench *bench);
void check_all(struct bench *bench);
void check_growth(struct bench *bench);
void check_bar(struct bench *bench);
void check_cases(struct bench *bench);
void check_engraved(struct bench *bench);
void check_nodes(struct bench *bench);

#endif
