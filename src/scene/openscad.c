/* SPDX-License-Identifier: MIT */
#include "scene/openscad.h"

#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/array.h"

extern char **environ;

/* One run of openscad. It starts as zeroes with both ends of the pipe -1. */
struct run {
    const char *path; /* as the caller named it */
    const char *program;
    const struct csg_log *log;
    char *input;     /* absolute: openscad resolves -o beside its input file */
    char *directory; /* temporary, ours alone */
    char *output;    /* in it; the ending tells openscad the format */
    int pipe[2];     /* carries what openscad prints */
    int status;      /* as from waitpid */
    struct csg_bytes messages;
};

/* The exit status by which some systems say that a program could not be started. */
enum { status_not_started = 127 };

static bool fail(const struct run *run, const char *what, int error)
{
    csg_log_error(run->log, CSGCAST_MESSAGE_OPENSCAD, "cannot flatten %s: %s: %s", run->path, what,
                  strerror(error));
    return false;
}

static bool fail_to_start(const struct run *run, int error)
{
    csg_log_error(run->log, CSGCAST_MESSAGE_OPENSCAD,
                  "cannot flatten %s: '%s' does not run: %s; install OpenSCAD (on Debian and "
                  "Ubuntu: apt-get install openscad), or set the environment variable OPENSCAD to "
                  "the program, or give a .csg file",
                  run->path, run->program, strerror(error));
    return false;
}

static char *join(const char *a, const char *b)
{
    const size_t size = strlen(a) + strlen(b) + 1;
    char *joined = malloc(size);
    if (joined)
        snprintf(joined, size, "%s%s", a, b);
    return joined;
}

static bool make_directory(struct run *run)
{
    const char *parent = getenv("TMPDIR");
    run->directory = join(parent && parent[0] == '/' ? parent : "/tmp", "/csgcast-XXXXXX");
    if (!run->directory)
        return csg_log_memory(run->log);
    if (!mkdtemp(run->directory)) {
        fail(run, run->directory, errno);
        free(run->directory);
        run->directory = NULL;
        return false;
    }
    run->output = join(run->directory, "/scene.csg");
    return run->output || csg_log_memory(run->log);
}

static char *current_directory(void)
{
    char *name = NULL;
    size_t size = 256;
    do {
        free(name);
        size *= 2;
        name = malloc(size);
    } while (name && !getcwd(name, size) && errno == ERANGE);
    return name;
}

static bool make_absolute(struct run *run)
{
    char *here = run->path[0] == '/' ? join("", "") : current_directory();
    char *slashed = here ? join(here, run->path[0] == '/' ? "" : "/") : NULL;
    run->input = slashed ? join(slashed, run->path) : NULL;
    free(here);
    free(slashed);
    return run->input || csg_log_memory(run->log);
}

/* openscad's own words for a file that is not there are less clear. */
static bool check_readable(const struct run *run)
{
    struct stat info;
    int error = stat(run->input, &info) != 0 || access(run->input, R_OK) != 0 ? errno : 0;
    if (!error && S_ISDIR(info.st_mode))
        error = EISDIR;
    if (error)
        csg_log_error(run->log, CSGCAST_MESSAGE_FILE, "cannot read %s: %s", run->path,
                      strerror(error));
    return !error;
}

static bool prepare(struct run *run)
{
    if (!make_absolute(run) || !check_readable(run))
        return false;
    if (!make_directory(run))
        return false;
    if (pipe(run->pipe) != 0)
        return fail(run, "pipe", errno);
    fcntl(run->pipe[0], F_SETFD, FD_CLOEXEC);
    fcntl(run->pipe[1], F_SETFD, FD_CLOEXEC);
    return true;
}

static void close_end(int *fd)
{
    if (*fd >= 0)
        close(*fd);
    *fd = -1;
}

static void finish(struct run *run)
{
    close_end(&run->pipe[0]);
    close_end(&run->pipe[1]);
    if (run->output)
        unlink(run->output);
    if (run->directory)
        rmdir(run->directory);
    free(run->output);
    free(run->directory);
    free(run->input);
    free(run->messages.data);
}

/* openscad -o OUTPUT [-D name=value]... INPUT. The strings are borrowed; the caller frees argv. */
static char **make_argv(const struct run *run, const struct csgcast_scene_params *params)
{
    const size_t num_defines = params->defines ? params->num_defines : 0;
    char **argv = calloc(2 * num_defines + 5, sizeof *argv);
    size_t num = 0;
    if (!argv)
        return NULL;
    argv[num++] = (char *)(uintptr_t)run->program;
    argv[num++] = (char *)(uintptr_t) "-o";
    argv[num++] = run->output;
    for (size_t i = 0; i < num_defines; i++) {
        argv[num++] = (char *)(uintptr_t) "-D";
        argv[num++] = (char *)(uintptr_t)params->defines[i];
    }
    argv[num++] = run->input;
    return argv;
}

/* No shell: names with blanks and quotes need no care. Returns an error number. */
static int start(struct run *run, char *const *argv, pid_t *child)
{
    posix_spawn_file_actions_t actions;
    int error = posix_spawn_file_actions_init(&actions);
    if (error)
        return error;
    error = posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (!error)
        error = posix_spawn_file_actions_adddup2(&actions, run->pipe[1], STDOUT_FILENO);
    if (!error)
        error = posix_spawn_file_actions_adddup2(&actions, run->pipe[1], STDERR_FILENO);
    if (!error)
        error = posix_spawnp(child, run->program, &actions, NULL, argv, environ);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

static int wait_for(struct run *run, pid_t child)
{
    close_end(&run->pipe[1]);
    int error = csg_file_read_all(run->pipe[0], &run->messages) ? 0 : errno;
    close_end(&run->pipe[0]); /* a child that still writes gets a broken pipe, not a hang */
    while (waitpid(child, &run->status, 0) < 0)
        if (errno != EINTR)
            return errno;
    return error;
}

static bool execute(struct run *run, const struct csgcast_scene_params *params)
{
    pid_t child;
    char **argv = make_argv(run, params);
    if (!argv)
        return csg_log_memory(run->log);
    int error = start(run, argv, &child);
    free(argv);
    if (error)
        return fail_to_start(run, error);
    error = wait_for(run, child);
    if (error)
        return fail(run, run->program, error);
    if (WIFEXITED(run->status) && WEXITSTATUS(run->status) == status_not_started)
        return fail_to_start(run, ENOENT);
    return true;
}

/* ---- messages ----------------------------------------------------------------------------- */

struct message_rule {
    const char *begin; /* of a line */
    enum csgcast_log_level level;
};

/* Lines that fit no rule say how far the work is; they are shown only where openscad failed. */
static const struct message_rule rules[] = {
    {"WARNING:", CSGCAST_LOG_WARNING},    {"FONT-WARNING:", CSGCAST_LOG_WARNING},
    {"DEPRECATED:", CSGCAST_LOG_WARNING}, {"ERROR:", CSGCAST_LOG_WARNING},
    {"Can't ", CSGCAST_LOG_WARNING},      {"ECHO:", CSGCAST_LOG_INFO},
    {"TRACE:", CSGCAST_LOG_INFO},         {NULL, CSGCAST_LOG_ERROR},
};

/* After these openscad 2021.01 exits as if all were well, with what it had until then. */
static const char *const fatal_errors[] = {"Assertion ", "Recursion detected", "exceeded limit"};

static bool contains(const char *line, size_t length, const char *text)
{
    const size_t text_length = strlen(text);
    size_t at = 0;
    while (at + text_length <= length && memcmp(line + at, text, text_length) != 0)
        at++;
    return at + text_length <= length;
}

static bool is_fatal(const char *line, size_t length)
{
    bool fatal = false;
    for (size_t i = 0; i < sizeof fatal_errors / sizeof fatal_errors[0]; i++)
        fatal |= contains(line, length, fatal_errors[i]);
    return fatal;
}

/* Returns whether the line means that the scene is incomplete. */
static bool pass_on_line(const struct run *run, const char *line, size_t length, bool failed)
{
    const struct message_rule *rule = rules;
    while (rule->begin && strncmp(rule->begin, line, strlen(rule->begin)) != 0)
        rule++;
    if (length == 0 || (!rule->begin && !failed))
        return false;
    const bool is_error = rule->begin && strcmp(rule->begin, "ERROR:") == 0;
    const bool fatal = is_error && is_fatal(line, length);
    csg_log_print(run->log, fatal || (is_error && failed) ? CSGCAST_LOG_ERROR : rule->level,
                  CSGCAST_MESSAGE_OPENSCAD, "openscad: %.*s", (int)length, line);
    return fatal;
}

/* messages ends in a zero, so comparing a line's begin does not run out of it. */
static bool pass_on_messages(const struct run *run, bool failed)
{
    bool has_error = false;
    const char *line = run->messages.data, *end = line + run->messages.num;
    while (line < end) {
        const char *newline = memchr(line, '\n', (size_t)(end - line));
        const size_t length = (size_t)((newline ? newline : end) - line);
        has_error |= pass_on_line(run, line, length < INT16_MAX ? length : INT16_MAX, failed);
        line = newline ? newline + 1 : end;
    }
    return has_error;
}

static bool check(struct run *run)
{
    const bool failed = !WIFEXITED(run->status) || WEXITSTATUS(run->status) != 0;
    if (!csg_array_push(&run->messages, '\0'))
        return csg_log_memory(run->log);
    run->messages.num--;
    const bool has_error = pass_on_messages(run, failed);
    if (!failed && !has_error)
        return true;
    if (WIFSIGNALED(run->status))
        csg_log_error(run->log, CSGCAST_MESSAGE_OPENSCAD,
                      "cannot flatten %s: %s was killed by signal %d", run->path, run->program,
                      WTERMSIG(run->status));
    else
        csg_log_error(run->log, CSGCAST_MESSAGE_OPENSCAD,
                      "cannot flatten %s: %s reports an error (exit status %d)", run->path,
                      run->program, WEXITSTATUS(run->status));
    return false;
}

/* The program that flattens: the caller's, the environment's, or the one in the path. */
static const char *choose_program(const struct csgcast_scene_params *params)
{
    const char *program = params->openscad ? params->openscad : getenv("OPENSCAD");
    return program && program[0] ? program : "openscad";
}

bool csg_openscad_flatten(const char *path, const struct csgcast_scene_params *params,
                          const struct csg_log *log, struct csg_bytes *text)
{
    struct run run = {
        .path = path, .program = choose_program(params), .log = log, .pipe = {-1, -1}};
    const bool done = prepare(&run) && execute(&run, params) && check(&run) &&
                      csg_file_read(run.output, text, log);
    finish(&run);
    return done;
}
