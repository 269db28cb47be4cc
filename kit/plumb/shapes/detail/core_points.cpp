// SPDX-License-Identifier: MIT
#include <plumb/shapes/detail/core_points.h>

#include <array>

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

}  // namespace plumb
