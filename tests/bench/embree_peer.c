/* SPDX-License-Identifier: MIT */

/* Embree 3: its own sphere and cone geometry, one primary ray a pixel in packets of 8, all cores.
 */

#include "peer.h"

#include <embree3/rtcore.h>
#include <math.h>
#include <pthread.h>
#include <stdint.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#define TILE 16
#define MAX_THREADS 64

struct state {
    const struct peer *peer;
    RTCScene scene;
    const struct peer_camera *camera;
    unsigned char *rgba;
    atomic_int next;
};

static void fill_ray(const struct state *state, struct RTCRayHit8 *rays, int lane, int x, int y)
{
    const struct peer_camera *camera = state->camera;
    const float u = 2 * ((float)x + 0.5F) / (float)state->peer->width - 1;
    const float v = 1 - 2 * ((float)y + 0.5F) / (float)state->peer->height;
    float d[3];
    for (int i = 0; i < 3; i++)
        d[i] = camera->forward[i] + u * camera->right[i] + v * camera->up[i];
    rays->ray.org_x[lane] = camera->eye[0];
    rays->ray.org_y[lane] = camera->eye[1];
    rays->ray.org_z[lane] = camera->eye[2];
    rays->ray.dir_x[lane] = d[0];
    rays->ray.dir_y[lane] = d[1];
    rays->ray.dir_z[lane] = d[2];
    rays->ray.tnear[lane] = 0;
    rays->ray.tfar[lane] = INFINITY;
    rays->ray.mask[lane] = UINT32_MAX;
    rays->ray.time[lane] = 0;
    rays->hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    rays->hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
}

static void shade_ray(const struct state *state, const struct RTCRayHit8 *rays, int lane,
                      unsigned char *rgba)
{
    float n[3] = {rays->hit.Ng_x[lane], rays->hit.Ng_y[lane], rays->hit.Ng_z[lane]};
    if (rays->hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID) {
        for (int i = 0; i < 3; i++)
            rgba[i] = peer_background[i];
        rgba[3] = 255;
        return;
    }
    const float length = sqrtf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int i = 0; i < 3; i++)
        n[i] /= length;
    peer_shade(state->camera, n, rgba);
}

/* Eight pixels: four by two. */
static void draw_packet(struct state *state, struct RTCIntersectContext *context, int x0, int y0)
{
    struct RTCRayHit8 rays;
    int valid[8];
    for (int i = 0; i < 8; i++) {
        const int x = x0 + i % 4, y = y0 + i / 4;
        valid[i] = x < state->peer->width && y < state->peer->height ? -1 : 0;
        fill_ray(state, &rays, i, x, y);
    }
    rtcIntersect8(valid, state->scene, context, &rays);
    for (int i = 0; i < 8; i++) {
        const size_t pixel = (size_t)(y0 + i / 4) * (size_t)state->peer->width + (size_t)x0;
        if (valid[i])
            shade_ray(state, &rays, i, state->rgba + 4 * (pixel + (size_t)(i % 4)));
    }
}

static void *draw_tiles(void *user)
{
    struct state *state = user;
    const int across = (state->peer->width + TILE - 1) / TILE;
    const int down = (state->peer->height + TILE - 1) / TILE;
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    for (int i; (i = atomic_fetch_add(&state->next, 1)) < across * down;)
        for (int y = 0; y < TILE; y += 2)
            for (int x = 0; x < TILE; x += 4)
                if (i % across * TILE + x < state->peer->width &&
                    i / across * TILE + y < state->peer->height)
                    draw_packet(state, &context, i % across * TILE + x, i / across * TILE + y);
    return NULL;
}

static bool draw(void *user, const struct peer_camera *camera, unsigned char *rgba)
{
    struct state *state = user;
    pthread_t threads[MAX_THREADS];
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    int num = 0;
    state->camera = camera;
    state->rgba = rgba;
    atomic_store(&state->next, 0);
    while (num + 1 < cores && num < MAX_THREADS &&
           !pthread_create(&threads[num], NULL, draw_tiles, state))
        num++;
    draw_tiles(state);
    while (num > 0)
        pthread_join(threads[--num], NULL);
    return true;
}

static void add_spheres(RTCDevice device, RTCScene scene, const struct peer_solids *solids)
{
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    float *points = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                            4 * sizeof *points, solids->num_spheres);
    size_t num = 0;
    for (size_t i = 0; i < solids->num; i++) {
        const struct peer_solid *s = &solids->data[i];
        for (int j = 0; j < 3 && i < solids->num_spheres; j++)
            points[4 * num + (size_t)j] = s->a[j];
        if (i < solids->num_spheres)
            points[4 * num++ + 3] = s->r;
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
}

static void add_cylinders(RTCDevice device, RTCScene scene, const struct peer_solids *solids)
{
    const size_t num = solids->num - solids->num_spheres;
    if (num == 0)
        return;
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_CONE_LINEAR_CURVE);
    float *points = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                            4 * sizeof *points, 2 * num);
    unsigned *index = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT,
                                              sizeof *index, num);
    for (size_t i = 0; i < num; i++) {
        const struct peer_solid *s = &solids->data[solids->num_spheres + i];
        for (size_t j = 0; j < 3; j++) {
            points[8 * i + j] = s->a[j];
            points[8 * i + 4 + j] = s->b[j];
        }
        points[8 * i + 3] = points[8 * i + 7] = s->r;
        index[i] = (unsigned)(2 * i);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
}

int main(int argc, char **argv)
{
    struct peer peer;
    struct peer_solids solids = {0};
    if (!peer_parse(&peer, argc, argv) || !peer_read_solids(&peer, &solids))
        return 1;
    RTCDevice device = rtcNewDevice(NULL);
    RTCScene scene = rtcNewScene(device);
    add_spheres(device, scene, &solids);
    add_cylinders(device, scene, &solids);
    rtcCommitScene(scene);
    struct state state = {.peer = &peer, .scene = scene};
    const bool good = peer_run(&peer, draw, &state, false);
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
    free(solids.data);
    return !good;
}
