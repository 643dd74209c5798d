/* SPDX-License-Identifier: MIT */
#include "peer.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/clock.h"

#define DEGREE (3.14159265358979323846 / 180)
#define FOV 22.5

const unsigned char peer_background[3] = {255, 255, 229};

static bool parse_option(struct peer *peer, const char *text)
{
    double *e = peer->eye, *c = peer->center;
    return sscanf(text, "--camera=%lf,%lf,%lf,%lf,%lf,%lf", &e[0], &e[1], &e[2], &c[0], &c[1],
                  &c[2]) == 6 ||
           sscanf(text, "--imgsize=%d,%d", &peer->width, &peer->height) == 2 ||
           sscanf(text, "--frames=%d", &peer->num_frames) == 1;
}

bool peer_parse(struct peer *peer, int argc, char **argv)
{
    *peer = (struct peer){.width = 512, .height = 512, .num_frames = 5, .begun = csg_clock_ms()};
    bool good = argc > 2;
    for (int i = 3; i < argc && good; i++) {
        if (!strcmp(argv[i], "-o") && i + 1 < argc)
            peer->output = argv[++i];
        else
            good = parse_option(peer, argv[i]);
    }
    if (!good || peer->width < 1 || peer->height < 1 || peer->num_frames < 1) {
        fprintf(stderr, "usage: %s MODE INPUT --camera=E,C --imgsize=W,H --frames=N -o PPM\n",
                argv[0]);
        return false;
    }
    peer->mode = argv[1];
    peer->input = argv[2];
    return true;
}

struct peer_camera peer_camera(const struct peer *peer, int frame)
{
    const double angle = 360.0 * DEGREE * frame / peer->num_frames;
    const double x = peer->eye[0] - peer->center[0], y = peer->eye[1] - peer->center[1];
    const double eye[3] = {cos(angle) * x - sin(angle) * y, sin(angle) * x + cos(angle) * y,
                           peer->eye[2] - peer->center[2]};
    const double distance = sqrt(eye[0] * eye[0] + eye[1] * eye[1] + eye[2] * eye[2]);
    const double across = hypot(eye[0], eye[1]), half = tan(0.5 * FOV * DEGREE);
    const double right[3] = {-eye[1] / across, eye[0] / across, 0};
    struct peer_camera camera;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        camera.eye[i] = (float)(peer->center[i] + eye[i]);
        camera.forward[i] = (float)(-eye[i] / distance);
        camera.right[i] = (float)(half * peer->width / peer->height * right[i]);
        camera.up[i] = (float)(half * (-right[j] * eye[k] + right[k] * eye[j]) / distance);
    }
    return camera;
}

bool peer_read_solids(const struct peer *peer, struct peer_solids *solids)
{
    size_t capacity = 0;
    char kind[16];
    struct peer_solid s;
    *solids = (struct peer_solids){0};
    FILE *file = fopen(peer->input, "r");
    if (!file)
        return perror(peer->input), false;
    while (fscanf(file, "%15s %f %f %f %f", kind, &s.a[0], &s.a[1], &s.a[2], &s.r) == 5) {
        if (solids->num == capacity) {
            capacity = 2 * capacity + 1024;
            struct peer_solid *data = realloc(solids->data, capacity * sizeof *data);
            if (!data)
                return fclose(file), perror(peer->input), false;
            solids->data = data;
        }
        if (kind[0] == 'c') {
            s.b[0] = s.r;
            if (fscanf(file, "%f %f %f", &s.b[1], &s.b[2], &s.r) != 3)
                break;
        } else {
            solids->num_spheres++;
        }
        solids->data[solids->num++] = s;
    }
    fclose(file);
    return solids->num > 0;
}

void peer_shade(const struct peer_camera *camera, const float normal[3], unsigned char rgba[4])
{
    static const float color[3] = {249, 215, 44};
    float n[3] = {0}, lengths[2] = {0};
    for (int i = 0; i < 3; i++) {
        lengths[0] += camera->right[i] * camera->right[i];
        lengths[1] += camera->up[i] * camera->up[i];
        n[0] += camera->right[i] * normal[i];
        n[1] += camera->up[i] * normal[i];
        n[2] -= camera->forward[i] * normal[i];
    }
    const float light =
        0.2F + 0.57735027F * fabsf(-n[0] / sqrtf(lengths[0]) + n[1] / sqrtf(lengths[1]) + n[2]);
    for (int i = 0; i < 3; i++)
        rgba[i] = (unsigned char)fminf(255, color[i] * light + 0.5F);
    rgba[3] = 255;
}

static bool write_picture(const struct peer *peer, const unsigned char *rgba, bool flipped)
{
    FILE *file = fopen(peer->output, "wb");
    if (!file)
        return perror(peer->output), false;
    fprintf(file, "P6\n%d %d\n255\n", peer->width, peer->height);
    for (int y = 0; y < peer->height; y++)
        for (int x = 0; x < peer->width; x++) {
            const int row = flipped ? peer->height - 1 - y : y;
            fwrite(rgba + 4 * ((size_t)row * (size_t)peer->width + (size_t)x), 1, 3, file);
        }
    return fclose(file) == 0;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *values, int num)
{
    qsort(values, (size_t)num, sizeof *values, compare);
    return 0.5 * (values[num / 2] + values[(num - 1) / 2]);
}

static bool draw_frames(const struct peer *peer, peer_draw_fn *draw, void *user,
                        unsigned char *rgba, double *times, bool flipped)
{
    const int num = peer->num_frames;
    double *work = times + num;
    struct peer_camera camera = peer_camera(peer, 0);
    bool good = draw(user, &camera, rgba);
    const double first = csg_clock_ms() - peer->begun;
    if (good && peer->output)
        good = write_picture(peer, rgba, flipped);
    for (int frame = 0; frame < num && good; frame++) {
        camera = peer_camera(peer, frame + 1);
        const double begun = csg_clock_ms(), worked = csg_clock_work_ms();
        good = draw(user, &camera, rgba);
        times[frame] = csg_clock_ms() - begun;
        work[frame] = csg_clock_work_ms() - worked;
    }
    if (good)
        printf("%.3f %.3f %.1f\n", median(times, num), median(work, num), first);
    return good;
}

bool peer_run(const struct peer *peer, peer_draw_fn *draw, void *user, bool flipped)
{
    unsigned char *rgba = malloc(4 * (size_t)peer->width * (size_t)peer->height);
    double *times = calloc(2 * (size_t)peer->num_frames, sizeof *times);
    const bool good = rgba && times && draw_frames(peer, draw, user, rgba, times, flipped);
    free(rgba);
    free(times);
    return good;
}
