/* SPDX-License-Identifier: MIT */

/* csgcast export: the scene for another renderer, with the same camera. */

#include "commands.h"
#include "messages.h"
#include "options.h"
#include "output.h"

#include <string.h>
#include <strings.h>

/* Looked at before the scene is read. */
static bool check_format(const char *output, const char *format)
{
    const char *dot = strrchr(output, '.');
    const char *wanted = format ? format : dot ? dot + 1 : "";
    if (!format && !strcmp(output, "-"))
        return true;
    for (size_t i = 0; csgcast_export_format_name(i); i++)
        if (!strcasecmp(wanted, csgcast_export_format_name(i)))
            return true;
    csg_cli_error("cannot export to %s: the name must end with .pov, for POV-Ray; `csgcast render` "
                  "writes images",
                  output);
    return false;
}

static enum csg_cli_exit run_to(const struct csg_cli_options *options, const char *output,
                                void *user)
{
    (void)user;
    const char *format = options->write.format;
    if (!check_format(output, format))
        return CSG_EXIT_OUTPUT;
    struct csgcast_scene *scene = csgcast_scene_load(options->input, &options->scene);
    if (!scene)
        return CSG_EXIT_FAILED;
    const bool written = csgcast_export(output, scene, &options->view, format);
    csgcast_scene_destroy(scene);
    return written ? CSG_EXIT_OK : CSG_EXIT_OUTPUT;
}

static enum csg_cli_exit run(const struct csg_cli_options *options)
{
    return csg_cli_with_output(options, "pov", run_to, NULL);
}

const struct csg_cli_command csg_command_export = {
    .name = "export",
    .bit = CSG_COMMAND_EXPORT,
    .summary = "write a scene for POV-Ray",
    .usage = "FILE [-o SCENE.pov] [OPTION...]",
    .text = "Writes the scene for POV-Ray 3.7: the same exact solids under the same Booleans,\n"
            "with the same camera, colours and light; only what has many flat faces becomes a\n"
            "mesh of them. What POV-Ray draws then is the picture of `csgcast render` with the\n"
            "same options, to start from with materials and shadows, or to compare. FILE - is\n"
            ".csg text on standard input.\n",
    .tail = "  csgcast export part.scad -o part.pov --imgsize=800,600\n"
            "  povray +W800 +H600 -D +Ipart.pov +Opart.png\n",
    .run = run,
};
