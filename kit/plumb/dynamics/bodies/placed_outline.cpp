// SPDX-License-Identifier: MIT
#include <plumb/dynamics/bodies/placed_outline.h>

#include <plumb/shapes/chain.h>

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

/// The corners of all pieces of its solid tiles; a single point if there are none.
PlacedOutline localOutline(const TileMap& map) {
    PlacedOutline outline{{}, 0, false};
    for (const Shape& piece : piecesOf(map)) {
        const PlacedOutline part = std::holds_alternative<Polygon>(piece) ? localOutline(std::get<Polygon>(piece))
                                                                          : localOutline(std::get<Segment>(piece));
        outline.corners.insert(outline.corners.end(), part.corners.begin(), part.corners.end());
    }
    if (outline.corners.empty()) outline.corners.push_back({0, 0});
    return outline;
}

}  // namespace

PlacedOutline placedOutline(const Shape& shape, const BodyRecord& body, const BodyMotion& there) {
    PlacedOutline outline = std::visit([](const auto& s) { return localOutline(s); }, shape);
    for (Vec2& corner : outline.corners) corner = there.center + there.rotation * Vec2(corner - body.localCenter);
    return outline;
}

}  // namespace plumb
