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

struct picture {
    int width, height;
    unsigned char *rgb;
};

static bool read_number(FILE *file, int *number)
{
    int c;
    while ((c = fgetc(file)) == '#' || c == ' ' || c == '\n')
        while (c == '#' && (c = fgetc(file)) != '\n' && c != EOF)
            c = '#';
    return ungetc(c, file) != EOF && fscanf(file, "%d", number) == 1;
}

static bool read_picture(const char *path, struct picture *picture)
{
    int max = 0;
    FILE *file = fopen(path, "rb");
    if (!file)
        return perror(path), false;
    bool ok = fgetc(file) == 'P' && fgetc(file) == '6' && read_number(file, &picture->width) &&
              read_number(file, &picture->height) && read_number(file, &max) && max == 255 &&
              fgetc(file) != EOF && picture->width > 0 && picture->height > 0;
    if (ok) {
        const size_t size = 3 * (size_t)picture->width * (size_t)picture->height;
        picture->rgb = malloc(size);
        ok = picture->rgb && fread(picture->rgb, 1, size, file) == size;
    }
    fclose(file);
    if (!ok)
        fprintf(stderr, "iou: %s is not a PPM picture of 8 bits a channel\n", path);
    return ok;
}

static bool is_covered(const struct picture *picture, size_t pixel)
{
    for (size_t c = 0; c < 3; c++)
        if (abs(picture->rgb[3 * pixel + c] - picture->rgb[c]) > 2)
            return true;
    return false;
}

int main(int argc, char **argv)
{
    struct picture a, b;
    size_t both = 0, either = 0;
    if (argc != 3 || !read_picture(argv[1], &a) || !read_picture(argv[2], &b))
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
