/* SPDX-License-Identifier: MIT */
#include "scene_options.h"

#include "common/file.h"
#include "messages.h"
#include "values.h"

#include <string.h>

const char *csg_set_define(struct csg_cli_options *options, const char *value)
{
    const char *equals = strchr(value, '=');
    if (!equals || equals == value)
        return "NAME=VALUE";
    options->defines[options->scene.num_defines++] = value;
    return NULL;
}

/* openscad --render flattens the model as for export; what a .scad sees of that is $preview. */
const char *csg_set_render(struct csg_cli_options *options, const char *value)
{
    (void)value;
    return csg_set_define(options, "$preview=false");
}

const char *csg_set_font(struct csg_cli_options *options, const char *value)
{
    options->fonts[options->scene.num_fonts++] = value;
    return *value ? NULL : "a font file";
}

const char *csg_set_parameter_file(struct csg_cli_options *options, const char *value)
{
    options->scene.parameter_file = value;
    return *value ? NULL : "a file";
}

const char *csg_set_parameter_set(struct csg_cli_options *options, const char *value)
{
    options->scene.parameter_set = value;
    return NULL;
}

const char *csg_set_animate(struct csg_cli_options *options, const char *value)
{
    return csg_value_frames(value, &options->num_animated);
}

const char *csg_set_facets(struct csg_cli_options *options, const char *value)
{
    static const struct csg_value_name names[] = {{"auto", CSGCAST_FACETS_AUTO},
                                                  {"exact", CSGCAST_FACETS_EXACT},
                                                  {"as-written", CSGCAST_FACETS_AS_WRITTEN},
                                                  {NULL, 0}};
    int facets;
    if (!csg_value_enum(value, names, &facets))
        return "auto, exact or as-written";
    options->scene.facets = (enum csgcast_facets)facets;
    options->facets = value;
    return NULL;
}

const char *csg_set_openscad(struct csg_cli_options *options, const char *value)
{
    options->scene.openscad = value;
    return *value ? NULL : "a program";
}

const char *csg_set_openscad_memory(struct csg_cli_options *options, const char *value)
{
    double mebibytes;
    if (!csg_value_double(value, &mebibytes) || !(mebibytes >= 1 && mebibytes < 1e9))
        return "mebibytes from 1";
    options->scene.openscad_memory = (uint64_t)(mebibytes * (1 << 20));
    return NULL;
}

const char *csg_set_openscad_time(struct csg_cli_options *options, const char *value)
{
    int seconds;
    if (!csg_value_int(value, &seconds) || seconds <= 0)
        return "whole seconds above 0";
    options->scene.openscad_seconds = (uint32_t)seconds;
    return NULL;
}

const char *csg_set_cache(struct csg_cli_options *options, const char *value)
{
    options->scene.cache = value;
    return *value ? NULL : "a directory; see --no-cache";
}

const char *csg_set_no_cache(struct csg_cli_options *options, const char *value)
{
    (void)value;
    options->scene.cache = "";
    return NULL;
}

const char *csg_set_cache_size(struct csg_cli_options *options, const char *value)
{
    double mebibytes;
    if (!csg_value_double(value, &mebibytes) || !(mebibytes > 0 && mebibytes < 1e9))
        return "mebibytes above 0";
    options->scene.cache_size = (uint64_t)(mebibytes * (1 << 20)) + 1;
    return NULL;
}

/* A .csg has no variables; whoever sets some expects another picture. */
static void warn_variables(const struct csg_cli_options *options)
{
    const struct csgcast_scene_params *scene = &options->scene;
    for (size_t i = 0; i < scene->num_defines; i++) {
        if (scene->defines[i][0] != '$')
            csg_cli_warning("-D %s has no effect: %s is not a .scad file", scene->defines[i],
                            options->input);
    }
    if (scene->parameter_file)
        csg_cli_warning("-p %s has no effect: %s is not a .scad file", scene->parameter_file,
                        options->input);
}

void csg_warn_unheeded(const struct csg_cli_options *options)
{
    const struct csgcast_scene_params *scene = &options->scene;
    bool has_scad = false;
    for (size_t i = 0; i < options->num_inputs; i++)
        has_scad |= csg_path_ends(options->inputs[i], ".scad");
    if (options->quiet || options->num_inputs == 0)
        return;
    if (!has_scad)
        warn_variables(options);
    if (scene->parameter_set && !scene->parameter_file)
        csg_cli_warning("-P %s has no effect: -p names the file that has the set",
                        scene->parameter_set);
    if (scene->parameter_file && !scene->parameter_set)
        csg_cli_warning("-p %s has no effect: -P names which set of it", scene->parameter_file);
}
