/* SPDX-License-Identifier: MIT */
/*
 * test_cases [--update] FILE.csg...
 *
 * Reads each file and compares the scene's printed form and all messages with FILE.expected.
 * --update writes those files instead; read what changed before it is committed. A first line
 * "// skip-unsupported" turns on that parameter.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/file.h"
#include "scene/load.h"
#include "scene_print.h"

static void add_message(void *user, enum csgcast_log_level level, enum csgcast_message id,
                        const char *message)
{
    static const char *const levels[] = {"error", "warning", "info"};
    (void)id;
    text_add(user, "%s: %s\n", levels[level], message);
}

static const char *base_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

static void read_scene(const char *path, const struct csg_bytes *bytes, struct text *printed)
{
    static const char skip[] = "// skip-unsupported";
    struct text messages = {0};
    struct csgcast_scene_params params = {
        .name = base_name(path), .log = add_message, .log_user = &messages, .no_handoff = true};
    params.skip_unsupported =
        bytes->num > sizeof skip && memcmp(bytes->data, skip, sizeof skip - 1) == 0;
    struct csgcast_scene *scene = csg_scene_read(bytes->data, bytes->num, &params);
    if (scene)
        scene_print(scene, printed);
    text_add(printed, "%s", scene ? "" : "no scene\n");
    for (size_t i = 0; i < messages.num; i++)
        text_add(printed, "%c", messages.data[i]);
    csgcast_scene_destroy(scene);
    free(messages.data);
}

static bool write_file(const char *path, const struct text *text)
{
    FILE *file = fopen(path, "wb");
    bool done = file && fwrite(text->data, 1, text->num, file) == text->num;
    if (file)
        done &= fclose(file) == 0;
    return done;
}

static bool matches(const char *path, const struct text *printed)
{
    struct csg_bytes expected;
    if (!csg_file_read(path, &expected, NULL))
        return false;
    const bool equal =
        expected.num == printed->num && memcmp(expected.data, printed->data, printed->num) == 0;
    if (!equal)
        fprintf(stderr, "%s differs; now:\n%s\nexpected:\n%.*s\n", path, printed->data,
                (int)expected.num, expected.data);
    free(expected.data);
    return equal;
}

static bool run_case(const char *path, bool update)
{
    char expected[4096];
    struct csg_bytes bytes;
    struct text printed = {0};
    if (!csg_file_read(path, &bytes, NULL))
        return false;
    snprintf(expected, sizeof expected, "%.*s.expected", (int)(strlen(path) - strlen(".csg")),
             path);
    read_scene(path, &bytes, &printed);
    const bool done = update ? write_file(expected, &printed) : matches(expected, &printed);
    free(bytes.data);
    free(printed.data);
    return done;
}

int main(int argc, char **argv)
{
    const bool update = argc > 1 && strcmp(argv[1], "--update") == 0;
    int num_failed = 0, num = 0;
    for (int i = update ? 2 : 1; i < argc; i++, num++)
        num_failed += !run_case(argv[i], update);
    printf("%d of %d cases failed\n", num_failed, num);
    return num_failed > 0 || num == 0;
}
