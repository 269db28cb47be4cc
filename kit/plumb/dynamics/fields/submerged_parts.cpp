// SPDX-License-Identifier: MIT
#include <plumb/dynamics/fields/submerged_parts.h>

#include <plumb/dynamics/bodies/placed_outline.h>

namespace plumb {

namespace {

/// A fluid in a body's frame, with the origin at its centre of mass.
Fluid seenFrom(const BodyMotion& motion, const Fluid& fluid) {
    const Rot back = motion.rotation.inverse();
    return {fluid.density, back * Vec2(fluid.surface - motion.center), back * fluid.gravity};
}

}  // namespace

// Computed in the body's frame: there the shapes are as exact as when they were added, however far the body is from the
// world's origin.
std::vector<Submerged> submergedPartsOf(const BodyStore& bodies, const Space& space, BodyIndex body,
                                        const BodyMotion& motion, const Fluid& fluid) {
    const BodyRecord& record = bodies.record[body];
    const Fluid seen = seenFrom(motion, fluid);
    std::vector<Submerged> parts;
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
