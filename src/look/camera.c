/* SPDX-License-Identifier: MIT */

/* Cameras as OpenSCAD 2021.01 has them (Camera.cc, GLView.cc), resolved to an eye and three axes.
 */

#include "csg/scene.h"

#define DEFAULT_FOV 22.5
#define DEFAULT_DISTANCE 140.0 /* of an empty scene */
#define DEGREE (3.14159265358979323846 / 180)
#define MAX_PIXELS 16384

/* What the camera looks at, from how far, turned how. */
struct gimbal {
    struct csg_vec3 target;
    double rotate[3]; /* degrees, as OpenSCAD's $vpr */
    double distance;
};

static const struct gimbal default_gimbal = {{0, 0, 0}, {55, 0, 25}, DEFAULT_DISTANCE};

/* The rotation that looks along direction with +z up; straight down has +y up, straight up -y. */
static void look_along(struct csg_vec3 direction, double rotate[3])
{
    const double across = hypot(direction.x, direction.y);
    rotate[0] = 90 + atan2(direction.z, across) / DEGREE;
    rotate[1] = 0;
    rotate[2] = across > 0 ? atan2(-direction.x, direction.y) / DEGREE : direction.z > 0 ? 180 : 0;
}

static struct gimbal gimbal_of(const struct csgcast_camera *camera)
{
    struct gimbal gimbal = default_gimbal;
    if (camera->kind == CSGCAST_CAMERA_GIMBAL) {
        gimbal.target = csg_vec3_of(camera->translate);
        for (int i = 0; i < 3; i++)
            gimbal.rotate[i] = camera->rotate[i];
        gimbal.distance = camera->distance;
    } else if (camera->kind == CSGCAST_CAMERA_VECTOR) {
        gimbal.target = csg_vec3_of(camera->center);
        const struct csg_vec3 direction = csg_sub(gimbal.target, csg_vec3_of(camera->eye));
        look_along(direction, gimbal.rotate);
        gimbal.distance = csg_length(direction);
    }
    return gimbal;
}

/* The box to frame: OpenSCAD's where the scene has solids that OpenSCAD knows. */
static struct csg_box framed_box(const struct csgcast_scene *scene)
{
    return csg_box_is_empty(&scene->written) ? scene->box : scene->written;
}

static void frame_scene(const struct csgcast_scene *scene, bool autocenter, double fov,
                        struct gimbal *gimbal)
{
    const struct csg_box box = framed_box(scene);
    if (csg_box_is_empty(&box) || !csg_box_is_finite(&box)) {
        if (csg_box_is_empty(&box))
            gimbal->target = csg_vec3(0, 0, 0);
        gimbal->distance = DEFAULT_DISTANCE;
        return;
    }
    if (autocenter)
        gimbal->target = csg_box_middle(&box);
    const struct csg_vec3 center = csg_box_middle(&box);
    const double radius =
        csg_length(csg_sub(center, gimbal->target)) + 0.5 * csg_length(csg_sub(box.hi, box.lo));
    gimbal->distance = radius / sin(0.5 * fov * DEGREE);
}

/* Columns of the inverse of Rx(90 - rx) Ry(-ry) Rz(-rz): world axes of the camera, whose own
 * space has x to the right, y along the view and z up. */
static void gimbal_axes(const double rotate[3], double right[3], double up[3], double forward[3])
{
    const double x = (90 - rotate[0]) * DEGREE, y = -rotate[1] * DEGREE, z = -rotate[2] * DEGREE;
    const double cx = cos(x), sx = sin(x), cy = cos(y), sy = sin(y), cz = cos(z), sz = sin(z);
    const double m[3][3] = {
        {cy * cz, -cy * sz, sy},
        {cx * sz + sx * sy * cz, cx * cz - sx * sy * sz, -sx * cy},
        {sx * sz - cx * sy * cz, sx * cz + cx * sy * sz, cx * cy},
    };
    for (int i = 0; i < 3; i++) {
        right[i] = m[0][i];
        forward[i] = m[1][i];
        up[i] = m[2][i];
    }
}

static bool is_finite_camera(const struct gimbal *gimbal)
{
    const double *r = gimbal->rotate;
    const struct csg_vec3 t = gimbal->target;
    return csg_vec3_is_finite(t) && isfinite(r[0]) && isfinite(r[1]) && isfinite(r[2]) &&
           isfinite(gimbal->distance) && gimbal->distance > 0;
}

static bool argument_error(const struct csgcast_scene *scene, const char *text)
{
    csg_log_error(&scene->log, CSGCAST_MESSAGE_ARGUMENT, "%s", text);
    return false;
}

/* The scene's own camera where it has one and no other was asked for: as OpenSCAD, which then does
 * without viewall, too. */
static struct csgcast_camera wanted_camera(const struct csgcast_scene *scene,
                                           const struct csgcast_camera *asked)
{
    struct csgcast_camera camera = *asked;
    if (asked->kind == CSGCAST_CAMERA_DEFAULT && scene->camera.kind != CSGCAST_CAMERA_DEFAULT) {
        camera = scene->camera;
        camera.projection = asked->projection;
        camera.fov = asked->fov != 0 ? asked->fov : camera.fov;
    }
    return camera;
}

/* A caller's enum may hold any number. */
static bool has_known_names(const struct csgcast_view *view)
{
    return (unsigned)view->camera.kind <= CSGCAST_CAMERA_VECTOR &&
           (unsigned)view->camera.projection <= CSGCAST_ORTHOGRAPHIC &&
           (unsigned)view->cut_color <= CSGCAST_CUT_MINUEND;
}

bool csgcast_view_resolve(const struct csgcast_scene *scene, const struct csgcast_view *view,
                          struct csgcast_frustum *frustum)
{
    static const struct csgcast_view default_view;
    if (!scene)
        return false;
    if (!view)
        view = &default_view;
    if (!has_known_names(view))
        return argument_error(scene, "there is no such kind of camera, projection or cut colour");
    const struct csgcast_camera camera = wanted_camera(scene, &view->camera);
    const int width = view->width ? view->width : 512, height = view->height ? view->height : 512;
    const double fov = camera.fov != 0 ? camera.fov : DEFAULT_FOV;
    if (width < 1 || height < 1 || width > MAX_PIXELS || height > MAX_PIXELS)
        return argument_error(scene, "image size must be 1 to 16384 pixels each way");
    if (!(fov > 0 && fov < 180))
        return argument_error(scene, "field of view must be between 0 and 180 degrees");
    struct gimbal gimbal = gimbal_of(&camera);
    const bool by_default = camera.kind == CSGCAST_CAMERA_DEFAULT;
    if (by_default || camera.viewall)
        frame_scene(scene, by_default || camera.autocenter, fov, &gimbal);
    if (!is_finite_camera(&gimbal))
        return argument_error(scene, "the camera needs finite numbers and a distance above 0");
    gimbal_axes(gimbal.rotate, frustum->right, frustum->up, frustum->forward);
    const double target[3] = {gimbal.target.x, gimbal.target.y, gimbal.target.z};
    for (int i = 0; i < 3; i++)
        frustum->eye[i] = target[i] - gimbal.distance * frustum->forward[i];
    frustum->orthographic = camera.projection == CSGCAST_ORTHOGRAPHIC;
    frustum->half_height = tan(0.5 * fov * DEGREE) * (frustum->orthographic ? gimbal.distance : 1);
    frustum->half_width = frustum->half_height * width / height;
    return true;
}
