/* SPDX-License-Identifier: MIT */

/* csgcast cache: where it is, how large it is; clears it. */

#include "commands.h"
#include "json.h"
#include "messages.h"
#include "options.h"

#include <stdio.h>

static void print_text(const struct csgcast_cache_info *info)
{
    printf("path               %s\n", info->path[0] ? info->path : "none");
    printf("entries            %zu\n", info->num_entries);
    printf("bytes              %llu of %llu\n", (unsigned long long)info->size,
           (unsigned long long)info->limit);
}

static void print_json(const struct csgcast_cache_info *info)
{
    struct csg_json json = {.file = stdout};
    csg_json_open(&json, NULL);
    csg_json_string(&json, "path", info->path);
    csg_json_size(&json, "entries", info->num_entries);
    csg_json_size(&json, "bytes", (size_t)info->size);
    csg_json_size(&json, "limit", (size_t)info->limit);
    csg_json_close(&json);
}

static enum csg_cli_exit run(const struct csg_cli_options *options)
{
    struct csgcast_cache_info info;
    if (options->clear && !csgcast_cache_clear(options->scene.cache)) {
        csgcast_cache_get_info(options->scene.cache, &info);
        csg_cli_error("cannot remove all that is in %s", info.path);
        return CSG_EXIT_OUTPUT;
    }
    csgcast_cache_get_info(options->scene.cache, &info);
    if (options->json)
        print_json(&info);
    else if (!options->clear)
        print_text(&info);
    return csg_cli_end_output(CSG_EXIT_OK, CSG_EXIT_OUTPUT);
}

const struct csg_cli_command csg_command_cache = {
    .name = "cache",
    .bit = CSG_COMMAND_CACHE,
    .no_scene = true,
    .summary = "tell what the cache holds, or clear it",
    .usage = "[--clear] [OPTION...]",
    .text = "What only openscad can evaluate is evaluated once and then kept on disk by content:\n"
            "the text of the subtree, the files it imports and openscad's version. What was not\n"
            "used for the longest time goes when there is too much of it.\n",
    .tail = "  csgcast cache\n"
            "  csgcast cache --clear\n",
    .run = run,
};
