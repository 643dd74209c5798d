/* SPDX-License-Identifier: MIT */

/*
 *     pngcmp [--background=R,G,B] [--blocks=N] OURS.ppm THEIRS.ppm
 *
 * Compares two pictures as OpenSCAD's own tests/image_compare.py does: they differ where all nine
 * pixels of a 3x3 block differ by 8 or more with the same sign in one channel. Compares silhouettes
 * as well, i.e. what is background: they may differ only beside an edge of the silhouette. PPM,
 * which `oiiotool in.png -o out.ppm` makes, keeps this program free of libraries.
 * Exits with 0 when alike (at most N differing blocks, default 0), 1 when not, 2 on bad input.
 */

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ppm.h"

static const int pixel_tolerance = 8;

struct comparison {
    size_t num_pixels;     /* with any channel off by pixel_tolerance */
    size_t num_blocks;     /* 3x3 blocks that differ with the same sign */
    size_t num_silhouette; /* pixels off the silhouette's edge that are background in one only */
    size_t num_foreground; /* pixels of theirs that are not background */
};

static const unsigned char *pixel(const struct ppm *picture, int x, int y)
{
    return picture->rgb + 3 * ((size_t)y * (size_t)picture->width + (size_t)x);
}

/* -1, 0 or 1: how channel c at (x, y) differs. */
static int sign(const struct ppm *a, const struct ppm *b, int x, int y, int c)
{
    const int difference = pixel(a, x, y)[c] - pixel(b, x, y)[c];
    return (difference >= pixel_tolerance) - (difference <= -pixel_tolerance);
}

static bool block_differs(const struct ppm *a, const struct ppm *b, int x, int y)
{
    for (int c = 0; c < 3; c++) {
        int sum = 0;
        for (int i = 0; i < 9; i++)
            sum += sign(a, b, x + i % 3 - 1, y + i / 3 - 1, c);
        if (abs(sum) == 9)
            return true;
    }
    return false;
}

static bool is_background(const struct ppm *picture, const unsigned char background[3], int x,
                          int y)
{
    return memcmp(pixel(picture, x, y), background, 3) == 0;
}

/* Whether the 3x3 pixels around (x, y) are all background or all not. */
static bool is_uniform(const struct ppm *picture, const unsigned char background[3], int x, int y)
{
    int num = 0;
    for (int i = 0; i < 9; i++)
        num += is_background(picture, background, x + i % 3 - 1, y + i / 3 - 1);
    return num == 0 || num == 9;
}

static struct comparison compare(const struct ppm *ours, const struct ppm *theirs,
                                 const unsigned char background[3])
{
    struct comparison result = {0};
    for (int y = 1; y < ours->height - 1; y++) {
        for (int x = 1; x < ours->width - 1; x++) {
            const bool empty = is_background(theirs, background, x, y);
            result.num_foreground += !empty;
            result.num_pixels += sign(ours, theirs, x, y, 0) || sign(ours, theirs, x, y, 1) ||
                                 sign(ours, theirs, x, y, 2);
            result.num_blocks += block_differs(ours, theirs, x, y);
            result.num_silhouette += empty != is_background(ours, background, x, y) &&
                                     is_uniform(theirs, background, x, y);
        }
    }
    return result;
}

static bool parse_background(const char *text, unsigned char background[3])
{
    unsigned r, g, b;
    if (sscanf(text, "%u,%u,%u", &r, &g, &b) != 3 || r > 255 || g > 255 || b > 255)
        return false;
    background[0] = (unsigned char)r;
    background[1] = (unsigned char)g;
    background[2] = (unsigned char)b;
    return true;
}

int main(int argc, char **argv)
{
    unsigned char background[3] = {0xff, 0xff, 0xe5}; /* Cornfield */
    struct ppm ours = {0}, theirs = {0};
    unsigned long max_blocks = 0;
    int next = 1;

    for (; next < argc && strncmp(argv[next], "--", 2) == 0; next++) {
        if (strncmp(argv[next], "--background=", 13) == 0 &&
            parse_background(argv[next] + 13, background))
            continue;
        if (sscanf(argv[next], "--blocks=%lu", &max_blocks) == 1)
            continue;
        fprintf(stderr, "pngcmp: bad option %s\n", argv[next]);
        return 2;
    }
    if (argc - next != 2 || !ppm_read(argv[next], &ours) || !ppm_read(argv[next + 1], &theirs))
        return 2;
    if (ours.width != theirs.width || ours.height != theirs.height) {
        fprintf(stderr, "pngcmp: %dx%d against %dx%d pixels\n", ours.width, ours.height,
                theirs.width, theirs.height);
        return 1;
    }
    const struct comparison result = compare(&ours, &theirs, background);
    printf("covered %zu pixels %zu blocks %zu silhouette %zu\n", result.num_foreground,
           result.num_pixels, result.num_blocks, result.num_silhouette);
    free(ours.rgb);
    free(theirs.rgb);
    return result.num_blocks > max_blocks || result.num_silhouette > 0;
}
