/* SPDX-License-Identifier: MIT */
#include "ideal.h"

#include <math.h>
#include <string.h>

/* Shorter intervals than this share of the scene are rounding. */
#define MIN_INTERVAL 1e-13L

/* Neighbours further than this share of the scene from a pixel's surface see another one. */
#define SAME_SURFACE 1e-7L

/* Surfaces nearer to the eye, as a share of the coordinates, are the eye's own: the rule that
 * csgcast has for an eye on a face. */
#define NEAR_EYE 1e-11L

struct event {
    real t;
    const struct ideal_form *form;
};

struct ideal_vec ideal_vec(real x, real y, real z)
{
    return (struct ideal_vec){x, y, z};
}

struct ideal_vec ideal_add(struct ideal_vec a, struct ideal_vec b)
{
    return ideal_vec(a.x + b.x, a.y + b.y, a.z + b.z);
}

struct ideal_vec ideal_scale(real s, struct ideal_vec a)
{
    return ideal_vec(s * a.x, s * a.y, s * a.z);
}

real ideal_dot(struct ideal_vec a, struct ideal_vec b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

real ideal_length(struct ideal_vec a)
{
    return sqrtl(ideal_dot(a, a));
}

struct ideal_form ideal_plane(real x, real y, real z, real offset)
{
    struct ideal_form form = {{{0}}};
    form.q[0][3] = form.q[3][0] = 0.5L * x;
    form.q[1][3] = form.q[3][1] = 0.5L * y;
    form.q[2][3] = form.q[3][2] = 0.5L * z;
    form.q[3][3] = -offset;
    return form;
}

struct ideal_form ideal_quadric(struct ideal_vec center, real xx, real yy, real zz, real constant)
{
    struct ideal_form form = {{{xx, 0, 0, 0}, {0, yy, 0, 0}, {0, 0, zz, 0}, {0, 0, 0, 0}}};
    form.q[0][3] = form.q[3][0] = -xx * center.x;
    form.q[1][3] = form.q[3][1] = -yy * center.y;
    form.q[2][3] = form.q[3][2] = -zz * center.z;
    form.q[3][3] =
        constant + xx * center.x * center.x + yy * center.y * center.y + zz * center.z * center.z;
    return form;
}

void ideal_solid_add(struct ideal_solid *solid, struct ideal_form form)
{
    if (solid->num < IDEAL_MAX_FORMS)
        solid->forms[solid->num++] = form;
}

/* q' = A^T q A with A the inverse map: first the mirror, then the move. */
void ideal_solid_place(struct ideal_solid *solid, struct ideal_vec move, bool mirrored)
{
    const real s = mirrored ? -1 : 1, by[3] = {move.x, move.y, move.z};
    for (int i = 0; i < solid->num; i++) {
        real(*q)[4] = solid->forms[i].q;
        real old[4][4];
        for (int j = 0; j < 4; j++) {
            q[2][j] *= s;
            q[j][2] *= s;
        }
        memcpy(old, q, sizeof old);
        for (int j = 0; j < 3; j++) {
            for (int k = 0; k < 3; k++) {
                q[j][3] -= old[j][k] * by[k];
                q[3][3] += old[j][k] * by[j] * by[k];
            }
            q[3][j] = q[j][3];
            q[3][3] -= 2 * old[j][3] * by[j];
        }
    }
}

/* Rows of the inverse of map: cross products of its columns over the determinant. */
static void invert(const double map[3][4], real inverse[4][4])
{
    real det = 0;
    memset(inverse, 0, 4 * sizeof *inverse);
    inverse[3][3] = 1;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        for (int n = 0; n < 3; n++) {
            const int a = (n + 1) % 3, b = (n + 2) % 3;
            inverse[i][n] = (real)map[a][j] * map[b][k] - (real)map[b][j] * map[a][k];
        }
    }
    for (int n = 0; n < 3; n++)
        det += inverse[0][n] * map[n][0];
    for (int i = 0; i < 3; i++)
        for (int n = 0; n < 3; n++) {
            inverse[i][n] /= det;
            inverse[i][3] -= inverse[i][n] * map[n][3];
        }
}

/* q' = A^T q A with A the inverse. */
void ideal_solid_map(struct ideal_solid *solid, const double map[3][4])
{
    real a[4][4];
    invert(map, a);
    for (int f = 0; f < solid->num; f++) {
        real(*q)[4] = solid->forms[f].q;
        real half[4][4];
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < 4; j++) {
                half[i][j] = 0;
                for (int k = 0; k < 4; k++)
                    half[i][j] += q[i][k] * a[k][j];
            }
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < 4; j++) {
                q[i][j] = 0;
                for (int k = 0; k < 4; k++)
                    q[i][j] += a[k][i] * half[k][j];
            }
    }
}

real ideal_form_value(const struct ideal_form *form, struct ideal_vec p)
{
    const real v[4] = {p.x, p.y, p.z, 1};
    real sum = 0;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            sum += form->q[i][j] * v[i] * v[j];
    return sum;
}

struct ideal_vec ideal_form_gradient(const struct ideal_form *form, struct ideal_vec p)
{
    const real v[4] = {p.x, p.y, p.z, 1};
    real g[3] = {0, 0, 0};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            g[i] += 2 * form->q[i][j] * v[j];
    return ideal_vec(g[0], g[1], g[2]);
}

real ideal_form_distance(const struct ideal_form *form, struct ideal_vec p)
{
    const real slope = ideal_length(ideal_form_gradient(form, p));
    return slope > 0 ? fabsl(ideal_form_value(form, p)) / slope : 0;
}

void ideal_scene_rest(struct ideal_scene *scene)
{
    memset(scene->rotation, 0, sizeof scene->rotation);
    for (int i = 0; i < 3; i++)
        scene->rotation[i][i] = 1;
    scene->move = ideal_vec(0, 0, 0);
}

static struct ideal_vec rotate(const struct ideal_scene *scene, struct ideal_vec p, bool back)
{
    const real v[3] = {p.x, p.y, p.z};
    real out[3] = {0, 0, 0};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            out[i] += (back ? scene->rotation[j][i] : scene->rotation[i][j]) * v[j];
    return ideal_vec(out[0], out[1], out[2]);
}

struct ideal_vec ideal_to_world(const struct ideal_scene *scene, struct ideal_vec p)
{
    return ideal_add(rotate(scene, p, false), scene->move);
}

static struct ideal_vec combine(const struct csgcast_frustum *frustum, real x, real y, real z)
{
    real v[3];
    for (int i = 0; i < 3; i++)
        v[i] = x * frustum->right[i] + y * frustum->up[i] + z * frustum->forward[i];
    return ideal_vec(v[0], v[1], v[2]);
}

struct ideal_ray ideal_ray(const struct ideal_scene *scene, const struct csgcast_frustum *frustum,
                           int width, int height, real x, real y)
{
    const real sx = (2 * x / width - 1) * frustum->half_width;
    const real sy = (1 - 2 * y / height) * frustum->half_height;
    const bool flat = frustum->orthographic;
    struct ideal_vec org = ideal_vec(frustum->eye[0], frustum->eye[1], frustum->eye[2]);
    struct ideal_vec dir = combine(frustum, flat ? 0 : sx, flat ? 0 : sy, 1);
    if (flat)
        org = ideal_add(org, combine(frustum, sx, sy, 0));
    const real near = NEAR_EYE * (scene->size + ideal_length(org));
    org = ideal_add(org, ideal_scale(-1, scene->move));
    return (struct ideal_ray){rotate(scene, org, true), rotate(scene, dir, true),
                              flat ? -(real)INFINITY : near};
}

/* Roots of a t^2 + 2 b t + c. */
static int solve(real a, real b, real c, real t[2])
{
    const real disc = b * b - a * c;
    if (a == 0 && b == 0)
        return 0;
    if (a == 0) {
        t[0] = -c / (2 * b);
        return 1;
    }
    if (!(disc >= 0))
        return 0;
    const real far = -(b + copysignl(sqrtl(disc), b));
    t[0] = far / a;
    t[1] = far != 0 ? c / far : t[0];
    return 2;
}

static int cross(const struct ideal_form *form, const struct ideal_ray *ray, real t[2])
{
    const real o[4] = {ray->org.x, ray->org.y, ray->org.z, 1};
    const real d[4] = {ray->dir.x, ray->dir.y, ray->dir.z, 0};
    real a = 0, b = 0, c = 0;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            a += form->q[i][j] * d[i] * d[j];
            b += form->q[i][j] * o[i] * d[j];
            c += form->q[i][j] * o[i] * o[j];
        }
    return solve(a, b, c, t);
}

/* Crossings in order of t, by insertion: there are few. */
static int collect(const struct ideal_scene *scene, const struct ideal_ray *ray,
                   struct event *events)
{
    int num = 0;
    for (int i = 0; i < scene->num_solids; i++)
        for (int j = 0; j < scene->solids[i].num; j++) {
            const struct ideal_form *form = &scene->solids[i].forms[j];
            real t[2];
            const int roots = cross(form, ray, t);
            for (int k = 0; k < roots; k++) {
                int at = num++;
                for (; at > 0 && events[at - 1].t > t[k]; at--)
                    events[at] = events[at - 1];
                events[at] = (struct event){t[k], form};
            }
        }
    return num;
}

static bool solid_contains(const struct ideal_solid *solid, struct ideal_vec p)
{
    for (int i = 0; i < solid->num; i++)
        if (!(ideal_form_value(&solid->forms[i], p) <= 0))
            return false;
    return true;
}

static bool contains(const struct ideal_scene *scene, struct ideal_vec p)
{
    bool stack[16];
    int top = 0;
    for (const char *c = scene->rule; *c; c++) {
        if (*c >= 'a') {
            stack[top++] = solid_contains(&scene->solids[*c - 'a'], p);
            continue;
        }
        top--;
        const bool a = stack[top - 1], b = stack[top];
        stack[top - 1] = *c == '+' ? a || b : *c == '*' ? a && b : a && !b;
    }
    return stack[0];
}

static struct ideal_vec along(const struct ideal_ray *ray, real t)
{
    return ideal_add(ray->org, ideal_scale(t, ray->dir));
}

/* Solves from the point of the ray nearest to the middle of the solids: no large numbers. */
struct ideal_hit ideal_trace(const struct ideal_scene *scene, const struct ideal_ray *ray)
{
    struct event events[2 * IDEAL_MAX_FORMS * IDEAL_MAX_SOLIDS];
    const real dd = ideal_dot(ray->dir, ray->dir);
    const real shift = -ideal_dot(ray->org, ray->dir) / dd;
    const struct ideal_ray near = {along(ray, shift), ray->dir, ray->tnear - shift};
    const real shortest = MIN_INTERVAL * scene->size / sqrtl(dd);
    const int num = collect(scene, &near, events);
    struct ideal_hit hit = {.t = INFINITY};
    int i = 0;
    while (i < num && events[i].t <= near.tnear)
        i++;
    const real start = isinf(near.tnear) ? (num ? events[0].t : 0) - 2 * scene->size : near.tnear;
    hit.from_inside =
        contains(scene, along(&near, i < num ? 0.5L * (start + events[i].t) : start + scene->size));
    for (; i < num; i++) {
        const real next = i + 1 < num ? events[i + 1].t : events[i].t + scene->size;
        if (next - events[i].t < shortest)
            continue;
        if (contains(scene, along(&near, 0.5L * (events[i].t + next))) == hit.from_inside)
            continue;
        hit.hit = true;
        hit.t = events[i].t + shift;
        hit.point = along(&near, events[i].t);
        hit.form = events[i].form;
        hit.normal = ideal_form_gradient(hit.form, hit.point);
        const real length = ideal_length(hit.normal);
        const real s = ideal_dot(hit.normal, ray->dir) > 0 ? -1 : 1;
        hit.normal = ideal_scale(length > 0 ? s / length : 0, hit.normal);
        break;
    }
    return hit;
}

static bool sees_same(const struct ideal_scene *scene, const struct ideal_hit *here,
                      const struct ideal_hit *there)
{
    if (here->hit != there->hit)
        return false;
    return !here->hit ||
           (ideal_form_distance(here->form, there->point) < SAME_SURFACE * scene->size &&
            ideal_form_distance(there->form, here->point) < SAME_SURFACE * scene->size &&
            ideal_dot(here->normal, there->normal) > 0.7L);
}

bool ideal_is_edge(const struct ideal_scene *scene, const struct csgcast_frustum *frustum,
                   int width, int height, int x, int y)
{
    struct ideal_ray ray = ideal_ray(scene, frustum, width, height, x + 0.5L, y + 0.5L);
    const struct ideal_hit here = ideal_trace(scene, &ray);
    for (int v = -2; v <= 2; v++)
        for (int u = -2; u <= 2; u++) {
            ray = ideal_ray(scene, frustum, width, height, x + 0.5L * (1 + u), y + 0.5L * (1 + v));
            const struct ideal_hit there = ideal_trace(scene, &ray);
            if (!sees_same(scene, &here, &there))
                return true;
        }
    return false;
}

double ideal_silhouette(const struct ideal_scene *scene, const struct csgcast_frustum *frustum,
                        int width, int height, int x, int y)
{
    struct ideal_ray ray = ideal_ray(scene, frustum, width, height, x + 0.5L, y + 0.5L);
    const bool hit = ideal_trace(scene, &ray).hit;
    for (real reach = 1e-10L; reach <= 1; reach *= 2)
        for (int i = 0; i < 8; i++) {
            static const int steps[8][2] = {{1, 0}, {0, 1},  {-1, 0}, {0, -1},
                                            {1, 1}, {1, -1}, {-1, 1}, {-1, -1}};
            ray = ideal_ray(scene, frustum, width, height, x + 0.5L + reach * steps[i][0],
                            y + 0.5L + reach * steps[i][1]);
            if (ideal_trace(scene, &ray).hit != hit)
                return (double)reach;
        }
    return 2;
}
