/* SPDX-License-Identifier: MIT */
#include "openscad/openscad.h"

#include <stdint.h>
#include <string.h>

#include "common/array.h"
#include "document/digits.h"

/* More of one run than anybody reads: the first tell what began, the last what ended it. */
enum { MAX_FIRST = 100, MAX_LAST = 20 };

struct message_rule {
    const char *begin; /* of a line */
    enum csgcast_log_level level;
};

/* Lines that fit no rule say how far the work is; they are shown only where openscad failed. */
static const struct message_rule rules[] = {
    {"WARNING:", CSGCAST_LOG_WARNING},
    {"FONT-WARNING:", CSGCAST_LOG_WARNING},
    {"DEPRECATED:", CSGCAST_LOG_WARNING},
    {"ERROR:", CSGCAST_LOG_WARNING},
    {"Can't ", CSGCAST_LOG_WARNING},
    {"error", CSGCAST_LOG_WARNING}, /* CGAL, of OFF */
    {"ECHO:", CSGCAST_LOG_INFO},
    {"TRACE:", CSGCAST_LOG_INFO},
    {NULL, CSGCAST_LOG_ERROR},
};

/* After these openscad 2021.01 exits as if all were well, with what it had until then. */
static const char *const fatal_errors[] = {"Assertion ", "Recursion detected", "exceeded limit"};

/* What openscad 2021.01 says of what came after it, and what that is. */
static const struct newer_word {
    const char *said, *word;
} newer_words[] = {
    {"unknown function 'textmetrics'", "textmetrics()"},
    {"unknown function 'fontmetrics'", "fontmetrics()"},
    {"unknown function 'object'", "object()"},
    {"unknown function 'is_object'", "is_object()"},
    {"unknown function 'has_key'", "has_key()"},
    {"unknown function 'import'", "import() as a function"},
    {"unknown module 'fill'", "fill()"},
    {"unknown module 'roof'", "roof()"},
};

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

bool csg_openscad_mentions(const struct csg_bytes *messages, const char *text)
{
    return contains(messages->data, messages->num, text);
}

/* ld.so says that it leaves the module out, by which there is no loss. */
static bool is_of_digits(const char *line, size_t length)
{
    static const char begin[] = "ERROR: ld.so: ";
    return strncmp(begin, line, sizeof begin - 1) == 0 && contains(line, length, csg_digits_module);
}

struct message {
    const char *line;
    size_t length;
    bool counts; /* of many that do, those in the middle are left out; what a scene echoes is not */
    bool fatal;  /* the scene is incomplete */
    enum csgcast_log_level level;
};

/* false: the line is not shown. */
static bool read_message(const char *line, size_t length, bool failed, struct message *message)
{
    const struct message_rule *rule = rules;
    while (rule->begin && strncmp(rule->begin, line, strlen(rule->begin)) != 0)
        rule++;
    if (length == 0 || (!rule->begin && !failed) || is_of_digits(line, length))
        return false;
    const bool is_error = rule->begin && strcmp(rule->begin, "ERROR:") == 0;
    const bool is_echo = rule->begin && strcmp(rule->begin, "ECHO:") == 0;
    const bool fatal = is_error && is_fatal(line, length);
    *message = (struct message){line, length < INT16_MAX ? length : INT16_MAX, !is_echo, fatal,
                                fatal || (is_error && failed) ? CSGCAST_LOG_ERROR : rule->level};
    return true;
}

/* The next message from *at on; false: there is none. */
static bool next_message(const char **at, const char *end, bool failed, struct message *message)
{
    bool found = false;
    while (*at < end && !found) {
        const char *line = *at, *newline = memchr(line, '\n', (size_t)(end - line));
        const char *line_end = newline ? newline : end;
        found = read_message(line, (size_t)(line_end - line), failed, message);
        *at = newline ? newline + 1 : end;
    }
    return found;
}

static size_t count_messages(const char *at, const char *end, bool failed)
{
    struct message message;
    size_t num = 0;
    while (next_message(&at, end, failed, &message))
        num += message.counts;
    return num;
}

/* Returns whether some of them means that the scene is incomplete. */
static bool pass_on_messages(const struct csg_log *log, const char *prefix, const char *at,
                             const char *end, bool failed)
{
    const size_t num = count_messages(at, end, failed);
    const size_t left_out = num > MAX_FIRST + MAX_LAST ? num - MAX_FIRST - MAX_LAST : 0;
    struct message message;
    bool is_incomplete = false;
    for (size_t i = 0; next_message(&at, end, failed, &message); i += message.counts) {
        is_incomplete |= message.fatal;
        if (message.counts && i == MAX_FIRST && left_out > 0)
            csg_log_print(log, CSGCAST_LOG_WARNING, CSGCAST_MESSAGE_OPENSCAD,
                          "%sopenscad: (%zu more messages; openscad itself shows them)", prefix,
                          left_out);
        if (!message.counts || i < MAX_FIRST || i >= MAX_FIRST + left_out)
            csg_log_print(log, message.level, CSGCAST_MESSAGE_OPENSCAD, "%sopenscad: %.*s", prefix,
                          (int)message.length, message.line);
    }
    return is_incomplete;
}

/* Warnings of openscad do not tell why a word is unknown. */
static void name_newer_words(const struct csg_log *log, const char *prefix,
                             const struct csg_bytes *messages)
{
    for (size_t i = 0; i < sizeof newer_words / sizeof newer_words[0]; i++)
        if (csg_openscad_mentions(messages, newer_words[i].said))
            csg_log_print(log, CSGCAST_LOG_WARNING, CSGCAST_MESSAGE_OPENSCAD,
                          "%s%s is of a newer OpenSCAD than this openscad; --openscad names "
                          "another",
                          prefix, newer_words[i].word);
    if (csg_openscad_mentions(messages, "Parser error"))
        csg_log_print(log, CSGCAST_LOG_WARNING, CSGCAST_MESSAGE_OPENSCAD,
                      "%sthis openscad does not understand the file, which may be written for a "
                      "newer one; --openscad names another",
                      prefix);
}

bool csg_openscad_pass_on(const struct csg_log *log, const char *prefix, struct csg_bytes *messages,
                          bool failed)
{
    if (!csg_array_push(messages, '\0')) /* comparing a line's begin does not run out of it */
        return !csg_log_memory(log);
    messages->num--;
    const char *end = messages->data + messages->num;
    const bool is_incomplete = pass_on_messages(log, prefix, messages->data, end, failed);
    name_newer_words(log, prefix, messages);
    return is_incomplete;
}
