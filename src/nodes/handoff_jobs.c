/* SPDX-License-Identifier: MIT */
#include "nodes/handoff_jobs.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/hash.h"
#include "nodes/subtree.h"
#include "nodes/text.h"

/* Another number where keys or values mean something else than before. */
static const char key_version[] = "csgcast handoff 2\n";

bool csg_handoff_no_memory(const struct csg_handoff_run *run)
{
    return csg_log_memory(&run->report->log);
}

static int compare_nodes(const void *left, const void *right)
{
    const struct csg_handed_off *a = left, *b = right;
    return a->node < b->node ? -1 : a->node > b->node;
}

void csg_handoff_settle(struct csg_handoff *handoff)
{
    struct csg_handed_off *nodes = handoff->nodes.data;
    size_t num = 0;
    qsort(nodes, handoff->nodes.num, sizeof *nodes, compare_nodes);
    for (size_t i = 0; i < handoff->nodes.num; i++)
        if (num == 0 || nodes[i].node >= nodes[num - 1].end)
            nodes[num++] = nodes[i];
    handoff->nodes.num = num;
}

/* The content of the files that the subtree reads is part of the key; one that is not there is so
 * as well. */
static bool add_files(struct csg_bytes *key, const struct csg_handoff *handoff,
                      const struct csg_bytes *files)
{
    const char *directory = handoff->params->directory ? handoff->params->directory : ".";
    bool ok = true;
    for (size_t i = 0; i < files->num && ok; i += strlen(files->data + i) + 1) {
        const char *name = files->data + i;
        char path[PATH_MAX], line[64];
        struct csg_bytes bytes = {0};
        const int length = snprintf(path, sizeof path, "%s%s%s", name[0] == '/' ? "" : directory,
                                    name[0] == '/' ? "" : "/", name);
        const bool is_read = length > 0 && length < PATH_MAX && csg_file_read_regular(path, &bytes);
        snprintf(line, sizeof line, " %d %zu %016llx\n", is_read, bytes.num,
                 (unsigned long long)csg_hash(CSG_HASH_START, bytes.data, bytes.num));
        free(bytes.data);
        ok = csg_bytes_append_text(key, name) && csg_bytes_append_text(key, line);
    }
    return ok;
}

/* The fonts of this machine are part of the key of what has text in it. */
static bool add_fonts(struct csg_handoff_run *run, struct csg_bytes *key)
{
    char line[32];
    if (!run->fonts_known)
        run->fonts = csg_text_fonts(run->handoff->params);
    run->fonts_known = true;
    snprintf(line, sizeof line, "fonts %016llx\n", (unsigned long long)run->fonts);
    return csg_bytes_append_text(key, line);
}

static bool make_key(struct csg_handoff_run *run, const struct csg_subtree *subtree,
                     struct csg_bytes *key)
{
    return csg_bytes_append_text(key, key_version) &&
           csg_bytes_append(key, run->version.data, run->version.num) &&
           csg_bytes_append(key, subtree->text.data, subtree->text.num) &&
           add_files(key, run->handoff, &subtree->files) &&
           (!subtree->has_text || add_fonts(run, key));
}

/* A drawing is extruded: its floor is the drawing. */
static bool write_text(const struct csg_handoff *handoff, const struct csg_handed_off *node,
                       struct csg_subtree *subtree)
{
    return (node->dimension == 3 ||
            csg_bytes_append_text(&subtree->text, "linear_extrude(height = 1) ")) &&
           csg_subtree_write(subtree, handoff->document, node->node);
}

/* The result with that text; the number of results: there is none. */
static size_t find_text(const struct csg_handoff *handoff, const struct csg_bytes *text)
{
    size_t i = 0;
    while (i < handoff->results.num &&
           (handoff->results.data[i].text.num != text->num ||
            memcmp(handoff->results.data[i].text.data, text->data, text->num) != 0))
        i++;
    return i;
}

/* Adds a job, unless the same text has been asked for already. */
static bool add_job(struct csg_handoff_run *run, struct csg_handed_off *node)
{
    struct csg_handoff *handoff = run->handoff;
    struct csg_subtree subtree = {0};
    struct csg_handoff_job job = {.node = node->node, .result = handoff->results.num};
    bool ok = write_text(handoff, node, &subtree);
    if (ok)
        node->result = find_text(handoff, &subtree.text);
    if (ok && node->result == handoff->results.num) {
        struct csg_handoff_result result = {.text = subtree.text};
        ok = make_key(run, &subtree, &job.key) && csg_array_push(&run->jobs, job);
        if (!ok)
            free(job.key.data);
        if (ok && (ok = csg_array_push(&handoff->results, result)))
            subtree.text = (struct csg_bytes){0};
    }
    node->is_evaluated = ok;
    csg_subtree_finish(&subtree);
    return ok || csg_handoff_no_memory(run);
}

bool csg_handoff_add_jobs(struct csg_handoff_run *run)
{
    bool ok = true;
    for (size_t i = 0; i < run->handoff->nodes.num && ok; i++)
        if (!run->handoff->nodes.data[i].is_evaluated)
            ok = add_job(run, &run->handoff->nodes.data[i]);
    run->handoff->num_evaluated = run->handoff->nodes.num;
    return ok;
}
