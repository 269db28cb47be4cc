// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/placed_outline.h>

#include <array>

namespace plumb {

namespace {

PlacedOutline localOutline(const Circle& circle) {
    return {{circle.center}, circle.radius, true};
}
PlacedOutline localOutline(const Capsule& capsule) {
    return {{capsule.start, capsule.end}, capsule.radius, true};
}
PlacedOutline localOutline(const Polygon& polygon) {
    return {polygon.vertices, polygon.radius, true};
}
PlacedOutline localOutline(const Segment& segment) {
    return {{segment.start, segment.end}, 0, false};
}
PlacedOutline localOutline(const Chain& chain) {
    return {chain.points, 0, false};
}

PlacedOutline localOutline(const TileMap& map) {
    const std::array<Vec2, 4> corners = outerCornersOf(map);
    return {{corners.begin(), corners.end()}, 0, false};
}

}  // namespace

PlacedOutline placedOutline(const Shape& shape, const BodyRecord& body, const BodyMotion& there) {
    PlacedOutline outline = std::visit([](const auto& s) { return localOutline(s); }, shape);
    for (Vec2& corner : outline.corners) corner = there.center + there.rotation * Vec2(corner - body.localCenter);
    return outline;
}

}  // namespace plumb
