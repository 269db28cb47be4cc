// SPDX-License-Identifier: MIT
#include <plumb/dynamics/body_def.h>

#include <algorithm>
#include <cmath>

#include <plumb/math/check.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

namespace {

void validateMass(const BodyDef& def, const std::string& field) {
    const Mass mass = massOf(def);
    const std::string source = field + (def.mass ? ".mass" : ".shapes");
    if (def.mass) requireFinite(mass.center, source, ".center");
    const std::string why = def.mass ? "" : " (a dynamic body needs a shape with area and density, or BodyDef.mass)";
    if (!(mass.mass > 0) || !std::isfinite(mass.mass))
        refuse(source + ".mass", toText(mass.mass) + " is not a positive finite mass" + why);
    if (!(mass.inertia > 0) || !std::isfinite(mass.inertia))
        refuse(source + ".inertia", toText(mass.inertia) + " is not a positive finite moment of inertia" + why);
    // The solver's floats hold the squares and products of what is within these.
    requireWithin(mass.mass, 1e-12, 1e12, source, ".mass");
    requireWithin(std::sqrt(mass.inertia / mass.mass), 1e-6, 1e6, source, ".inertia, its radius of gyration");
}

}  // namespace

Mass massOf(const BodyDef& def) {
    if (def.mass) return *def.mass;
    std::vector<Mass> parts;
    for (const ShapeDef& shape : def.shapes) parts.push_back(massOf(shape.shape, shape.material.density));
    return combine(parts);
}

namespace {

/// Farther from its body's origin than this, a shape's corners are too coarse in the solver's floats to touch anything.
constexpr double farthestCorner = 1e5;

void validateReach(const ShapeDef& def, const std::string& field) {
    const Aabb box = aabbOf(def.shape, {});
    const double reach = std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
    if (reach > farthestCorner)
        refuse(field + ".shape", toText(reach) + " m from the body's origin, at most " + toText(farthestCorner) +
                                     " m was wanted: place the body there instead, or use several");
}

}  // namespace

void validate(const BodyDef& def, const std::string& field) {
    requireFinite(def.position, field, ".position");
    requireFinite(def.angle, field, ".angle");
    requireFinite(def.velocity, field, ".velocity");
    requireFinite(def.angularVelocity, field, ".angularVelocity");
    requireFinite(def.gravityScale, field, ".gravityScale");
    requireNotNegative(def.linearDamping, field, ".linearDamping");
    requireNotNegative(def.angularDamping, field, ".angularDamping");
    for (std::size_t i = 0; i < def.shapes.size(); ++i) {
        const std::string shape = field + ".shapes[" + std::to_string(i) + "]";
        validate(def.shapes[i], shape);
        validateReach(def.shapes[i], shape);
    }
    if (def.fixedRotation && def.angularVelocity != 0)
        refuse(field + ".angularVelocity", toText(def.angularVelocity) + " on a body of fixed rotation, not 0");
    if (def.mass && def.type != BodyType::Dynamic) refuse(field + ".mass", "given to a body that is not dynamic");
    if (def.type == BodyType::Dynamic) validateMass(def, field);
    if (def.type != BodyType::Static) return;
    if (!def.velocity.isZero(0)) refuse(field + ".velocity", toText(def.velocity) + " on a static body, not (0, 0)");
    if (def.angularVelocity != 0)
        refuse(field + ".angularVelocity", toText(def.angularVelocity) + " on a static body, not 0");
}

}  // namespace plumb
