/* SPDX-License-Identifier: MIT */

/*
 * OpenCSG, what OpenSCAD's preview draws with, on meshes of as many facets as MODE says:
 *
 *     opencsg_peer 64 SCENE.csg ...
 *
 * The scene must be one object, a difference of boxes, spheres and cylinders. Needs an X display.
 */

#include "opencsg_wrap.h"
#include "peer.h"

#include "csg/object.h"
#include "polyhedra/cell.h"

#include <GL/gl.h>
#include <GL/glx.h>
#include <X11/Xlib.h>
#include <stdio.h>
#include <stdlib.h>

#define PI 3.14159265358979323846

struct state {
    const struct peer *peer;
    struct opencsg_product *product;
    GLuint first_list;
    GLsizei num_lists;
    int facets;
};

/* ---- meshes --------------------------------------------------------------------------------- */

static void emit(struct csg_vec3 p)
{
    glVertex3d(p.x, p.y, p.z);
}

static bool emit_polyhedron(const struct csg_shape *shape)
{
    struct csg_cell cell = {0};
    const bool ok = csg_cell_from_shape(&cell, shape);
    for (size_t i = 0; i < cell.faces.num && ok; i++) {
        const struct csg_polygon *face = &cell.faces.data[i];
        glBegin(GL_POLYGON);
        glNormal3d(face->plane.normal.x, face->plane.normal.y, face->plane.normal.z);
        for (size_t j = 0; j < face->points.num; j++)
            emit(face->points.data[j]);
        glEnd();
    }
    csg_cell_finish(&cell);
    return ok;
}

/* A point of the canonical unit sphere or cylinder, in the world. */
static void emit_round(const struct csg_map *map, double angle, double radius, double z)
{
    const struct csg_vec3 n =
        csg_map_direction(map, csg_vec3(radius * cos(angle), radius * sin(angle), z));
    glNormal3d(n.x, n.y, n.z);
    emit(csg_map_point(map, csg_vec3(radius * cos(angle), radius * sin(angle), z)));
}

static void emit_sphere(const struct csg_map *map, int facets)
{
    for (int j = 0; j < facets / 2; j++) {
        const double a = 2 * PI * j / facets, b = 2 * PI * (j + 1) / facets;
        glBegin(GL_QUAD_STRIP);
        for (int i = 0; i <= facets; i++) {
            emit_round(map, 2 * PI * i / facets, sin(a), cos(a));
            emit_round(map, 2 * PI * i / facets, sin(b), cos(b));
        }
        glEnd();
    }
}

static void emit_cylinder(const struct csg_map *map, double lo, double hi, int facets)
{
    glBegin(GL_QUAD_STRIP);
    for (int i = 0; i <= facets; i++) {
        emit_round(map, 2 * PI * i / facets, 1, hi);
        emit_round(map, 2 * PI * i / facets, 1, lo);
    }
    glEnd();
    for (int end = 0; end < 2; end++) {
        glBegin(GL_POLYGON);
        for (int i = 0; i < facets; i++)
            emit_round(map, 2 * PI * (end ? i : -i) / facets, 1, end ? hi : lo);
        glEnd();
    }
}

/* Canonical z of the caps. */
static void find_ends(const struct csg_shape *shape, const struct csg_map *map, double *lo,
                      double *hi)
{
    const struct csg_vec3 shift = csg_vec3(map->m[0][3], map->m[1][3], map->m[2][3]);
    for (size_t i = 0; i < shape->num_planes; i++) {
        const struct csg_plane *plane = &shape->planes[i];
        const double z = csg_map_transposed(map, plane->normal).z;
        *(z > 0 ? hi : lo) = (plane->offset - csg_dot(plane->normal, shift)) / z;
    }
}

static bool emit_leaf(const struct csg_shape *shape, int facets)
{
    struct csg_map map;
    double lo = 0, hi = 0;
    if (!shape->has_quadric)
        return emit_polyhedron(shape);
    if (!csg_map_invert(&shape->quadric.to_canon, &map))
        return false;
    find_ends(shape, &map, &lo, &hi);
    if (shape->num_planes == 2)
        emit_cylinder(&map, lo, hi, facets);
    else
        emit_sphere(&map, facets);
    return true;
}

/* ---- the scene ------------------------------------------------------------------------------ */

static bool add_leaf(struct state *state, const struct csg_leaf *leaf, bool subtracted)
{
    const GLuint list = state->first_list + (GLuint)state->num_lists++;
    glNewList(list, GL_COMPILE);
    const bool ok = emit_leaf(&leaf->shape, state->facets);
    glEndList();
    return ok && opencsg_product_add(state->product, list, subtracted);
}

static bool load(struct state *state)
{
    struct csgcast_scene *scene = csgcast_scene_load(state->peer->input, NULL);
    if (!scene)
        return false;
    const struct csg_tree *tree = &scene->trees[CSG_LAYER_MODEL];
    bool ok = tree->num && tree->data[0].op != CSG_OR;
    state->first_list = glGenLists((GLsizei)tree->num);
    for (size_t i = 0; i < tree->num && ok; i++)
        if (tree->data[i].op == CSG_LEAF)
            ok = add_leaf(state, &scene->leaves[tree->data[i].leaf], tree->data[i].negated);
        else
            ok = i == 0;
    if (!ok)
        fprintf(stderr, "opencsg_peer: %s is no plain difference\n", state->peer->input);
    csgcast_scene_destroy(scene);
    return ok;
}

/* ---- the frames ----------------------------------------------------------------------------- */

static void set_camera(const struct state *state, const struct peer_camera *camera)
{
    float rows[3][3], lengths[2] = {0}, distance = 0;
    for (int i = 0; i < 3; i++) {
        lengths[0] += camera->right[i] * camera->right[i];
        lengths[1] += camera->up[i] * camera->up[i];
        distance += powf(camera->eye[i] - (float)state->peer->center[i], 2);
    }
    for (int i = 0; i < 3; i++) {
        rows[0][i] = camera->right[i] / sqrtf(lengths[0]);
        rows[1][i] = camera->up[i] / sqrtf(lengths[1]);
        rows[2][i] = -camera->forward[i];
    }
    GLfloat m[16] = {0};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            m[4 * j + i] = rows[i][j];
    m[15] = 1;
    const double near = 0.3 * sqrt((double)distance), far = 3 * sqrt((double)distance);
    const double x = near * sqrt((double)lengths[0]), y = near * sqrt((double)lengths[1]);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-x, x, -y, y, near, far);
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixf(m);
    glTranslatef(-camera->eye[0], -camera->eye[1], -camera->eye[2]);
}

static bool draw(void *user, const struct peer_camera *camera, unsigned char *rgba)
{
    struct state *state = user;
    glClearColor(1, 1, 229 / 255.F, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    set_camera(state, camera);
    opencsg_product_render(state->product);
    glDepthFunc(GL_EQUAL);
    glEnable(GL_LIGHTING);
    for (GLsizei i = 0; i < state->num_lists; i++)
        glCallList(state->first_list + (GLuint)i);
    glDisable(GL_LIGHTING);
    glDepthFunc(GL_LESS);
    glReadPixels(0, 0, state->peer->width, state->peer->height, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    return glGetError() == GL_NO_ERROR;
}

static void set_light(void)
{
    static const GLfloat color[] = {249 / 255.F, 215 / 255.F, 44 / 255.F, 1};
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, color);
}

static bool make_context(const struct peer *peer)
{
    static const int wanted[] = {GLX_DRAWABLE_TYPE,
                                 GLX_PBUFFER_BIT,
                                 GLX_RED_SIZE,
                                 8,
                                 GLX_GREEN_SIZE,
                                 8,
                                 GLX_BLUE_SIZE,
                                 8,
                                 GLX_ALPHA_SIZE,
                                 8,
                                 GLX_DEPTH_SIZE,
                                 24,
                                 GLX_STENCIL_SIZE,
                                 8,
                                 None};
    const int size[] = {GLX_PBUFFER_WIDTH, peer->width, GLX_PBUFFER_HEIGHT, peer->height, None};
    int num = 0;
    Display *display = XOpenDisplay(NULL);
    GLXFBConfig *configs =
        display ? glXChooseFBConfig(display, DefaultScreen(display), wanted, &num) : NULL;
    if (num == 0)
        return fprintf(stderr, "opencsg_peer: no X display with OpenGL\n"), false;
    const GLXPbuffer buffer = glXCreatePbuffer(display, configs[0], size);
    const GLXContext context = glXCreateNewContext(display, configs[0], GLX_RGBA_TYPE, NULL, True);
    XFree(configs);
    return glXMakeContextCurrent(display, buffer, buffer, context);
}

int main(int argc, char **argv)
{
    struct peer peer;
    if (!peer_parse(&peer, argc, argv) || !make_context(&peer))
        return 1;
    struct state state = {
        .peer = &peer, .product = opencsg_product_create(), .facets = atoi(peer.mode)};
    glViewport(0, 0, peer.width, peer.height);
    set_light();
    const bool good =
        state.facets >= 3 && state.product && load(&state) && peer_run(&peer, draw, &state, true);
    opencsg_product_destroy(state.product);
    return !good;
}
