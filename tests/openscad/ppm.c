/* SPDX-License-Identifier: MIT */
#include "ppm.h"

#include <stdio.h>
#include <stdlib.h>

static const int max_size = 16384;

/* The next number of the head, behind blanks and comments. */
static bool read_number(FILE *file, int *number)
{
    int c;
    while ((c = fgetc(file)) == '#' || c == ' ' || c == '\n')
        while (c == '#' && (c = fgetc(file)) != '\n' && c != EOF)
            c = '#';
    return ungetc(c, file) != EOF && fscanf(file, "%d", number) == 1;
}

static bool read_head(FILE *file, struct ppm *picture)
{
    int max = 0;
    return fgetc(file) == 'P' && fgetc(file) == '6' && read_number(file, &picture->width) &&
           read_number(file, &picture->height) && read_number(file, &max) && max == 255 &&
           fgetc(file) != EOF && picture->width > 0 && picture->height > 0 &&
           picture->width <= max_size && picture->height <= max_size;
}

static bool read_pixels(FILE *file, struct ppm *picture)
{
    const size_t size = 3 * (size_t)picture->width * (size_t)picture->height;
    picture->rgb = malloc(size);
    return picture->rgb && fread(picture->rgb, 1, size, file) == size;
}

bool ppm_read(const char *path, struct ppm *picture)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        return perror(path), false;
    const bool ok = read_head(file, picture) && read_pixels(file, picture);
    fclose(file);
    if (!ok)
        fprintf(stderr, "%s is not a PPM picture of 8 bits a channel\n", path);
    return ok;
}
