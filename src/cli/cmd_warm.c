/* SPDX-License-Identifier: MIT */

/* csgcast warm: fills the driver's cache with what pictures are drawn by. */

#include "commands.h"
#include "options.h"

static bool warm(const struct csg_cli_options *options)
{
    struct csgcast_renderer *renderer = csgcast_renderer_create(&options->renderer);
    const bool ok = renderer && csgcast_renderer_warm(renderer);
    csgcast_renderer_destroy(renderer);
    return ok;
}

/* Twice: some programs are not quite the same where Mesa has read them from its cache, and llvmpipe
 * compiles them once more. */
static enum csg_cli_exit run(const struct csg_cli_options *options)
{
    return warm(options) && warm(options) ? CSG_EXIT_OK : CSG_EXIT_FAILED;
}

const struct csg_cli_command csg_command_warm = {
    .name = "warm",
    .bit = CSG_COMMAND_WARM,
    .no_scene = true,
    .summary = "have the driver compile what pictures are drawn by",
    .usage = "[OPTION...]",
    .text =
        "Most scenes are drawn by the same programs. Mesa keeps on disk what it has compiled, for\n"
        "each user: after this, once for each version of csgcast and of Mesa, the first picture\n"
        "of a scene takes no longer than the next. It takes some twelve seconds.\n",
    .tail = "  csgcast warm\n",
    .run = run,
};
