// SPDX-License-Identifier: MIT
#include <plumb/shapes/detail/point_sets.h>

#include <array>
#include <numeric>
#include <tuple>

#include <plumb/math/detail/sorting.h>

namespace plumb {
namespace {

CorePoints coreOf(const Circle& circle) {
    return {{circle.center}, circle.radius};
}

CorePoints coreOf(const Capsule& capsule) {
    return {{capsule.start, capsule.end}, capsule.radius};
}

CorePoints coreOf(const Polygon& polygon) {
    return {polygon.vertices, polygon.radius};
}

CorePoints coreOf(const Segment& segment) {
    return {{segment.start, segment.end}, 0};
}

CorePoints coreOf(const Chain& chain) {
    return {chain.points, 0};
}

CorePoints coreOf(const TileMap& map) {
    const std::array<Vec2, 4> corners = outerCornersOf(map);
    return {{corners.begin(), corners.end()}, 0};
}

}  // namespace

CorePoints corePointsOf(const Shape& shape) {
    return std::visit([](const auto& outline) { return coreOf(outline); }, shape);
}

// The lower hull from left to right, then the upper hull back.
HullIndices hullOutline(std::span<const Vec2> points) {
    HullIndices sorted(points.size());
    std::iota(sorted.begin(), sorted.end(), std::size_t{0});
    sortBy(sorted, [&](std::size_t i) { return std::tuple(points[i].x(), points[i].y()); });
    HullIndices hull;
    const auto add = [&](std::size_t index, std::size_t least) {
        const auto turnsLeft = [&] {
            const Vec2& end = points[hull.back()];
            const Vec2 in = end - points[hull[hull.size() - 2]], out = points[index] - end;
            return cross(in, out) > 0;
        };
        while (hull.size() > least && !turnsLeft()) hull.pop_back();
        hull.push_back(index);
    };
    for (const std::size_t index : sorted) add(index, 1);
    const std::size_t lower = hull.size();
    for (std::size_t i = sorted.size() - 1; i-- > 0;) add(sorted[i], lower);
    if (hull.size() > 1) hull.pop_back();  // the first point again
    return hull;
}

}  // namespace plumb
