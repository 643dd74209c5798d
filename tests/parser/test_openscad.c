/* SPDX-License-Identifier: MIT */
/*
 * What csgcast_scene_load makes of openscad's behaviour: stand-ins for it, small shell scripts,
 * print, fail and write what openscad would. The installed openscad is tested in tests/openscad.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "csgcast/csgcast.h"
#include "scene_print.h"

struct stand_in {
    const char *name;
    const char *script; /* $2 is the output, the last argument the input; NULL: no such program */
    bool is_scene;
    const char *messages; /* each line must occur; a leading ! means that it must not */
};

static const struct stand_in stand_ins[] = {
    {"works", "echo 'cube(size = [1, 1, 1]);' > \"$2\"", true, "!error"},
    {"warns",
     "echo 'WARNING: too bad' >&2; echo 'ECHO: \"hi\"'; echo 'Compiling design (CSG Products "
     "generation)...'; echo 'cube(size = [1, 1, 1]);' > \"$2\"",
     true, "warning: openscad: WARNING: too bad\ninfo: openscad: ECHO: \"hi\"\n!Compiling"},
    {"asserts",
     "echo 'ERROR: Assertion '\"'false'\"' failed' >&2; echo 'cube(size = [1, 1, 1]);' > \"$2\"",
     false, "error: openscad: ERROR: Assertion\nerror: cannot flatten"},
    {"fails", "echo 'ERROR: Parser error: syntax error' >&2; echo \"Can't parse file\" >&2; exit 1",
     false, "error: openscad: ERROR: Parser error\n(exit status 1)"},
    {"dies", "kill -9 $$", false, "was killed by signal 9"},
    {"writes nothing", "exit 0", false, "has written nothing"},
    {"writes nonsense", "echo 'cube(' > \"$2\"", false, "case.scad (flattened by openscad):2:1: "},
    {"is missing", NULL, false, "does not run\ninstall OpenSCAD\nOPENSCAD"},
    {"gets the arguments",
     "test \"$1\" = -o && test \"$3\" = -D && test \"$4\" = 'a=\"b c\"' && test \"$5\" = -D && "
     "test \"$6\" = 'n=$(echo 1)' && test \"$7\" = -D && test -f \"$9\" && test $# = 9 && "
     "echo 'cube(size = [1, 1, 1]);' > \"$2\"",
     true, "!error"},
    {"echoes no camera",
     "echo 'ECHO: csgcast_view = [[0, 0, 0'; echo 'ECHO: csgcast_view = ['; "
     "echo 'ECHO: csgcast_view = [\"[\\\\\\\"\", -, [1, 2, 3, 4], [[['; "
     "echo 'WARNING: Viewall and autocenter disabled in favor of $vp*'; "
     "echo 'cube(size = [1, 1, 1]);' > \"$2\"",
     true, "!csgcast_view"},
    {"reads no input", "cat > \"$2\"", true, "!error"},
    {"prints a lot",
     "i=0; while test $i -lt 3000; do echo \"noise noise noise noise noise noise $i\" >&2; "
     "i=$((i + 1)); done; echo 'cube(size = [1, 1, 1]);' > \"$2\"",
     true, "!noise"},
    {"fails with a lot",
     "i=0; while test $i -lt 3000; do echo \"noise $i;\" >&2; i=$((i + 1)); done; exit 1", false,
     "openscad: noise 99;\n!noise 100;\n(2880 more messages\n!noise 2979;\nopenscad: noise 2980;\n"
     "openscad: noise 2999;\n(exit status 1)"},
    {"dies at the middle of a lot",
     "i=0; while test $i -lt 3000; do echo \"WARNING: $i;\" >&2; "
     "test $i = 1500 && echo 'ERROR: Recursion detected' >&2; i=$((i + 1)); done; "
     "echo 'cube(size = [1, 1, 1]);' > \"$2\"",
     false, "(2881 more messages\n!WARNING: 1500;\nerror: cannot flatten"},
    {"echoes a lot",
     "i=0; while test $i -lt 3000; do echo \"ECHO: $i;\"; i=$((i + 1)); done; "
     "echo 'cube(size = [1, 1, 1]);' > \"$2\"",
     true, "ECHO: 1500;\n!more messages"},
};

static void add_message(void *user, enum csgcast_log_level level, enum csgcast_message id,
                        const char *message)
{
    static const char *const levels[] = {"error", "warning", "info"};
    (void)id;
    text_add(user, "%s: %s\n", levels[level], message);
}

static bool write_text(const char *path, const char *text, mode_t mode)
{
    FILE *file = fopen(path, "w");
    if (!file)
        return false;
    const bool done = fputs(text, file) >= 0;
    return fclose(file) == 0 && done && chmod(path, mode) == 0;
}

/* Whether each line of expected occurs in messages, or does not when it begins with '!'. */
static bool has_lines(const char *messages, const char *expected)
{
    bool all = true;
    while (*expected) {
        char line[256];
        const size_t length = strcspn(expected, "\n");
        snprintf(line, sizeof line, "%.*s", (int)length, expected);
        all &= line[0] == '!' ? !strstr(messages, line + 1) : strstr(messages, line) != NULL;
        expected += length + (expected[length] == '\n');
    }
    return all;
}

/* Temporary files would lie in TMPDIR, which holds only the scene and the script. */
static bool is_clean(const char *directory)
{
    char command[512];
    snprintf(command, sizeof command,
             "test \"$(ls -A '%s' | wc -l)\" = \"$(ls -A '%s' | grep -c case)\"", directory,
             directory);
    return system(command) == 0;
}

static bool run_case(const struct stand_in *stand_in, const char *directory)
{
    static const char *const defines[] = {"a=\"b c\"", "n=$(echo 1)"};
    char program[256], scene_path[256], script[1024];
    struct text messages = {0};
    snprintf(program, sizeof program, "%s/case.sh", directory);
    snprintf(scene_path, sizeof scene_path, "%s/case.scad", directory);
    snprintf(script, sizeof script, "#!/bin/sh\n%s\n", stand_in->script ? stand_in->script : "");
    unlink(program);
    if (!write_text(scene_path, "cube();\n", 0644) ||
        (stand_in->script && !write_text(program, script, 0755)))
        return false;
    const bool has_defines = strcmp(stand_in->name, "gets the arguments") == 0;
    const struct csgcast_scene_params params = {.name = "case.scad",
                                                .openscad = program,
                                                .defines = defines,
                                                .num_defines = has_defines ? 2 : 0,
                                                .log = add_message,
                                                .log_user = &messages};
    struct csgcast_scene *scene = csgcast_scene_load(scene_path, &params);
    text_add(&messages, "%s", "");
    const bool passed = (scene != NULL) == stand_in->is_scene &&
                        has_lines(messages.data, stand_in->messages) && is_clean(directory);
    if (!passed)
        fprintf(stderr, "openscad %s: %s\n%s", stand_in->name, scene ? "a scene" : "no scene",
                messages.data);
    csgcast_scene_destroy(scene);
    free(messages.data);
    return passed;
}

/* Paths that cannot be read; openscad is not asked. */
static bool refuses(const char *path, const char *expected)
{
    struct text messages = {0};
    const struct csgcast_scene_params params = {.log = add_message, .log_user = &messages};
    struct csgcast_scene *scene = csgcast_scene_load(path, &params);
    text_add(&messages, "%s", "");
    const bool passed = !scene && has_lines(messages.data, expected);
    if (!passed)
        fprintf(stderr, "%s: %s\n", path, messages.data);
    csgcast_scene_destroy(scene);
    free(messages.data);
    return passed;
}

int main(void)
{
    char directory[] = "/tmp/csgcast-test-XXXXXX", command[64];
    int num_failed = 0;
    if (!mkdtemp(directory) || setenv("TMPDIR", directory, 1) != 0)
        return 1;
    for (size_t i = 0; i < sizeof stand_ins / sizeof stand_ins[0]; i++)
        num_failed += !run_case(&stand_ins[i], directory);
    num_failed += !refuses("/nowhere/x.scad", "error: cannot read /nowhere/x.scad: No such file");
    num_failed += !refuses("/nowhere/x.csg", "error: cannot read /nowhere/x.csg: No such file");
    num_failed += !refuses(directory, "Is a directory");
    snprintf(command, sizeof command, "rm -r '%s'", directory);
    num_failed += system(command) != 0;
    printf("%d checks failed\n", num_failed);
    return num_failed > 0;
}
