// SPDX-License-Identifier: MIT
#include <plumb/dynamics/fields/placed_outline.h>

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
    return {{polygon.vertices.begin(), polygon.vertices.end()}, polygon.radius, true};
}
PlacedOutline localOutline(const Segment& segment) {
    return {{segment.start, segment.end}, 0, false};
}
PlacedOutline localOutline(const Chain& chain) {
    return {{chain.points.begin(), chain.points.end()}, 0, false};
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

namespace {

/// A fluid in a body's frame, with the origin at its centre of mass.
Fluid seenFrom(const BodyMotion& motion, const Fluid& fluid) {
    const Rot back = motion.rotation.inverse();
    return {fluid.density, back * Vec2(fluid.surface - motion.center), back * fluid.gravity};
}

}  // namespace

// Computed in the body's frame: there the shapes are as exact as when they were added, however far the body is from the
// world's origin.
StepList<Submerged> submergedPartsOf(const BodyStore& bodies, const Space& space, BodyIndex body,
                                     const BodyMotion& motion, const Fluid& fluid) {
    const BodyRecord& record = bodies.record[body];
    const Fluid seen = seenFrom(motion, fluid);
    StepList<Submerged> parts;
    for (const ProxyId proxy : bodies.links[body].proxies) {
        const ShapeDef& def = space[proxy].def;
        const PlacedOutline outline = placedOutline(def.shape, record, {});
        if (def.sensor || !outline.hasArea) continue;
        Submerged part = submergedPartOf(outline.corners, outline.radius, seen);
        part.centroid = motion.center + motion.rotation * part.centroid;
        if (part.area > 0) parts.push_back(part);
    }
    return parts;
}

}  // namespace plumb
