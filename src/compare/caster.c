/* SPDX-License-Identifier: MIT */
#include "compare/caster.h"

#include "common/array.h"

#include <embree3/rtcore.h>
#include <float.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

/*
 * Boxes are padded by this part of the mesh's radius: Embree walks its tree in float, and its ray
 * deviates from the double one by a few 2^-24 of the way through the mesh.
 */
#define BOX_PADDING 4e-6

/*
 * Two crossings closer than this part of the radius bound a skin or a gap that only rounding made:
 * Manifold's faces that ought to coincide are some 1e-15 apart when separate matrices placed them.
 */
#define SKIN_THICKNESS 1e-10

struct crossing {
    double t;
    struct csg_vec3 normal;
    bool enters;
};

struct embree_caster {
    struct csg_caster base; /* first, so that a cast leads back */
    RTCDevice device;
    RTCScene scene;
    struct csg_vec3 center; /* subtracted from all vertices, so that floats hold them well */
    double radius;
    size_t num_triangles;
    struct csg_triangle *triangles;
    CSG_ARRAY(struct crossing) crossings; /* of the ray in flight */
};

/* Embree hands the context through to the callback: this is how the double ray gets there. */
struct query {
    struct RTCIntersectContext context; /* first, so that a cast leads back to the query */
    struct embree_caster *caster;
    struct csg_vec3 org, dir;
    double tnear;
};

static void set_bounds(const struct RTCBoundsFunctionArguments *args)
{
    const struct embree_caster *caster = args->geometryUserPtr;
    const struct csg_triangle *triangle = &caster->triangles[args->primID];
    const double pad = BOX_PADDING * caster->radius + DBL_MIN;
    struct csg_box box = csg_box_empty;
    for (int i = 0; i < 3; i++)
        csg_box_extend(&box, triangle->corner[i]);
    args->bounds_o->lower_x = (float)(box.lo.x - pad);
    args->bounds_o->lower_y = (float)(box.lo.y - pad);
    args->bounds_o->lower_z = (float)(box.lo.z - pad);
    args->bounds_o->upper_x = (float)(box.hi.x + pad);
    args->bounds_o->upper_y = (float)(box.hi.y + pad);
    args->bounds_o->upper_z = (float)(box.hi.z + pad);
}

/*
 * The ray passes inside when it sees all three edges turn the same way. The edge function that two
 * triangles have of their common edge differs in sign only, to the last bit: no ray slips through.
 */
static bool passes_inside(struct csg_vec3 dir, struct csg_vec3 a, struct csg_vec3 b,
                          struct csg_vec3 c)
{
    const double u = csg_dot(dir, csg_cross(a, b));
    const double v = csg_dot(dir, csg_cross(b, c));
    const double w = csg_dot(dir, csg_cross(c, a));
    return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

static void intersect(const struct RTCIntersectFunctionNArguments *args)
{
    struct query *query = (struct query *)args->context;
    struct embree_caster *caster = query->caster;
    const struct csg_triangle *triangle = &caster->triangles[args->primID];
    const struct csg_vec3 a = csg_sub(triangle->corner[0], query->org);
    const struct csg_vec3 b = csg_sub(triangle->corner[1], query->org);
    const struct csg_vec3 c = csg_sub(triangle->corner[2], query->org);
    const struct csg_vec3 normal = csg_cross(csg_sub(b, a), csg_sub(c, a));
    const double slope = csg_dot(normal, query->dir);
    if (slope == 0 || !passes_inside(query->dir, a, b, c))
        return;
    const struct crossing crossing = {
        .t = csg_dot(normal, a) / slope,
        .normal = csg_normalize(normal),
        .enters = slope < 0,
    };
    if (crossing.t >= query->tnear && !csg_array_push(&caster->crossings, crossing))
        caster->base.failed = true;
}

static bool create_scene(struct embree_caster *caster)
{
    caster->device = rtcNewDevice("threads=1");
    if (!caster->device)
        return false;
    caster->scene = rtcNewScene(caster->device);
    RTCGeometry geometry = rtcNewGeometry(caster->device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, (unsigned)caster->num_triangles);
    rtcSetGeometryUserData(geometry, caster);
    rtcSetGeometryBoundsFunction(geometry, set_bounds, NULL);
    rtcSetGeometryIntersectFunction(geometry, intersect);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(caster->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(caster->scene, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(caster->scene);
    return rtcGetDeviceError(caster->device) == RTC_ERROR_NONE;
}

static void copy_centered(struct embree_caster *caster, const struct csg_soup *soup)
{
    if (soup->num_triangles > 0) {
        const struct csg_vec3 diagonal = csg_sub(soup->bounds.hi, soup->bounds.lo);
        caster->center = csg_box_middle(&soup->bounds);
        caster->radius = 0.5 * csg_length(diagonal);
    }
    for (size_t i = 0; i < soup->num_triangles; i++)
        for (int k = 0; k < 3; k++)
            caster->triangles[i].corner[k] = csg_sub(soup->triangles[i].corner[k], caster->center);
}

static int compare_crossings(const void *left, const void *right)
{
    const struct crossing *a = left, *b = right;
    return (a->t > b->t) - (a->t < b->t);
}

/* The first crossing that is not one side of a skin. Crossings are sorted. */
static struct csg_mesh_hit first_hit(const struct embree_caster *caster, double dir_length)
{
    const double thickness = SKIN_THICKNESS * caster->radius / dir_length;
    const struct crossing *crossings = caster->crossings.data;
    const size_t num = caster->crossings.num;
    size_t i = 0;
    while (i + 1 < num && crossings[i].enters != crossings[i + 1].enters &&
           crossings[i + 1].t - crossings[i].t <= thickness)
        i += 2;
    const double skin = i > 0 ? crossings[0].t : INFINITY;
    if (i >= num)
        return (struct csg_mesh_hit){.found = false, .skin = skin};
    return (struct csg_mesh_hit){
        .found = true, .t = crossings[i].t, .normal = crossings[i].normal, .skin = skin};
}

/* Embree's own ray starts where the mesh's sphere does: floats are coarse far from the mesh. */
static void shoot(struct query *query, double start)
{
    const struct csg_vec3 org = csg_add(query->org, csg_scale(start, query->dir));
    struct RTCRayHit rayhit = {
        .ray = {.org_x = (float)org.x,
                .org_y = (float)org.y,
                .org_z = (float)org.z,
                .dir_x = (float)query->dir.x,
                .dir_y = (float)query->dir.y,
                .dir_z = (float)query->dir.z,
                .tnear = 0,
                .tfar = INFINITY,
                .mask = UINT32_MAX},
        .hit = {.geomID = RTC_INVALID_GEOMETRY_ID},
    };
    rtcInitIntersectContext(&query->context);
    rtcIntersect1(query->caster->scene, &query->context, &rayhit);
}

static struct csg_mesh_hit trace(struct csg_caster *base, const struct csg_mesh_ray *ray)
{
    struct embree_caster *caster = (struct embree_caster *)base;
    const double length = csg_length(ray->dir);
    struct query query = {
        .caster = caster,
        .org = csg_sub(ray->org, caster->center),
        .dir = ray->dir,
        .tnear = ray->tnear,
    };
    if (caster->num_triangles == 0)
        return (struct csg_mesh_hit){.found = false, .skin = INFINITY};
    const double closest = -csg_dot(query.org, query.dir) / (length * length);
    caster->crossings.num = 0;
    shoot(&query, closest - 1.01 * caster->radius / length);
    if (caster->crossings.num)
        qsort(caster->crossings.data, caster->crossings.num, sizeof *caster->crossings.data,
              compare_crossings);
    return first_hit(caster, length);
}

static void destroy(struct csg_caster *base)
{
    struct embree_caster *caster = (struct embree_caster *)base;
    if (caster->scene)
        rtcReleaseScene(caster->scene);
    if (caster->device)
        rtcReleaseDevice(caster->device);
    free(caster->crossings.data);
    free(caster->triangles);
    free(caster);
}

struct csg_caster *csg_caster_create(const struct csg_soup *soup, const struct csg_log *log)
{
    struct embree_caster *caster = calloc(1, sizeof *caster);
    struct csg_triangle *triangles = calloc(soup->num_triangles + 1, sizeof *triangles);
    if (!caster || !triangles) {
        free(caster);
        free(triangles);
        csg_log_memory(log);
        return NULL;
    }
    caster->base = (struct csg_caster){.trace = trace, .destroy = destroy};
    caster->num_triangles = soup->num_triangles;
    caster->triangles = triangles;
    copy_centered(caster, soup);
    if (create_scene(caster))
        return &caster->base;
    csg_log_error(log, CSGCAST_MESSAGE_FILE, "Embree cannot take a mesh of %zu triangles",
                  soup->num_triangles);
    destroy(&caster->base);
    return NULL;
}
