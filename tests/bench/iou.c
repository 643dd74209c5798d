/* SPDX-License-Identifier: MIT */

/*
 *     iou A.ppm B.ppm
 *
 * Prints intersection over union of the silhouettes of two pictures of the same size. Background is
 * what has the colour of the upper left pixel, to 2 of 255.
 */

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "../openscad/ppm.h"

static bool is_covered(const struct ppm *picture, size_t pixel)
{
    for (size_t c = 0; c < 3; c++)
        if (abs(picture->rgb[3 * pixel + c] - picture->rgb[c]) > 2)
            return true;
    return false;
}

int main(int argc, char **argv)
{
    struct ppm a, b;
    size_t both = 0, either = 0;
    if (argc != 3 || !ppm_read(argv[1], &a) || !ppm_read(argv[2], &b))
        return 2;
    if (a.width != b.width || a.height != b.height)
        return fprintf(stderr, "iou: %s and %s differ in size\n", argv[1], argv[2]), 2;
    for (size_t i = 0; i < (size_t)a.width * (size_t)a.height; i++) {
        const bool in_a = is_covered(&a, i), in_b = is_covered(&b, i);
        both += in_a && in_b;
        either += in_a || in_b;
    }
    printf("%.5f\n", either ? (double)both / (double)either : 1.0);
    free(a.rgb);
    free(b.rgb);
    return 0;
}
