/* SPDX-License-Identifier: MIT */
#include "export/pov.h"

#include <stdlib.h>

#include "carrier/carrier.h"

/* POV-Ray's tolerances are absolute, made for scenes of some units: its nearest hit is at 1e-6 or
 * so, its furthest at 1e7. Scenes of other sizes are scaled. */
#define LEAST_SIZE 0.1
#define LARGEST_SIZE 1e4

static double box_size(const struct csg_box *box)
{
    return csg_box_is_empty(box) || !csg_box_is_finite(box) ? 0
                                                            : csg_length(csg_sub(box->hi, box->lo));
}

static double choose_unit(double size)
{
    const bool fits = size == 0 || (size >= LEAST_SIZE && size <= LARGEST_SIZE);
    return fits ? 1 : pow(10, round(1 - log10(size)));
}

/* An orthographic view shows what lies behind the eye as well; POV-Ray's begins at the eye. */
static struct csg_vec3 find_location(const struct csg_pov *pov)
{
    const struct csgcast_frustum *frustum = &pov->frustum;
    const struct csg_vec3 eye = csg_vec3_of(frustum->eye), forward = csg_vec3_of(frustum->forward);
    const struct csg_box *box = &pov->scene->box;
    double nearest = 0;
    if (!frustum->orthographic || !(pov->size > 0))
        return eye;
    for (int i = 0; i < 8; i++)
        nearest = fmin(nearest, csg_dot(csg_sub(csg_box_corner(box, i), eye), forward));
    return nearest < 0 ? csg_add(eye, csg_scale(nearest - 0.1 * pov->size, forward)) : eye;
}

static void write_vector(const struct csg_pov *pov, const char *name, struct csg_vec3 v)
{
    char vector[CSG_TEXT_VECTOR];
    csg_text_line(pov->text, "%s %s", name, csg_text_vector(vector, v));
}

/* right has its length and, unlike POV-Ray's default, its direction from a right-handed space. */
static void write_camera(const struct csg_pov *pov)
{
    const struct csgcast_frustum *frustum = &pov->frustum;
    const double size = frustum->orthographic ? 2 * pov->unit : 2;
    csg_text_open(pov->text, "camera");
    csg_text_line(pov->text, "%s", frustum->orthographic ? "orthographic" : "perspective");
    write_vector(pov, "location", csg_scale(pov->unit, find_location(pov)));
    write_vector(pov, "direction", csg_vec3_of(frustum->forward));
    write_vector(pov, "right", csg_scale(size * frustum->half_width, csg_vec3_of(frustum->right)));
    write_vector(pov, "up", csg_scale(size * frustum->half_height, csg_vec3_of(frustum->up)));
    csg_text_close(pov->text);
}

/* Parallel light along a direction of eye space; where it comes from is of no account. */
static void write_light(const struct csg_pov *pov, double sign)
{
    const struct csgcast_frustum *frustum = &pov->frustum;
    const struct csg_vec3 direction =
        csg_add(csg_add(csg_scale(CSG_LIGHT_X, csg_vec3_of(frustum->right)),
                        csg_scale(CSG_LIGHT_Y, csg_vec3_of(frustum->up))),
                csg_scale(-CSG_LIGHT_Z, csg_vec3_of(frustum->forward)));
    char from[CSG_TEXT_VECTOR];
    csg_text_line(pov->text, "light_source { %s, rgb 1 parallel point_at 0 shadowless }",
                  csg_text_vector(from, csg_scale(1e6 * sign, direction)));
}

static void write_color(const struct csg_pov *pov, const char *head, const float rgba[4],
                        const char *tail)
{
    char rgb[CSG_TEXT_VECTOR], transmit[CSG_TEXT_NUMBER];
    csg_text_vector(rgb, csg_vec3((double)rgba[0], (double)rgba[1], (double)rgba[2]));
    if (rgba[3] < 1)
        csg_text_line(pov->text, "%srgb %s transmit %s%s", head, rgb,
                      csg_text_number(transmit, 1 - (double)rgba[3]), tail);
    else
        csg_text_line(pov->text, "%srgb %s%s", head, rgb, tail);
}

static void write_paints(const struct csg_pov *pov)
{
    char head[64];
    for (size_t i = 0; i < pov->paints.num; i++) {
        snprintf(head, sizeof head, "#declare Paint%zu = texture { pigment { ", i);
        write_color(pov, head, pov->paints.data[i].rgba, " } finish { Matt } }");
    }
}

static void write_head(const struct csg_pov *pov)
{
    const float *b = pov->scheme->background;
    const float background[4] = {b[0], b[1], b[2], 1};
    char ambient[CSG_TEXT_NUMBER];
    const int width = pov->view->width ? pov->view->width : 512;
    const int height = pov->view->height ? pov->view->height : 512;
    csg_text_line(pov->text, "// Made by csgcast " CSGCAST_VERSION_STRING "; draw it with");
    csg_text_line(pov->text, "//   povray +W%d +H%d -D +IFILE.pov +OFILE.png", width, height);
    if (pov->unit != 1)
        csg_text_line(pov->text, "// Lengths are scaled to suit POV-Ray's tolerances.");
    csg_text_line(pov->text, "#version 3.7;");
    /* Colours are what OpenSCAD shows, and light is computed with them as they are. */
    csg_text_line(pov->text, "global_settings { assumed_gamma srgb max_trace_level 250 }");
    write_color(pov, "background { ", background, " }");
    write_camera(pov);
    write_light(pov, 1);
    write_light(pov, -1);
    csg_text_line(pov->text, "#declare Matt = finish { ambient %s diffuse 1 }",
                  csg_text_number(ambient, CSG_LIGHT_AMBIENT));
}

/* The set of all points has no surface. */
static bool is_everything(const struct csg_pov *pov, const struct csg_object *object)
{
    return pov->scene->trees[object->layer].data[object->begin].op != CSG_LEAF &&
           object->end == object->begin + 1;
}

static bool write_objects(struct csg_pov *pov)
{
    const struct csg_objects *objects = pov->scene->objects;
    for (size_t i = 0; i < objects->num; i++) {
        const struct csg_object *object = &objects->data[i];
        if (!object->hidden && !is_everything(pov, object) && !csg_pov_object(pov, object))
            return false;
    }
    return true;
}

bool csg_pov_write(struct csg_text *text, const struct csgcast_scene *scene,
                   const struct csgcast_view *view, const struct csg_colorscheme *scheme,
                   const struct csgcast_frustum *frustum)
{
    const struct csg_carriers *carriers = scene->carriers;
    const double size = box_size(&scene->box);
    struct csg_pov pov = {.text = text,
                          .scene = scene,
                          .view = view,
                          .scheme = scheme,
                          .frustum = *frustum,
                          .size = size,
                          .unit = choose_unit(size),
                          .sides = calloc(carriers->num_planes + carriers->num_quadrics + 1, 1)};
    bool ok = pov.sides && csg_pov_paints_fill(&pov);
    if (ok) {
        write_head(&pov);
        write_paints(&pov);
        ok = write_objects(&pov);
    }
    free(pov.paints.data);
    free(pov.sides);
    return ok;
}
