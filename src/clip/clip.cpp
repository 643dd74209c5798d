/* SPDX-License-Identifier: MIT */
/*
 * csgcast-clip.so: Booleans of drawings as OpenSCAD 2021.01 makes them (clipper-utils.cc): on a
 * grid of 2^-16, to which coordinates are cut off, with operands cleaned by the even-odd rule
 * first, and corners left out that are within a grid step of a straight side.
 */
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <vector>

#include <polyclipping/clipper.hpp>

#include "clip/module.h"

using ClipperLib::Clipper;
using ClipperLib::Path;
using ClipperLib::Paths;
using ClipperLib::PolyTree;

namespace
{

constexpr double scale = 65536;

/* Clipper takes integers up to 2^62, and products of differences must stay below 2^127. */
constexpr double max_coordinate = 1e13;

bool is_too_large(const csg_clip_path *paths, size_t num)
{
    for (size_t i = 0; i < num; i++)
        for (size_t k = 0; k < 2 * paths[i].num; k++)
            if (!(std::fabs(paths[i].points[k]) < max_coordinate))
                return true;
    return false;
}

/* Contours of a figure that is no outline yet all run one way. */
Path path_of(const csg_clip_path &from)
{
    Path path;
    for (size_t i = 0; i < from.num; i++)
        path.emplace_back(static_cast<ClipperLib::cInt>(from.points[2 * i] * scale),
                          static_cast<ClipperLib::cInt>(from.points[2 * i + 1] * scale));
    if (!from.is_outline && !ClipperLib::Orientation(path))
        std::reverse(path.begin(), path.end());
    return path;
}

void clean(const Paths &paths, PolyTree &result)
{
    Clipper clipper;
    clipper.AddPaths(paths, ClipperLib::ptSubject, true);
    clipper.Execute(ClipperLib::ctUnion, result, ClipperLib::pftEvenOdd);
}

Paths clean(const Paths &paths)
{
    PolyTree tree;
    Paths result;
    clean(paths, tree);
    ClipperLib::PolyTreeToPaths(tree, result);
    return result;
}

/* The paths of each operand, figure by figure. */
std::vector<Paths> collect(uint32_t num_operands, const csg_clip_path *paths, size_t num)
{
    std::vector<Paths> operands(num_operands);
    for (size_t i = 0; i < num;) {
        const csg_clip_path &first = paths[i];
        Paths figure;
        for (; i < num && paths[i].figure == first.figure; i++)
            figure.push_back(path_of(paths[i]));
        if (!first.is_outline)
            figure = clean(figure);
        Paths &operand = operands[first.operand];
        operand.insert(operand.end(), figure.begin(), figure.end());
    }
    return operands;
}

ClipperLib::ClipType type_of(csg_clip_op op)
{
    if (op == CSG_CLIP_DIFFERENCE)
        return ClipperLib::ctDifference;
    return op == CSG_CLIP_INTERSECTION ? ClipperLib::ctIntersection : ClipperLib::ctUnion;
}

void execute(csg_clip_op op, const std::vector<Paths> &operands, PolyTree &result)
{
    Clipper clipper;
    for (size_t i = 0; i < operands.size(); i++)
        clipper.AddPaths(operands[i], i == 0 ? ClipperLib::ptSubject : ClipperLib::ptClip, true);
    clipper.Execute(type_of(op), result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
}

/* One after the other. */
void intersect(const std::vector<Paths> &operands, PolyTree &result)
{
    Paths so_far = operands[0];
    for (size_t i = 1; i < operands.size(); i++) {
        execute(CSG_CLIP_INTERSECTION, {so_far, operands[i]}, result);
        ClipperLib::PolyTreeToPaths(result, so_far);
    }
}

bool hand_over(const PolyTree &tree, const csg_clip_sink &sink)
{
    for (const ClipperLib::PolyNode *node = tree.GetFirst(); node; node = node->GetNext()) {
        Path path;
        ClipperLib::CleanPolygon(node->Contour, path);
        if (path.size() < 3)
            continue;
        if (!sink.begin_contour(sink.user))
            return false;
        for (const ClipperLib::IntPoint &point : path)
            if (!sink.add_point(sink.user, static_cast<double>(point.X) / scale,
                                static_cast<double>(point.Y) / scale))
                return false;
    }
    return true;
}

void clean(const csg_clip_path *paths, size_t num, PolyTree &result)
{
    Paths figure;
    for (size_t i = 0; i < num; i++)
        figure.push_back(path_of(paths[i]));
    clean(figure, result);
}

csg_clip_result combine(csg_clip_op op, uint32_t num_operands, const csg_clip_path *paths,
                        size_t num_paths, const csg_clip_sink *sink)
{
    if (is_too_large(paths, num_paths))
        return CSG_CLIP_TOO_LARGE;
    try {
        PolyTree result;
        if (op == CSG_CLIP_CLEAN) {
            clean(paths, num_paths, result);
            return hand_over(result, *sink) ? CSG_CLIP_DONE : CSG_CLIP_NO_MEMORY;
        }
        const std::vector<Paths> operands = collect(num_operands, paths, num_paths);
        if (op == CSG_CLIP_INTERSECTION && operands.size() >= 2)
            intersect(operands, result);
        else if (!operands.empty())
            execute(op, operands, result);
        return hand_over(result, *sink) ? CSG_CLIP_DONE : CSG_CLIP_NO_MEMORY;
    } catch (const ClipperLib::clipperException &) {
        return CSG_CLIP_TOO_LARGE;
    } catch (const std::exception &) {
        return CSG_CLIP_NO_MEMORY;
    }
}

/* ---- offsets -------------------------------------------------------------------------------- */

/* What OpenSCAD allows a mitered corner, in units of the distance. */
constexpr double miter_limit = 1e6;

ClipperLib::JoinType join_of(csg_clip_join join)
{
    if (join == CSG_CLIP_JOIN_ROUND)
        return ClipperLib::jtRound;
    return join == CSG_CLIP_JOIN_BEVEL ? ClipperLib::jtSquare : ClipperLib::jtMiter;
}

csg_clip_result offset(const csg_clip_offset *how, const csg_clip_path *paths, size_t num,
                       const csg_clip_sink *sink)
{
    if (is_too_large(paths, num) || !(std::fabs(how->distance) < max_coordinate))
        return CSG_CLIP_TOO_LARGE;
    try {
        ClipperLib::ClipperOffset mover(miter_limit, how->tolerance * scale);
        PolyTree result;
        for (size_t i = 0; i < num; i++)
            mover.AddPath(path_of(paths[i]), join_of(how->join), ClipperLib::etClosedPolygon);
        mover.Execute(result, how->distance * scale);
        return hand_over(result, *sink) ? CSG_CLIP_DONE : CSG_CLIP_NO_MEMORY;
    } catch (const ClipperLib::clipperException &) {
        return CSG_CLIP_TOO_LARGE;
    } catch (const std::exception &) {
        return CSG_CLIP_NO_MEMORY;
    }
}

/* ---- strokes -------------------------------------------------------------------------------- */

constexpr double stroke_scale = 10000;

/* A round end of a wider stroke would have more than 100,000 corners. */
constexpr double max_width = 1e5;

ClipperLib::EndType cap_of(csg_clip_cap cap)
{
    if (cap == CSG_CLIP_CAP_ROUND)
        return ClipperLib::etOpenRound;
    return cap == CSG_CLIP_CAP_BUTT ? ClipperLib::etOpenButt : ClipperLib::etOpenSquare;
}

bool hand_over(const Paths &paths, const csg_clip_sink &sink)
{
    for (const Path &path : paths) {
        if (!sink.begin_contour(sink.user))
            return false;
        for (const ClipperLib::IntPoint &point : path)
            if (!sink.add_point(sink.user, static_cast<double>(point.X) / stroke_scale,
                                static_cast<double>(point.Y) / stroke_scale))
                return false;
    }
    return true;
}

csg_clip_result stroke(const double *points, size_t num, const csg_clip_pen *pen,
                       const csg_clip_sink *sink)
{
    for (size_t i = 0; i < 2 * num; i++)
        if (!(std::fabs(points[i]) < max_coordinate))
            return CSG_CLIP_TOO_LARGE;
    if (!(pen->width < max_width))
        return CSG_CLIP_TOO_LARGE;
    try {
        Path path;
        Paths result;
        for (size_t i = 0; i < num; i++)
            path.emplace_back(static_cast<ClipperLib::cInt>(points[2 * i] * stroke_scale),
                              static_cast<ClipperLib::cInt>(points[2 * i + 1] * stroke_scale));
        ClipperLib::ClipperOffset offset;
        offset.AddPath(path, join_of(pen->join), cap_of(pen->cap));
        offset.Execute(result, pen->width * stroke_scale / 2);
        return hand_over(result, *sink) ? CSG_CLIP_DONE : CSG_CLIP_NO_MEMORY;
    } catch (const ClipperLib::clipperException &) {
        return CSG_CLIP_TOO_LARGE;
    } catch (const std::exception &) {
        return CSG_CLIP_NO_MEMORY;
    }
}

} // namespace

extern "C" {
extern __attribute__((visibility("default"))) const csg_clip_module CSG_CLIP_MODULE;
const csg_clip_module CSG_CLIP_MODULE = {combine, offset, stroke};
}
