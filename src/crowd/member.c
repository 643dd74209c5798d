/* SPDX-License-Identifier: MIT */
#include "crowd/member.h"

#include "carrier/carrier.h"
#include "pack/ball.h"
#include "pack/terms.h"

static bool is_ball(const struct csg_crowd_view *view, const struct csg_crowd_class *class)
{
    return class->outline == CSG_OUTLINE_BALL && view->square;
}

struct csg_crowd_run csg_member_run(const struct csg_crowd_view *view,
                                    const struct csg_crowd_class *class)
{
    return (struct csg_crowd_run){.ball = is_ball(view, class),
                                  .has_quadric = class->has_quadric,
                                  .num_planes = class->num_planes};
}

static struct csg_vec3 center_of(const struct csg_crowd_view *view, uint32_t member)
{
    const struct csg_crowd *crowd = view->crowd;
    return csg_vec3(crowd->x[member], crowd->y[member], crowd->z[member]);
}

static void put_quadric(double texels[CSG_QUADRIC_TEXELS][4], float *out)
{
    for (int i = 0; i < 12; i++)
        out[i] = (float)texels[i / 4][i % 4];
}

static void plane_terms(const struct csg_frame *frame, const struct csgcast_scene *scene,
                        const struct csg_face *face, float *out)
{
    double texel[4];
    csg_screen_plane(&frame->screen, frame->at, &scene->carriers->planes[face->carrier],
                     face->flipped, texel);
    for (int j = 0; j < 3; j++)
        out[j] = (float)texel[j];
    out[3] = texel[3] < 0 ? CSG_KEY_MAX : 0;
}

bool csg_leaf_cast_terms(const struct csg_frame *frame, const struct csgcast_scene *scene,
                         uint32_t leaf, float *out)
{
    const struct csg_carriers *carriers = scene->carriers;
    if (carriers->quadric_faces[leaf].carrier != CSG_NO_CARRIER) {
        double texels[CSG_QUADRIC_TEXELS][4];
        csg_terms_crossings(frame, scene, leaf, texels, NULL);
        put_quadric(texels, out);
        out += 12;
        if ((int)texels[0][3] & CSG_QUADRIC_STIFF)
            return false;
    }
    for (uint32_t i = carriers->face_begin[leaf]; i < carriers->face_begin[leaf + 1]; i++, out += 4)
        plane_terms(frame, scene, &carriers->faces[i], out);
    return true;
}

bool csg_member_terms(const struct csg_crowd_view *view, const struct csg_crowd_class *class,
                      uint32_t member, float *out)
{
    double texels[CSG_QUADRIC_TEXELS][4];
    if (!is_ball(view, class))
        return csg_leaf_cast_terms(view->frame, view->scene, view->crowd->leaf[member], out);
    csg_screen_ball(&view->frame->screen, view->frame->at, center_of(view, member),
                    view->crowd->radius[member], texels);
    put_quadric(texels, out);
    return !((int)texels[0][3] & CSG_QUADRIC_STIFF);
}

static void put_normal(float *texel, const float normal[3], double sign, float mark)
{
    for (int i = 0; i < 3; i++)
        texel[i] = (float)(sign * (double)normal[i]);
    texel[3] = mark;
}

static void quadric_normals(const struct csg_crowd_view *view, const struct csg_crowd_class *class,
                            uint32_t member, float mark, float (*normals)[4])
{
    const struct csg_frame *frame = view->frame;
    const struct csg_carriers *carriers = view->scene->carriers;
    const struct csg_face face = carriers->quadric_faces[view->crowd->leaf[member]];
    const float base[3] = {0, 0, 0};
    float terms[CSG_NORMAL_TERMS][3];
    if (is_ball(view, class))
        csg_screen_ball_normal(&frame->screen, frame->at, center_of(view, member), terms);
    else
        csg_screen_normal(&frame->screen, frame->at,
                          csg_carrier_quadric(view->scene, carriers, face.carrier), base, terms);
    for (int i = 0; i < CSG_NORMAL_TERMS; i++)
        put_normal(normals[i], terms[i], 1, i == 0 ? -mark : 0);
}

void csg_member_normals(const struct csg_crowd_view *view, const struct csg_crowd_class *class,
                        uint32_t member, float mark, float (*normals)[4])
{
    const struct csg_carriers *carriers = view->scene->carriers;
    const struct csg_face *faces =
        carriers->faces + carriers->face_begin[view->crowd->leaf[member]];
    if (class->has_quadric)
        quadric_normals(view, class, member, mark, normals);
    normals += class->has_quadric ? CSG_NORMAL_TERMS : 0;
    for (uint32_t i = 0; i < class->num_planes; i++) {
        const struct csg_vec3 n = carriers->planes[faces[i].carrier].normal;
        const float normal[3] = {(float)n.x, (float)n.y, (float)n.z};
        put_normal(normals[i], normal, faces[i].flipped ? -1 : 1, mark);
    }
}
