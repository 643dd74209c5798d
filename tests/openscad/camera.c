/* SPDX-License-Identifier: MIT */
#include "camera.h"

#include <stdint.h>
#include <stdio.h>

#include "common/random.h"

static const double default_fov = 22.5;
static const double degree = 3.14159265358979323846 / 180;

/* What GLView.cc feeds to OpenGL: look at -trans, turned by rot about x, y and z, from distance. */
struct gimbal {
    struct csg_vec3 trans, rot;
    double distance;
};

static struct csg_vec3 from_array(const double v[3])
{
    return csg_vec3(v[0], v[1], v[2]);
}

static struct gimbal gimbal_from_rotation(struct csg_vec3 vpt, struct csg_vec3 vpr, double distance)
{
    return (struct gimbal){
        .trans = csg_scale(-1, vpt),
        .rot = csg_vec3(90 - vpr.x, -vpr.y, -vpr.z),
        .distance = distance,
    };
}

/* Camera.cc, setup() with six numbers. Straight up, the picture's top is -y; straight down, +y. */
static struct gimbal gimbal_from_vector(struct csg_vec3 eye, struct csg_vec3 center)
{
    const struct csg_vec3 dir = csg_sub(center, eye);
    const double flat = hypot(dir.x, dir.y);
    const double azimuth = flat > 0 ? atan2(dir.y, dir.x) / degree : dir.z > 0 ? -90 : 90;
    return (struct gimbal){
        .trans = csg_scale(-1, center),
        .rot = csg_vec3(-atan2(dir.z, flat) / degree, 0, 90 - azimuth),
        .distance = csg_length(dir),
    };
}

static struct gimbal gimbal_from_camera(const struct csgcast_camera *camera)
{
    if (camera->kind == CSGCAST_CAMERA_VECTOR)
        return gimbal_from_vector(from_array(camera->eye), from_array(camera->center));
    if (camera->kind == CSGCAST_CAMERA_GIMBAL)
        return gimbal_from_rotation(from_array(camera->translate), from_array(camera->rotate),
                                    camera->distance);
    return gimbal_from_rotation(csg_vec3(0, 0, 0), csg_vec3(55, 0, 25), 140);
}

/* The vector that glRotated(rot.x), glRotated(rot.y), glRotated(rot.z) carry to v. */
static struct csg_vec3 unrotate(struct csg_vec3 rot, struct csg_vec3 v)
{
    const double cx = cos(rot.x * degree), sx = sin(rot.x * degree);
    const double cy = cos(rot.y * degree), sy = sin(rot.y * degree);
    const double cz = cos(rot.z * degree), sz = sin(rot.z * degree);
    v = csg_vec3(v.x, cx * v.y + sx * v.z, cx * v.z - sx * v.y);
    v = csg_vec3(cy * v.x - sy * v.z, v.y, cy * v.z + sy * v.x);
    return csg_vec3(cz * v.x + sz * v.y, cz * v.y - sz * v.x, v.z);
}

struct csgcast_frustum camera_frustum(const struct csgcast_view *view, const struct csg_box *box)
{
    const struct csgcast_camera *camera = &view->camera;
    const bool is_default = camera->kind == CSGCAST_CAMERA_DEFAULT;
    const double half_fov = 0.5 * (camera->fov > 0 ? camera->fov : default_fov) * degree;
    const double aspect = (double)view->width / view->height;
    const bool bounded = !csg_box_is_empty(box);
    struct gimbal gimbal = gimbal_from_camera(camera);

    /* Camera.cc, viewAll(): autocenter counts only there. */
    if (bounded && (camera->viewall || is_default)) {
        const struct csg_vec3 center = csg_scale(0.5, csg_add(box->lo, box->hi));
        if (camera->autocenter || is_default)
            gimbal.trans = csg_scale(-1, center);
        const double radius =
            csg_length(csg_add(center, gimbal.trans)) + csg_length(csg_sub(box->hi, box->lo)) / 2;
        gimbal.distance = radius / sin(half_fov);
    }

    struct csgcast_frustum frustum = {.orthographic = camera->projection == CSGCAST_ORTHOGRAPHIC};
    const struct csg_vec3 right = unrotate(gimbal.rot, csg_vec3(1, 0, 0));
    const struct csg_vec3 forward = unrotate(gimbal.rot, csg_vec3(0, 1, 0));
    const struct csg_vec3 up = unrotate(gimbal.rot, csg_vec3(0, 0, 1));
    const struct csg_vec3 eye =
        csg_sub(csg_scale(-1, gimbal.trans), csg_scale(gimbal.distance, forward));
    frustum.half_height = tan(half_fov) * (frustum.orthographic ? gimbal.distance : 1);
    frustum.half_width = aspect * frustum.half_height;
    const struct csg_vec3 source[4] = {eye, right, up, forward};
    double *const target[4] = {frustum.eye, frustum.right, frustum.up, frustum.forward};
    for (int i = 0; i < 4; i++) {
        target[i][0] = source[i].x;
        target[i][1] = source[i].y;
        target[i][2] = source[i].z;
    }
    return frustum;
}

bool camera_parse(const char *text, struct csgcast_camera *camera)
{
    double v[7];
    char rest;
    const int num = sscanf(text, "%lf,%lf,%lf,%lf,%lf,%lf,%lf%c", &v[0], &v[1], &v[2], &v[3], &v[4],
                           &v[5], &v[6], &rest);
    if (num != 6 && num != 7)
        return false;
    camera->kind = num == 7 ? CSGCAST_CAMERA_GIMBAL : CSGCAST_CAMERA_VECTOR;
    for (int i = 0; i < 3; i++) {
        camera->translate[i] = camera->eye[i] = v[i];
        camera->rotate[i] = camera->center[i] = v[3 + i];
    }
    camera->distance = num == 7 ? v[6] : 0;
    return true;
}

static double next_random(uint64_t *state)
{
    return csg_random_between(state, 0, 1);
}

struct csgcast_camera camera_random(unsigned number, const struct csg_box *box)
{
    uint64_t state = number;
    const bool bounded = !csg_box_is_empty(box);
    const double radius = bounded ? csg_length(csg_sub(box->hi, box->lo)) / 2 : 1;
    const struct csg_vec3 center =
        bounded ? csg_scale(0.5, csg_add(box->lo, box->hi)) : csg_vec3(0, 0, 0);
    const double pitch = 180 * next_random(&state), roll = 360 * next_random(&state);
    const double yaw = 360 * next_random(&state), zoom = 0.6 + next_random(&state);
    return (struct csgcast_camera){
        .kind = CSGCAST_CAMERA_GIMBAL,
        .translate = {center.x, center.y, center.z},
        .rotate = {pitch, roll, yaw},
        .distance = zoom * radius / sin(default_fov / 2 * degree),
        .projection = number % 2 ? CSGCAST_ORTHOGRAPHIC : CSGCAST_PERSPECTIVE,
    };
}
