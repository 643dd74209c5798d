/* SPDX-License-Identifier: MIT */
#include "bodies.h"

#include <math.h>

struct voxels voxels_random(struct dice *dice)
{
    struct voxels voxels;
    for (int i = 0; i < VOXEL_SIDE * VOXEL_SIDE * VOXEL_SIDE; i++)
        voxels.cell[i / 9][i / 3 % 3][i % 3] = dice_pick(dice, 5) < 3;
    voxels.cell[1][1][1] = voxels.cell[0][1][1] = true;
    return voxels;
}

void voxels_put_cubes(struct text *text, const struct voxels *voxels)
{
    text_put(text, "union() {\n");
    for (int i = 0; i < VOXEL_SIDE * VOXEL_SIDE * VOXEL_SIDE; i++)
        if (voxels->cell[i / 9][i / 3 % 3][i % 3])
            text_put(text,
                     "multmatrix([[1, 0, 0, %d], [0, 1, 0, %d], [0, 0, 1, %d], [0, 0, 0, 1]]) "
                     "cube(size = 1);\n",
                     i / 9, i / 3 % 3, i % 3);
    text_put(text, "}\n");
}

static bool is_solid(const struct voxels *voxels, const int at[3])
{
    for (int i = 0; i < 3; i++)
        if (at[i] < 0 || at[i] >= VOXEL_SIDE)
            return false;
    return voxels->cell[at[0]][at[1]][at[2]];
}

/* All places of the fine grid are points, whether used or not. */
static int point(int cuts, const int at[3])
{
    return (at[0] * (VOXEL_SIDE * cuts + 1) + at[1]) * (VOXEL_SIDE * cuts + 1) + at[2];
}

static void put_square(struct text *text, const int at[3], int axis, bool upwards, int cuts)
{
    int corners[4][3];
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 3; j++)
            corners[i][j] = at[j];
        corners[i][u] += i == 1 || i == 2;
        corners[i][v] += i >= 2;
    }
    text_put(text, "[");
    for (int i = 0; i < 4; i++)
        text_put(text, i ? ", %d" : "%d", point(cuts, corners[upwards ? i : 3 - i]));
    text_put(text, "], ");
}

static void put_side(struct text *text, const int cell[3], int axis, bool upwards, int cuts)
{
    for (int i = 0; i < cuts * cuts; i++) {
        int at[3];
        at[axis] = (cell[axis] + upwards) * cuts;
        at[(axis + 1) % 3] = cell[(axis + 1) % 3] * cuts + i / cuts;
        at[(axis + 2) % 3] = cell[(axis + 2) % 3] * cuts + i % cuts;
        put_square(text, at, axis, upwards, cuts);
    }
}

void voxels_put_polyhedron(struct text *text, const struct voxels *voxels, int cuts)
{
    const int grid = VOXEL_SIDE * cuts + 1;
    text_put(text, "polyhedron(points = [");
    for (int i = 0; i < grid * grid * grid; i++)
        text_put(text, "[%g, %g, %g], ", (double)(i / grid / grid) / cuts,
                 (double)(i / grid % grid) / cuts, (double)(i % grid) / cuts);
    text_put(text, "], faces = [");
    for (int i = 0; i < VOXEL_SIDE * VOXEL_SIDE * VOXEL_SIDE; i++)
        for (int side = 0; side < 6; side++) {
            const int cell[3] = {i / 9, i / 3 % 3, i % 3};
            int next[3] = {cell[0], cell[1], cell[2]};
            next[side / 2] += side % 2 ? 1 : -1;
            if (is_solid(voxels, cell) && !is_solid(voxels, next))
                put_side(text, cell, side / 2, side % 2, cuts);
        }
    text_put(text, "]);\n");
}

void tube_put(struct text *text, int n, int m, struct dice *dice)
{
    double wave[3][4];
    for (int i = 0; i < 12; i++)
        wave[i / 4][i % 4] = dice_between(dice, -1, 1);
    text_put(text, "polyhedron(points = [");
    for (int i = 0; i < n * m; i++) {
        const double a = 6.283185307179586 * (i / m) / n, b = 6.283185307179586 * (i % m) / m;
        const double thick = 0.6 + 0.3 * sin(3 * a);
        const double x = 2 * cos(a) + wave[0][0] * cos(2 * a) + 0.5 * wave[0][1] * sin(3 * a);
        const double y = 2 * sin(a) + wave[1][0] * sin(2 * a) + 0.5 * wave[1][1] * cos(3 * a);
        const double z = wave[2][0] * sin(a) + wave[2][1] * cos(2 * a) + wave[2][2] * sin(3 * a);
        text_put(text, "[%.6g, %.6g, %.6g], ", x + thick * cos(b) * cos(a),
                 y + thick * cos(b) * sin(a), z + thick * sin(b));
    }
    text_put(text, "], faces = [");
    const bool turned = dice_pick(dice, 2);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < m; j++) {
            const int a = i * m + j, b = (i + 1) % n * m + j, c = (i + 1) % n * m + (j + 1) % m;
            const int d = i * m + (j + 1) % m;
            const bool back = turned || dice_pick(dice, 20) == 0;
            if (back)
                text_put(text, "[%d, %d, %d, %d], ", a, b, c, d);
            else
                text_put(text, "[%d, %d, %d, %d], ", d, c, b, a);
        }
    text_put(text, "]);\n");
}

/* Points 0 and 1 are the ends of the edge, 2 i + 2 and 2 i + 3 those of the side across. */
void fan_put(struct text *text, int n)
{
    text_put(text, "polyhedron(points = [[0, 0, 0], [0, 0, 10]");
    for (int i = 0; i <= n; i++)
        text_put(text, ", [50, %.17g, 0], [50, %.17g, 10]", 50.0 * i / n, 50.0 * i / n);
    text_put(text, "], faces = [[0, 1, 3, 2], [0, %d, %d, 1]", 2 * n + 2, 2 * n + 3);
    for (int i = 0; i < n; i++) {
        const int a = 2 * i + 2;
        text_put(text, ", [0, %d, %d], [1, %d, %d], [%d, %d, %d, %d]", a, a + 2, a + 3, a + 1, a,
                 a + 1, a + 3, a + 2);
    }
    text_put(text, "]);\n");
}
