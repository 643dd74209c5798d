/* SPDX-License-Identifier: MIT */

/* The texts that openscad has made of a .scad file, and the cameras that belong to them. */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "scene/openscad.h"

/* The name of a frame's text, as openscad --animate makes it; NULL: out of memory. */
static char *path_of(const struct csg_flattened *flattened, size_t frame)
{
    const size_t size = strlen(flattened->folder) + sizeof "/scene.csg" + 24;
    char *path = malloc(size);
    if (path && flattened->num_frames > 0)
        snprintf(path, size, "%s/scene%05zu.csg", flattened->folder, frame);
    else if (path)
        snprintf(path, size, "%s/scene.csg", flattened->folder);
    return path;
}

bool csg_flattened_read(const struct csg_flattened *flattened, size_t frame,
                        const struct csg_log *log, struct csg_bytes *text)
{
    char *path = path_of(flattened, frame);
    const bool read = path ? csg_file_read(path, text, log) : csg_log_memory(log);
    free(path);
    return read;
}

struct csgcast_camera csg_flattened_camera(const struct csg_flattened *flattened, size_t frame)
{
    return frame < flattened->cameras.num ? flattened->cameras.data[frame]
                                          : (struct csgcast_camera){0};
}

void csg_flattened_finish(struct csg_flattened *flattened)
{
    const size_t num = flattened->num_frames > 0 ? flattened->num_frames : 1;
    for (size_t i = 0; i < num && flattened->folder; i++) {
        char *path = path_of(flattened, i);
        if (path)
            unlink(path);
        free(path);
    }
    if (flattened->folder)
        rmdir(flattened->folder);
    free(flattened->folder);
    free(flattened->cameras.data);
}
