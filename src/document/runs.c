/* SPDX-License-Identifier: MIT */
#include "document/runs.h"

#include <stdlib.h>
#include <string.h>

#include "common/parallel.h"

/* Shorter texts are read sooner than threads start. */
#define MIN_SIZE ((size_t)1 << 20)

enum { NUM_RUNS = 16 };

struct runs {
    struct csg_run runs[NUM_RUNS];
    const char *file;
};

void csg_run_finish(struct csg_run *run)
{
    csg_document_finish(&run->document);
    csg_twins_finish(&run->twins);
}

static bool is_letter(char c)
{
    return c >= 'a' && c <= 'z';
}

/* Where the first outermost node seems to begin from byte at on; size: nowhere. */
static size_t find_cut(const char *text, size_t size, size_t at)
{
    const char *line = at + 1 < size ? memchr(text + at, '\n', size - at - 1) : NULL;
    for (; line; line = memchr(line + 1, '\n', (size_t)(text + size - line) - 2))
        if (line > text && is_letter(line[1]) && (line[-1] == '}' || line[-1] == ';'))
            return (size_t)(line - text) + 1;
    return size;
}

static void parse_run(void *user, size_t task)
{
    struct runs *runs = user;
    struct csg_run *run = &runs->runs[task];
    struct csg_report report;
    csg_report_init(&report, &csg_log_silent, runs->file);
    csg_run_parse(run, &report);
    for (int level = 0; level <= CSGCAST_LOG_INFO; level++)
        run->is_whole &= report.num[level] == 0;
}

/* The number that the first of all twins has; run's own one comes first in it. UINT32_MAX: out of
 * memory. */
static uint32_t number_twin(struct csg_twins *twins, const struct csg_lexer *lexer,
                            struct csg_twin twin, uint32_t base)
{
    const struct csg_twin *first = csg_twins_find(twins, lexer, twin.at);
    if (first)
        return first->node;
    twin.node += base;
    return csg_twins_add(twins, lexer, &twin) ? twin.node : UINT32_MAX;
}

/* Twins are numbered in the order of their first nodes, which are theirs. */
static bool number_twins(struct csg_twins *twins, const struct csg_lexer *lexer,
                         struct csg_run *run, uint32_t base)
{
    struct csg_parsed_node *nodes = run->document.nodes.data;
    size_t num = 0;
    bool ok = true;
    for (uint32_t i = 0; i < run->document.nodes.num && ok; i++) {
        const uint32_t twin = nodes[i].twin;
        if (twin == i)
            nodes[i].twin = number_twin(twins, lexer, run->twins.all.data[num++], base);
        else if (twin != CSG_NO_TWIN)
            nodes[i].twin = nodes[twin].twin;
        ok = twin != i || nodes[i].twin != UINT32_MAX;
    }
    return ok;
}

static void append(struct csg_document *document, const struct csg_run *run, uint32_t line)
{
    const uint32_t base = (uint32_t)document->nodes.num;
    for (size_t i = 0; i < run->document.nodes.num; i++) {
        struct csg_parsed_node node = run->document.nodes.data[i];
        node.end += base;
        node.place.line += line;
        document->nodes.data[base + i] = node;
    }
    document->nodes.num += run->document.nodes.num;
    document->num_rounded += run->document.num_rounded;
}

static size_t count_nodes(const struct runs *runs)
{
    size_t num = 0;
    for (size_t i = 0; i < NUM_RUNS; i++)
        num += runs->runs[i].document.nodes.num;
    return num;
}

static bool join(struct csg_document *document, struct runs *runs)
{
    const struct csg_lexer lexer = {.text = document->text, .size = document->size};
    struct csg_twins twins = {0};
    uint32_t line = 0;
    bool ok = csg_array_reserve(&document->nodes, count_nodes(runs));
    for (size_t i = 0; i < NUM_RUNS && ok; i++) {
        struct csg_run *run = &runs->runs[i];
        ok = number_twins(&twins, &lexer, run, (uint32_t)document->nodes.num);
        if (ok)
            append(document, run, line);
        line += run->num_lines;
        csg_run_finish(run);
    }
    csg_twins_finish(&twins);
    if (!ok)
        document->nodes.num = document->num_rounded = 0;
    return ok;
}

static size_t cut(struct runs *runs, const char *text, size_t size)
{
    size_t begin = 0, num = 0;
    for (size_t i = 0; i < NUM_RUNS; i++) {
        const size_t to = size / NUM_RUNS * (i + 1);
        const size_t end = i + 1 == NUM_RUNS ? size : find_cut(text, size, to > begin ? to : begin);
        runs->runs[i] = (struct csg_run){.text = text, .size = size, .begin = begin, .end = end};
        num += end > begin;
        begin = end;
    }
    return num;
}

bool csg_runs_parse(struct csg_document *document, const char *file, int num_threads)
{
    struct runs runs = {.file = file};
    if (document->size < MIN_SIZE || cut(&runs, document->text, document->size) < 2)
        return false;
    csg_parallel(num_threads, NUM_RUNS, parse_run, &runs);
    bool ok = count_nodes(&runs) < UINT32_MAX - 1;
    for (size_t i = 0; i < NUM_RUNS; i++)
        ok &= runs.runs[i].ok && runs.runs[i].is_whole;
    ok = ok && join(document, &runs);
    for (size_t i = 0; i < NUM_RUNS; i++)
        csg_run_finish(&runs.runs[i]);
    return ok;
}
