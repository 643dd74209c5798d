/* SPDX-License-Identifier: MIT */
/*
 * rotate_extrude(angle, start, $fn, $fa, $fs) as OpenSCAD 2021.01 and 2025 write it. The profile is
 * a polygon, with OpenSCAD's facets for circles; the turn is exact.
 */
#include "nodes/compounds.h"
#include "nodes/drawings.h"
#include "nodes/import.h"
#include "nodes/polyhedron.h"
#include "plane/hull.h"
#include "plane/outline.h"
#include "plane/revolve_surface.h"
#include "solids/facets.h"

/* Turns with more segments are refused in as-written mode. */
enum { max_segments = 65536 };

/* From so many spans of the profile on its flat segments are drawn as a surface of triangles; each
 * span would be a ring of as many planes as the turn has segments. */
#define MIN_SURFACE_SPANS 4

struct revolution {
    struct csg_turn turn;
    struct csg_facets facets;
    bool has_file;
    bool rounds_up; /* the number of segments of a part of a turn */
};

/* OpenSCAD turns all round for an angle outside of (-360, 360], and starts on -x then. */
static void read_revolution(const struct csg_args *args, struct revolution *to)
{
    const struct csg_value *file = csg_args_find(args, "file");
    double angle = csg_args_number(args, "angle", 360, NULL);
    if (!(angle > -360 && angle <= 360))
        angle = 360;
    to->turn.angle = angle;
    to->turn.start = csg_args_number(args, "start", angle >= 360 ? 180 : 0, NULL);
    if (!isfinite(to->turn.start))
        to->turn.start = 0;
    to->rounds_up = csg_args_find(args, "start") != NULL;
    to->facets = csg_args_facets(args);
    to->turn.facetted = csg_facets_wanted(args, &to->facets);
    to->has_file = file && file->type == CSG_VALUE_STRING && file->num > 0;
}

/* Segments of the turn: those of a circle as large as the profile. OpenSCAD 2021.01 leaves a part
 * of one out (GeometryEvaluator.cc), 2025, which always writes start, does not. */
static int count_segments(const struct revolution *revolution, const struct csg_profile *profile)
{
    const double radius = fmax(profile->hi, 0) - fmin(profile->lo, 0);
    const int all_round = csg_facets_count(&revolution->facets, radius);
    const double part = fmax(all_round * fabs(revolution->turn.angle) / 360, 1);
    const double num = revolution->rounds_up ? ceil(part) : floor(part);
    return num < max_segments ? (int)num : max_segments;
}

/* Flat segments of a profile with many sides, as one surface; *taken: that is there. */
static bool add_surface(struct csg_drawing *drawing, const struct csg_turn *turn,
                        const struct csg_profile *profile, double rounding, struct csg_part *part,
                        bool *taken)
{
    struct csg_shape shape = {0};
    const enum csg_sweep_result result = csg_drawing_evaluate(drawing, 0);
    bool ok = result != CSG_SWEEP_NO_MEMORY;
    if (result == CSG_SWEEP_DONE)
        ok = csg_revolve_surface(&shape, drawing, profile, turn, rounding);
    *taken = shape.surface != NULL;
    return ok && (!*taken || csg_part_add(part, &shape, false));
}

/* Only dents of so many degrees may be so shallow in OpenSCAD's facets, where these are put, that
 * it takes the hull. */
#define MAPPED_DEGREES 10.0

/* Replaces the profile of a solid that shows as its hull by its own. false, with a message, when
 * memory is out. */
static bool take_hull(struct csg_walk *walk, uint32_t node, const struct csg_turn *turn,
                      struct csg_drawing *drawing, struct csg_profile *profile, double rounding)
{
    struct csg_mesh mesh = {0};
    struct csg_mesh_gaps gaps = {0};
    bool is_hull = false;
    const double dents = csg_profile_dents(profile);
    if (!(dents > 0 && dents < MAPPED_DEGREES) || walk->points_only)
        return true;
    enum csg_sweep_result result = csg_drawing_evaluate(drawing, 0);
    if (result == CSG_SWEEP_DONE &&
        !csg_revolve_mesh(&mesh, &gaps, drawing, profile, turn, rounding))
        result = CSG_SWEEP_NO_MEMORY;
    bool ok = result != CSG_SWEEP_DONE || mesh.faces.num == 0 || gaps.num > 0 ||
              csg_polyhedron_find_hull(walk, node, &mesh, &is_hull);
    csg_mesh_finish(&mesh);
    if (is_hull)
        result = csg_drawing_hull(drawing, 0);
    if (is_hull && result == CSG_SWEEP_DONE) {
        csg_profile_finish(profile);
        result = csg_profile_init(profile, drawing);
    }
    if (result == CSG_SWEEP_NO_MEMORY)
        ok = csg_log_memory(&walk->builder->report->log);
    return ok;
}

static bool revolve(struct csg_walk *walk, uint32_t node, struct revolution *revolution,
                    struct csg_drawing *drawing, struct csg_profile *profile, double rounding,
                    bool in_boolean, struct csg_part *part)
{
    if (profile->lo < -profile->snap && profile->hi > profile->snap) {
        csg_walk_warning(walk, node,
                         "the profile must lie on one side of the axis, but its x reaches from %g "
                         "to %g; nothing is drawn",
                         profile->lo, profile->hi);
        return true;
    }
    if (!(profile->hi > profile->snap) && !(profile->lo < -profile->snap))
        return true;
    revolution->turn.num = count_segments(revolution, profile);
    /* A single segment is what lies between its two ends, on their near side. */
    if (revolution->turn.facetted && revolution->turn.num == 1 &&
        fabs(revolution->turn.angle) > 180)
        revolution->turn.angle -= copysign(360, revolution->turn.angle);
    if (!take_hull(walk, node, &revolution->turn, drawing, profile, rounding))
        return false;
    bool taken = false;
    const bool is_surface = csg_turn_is_flat(&revolution->turn)
                                ? !in_boolean
                                : profile->sweep.spans.num >= MIN_SURFACE_SPANS;
    if (revolution->turn.facetted && !walk->is_operand && is_surface &&
        !add_surface(drawing, &revolution->turn, profile, rounding, part, &taken))
        return csg_walk_no_memory(walk);
    return taken || csg_revolve(part, profile, &revolution->turn, rounding) ||
           csg_walk_no_memory(walk);
}

bool csg_compound_rotate_extrude(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                                 bool in_boolean, struct csg_part *part)
{
    struct revolution revolution = {0};
    struct csg_drawing drawing = {0};
    struct csg_profile profile = {0};
    read_revolution(args, &revolution);
    if (revolution.turn.angle == 0)
        return true;
    bool ok = revolution.has_file
                  ? csg_import_drawing(walk, node, args, csg_args_number(args, "scale", 1, NULL),
                                       &drawing)
                  : csg_drawing_read(walk, node, in_boolean, &drawing);
    if (ok) {
        const enum csg_sweep_result result = csg_profile_init(&profile, &drawing);
        const double rounding = csg_drawing_rounding(&drawing, 0, (uint32_t)drawing.nodes.num);
        part->is_too_large |= result == CSG_SWEEP_TOO_LARGE;
        if (result == CSG_SWEEP_DONE)
            ok = revolve(walk, node, &revolution, &drawing, &profile, rounding, in_boolean, part);
        else
            ok = result == CSG_SWEEP_TOO_LARGE || csg_walk_no_memory(walk);
    }
    csg_profile_finish(&profile);
    csg_drawing_finish(&drawing);
    return ok;
}
