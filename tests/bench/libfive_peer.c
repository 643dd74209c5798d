/* SPDX-License-Identifier: MIT */

/*
 * libfive's heightmap (interval arithmetic over an octree, then voxels of a pixel's size) of any
 * scene of quadrics and convex polyhedra:
 *
 *     libfive_peer heightmap SCENE.csg ...
 *
 * Its rays are parallel, so the field is seen through the camera's perspective: x and y of the
 * voxels are places in the picture, -z is the distance along the view.
 */

#include "libfive_wrap.h"
#include "peer.h"

#include "csg/scene.h"

#include <libfive.h>
#include <stdio.h>
#include <stdlib.h>

struct state {
    const struct peer *peer;
    struct csgcast_scene *scene;
    libfive_tree field; /* negative inside, x, y, z in the world */
};

/* ---- expressions: they take their operands over ---------------------------------------------- */

static libfive_tree unary(const char *name, libfive_tree a)
{
    libfive_tree result = libfive_tree_unary(libfive_opcode_enum(name), a);
    libfive_tree_delete(a);
    return result;
}

static libfive_tree binary(const char *name, libfive_tree a, libfive_tree b)
{
    libfive_tree result = libfive_tree_binary(libfive_opcode_enum(name), a, b);
    libfive_tree_delete(a);
    libfive_tree_delete(b);
    return result;
}

/* factor * a + b */
static libfive_tree add_scaled(double factor, libfive_tree a, libfive_tree b)
{
    return binary("add", binary("mul", libfive_tree_const((float)factor), a), b);
}

static libfive_tree affine(double x, double y, double z, double constant)
{
    libfive_tree sum = libfive_tree_const((float)constant);
    sum = add_scaled(x, libfive_tree_x(), sum);
    sum = add_scaled(y, libfive_tree_y(), sum);
    return add_scaled(z, libfive_tree_z(), sum);
}

/* ---- the scene as a field -------------------------------------------------------------------- */

static libfive_tree quadric_field(const struct csg_quadric *quadric)
{
    libfive_tree sum = libfive_tree_const(quadric->diag[3]);
    for (int i = 0; i < 3; i++) {
        const double *row = quadric->to_canon.m[i];
        if (quadric->diag[i] != 0)
            sum = add_scaled(quadric->diag[i],
                             unary("square", affine(row[0], row[1], row[2], row[3])), sum);
        if (i == 2 && quadric->linear != 0)
            sum = add_scaled(2 * (double)quadric->linear, affine(row[0], row[1], row[2], row[3]),
                             sum);
    }
    return sum;
}

static libfive_tree leaf_field(const struct csg_shape *shape)
{
    libfive_tree field =
        shape->has_quadric ? quadric_field(&shape->quadric) : libfive_tree_const(-1e30F);
    for (size_t i = 0; i < shape->num_planes; i++) {
        const struct csg_vec3 n = shape->planes[i].normal;
        field = binary("max", field, affine(n.x, n.y, n.z, -shape->planes[i].offset));
    }
    return field;
}

/* Of the subtree at *node, one past it afterwards. The scenes of the bench are not deep. */
static libfive_tree tree_field(const struct csgcast_scene *scene, const struct csg_tree *tree,
                               size_t *node)
{
    const struct csg_node *top = &tree->data[(*node)++];
    if (top->op == CSG_LEAF) {
        libfive_tree field = leaf_field(&scene->leaves[top->leaf].shape);
        return top->negated ? unary("neg", field) : field;
    }
    libfive_tree field = tree_field(scene, tree, node);
    while (*node < top->end)
        field = binary(top->op == CSG_OR ? "min" : "max", field, tree_field(scene, tree, node));
    return field;
}

static bool load(struct state *state)
{
    state->scene = csgcast_scene_load(state->peer->input, NULL);
    if (!state->scene || !state->scene->trees[CSG_LAYER_MODEL].num)
        return false;
    for (size_t i = 0; i < state->scene->num_leaves; i++)
        if (state->scene->leaves[i].shape.surface)
            return fprintf(stderr, "libfive_peer: a mesh is no field\n"), false;
    size_t node = 0;
    state->field = tree_field(state->scene, &state->scene->trees[CSG_LAYER_MODEL], &node);
    return true;
}

/* ---- the frames ------------------------------------------------------------------------------ */

/* The least and the largest distance along the view of the scene's box. */
static void find_distances(const struct csg_box *box, const struct peer_camera *camera,
                           double limits[2])
{
    const double lo[3] = {box->lo.x, box->lo.y, box->lo.z},
                 hi[3] = {box->hi.x, box->hi.y, box->hi.z};
    limits[0] = limits[1] = 0;
    for (int i = 0; i < 3; i++) {
        const double a = (double)camera->forward[i] * (lo[i] - (double)camera->eye[i]);
        const double b = (double)camera->forward[i] * (hi[i] - (double)camera->eye[i]);
        limits[0] += fmin(a, b);
        limits[1] += fmax(a, b);
    }
}

/* The world's x, y or z of a voxel: eye - z (forward + x right + y up). */
static libfive_tree seen(const struct peer_camera *camera, int i)
{
    libfive_tree along =
        affine((double)camera->right[i], (double)camera->up[i], 0, (double)camera->forward[i]);
    return binary("sub", libfive_tree_const(camera->eye[i]),
                  binary("mul", libfive_tree_z(), along));
}

static void set_light(const struct peer *peer, unsigned char *rgba)
{
    const size_t num = (size_t)peer->width * (size_t)peer->height;
    for (size_t i = 0; i < num; i++, rgba += 4)
        for (int j = 0; j < 3; j++)
            if (!rgba[3])
                rgba[j] = peer_background[j];
}

static bool draw(void *user, const struct peer_camera *camera, unsigned char *rgba)
{
    const struct state *state = user;
    const struct peer *peer = state->peer;
    double limits[2];
    find_distances(&state->scene->box, camera, limits);
    const double pixel = (limits[0] + limits[1]) *
                         (double)hypotf(camera->up[0], hypotf(camera->up[1], camera->up[2])) /
                         peer->height;
    const struct libfive_view view = {
        .lower = {-1, -1, (float)-limits[1]},
        .upper = {1, 1, (float)-limits[0]},
        .num = {peer->width, peer->height, (int)ceil((limits[1] - limits[0]) / pixel)},
    };
    libfive_tree axes[3] = {seen(camera, 0), seen(camera, 1), seen(camera, 2)};
    libfive_tree field = libfive_tree_remap(state->field, axes[0], axes[1], axes[2]);
    const bool good = limits[0] > 0 && libfive_heightmap(field, &view, rgba);
    libfive_tree_delete(field);
    for (int i = 0; i < 3; i++)
        libfive_tree_delete(axes[i]);
    set_light(peer, rgba);
    return good;
}

int main(int argc, char **argv)
{
    struct peer peer;
    struct state state = {.peer = &peer};
    const bool good =
        peer_parse(&peer, argc, argv) && load(&state) && peer_run(&peer, draw, &state, true);
    if (state.field)
        libfive_tree_delete(state.field);
    csgcast_scene_destroy(state.scene);
    return !good;
}
