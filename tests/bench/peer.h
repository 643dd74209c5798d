/* SPDX-License-Identifier: MIT */
#ifndef BENCH_PEER_H
#define BENCH_PEER_H

/*
 * What the peers that we drive ourselves share: the same command line, camera, light and timing as
 * `csgcast bench --orbit`, so that pictures and times can be compared.
 *
 *     PEER MODE INPUT --camera=ex,ey,ez,cx,cy,cz --imgsize=W,H --frames=N -o FIRST.ppm
 *
 * prints "frame work first" in milliseconds: medians of the frames after the first image, by the
 * clock and as processor time of all cores; and the first image, which goes to the file, with its
 * preparations. Frames include the picture in the caller's memory.
 */

#include <stdbool.h>
#include <stddef.h>

struct peer {
    const char *mode, *input, *output;
    double eye[3], center[3];
    int width, height, num_frames;
    double begun; /* ms */
};

/* Field of view 22.5 degrees, z up, as csgcast. right and up have the length of half the picture
 * at unit distance. */
struct peer_camera {
    float eye[3], right[3], up[3], forward[3];
};

/* A sphere, or a cylinder from a to b. */
struct peer_solid {
    float a[3], b[3], r;
};

struct peer_solids {
    struct peer_solid *data;
    size_t num, num_spheres; /* spheres first */
};

bool peer_parse(struct peer *peer, int argc, char **argv);

/* The camera of a frame: 0 for the first image, then turned about z in steps. */
struct peer_camera peer_camera(const struct peer *peer, int frame);

/* Reads scenes/bench/crowd.awk's lists. */
bool peer_read_solids(const struct peer *peer, struct peer_solids *solids);

/* draw fills 4 bytes a pixel, row 0 on top or, if flipped, at the bottom. */
typedef bool peer_draw_fn(void *user, const struct peer_camera *camera, unsigned char *rgba);
bool peer_run(const struct peer *peer, peer_draw_fn *draw, void *user, bool flipped);

/* OpenSCAD's colours: the background, and a face with its light. */
extern const unsigned char peer_background[3];
void peer_shade(const struct peer_camera *camera, const float normal[3], unsigned char rgba[4]);

#endif
