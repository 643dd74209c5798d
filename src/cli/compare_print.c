/* SPDX-License-Identifier: MIT */

/* The figures of `csgcast compare`, for people and for machines. */

#include "compare.h"
#include "json.h"

#include <math.h>

void csg_compare_thresholds(const struct csg_compared *compared,
                            struct csg_threshold thresholds[CSG_NUM_THRESHOLDS])
{
    const struct csg_compare_limits *limits = &compared->options->compare.limits;
    const struct csg_compared_total *total = &compared->total;
    thresholds[0] = (struct csg_threshold){"max-wrong", "of the mesh's pixels", limits->wrong,
                                           total->wrong, false};
    thresholds[1] = (struct csg_threshold){"min-iou", "", limits->iou, total->iou, true};
    thresholds[2] = (struct csg_threshold){"max-depth-error", "scene units", limits->depth,
                                           total->depth.max, false};
    thresholds[3] = (struct csg_threshold){"max-depth-p99", "scene units", limits->depth_p99,
                                           total->depth.p99, false};
    thresholds[4] = (struct csg_threshold){"max-normal-p99", "degrees", limits->normal_p99,
                                           total->normal.p99, false};
}

bool csg_threshold_is_judged(const struct csg_threshold *threshold)
{
    return threshold->is_minimum ? threshold->limit > 0 : isfinite(threshold->limit);
}

bool csg_threshold_holds(const struct csg_threshold *threshold)
{
    return threshold->is_minimum ? threshold->value >= threshold->limit
                                 : threshold->value <= threshold->limit;
}

/* ---- for people ----------------------------------------------------------------------------- */

static void print_errors(const char *name, const struct csg_errors *errors, const char *unit,
                         const struct csg_compared_view *view)
{
    const struct csg_vec3 p = csg_compared_position(view, errors->x, errors->y);
    printf("  %-15s mean %.3g, 99%% %.3g, max %.3g %s at pixel %d,%d (%.6g %.6g %.6g)\n", name,
           errors->mean, errors->p99, errors->max, unit, errors->x, errors->y, p.x, p.y, p.z);
}

static void print_view(const struct csg_compared_view *view)
{
    const struct csg_comparison *r = &view->result;
    printf("\n%s\n", view->label);
    printf("  silhouette      IoU %.6f: %zu pixels, %zu only in the mesh, %zu only in csgcast\n",
           csg_comparison_iou(r), r->num_hits, r->num_missing, r->num_extra);
    if (r->num_compared) {
        print_errors("depth error", &r->depth, "scene units", view);
        print_errors("across surface", &r->offset, "scene units", view);
        print_errors("normal error", &r->normal, "degrees", view);
    }
    printf("  wrong           %zu pixels\n", view->num_wrong);
}

static void print_total(const struct csg_compared *compared)
{
    const struct csg_compared_total *t = &compared->total;
    printf("\nall views\n  silhouette      IoU %.6f\n  wrong           %zu pixels, %.3g of the "
           "mesh's\n",
           t->iou, t->num_wrong, t->wrong);
    printf("  depth error     mean %.3g, 99%% %.3g, max %.3g scene units\n", t->depth.mean,
           t->depth.p99, t->depth.max);
    printf("  normal error    mean %.3g, 99%% %.3g, max %.3g degrees\n", t->normal.mean,
           t->normal.p99, t->normal.max);
    if (compared->by_facets)
        printf("  sagitta         OpenSCAD's facets are at most %.3g scene units off the surface "
               "drawn; "
               "seen: %.3g\n",
               compared->sagitta, t->facets);
    else if (compared->options->compare.sagitta > 0)
        printf("  sagitta         %.3g scene units across the surface are allowed\n",
               compared->options->compare.sagitta);
}

static void print_verdict(const struct csg_compared *compared)
{
    struct csg_threshold thresholds[CSG_NUM_THRESHOLDS];
    csg_compare_thresholds(compared, thresholds);
    printf("\n");
    for (int i = 0; i < CSG_NUM_THRESHOLDS; i++) {
        const struct csg_threshold *t = &thresholds[i];
        if (csg_threshold_is_judged(t))
            printf("%-6s --%s=%g: %.6g %s\n", csg_threshold_holds(t) ? "within" : "BEYOND",
                   t->option, t->limit, t->value, t->unit);
    }
}

void csg_compare_print(const struct csg_compared *compared)
{
    printf("scene             %s\n", compared->options->input);
    printf("mesh              %s: %zu triangles", compared->mesh_name, compared->num_triangles);
    if (compared->mesh_seconds > 0)
        printf(", made in %.2f s", compared->mesh_seconds);
    printf("\nfacets            %s\nwrong means       %s\n", compared->options->facets,
           compared->by_facets
               ? "off the edges and drawn with OpenSCAD's facets, still not the mesh's surface"
               : "off the edges, not the mesh's surface within the tolerance");
    for (int i = 0; i < compared->num_views; i++)
        print_view(&compared->views[i]);
    print_total(compared);
    print_verdict(compared);
}

/* ---- for machines --------------------------------------------------------------------------- */

static void json_errors(struct csg_json *json, const char *key, const struct csg_errors *errors,
                        const struct csg_compared_view *view)
{
    csg_json_open(json, key);
    csg_json_number(json, "mean", errors->mean);
    csg_json_number(json, "p99", errors->p99);
    csg_json_number(json, "p999", errors->p999);
    csg_json_number(json, "max", errors->max);
    if (view) {
        const struct csg_vec3 p = csg_compared_position(view, errors->x, errors->y);
        const double position[3] = {p.x, p.y, p.z};
        csg_json_size(json, "x", (size_t)errors->x);
        csg_json_size(json, "y", (size_t)errors->y);
        csg_json_vector(json, "position", position);
    }
    csg_json_close(json);
}

static void json_camera(struct csg_json *json, const struct csgcast_frustum *frustum)
{
    csg_json_open(json, "camera");
    csg_json_string(json, "projection", frustum->orthographic ? "orthographic" : "perspective");
    csg_json_vector(json, "eye", frustum->eye);
    csg_json_vector(json, "right", frustum->right);
    csg_json_vector(json, "up", frustum->up);
    csg_json_vector(json, "forward", frustum->forward);
    csg_json_number(json, "half_width", frustum->half_width);
    csg_json_number(json, "half_height", frustum->half_height);
    csg_json_close(json);
}

static void json_view(struct csg_json *json, const struct csg_compared_view *view)
{
    const struct csg_comparison *r = &view->result;
    csg_json_open(json, NULL);
    csg_json_string(json, "view", view->label);
    json_camera(json, &view->mesh.frustum);
    csg_json_size(json, "width", (size_t)view->mesh.width);
    csg_json_size(json, "height", (size_t)view->mesh.height);
    csg_json_number(json, "iou", csg_comparison_iou(r));
    csg_json_size(json, "mesh_pixels", r->num_hits);
    csg_json_size(json, "only_mesh", r->num_missing);
    csg_json_size(json, "only_csgcast", r->num_extra);
    csg_json_size(json, "compared", r->num_compared);
    csg_json_size(json, "wrong", view->num_wrong);
    json_errors(json, "depth", &r->depth, view);
    json_errors(json, "relative_depth", &r->relative, view);
    json_errors(json, "across", &r->offset, view);
    json_errors(json, "normal", &r->normal, view);
    csg_json_close(json);
}

static bool json_thresholds(struct csg_json *json, const struct csg_compared *compared)
{
    struct csg_threshold thresholds[CSG_NUM_THRESHOLDS];
    bool all = true;
    csg_compare_thresholds(compared, thresholds);
    csg_json_list_open(json, "thresholds");
    for (int i = 0; i < CSG_NUM_THRESHOLDS; i++) {
        const struct csg_threshold *t = &thresholds[i];
        if (!csg_threshold_is_judged(t))
            continue;
        csg_json_open(json, NULL);
        csg_json_string(json, "option", t->option);
        csg_json_number(json, "limit", t->limit);
        csg_json_number(json, "value", t->value);
        csg_json_bool(json, "within", csg_threshold_holds(t));
        csg_json_close(json);
        all = all && csg_threshold_holds(t);
    }
    csg_json_list_close(json);
    return all;
}

static void json_total(struct csg_json *json, const struct csg_compared *compared)
{
    const struct csg_compared_total *t = &compared->total;
    csg_json_number(json, "iou", t->iou);
    csg_json_size(json, "mesh_pixels", t->num_hits);
    csg_json_size(json, "only_mesh", t->num_missing);
    csg_json_size(json, "only_csgcast", t->num_extra);
    csg_json_size(json, "compared", t->num_compared);
    csg_json_size(json, "wrong", t->num_wrong);
    csg_json_number(json, "wrong_share", t->wrong);
    csg_json_number(json, "sagitta", compared->sagitta);
    if (compared->by_facets)
        csg_json_number(json, "sagitta_seen", t->facets);
    json_errors(json, "depth", &t->depth, NULL);
    json_errors(json, "relative_depth", &t->relative, NULL);
    json_errors(json, "across", &t->offset, NULL);
    json_errors(json, "normal", &t->normal, NULL);
}

void csg_compare_print_json(const struct csg_compared *compared)
{
    struct csg_json json = {.file = stdout};
    csg_json_open(&json, NULL);
    csg_json_string(&json, "scene", compared->options->input);
    csg_json_string(&json, "version", csgcast_version());
    csg_json_string(&json, "mesh", compared->mesh_name);
    csg_json_size(&json, "triangles", compared->num_triangles);
    csg_json_number(&json, "mesh_seconds", compared->mesh_seconds);
    csg_json_number(&json, "radius", compared->radius);
    csg_json_string(&json, "facets", compared->options->facets);
    json_total(&json, compared);
    csg_json_list_open(&json, "views");
    for (int i = 0; i < compared->num_views; i++)
        json_view(&json, &compared->views[i]);
    csg_json_list_close(&json);
    const bool within = json_thresholds(&json, compared);
    csg_json_string(&json, "verdict", within ? "within" : "beyond");
    csg_json_close(&json);
}
