/* SPDX-License-Identifier: MIT */
#ifndef PPM_H
#define PPM_H

#include <stdbool.h>

/* A picture of 8 bits a channel, row 0 on top. */
struct ppm {
    int width, height;
    unsigned char *rgb; /* width * height * 3 */
};

/* Reads a binary PPM (P6). false, with a message on standard error, where it is none. */
bool ppm_read(const char *path, struct ppm *picture);

#endif
