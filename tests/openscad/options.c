/* SPDX-License-Identifier: MIT */
#include "options.h"

#include "camera.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const facets_names[] = {"auto", "exact", "as-written", NULL};
static const char *const backend_names[] = {"auto", "egl", "osmesa", "reference", NULL};

/* The index of text in names; -1 when it is none of them. */
static int find_name(const char *const *names, const char *text)
{
    for (int i = 0; names[i]; i++)
        if (strcmp(names[i], text) == 0)
            return i;
    return -1;
}

static bool parse_number(const char *text, double *number)
{
    char *end;
    *number = strtod(text, &end);
    return end != text && *end == '\0' && *number >= 0;
}

static bool parse_count(const char *text, unsigned *count)
{
    char rest;
    return sscanf(text, "%u%c", count, &rest) == 1;
}

static bool parse_size(const char *text, struct csgcast_view *view)
{
    char rest;
    return sscanf(text, "%d,%d%c", &view->width, &view->height, &rest) == 2 && view->width > 0 &&
           view->height > 0 && view->width <= 16384 && view->height <= 16384;
}

static bool parse_name(const char *const *names, const char *text, int *index)
{
    *index = find_name(names, text);
    return *index >= 0;
}

static bool parse_threshold(const char *name, const char *value, struct options *options)
{
    if (strcmp(name, "sagitta") == 0)
        return parse_number(value, &options->sagitta);
    if (strcmp(name, "depth") == 0)
        return parse_number(value, &options->depth);
    if (strcmp(name, "depth-of-radius") == 0)
        return parse_number(value, &options->depth_of_radius);
    if (strcmp(name, "normal") == 0)
        return parse_number(value, &options->normal);
    if (strcmp(name, "edge") == 0)
        return parse_number(value, &options->edge);
    if (strcmp(name, "thin") == 0)
        return parse_number(value, &options->thin);
    char rest;
    return strcmp(name, "off") == 0 && sscanf(value, "%lu%c", &options->off, &rest) == 1;
}

static bool parse_value(const char *name, const char *value, struct options *options)
{
    int index = 0;
    bool ok = true;
    if (strcmp(name, "name") == 0) {
        options->name = value;
    } else if (strcmp(name, "variant") == 0) {
        options->view.variant = value;
    } else if (strcmp(name, "facets") == 0) {
        ok = parse_name(facets_names, value, &index);
        options->facets = (enum csgcast_facets)index;
    } else if (strcmp(name, "backend") == 0) {
        ok = parse_name(backend_names, value, &index);
        options->backend = (enum csgcast_backend)index;
    } else if (strcmp(name, "imgsize") == 0) {
        ok = parse_size(value, &options->view);
    } else if (strcmp(name, "camera") == 0) {
        ok = options->has_camera = camera_parse(value, &options->view.camera);
    } else if (strcmp(name, "projection") == 0) {
        ok = value[0] == 'o' || value[0] == 'p';
        options->view.camera.projection =
            value[0] == 'o' ? CSGCAST_ORTHOGRAPHIC : CSGCAST_PERSPECTIVE;
    } else if (strcmp(name, "views") == 0) {
        ok = parse_count(value, &options->views);
    } else if (strcmp(name, "seed") == 0) {
        ok = parse_count(value, &options->seed);
    } else {
        ok = parse_threshold(name, value, options);
    }
    return ok;
}

static bool parse_option(const char *text, struct options *options)
{
    char name[32];
    const char *equals = strchr(text, '=');
    const size_t length = equals ? (size_t)(equals - text) : strlen(text);
    if (strcmp(text, "converge") == 0)
        return options->converge = true;
    if (strcmp(text, "render") == 0)
        return options->render = true;
    if (!equals || length >= sizeof name)
        return false;
    memcpy(name, text, length);
    name[length] = '\0';
    return parse_value(name, equals + 1, options);
}

bool options_parse(int argc, char **argv, struct options *options)
{
    int next = 1;
    *options = (struct options){
        .facets = CSGCAST_FACETS_AS_WRITTEN,
        .view = {.width = 256, .height = 192},
        .views = 4,
        .depth = 1e-5,
        .normal = 0.1,
        .edge = 0.02,
        .thin = 0.002,
    };
    for (; next < argc && strncmp(argv[next], "--", 2) == 0; next++) {
        if (!parse_option(argv[next] + 2, options)) {
            fprintf(stderr, "referee: bad option %s\n", argv[next]);
            return false;
        }
    }
    const int num_meshes = argc - next - 1;
    if (num_meshes < 1 || (options->converge ? num_meshes < 2 : num_meshes > 1)) {
        fprintf(stderr, "usage: referee [option...] SCENE MESH.stl, see referee.c\n");
        return false;
    }
    options->scene = argv[next];
    options->meshes = &argv[next + 1];
    options->num_meshes = num_meshes;
    if (!options->name)
        options->name = options->scene;
    return true;
}
