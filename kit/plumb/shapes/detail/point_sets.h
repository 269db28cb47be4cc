// SPDX-License-Identifier: MIT
// What do hulls, boxes and decompositions ask of points: those of a shape, their hull, their scale, their triangles,
// their number?
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include <plumb/shapes/shape.h>

namespace plumb {

/// The shape lies in the convex hull of the points, enlarged by the radius, and touches all its sides.
struct CorePoints {
    std::vector<Vec2> points;  ///< in the body's frame [m]
    double radius = 0;         ///< [m]
};
CorePoints corePointsOf(const Shape& shape);

using HullIndices = std::vector<std::size_t>;

/// Which of these points are corners of their convex hull. Counter-clockwise, starting with the leftmost point (the
/// lowest of several); no corner is collinear with its neighbours. Collinear points have two corners; so have several
/// equal points, and one point has one. There must be one point or more, and all must be finite. Source: Andrew,
/// "Another efficient algorithm for convex hulls in two dimensions", 1979.
HullIndices hullOutline(std::span<const Vec2> points);

/// The smallest edge relative to the diagonal, and the smallest sine of a corner, of polygons that are constructed: a
/// little more than validate() demands, so that rounding does not make a polygon invalid [-].
inline constexpr double cornerTolerance = 1.5e-6;

/// Points relative to the first one, times a power of two, so that products of huge or tiny lengths neither overflow
/// nor underflow.
inline std::vector<Vec2> scaledPoints(std::span<const Vec2> points) {
    double largest = 0;
    for (const Vec2& p : points) largest = std::max({largest, std::fabs(p.x()), std::fabs(p.y())});
    int exponent = 0;
    std::frexp(largest, &exponent);
    std::vector<Vec2> scaled;
    scaled.reserve(points.size());
    for (const Vec2& p : points) scaled.emplace_back(std::ldexp(p.x(), -exponent), std::ldexp(p.y(), -exponent));
    const Vec2 first = scaled.front();
    for (Vec2& p : scaled) p -= first;
    return scaled;
}

/// The diagonal of the axis-aligned box around points.
inline double diagonalOf(const std::vector<Vec2>& points) {
    Vec2 lower = points.front(), upper = points.front();
    for (const Vec2& p : points) {
        lower = lower.cwiseMin(p);
        upper = upper.cwiseMax(p);
    }
    return (upper - lower).norm();
}

using Triangle = std::array<std::size_t, 3>;

/// Into which triangles a simple polygon can be divided: counter-clockwise triangles between the corners of a simple
/// counter-clockwise polygon, as far from degenerate as possible. Ear clipping, the thickest ear first; then every
/// diagonal is flipped whose opposite angles add up to more than 180 degrees (Delaunay). Source: Meisters, "Polygons
/// have ears", 1975; Lawson, "Transforming triangulations", 1972. Test: "pieces of 8,000 random outlines ..."
std::vector<Triangle> triangulate(std::span<const Vec2> corners);

// Does a shape have a valid number of corners?

[[noreturn]] void refuseCount(const Polygon& polygon, std::string_view field);
[[noreturn]] void refuseCount(const Chain& chain, std::string_view field);

// Cheap enough for hot loops. Other faults that validate() finds give wrong results, but no access outside of an array.
// Each throws std::invalid_argument with the field's name and the count.

/// Unless there are 3 to maxPolygonVertices corners.
inline void requireCount(const Polygon& polygon, std::string_view field = "Polygon") {
    const std::size_t count = polygon.vertices.size();
    if (count < 3 || count > static_cast<std::size_t>(maxPolygonVertices)) refuseCount(polygon, field);
}

/// Unless there are 2 points, or 3 if it is closed.
inline void requireCount(const Chain& chain, std::string_view field = "Chain") {
    if (chain.points.size() < (chain.closed ? 3u : 2u)) refuseCount(chain, field);
}

}  // namespace plumb
