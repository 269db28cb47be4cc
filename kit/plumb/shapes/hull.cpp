// SPDX-License-Identifier: MIT
#include <plumb/shapes/hull.h>

#include <cmath>

#include <plumb/math/check.h>
#include <plumb/shapes/detail/point_sets.h>

namespace plumb {
namespace {

/// One pass along the outline that removes corners which are too near to the one before or hardly make a turn.
HullIndices withoutFlats(const HullIndices& outline, const std::vector<Vec2>& points, double shortest) {
    HullIndices kept;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t before = kept.empty() ? outline.back() : kept.back();
        const std::size_t after = i + 1 < outline.size() ? outline[i + 1] : (kept.empty() ? before : kept.front());
        const Vec2 in = points[outline[i]] - points[before];
        const Vec2 out = points[after] - points[outline[i]];
        const bool corner = in.norm() > shortest && cross(in, out) > cornerTolerance * in.norm() * out.norm();
        if (corner) kept.push_back(outline[i]);
    }
    return kept;
}

}  // namespace

Polygon hullOf(std::span<const Vec2> points) {
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!points[i].allFinite()) requireFinite(points[i], "hullOf.points[" + std::to_string(i) + "]");
    HullIndices hull;
    if (!points.empty()) {
        const std::vector<Vec2> scaled = scaledPoints(points);
        const double shortest = cornerTolerance * diagonalOf(scaled);
        hull = hullOutline(scaled);
        for (std::size_t before = hull.size() + 1; hull.size() < before;) {
            before = hull.size();
            hull = withoutFlats(hull, scaled, shortest);
        }
    }
    const std::string made =
        std::to_string(hull.size()) + " corners, made of " + std::to_string(points.size()) + " points, are ";
    if (hull.size() < 3) refuse("hullOf.points", made + "fewer than 3");
    if (hull.size() > static_cast<std::size_t>(maxPolygonVertices))
        refuse("hullOf.points", made + "more than " + std::to_string(maxPolygonVertices));
    Polygon polygon;
    for (const std::size_t index : hull) polygon.vertices.push_back(points[index]);
    return polygon;
}

}  // namespace plumb
