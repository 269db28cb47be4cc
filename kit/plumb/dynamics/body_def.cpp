// SPDX-License-Identifier: MIT
#include <plumb/dynamics/body_def.h>

#include <plumb/dynamics/edit/validate.h>
#include <plumb/math/check.h>

namespace plumb {

namespace {

void validateMass(const BodyDef& def, const std::string& field) {
    if (def.mass)
        requireMass(*def.mass, field + ".mass");
    else
        requireMass(massOf(def), field + ".shapes",
                    "a dynamic body needs a shape with area and density, or BodyDef.mass");
}

}  // namespace

Mass massOf(const BodyDef& def) {
    if (def.mass) return *def.mass;
    std::vector<Mass> parts;
    for (const ShapeDef& shape : def.shapes) parts.push_back(massOf(shape.shape, shape.material.density));
    return combine(parts);
}

void validate(const BodyDef& def, const std::string& field) {
    requireType(def.type, field + ".type");
    requireFinite(def.position, field, ".position");
    requireFinite(def.angle, field, ".angle");
    requireFinite(def.velocity, field, ".velocity");
    requireFinite(def.angularVelocity, field, ".angularVelocity");
    requireFinite(def.gravityScale, field, ".gravityScale");
    requireNotNegative(def.linearDamping, field, ".linearDamping");
    requireNotNegative(def.angularDamping, field, ".angularDamping");
    for (std::size_t i = 0; i < def.shapes.size(); ++i)
        requireShape(def.shapes[i], field + ".shapes[" + std::to_string(i) + "]");
    if (def.fixedRotation && def.angularVelocity != 0)
        refuse(field + ".angularVelocity", toText(def.angularVelocity) + " on a body of fixed rotation, not 0");
    if (def.mass && def.type != BodyType::Dynamic)
        refuse(field + ".mass", toText(def.mass->mass) + " kg given to a body that is not dynamic");
    if (def.type == BodyType::Dynamic) validateMass(def, field);
    if (def.type != BodyType::Static) return;
    if (!def.velocity.isZero(0)) refuse(field + ".velocity", toText(def.velocity) + " on a static body, not (0, 0)");
    if (def.angularVelocity != 0)
        refuse(field + ".angularVelocity", toText(def.angularVelocity) + " on a static body, not 0");
}

}  // namespace plumb
