/* SPDX-License-Identifier: MIT */

/* The texts that openscad has made of a .scad file, and the cameras that belong to them. */

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "document/digits.h"
#include "openscad/openscad.h"

/* The name of a frame's text, as openscad --animate makes it; NULL: out of memory. */
static char *path_of(const struct csg_flattened *flattened, size_t frame)
{
    char name[48] = CSG_DIGITS_STILL;
    if (flattened->num_frames > 0)
        snprintf(name, sizeof name, "scene%05zu.csg", frame);
    return csg_folder_file(&flattened->folder, name);
}

static bool add_font(struct csg_flattened *flattened, const char *name, size_t length)
{
    char *font = malloc(length + 1);
    if (!font)
        return false;
    memcpy(font, name, length);
    font[length] = '\0';
    if (csg_array_push(&flattened->fonts, font))
        return true;
    free(font);
    return false;
}

/* A font a line. */
static bool add_listed(struct csg_flattened *flattened, const struct csg_bytes *list)
{
    const char *line = list->data, *const end = line + list->num;
    bool ok = true;
    while (line < end && ok) {
        const char *newline = memchr(line, '\n', (size_t)(end - line));
        const size_t length = (size_t)((newline ? newline : end) - line);
        ok = add_font(flattened, line, length);
        line += length + 1;
    }
    return ok;
}

bool csg_flattened_find_fonts(struct csg_flattened *flattened,
                              const struct csgcast_scene_params *params, const struct csg_log *log)
{
    struct csg_bytes list = {0};
    char *path = csg_folder_file(&flattened->folder, CSG_DIGITS_FONTS);
    bool ok = path != NULL;
    for (size_t i = 0; i < params->num_fonts && ok; i++)
        ok = add_font(flattened, params->fonts[i], strlen(params->fonts[i]));
    if (ok && csg_file_read(path, &list, &csg_log_silent)) /* no font, no list */
        ok = add_listed(flattened, &list);
    free(list.data);
    free(path);
    return ok || csg_log_memory(log);
}

/* openscad does not tell when the disk is full. */
static bool check_whole(const struct csg_flattened *flattened, const struct csg_log *log,
                        struct csg_bytes *text)
{
    if (csg_digits_are_all(text->data, text->num) || csg_folder_has_room(&flattened->folder))
        return true;
    csg_log_error(log, CSGCAST_MESSAGE_FILE,
                  "openscad's text may be cut: %s: %s; the environment variable TMPDIR names "
                  "another place for temporary files",
                  flattened->folder.path, strerror(errno));
    free(text->data);
    *text = (struct csg_bytes){0};
    return false;
}

bool csg_flattened_read(const struct csg_flattened *flattened, size_t frame,
                        const struct csg_log *log, struct csg_bytes *text)
{
    char *path = path_of(flattened, frame);
    const bool is_there = path && access(path, F_OK) == 0;
    if (path && !is_there)
        csg_log_error(
            log, CSGCAST_MESSAGE_OPENSCAD,
            "openscad has ended without an error and has written nothing; is it OpenSCAD?");
    const bool read = path ? is_there && csg_file_read(path, text, log) : csg_log_memory(log);
    free(path);
    return read && check_whole(flattened, log, text);
}

struct csgcast_camera csg_flattened_camera(const struct csg_flattened *flattened, size_t frame)
{
    return frame < flattened->cameras.num ? flattened->cameras.data[frame]
                                          : (struct csgcast_camera){0};
}

void csg_flattened_finish(struct csg_flattened *flattened)
{
    csg_folder_remove(&flattened->folder);
    for (size_t i = 0; i < flattened->fonts.num; i++)
        free(flattened->fonts.data[i]);
    free(flattened->fonts.data);
    free(flattened->cameras.data);
}
