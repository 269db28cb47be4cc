// SPDX-License-Identifier: MIT
#include <plumb/dynamics/body_def.h>

#include <cmath>

#include <plumb/math/check.h>

namespace plumb {

namespace {

void validateMass(const BodyDef& def, const std::string& field) {
    const Mass mass = massOf(def);
    const std::string source = field + (def.mass ? ".mass" : ".shapes");
    if (def.mass) requireFinite(mass.center, source, ".center");
    const std::string why = def.mass ? "" : " (a dynamic body needs a shape with area and density, or BodyDef.mass)";
    if (!(mass.mass > 0) || !std::isfinite(1 / mass.mass) || !std::isfinite(mass.mass))
        refuse(source + ".mass", toText(mass.mass) + " is not a positive finite mass" + why);
    if (!(mass.inertia > 0) || !std::isfinite(1 / mass.inertia) || !std::isfinite(mass.inertia))
        refuse(source + ".inertia", toText(mass.inertia) + " is not a positive finite moment of inertia" + why);
}

}  // namespace

Mass massOf(const BodyDef& def) {
    if (def.mass) return *def.mass;
    std::vector<Mass> parts;
    for (const ShapeDef& shape : def.shapes) parts.push_back(massOf(shape.shape, shape.material.density));
    return combine(parts);
}

void validate(const BodyDef& def, const std::string& field) {
    requireFinite(def.position, field, ".position");
    requireFinite(def.angle, field, ".angle");
    requireFinite(def.velocity, field, ".velocity");
    requireFinite(def.angularVelocity, field, ".angularVelocity");
    requireFinite(def.gravityScale, field, ".gravityScale");
    requireNotNegative(def.linearDamping, field, ".linearDamping");
    requireNotNegative(def.angularDamping, field, ".angularDamping");
    for (std::size_t i = 0; i < def.shapes.size(); ++i)
        validate(def.shapes[i], field + ".shapes[" + std::to_string(i) + "]");
    if (def.type == BodyType::Dynamic) validateMass(def, field);
    if (def.type != BodyType::Static) return;
    if (!def.velocity.isZero(0)) refuse(field + ".velocity", toText(def.velocity) + " on a static body, not (0, 0)");
    if (def.angularVelocity != 0)
        refuse(field + ".angularVelocity", toText(def.angularVelocity) + " on a static body, not 0");
}

}  // namespace plumb
