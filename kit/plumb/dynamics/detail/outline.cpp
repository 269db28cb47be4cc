// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/outline.h>

namespace plumb {

namespace {

Outline localOutline(const Circle& circle) {
    return {{circle.center}, circle.radius, true};
}
Outline localOutline(const Capsule& capsule) {
    return {{capsule.start, capsule.end}, capsule.radius, true};
}
Outline localOutline(const Polygon& polygon) {
    return {polygon.vertices, polygon.radius, true};
}
Outline localOutline(const Segment& segment) {
    return {{segment.start, segment.end}, 0, false};
}
Outline localOutline(const Chain& chain) {
    return {chain.points, 0, false};
}

}  // namespace

Outline outlineOf(const Shape& shape, const BodyRecord& body, const BodyMotion& there) {
    Outline outline = std::visit([](const auto& s) { return localOutline(s); }, shape);
    for (Vec2& corner : outline.corners) corner = there.center + there.rotation * Vec2(corner - body.localCenter);
    return outline;
}

}  // namespace plumb
