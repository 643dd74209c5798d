/* SPDX-License-Identifier: MIT */
#include "view_options.h"

#include "antialias.h"
#include "values.h"

#include <stdlib.h>
#include <string.h>

const char *csg_set_imgsize(struct csg_cli_options *options, const char *value)
{
    double size[2];
    if (csg_value_list(value, size, 2) != 2)
        return "WIDTH,HEIGHT";
    for (int i = 0; i < 2; i++) {
        if (size[i] < 1 || size[i] > CSG_MAX_IMAGE_SIZE || size[i] != (int)size[i])
            return "two whole numbers from 1 to 16384";
    }
    options->view.width = (int)size[0];
    options->view.height = (int)size[1];
    return NULL;
}

const char *csg_set_antialias(struct csg_cli_options *options, const char *value)
{
    int *n = &options->antialias;
    return csg_value_int(value, n) && *n >= 1 && *n <= CSG_ANTIALIAS_MAX ? NULL : "1 to 8";
}

const char *csg_set_camera(struct csg_cli_options *options, const char *value)
{
    struct csgcast_camera *camera = &options->view.camera;
    double v[7];
    const size_t num = csg_value_list(value, v, 7);
    if (num == 7) {
        camera->kind = CSGCAST_CAMERA_GIMBAL;
        memcpy(camera->translate, v, sizeof camera->translate);
        memcpy(camera->rotate, v + 3, sizeof camera->rotate);
        camera->distance = v[6];
    } else if (num == 6) {
        camera->kind = CSGCAST_CAMERA_VECTOR;
        memcpy(camera->eye, v, sizeof camera->eye);
        memcpy(camera->center, v + 3, sizeof camera->center);
    } else {
        return "7 numbers tx,ty,tz,rx,ry,rz,distance or 6 numbers ex,ey,ez,cx,cy,cz";
    }
    options->camera = value;
    return NULL;
}

const char *csg_set_projection(struct csg_cli_options *options, const char *value)
{
    static const struct csg_value_name names[] = {
        {"p", CSGCAST_PERSPECTIVE},
        {"perspective", CSGCAST_PERSPECTIVE},
        {"o", CSGCAST_ORTHOGRAPHIC},
        {"ortho", CSGCAST_ORTHOGRAPHIC},
        {"orthographic", CSGCAST_ORTHOGRAPHIC},
        {"orthogonal", CSGCAST_ORTHOGRAPHIC},
        {NULL, 0},
    };
    int projection;
    if (!csg_value_enum(value, names, &projection))
        return "p (perspective) or o (orthographic)";
    options->view.camera.projection = (enum csgcast_projection)projection;
    return NULL;
}

const char *csg_set_fov(struct csg_cli_options *options, const char *value)
{
    double *fov = &options->view.camera.fov;
    if (!csg_value_double(value, fov) || !(*fov > 0 && *fov < 180))
        return "degrees between 0 and 180";
    return NULL;
}

const char *csg_set_colorscheme(struct csg_cli_options *options, const char *value)
{
    options->view.colorscheme = value;
    for (size_t i = 0; csgcast_colorscheme_name(i); i++) {
        if (!strcmp(csgcast_colorscheme_name(i), value))
            return NULL;
    }
    return "one of the names that `csgcast help render` lists";
}

const char *csg_set_cut_color(struct csg_cli_options *options, const char *value)
{
    static const struct csg_value_name names[] = {
        {"openscad", CSGCAST_CUT_OPENSCAD}, {"minuend", CSGCAST_CUT_MINUEND}, {NULL, 0}};
    int cut_color;
    if (!csg_value_enum(value, names, &cut_color))
        return "openscad or minuend";
    options->view.cut_color = (enum csgcast_cut_color)cut_color;
    return NULL;
}

const char *csg_set_backend(struct csg_cli_options *options, const char *value)
{
    /* The last four are the mesh kernels of OpenSCAD's option of this name: any of ours will do. */
    static const struct csg_value_name names[] = {{"auto", CSGCAST_BACKEND_AUTO},
                                                  {"egl", CSGCAST_BACKEND_EGL},
                                                  {"osmesa", CSGCAST_BACKEND_OSMESA},
                                                  {"reference", CSGCAST_BACKEND_REFERENCE},
                                                  {"Manifold", CSGCAST_BACKEND_AUTO},
                                                  {"manifold", CSGCAST_BACKEND_AUTO},
                                                  {"CGAL", CSGCAST_BACKEND_AUTO},
                                                  {"cgal", CSGCAST_BACKEND_AUTO},
                                                  {NULL, 0}};
    int backend;
    if (!csg_value_enum(value, names, &backend))
        return "auto, egl, osmesa or reference";
    options->renderer.backend = (enum csgcast_backend)backend;
    return NULL;
}

const char *csg_set_threads(struct csg_cli_options *options, const char *value)
{
    int num;
    if (!csg_value_int(value, &num) || num < 0 || num > 64)
        return "0 to 64";
    options->renderer.num_threads = options->scene.num_threads = num;
    if (num > 0)
        setenv("LP_NUM_THREADS", value, 0); /* for llvmpipe, which is loaded later */
    return NULL;
}

const char *csg_set_variant(struct csg_cli_options *options, const char *value)
{
    options->view.variant = value;
    if (!strcmp(value, "auto"))
        return NULL;
    for (size_t i = 0; csgcast_variant_name(i); i++) {
        if (!strcmp(csgcast_variant_name(i), value))
            return NULL;
    }
    return "auto or one of the names that `csgcast help render` lists";
}
