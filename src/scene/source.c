/* SPDX-License-Identifier: MIT */
#include "scene/source.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static bool copy_string(const char *string, char **copy, const char **used)
{
    const size_t size = string ? strlen(string) + 1 : 0;
    *copy = string ? malloc(size) : NULL;
    *used = *copy;
    if (*copy)
        memcpy(*copy, string, size);
    return *copy || !string;
}

static bool copy_fonts(struct csg_source *source, const struct csgcast_scene_params *params)
{
    const char *used;
    bool copied = true;
    source->fonts = calloc(params->num_fonts + 1, sizeof *source->fonts);
    source->params.num_fonts = source->fonts ? params->num_fonts : 0;
    source->params.fonts = (const char *const *)source->fonts;
    for (size_t i = 0; i < source->params.num_fonts; i++)
        copied &= copy_string(params->fonts[i], &source->fonts[i], &used);
    return copied && source->fonts;
}

struct csg_source *csg_source_create(char *text, size_t size,
                                     const struct csgcast_scene_params *params)
{
    struct csg_source *source = calloc(1, sizeof *source);
    if (!source) {
        free(text);
        return NULL;
    }
    source->text = text;
    source->size = size;
    source->params = *params;
    source->params.defines = NULL;
    source->params.num_defines = 0;
    source->params.parameter_file = source->params.parameter_set = NULL;
    const bool named = copy_string(params->name, &source->name, &source->params.name);
    const bool placed =
        copy_string(params->directory, &source->directory, &source->params.directory);
    const bool run = copy_string(params->openscad, &source->openscad, &source->params.openscad);
    const bool cached = copy_string(params->cache, &source->cache, &source->params.cache);
    const bool lettered = copy_fonts(source, params);
    if (named && placed && run && cached && lettered)
        return source;
    csg_source_destroy(source);
    return NULL;
}

void csg_source_destroy(struct csg_source *source)
{
    if (!source)
        return;
    for (size_t i = 0; i < source->params.num_fonts; i++)
        free(source->fonts[i]);
    free(source->fonts);
    free(source->text);
    free(source->name);
    free(source->directory);
    free(source->openscad);
    free(source->cache);
    free(source);
}
