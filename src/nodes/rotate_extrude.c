/* SPDX-License-Identifier: MIT */
/*
 * rotate_extrude(angle, start, $fn, $fa, $fs) as OpenSCAD 2021.01 and 2025 write it. The profile is
 * a polygon, with OpenSCAD's facets for circles; the turn is exact.
 */
#include "nodes/compounds.h"
#include "nodes/drawings.h"
#include "nodes/import.h"
#include "nodes/parts.h"
#include "nodes/polyhedron.h"
#include "plane/hull.h"
#include "plane/outline.h"
#include "plane/revolve_surface.h"
#include "solids/facets.h"

/* Turns with more segments are refused in as-written mode, and OpenSCAD's meshes with more faces. */
enum { max_segments = 65536, max_faces = 5000000 };

/* From so many spans of the profile on its flat segments are drawn as a surface of triangles; each
 * span would be a ring of as many planes as the turn has segments. */
#define MIN_SURFACE_SPANS 4

struct revolution {
    struct csg_walk *walk;
    uint32_t node;
    bool in_boolean;
    struct csg_turn turn;
    struct csg_facets facets;
    bool has_file;
    bool rounds_up; /* the number of segments of a part of a turn */
    struct csg_drawing drawing;
    struct csg_profile profile; /* the same, swept */
    double rounding;            /* of its points */
    struct csg_part *part;
};

static bool no_memory(const struct revolution *revolution)
{
    return csg_walk_no_memory(revolution->walk);
}

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
static double count_segments(const struct revolution *revolution)
{
    const struct csg_profile *profile = &revolution->profile;
    const double radius = fmax(profile->hi, 0) - fmin(profile->lo, 0);
    const int all_round = csg_facets_count(&revolution->facets, radius);
    const double part = fmax(all_round * fabs(revolution->turn.angle) / 360, 1);
    return revolution->rounds_up ? ceil(part) : floor(part);
}

static bool refuse_operand(const struct revolution *revolution, double segments)
{
    const bool is_refused = revolution->walk->is_operand && segments > CSG_OPERAND_MAX_FRAGMENTS;
    if (is_refused)
        csg_walk_refuse(revolution->walk, revolution->node,
                        "rotate_extrude: it has %.0f segments, and %d are the most in a hull, "
                        "minkowski, resize or projection; a lower $fn makes less",
                        segments, CSG_OPERAND_MAX_FRAGMENTS);
    return is_refused;
}

/* Beyond max_faces in OpenSCAD's mesh, where that is what is to be drawn or asked for. */
static bool refuse_turn(const struct revolution *revolution, double segments)
{
    const double num = 2 * segments * (double)revolution->drawing.points.num;
    const bool is_refused = num > max_faces;
    if (is_refused)
        csg_walk_refuse(
            revolution->walk, revolution->node,
            "rotate_extrude: its %.0f segments have %.3g faces, the most is %d; a lower "
            "$fn there or in the profile makes less",
            segments, num, max_faces);
    return is_refused;
}

/* Flat segments of a profile with many sides, as one surface; *taken: that is there. */
static bool add_surface(struct revolution *revolution, bool *taken)
{
    struct csg_shape shape = {0};
    const enum csg_sweep_result result = csg_drawing_evaluate(&revolution->drawing, 0);
    bool ok = result != CSG_SWEEP_NO_MEMORY;
    if (result == CSG_SWEEP_DONE)
        ok = csg_revolve_surface(&shape, &revolution->drawing, &revolution->profile,
                                 &revolution->turn, revolution->rounding);
    *taken = shape.surface != NULL;
    return (ok && (!*taken || csg_part_add(revolution->part, &shape, false))) ||
           no_memory(revolution);
}

/* Only dents of so many degrees may be so shallow in OpenSCAD's facets, where these are put, that
 * it takes the hull. */
#define MAPPED_DEGREES 10.0

/* Replaces the profile of a solid that shows as its hull by its own. false, with a message, when
 * memory is out. */
static bool take_hull(struct revolution *revolution)
{
    struct csg_drawing *drawing = &revolution->drawing;
    struct csg_profile *profile = &revolution->profile;
    struct csg_mesh mesh = {0};
    struct csg_mesh_gaps gaps = {0};
    bool is_hull = false;
    const double dents = csg_profile_dents(profile);
    if (!(dents > 0 && dents < MAPPED_DEGREES) || revolution->walk->points_only)
        return true;
    enum csg_sweep_result result = csg_drawing_evaluate(drawing, 0);
    if (result == CSG_SWEEP_DONE &&
        !csg_revolve_mesh(&mesh, &gaps, drawing, profile, &revolution->turn, revolution->rounding))
        result = CSG_SWEEP_NO_MEMORY;
    bool ok = result != CSG_SWEEP_DONE || mesh.faces.num == 0 || gaps.num > 0 ||
              csg_polyhedron_find_hull(revolution->walk, revolution->node, &mesh, &is_hull);
    csg_mesh_finish(&mesh);
    if (is_hull)
        result = csg_drawing_hull(drawing, 0);
    if (is_hull && result == CSG_SWEEP_DONE) {
        csg_profile_finish(profile);
        result = csg_profile_init(profile, drawing);
    }
    return result == CSG_SWEEP_NO_MEMORY ? no_memory(revolution) : ok;
}

/* Whether flat segments make a surface. */
static bool is_surface(const struct revolution *revolution)
{
    return revolution->turn.facetted && !revolution->walk->is_operand &&
           (csg_turn_is_flat(&revolution->turn)
                ? !revolution->in_boolean
                : revolution->profile.sweep.spans.num >= MIN_SURFACE_SPANS);
}

static bool revolve(struct revolution *revolution)
{
    const struct csg_profile *profile = &revolution->profile;
    struct csg_turn *turn = &revolution->turn;
    bool taken = false;
    if (profile->lo < -profile->snap && profile->hi > profile->snap) {
        csg_walk_warning(revolution->walk, revolution->node,
                         "the profile must lie on one side of the axis, but its x reaches from %g "
                         "to %g; nothing is drawn",
                         profile->lo, profile->hi);
        return true;
    }
    if (!(profile->hi > profile->snap) && !(profile->lo < -profile->snap))
        return true;
    const double segments = count_segments(revolution);
    if (turn->facetted &&
        (refuse_operand(revolution, segments) || refuse_turn(revolution, segments)))
        return true;
    turn->num = segments < max_segments ? (int)segments : max_segments;
    /* A single segment is what lies between its two ends, on their near side. */
    if (turn->facetted && turn->num == 1 && fabs(turn->angle) > 180)
        turn->angle -= copysign(360, turn->angle);
    if (!take_hull(revolution) || (is_surface(revolution) && !add_surface(revolution, &taken)))
        return false;
    const bool ok = taken || csg_revolve(revolution->part, profile, turn, revolution->rounding);
    if (ok && revolution->part->is_too_large && refuse_turn(revolution, segments))
        csg_part_finish(revolution->part);
    return ok || no_memory(revolution);
}

/* What is turned; a drawing that is too large leaves nothing. false, with a message, when memory is
 * out. */
static bool read_and_revolve(struct revolution *revolution, const struct csg_args *args)
{
    struct csg_drawing *drawing = &revolution->drawing;
    if (!(revolution->has_file
              ? csg_import_drawing(revolution->walk, revolution->node, args,
                                   csg_args_number(args, "scale", 1, NULL), drawing)
              : csg_drawing_read(revolution->walk, revolution->node, revolution->in_boolean,
                                 drawing)))
        return false;
    const enum csg_sweep_result result = csg_profile_init(&revolution->profile, drawing);
    revolution->rounding = csg_drawing_rounding(drawing, 0, (uint32_t)drawing->nodes.num);
    revolution->part->is_too_large |= result == CSG_SWEEP_TOO_LARGE;
    if (result == CSG_SWEEP_DONE)
        return revolve(revolution);
    return result == CSG_SWEEP_TOO_LARGE || no_memory(revolution);
}

bool csg_compound_rotate_extrude(struct csg_walk *walk, uint32_t node, const struct csg_args *args,
                                 bool in_boolean, struct csg_part *part)
{
    struct revolution revolution = {
        .walk = walk, .node = node, .in_boolean = in_boolean, .part = part};
    read_revolution(args, &revolution);
    if (revolution.turn.angle == 0)
        return true;
    const bool ok = read_and_revolve(&revolution, args);
    csg_profile_finish(&revolution.profile);
    csg_drawing_finish(&revolution.drawing);
    return ok;
}
