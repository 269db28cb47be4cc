// SPDX-License-Identifier: MIT
// Which bodies may be added, and what is their mass?
#include <type_traits>

#include <plumb/dynamics/describe.h>
#include <plumb/dynamics/edit/validate.h>
#include <plumb/math/check.h>
#include <plumb/math/require_members.h>
#include <plumb/space/detail/shape_radii.h>

namespace plumb {

namespace {

void validateMass(const BodyDef& def, const std::string& field) {
    if (def.mass)
        requireMass(*def.mass, field + ".mass");
    else
        requireMass(massOf(def), field + ".shapes",
                    "a dynamic body needs a shape with area and density, or a mass of its own");
}

/// On a body, shapes have more conditions than on their own, and the check of the mass depends on the type; both are
/// checked separately.
struct BodyCheck {
    const MemberPath& path;
    template <class T>
    [[gnu::always_inline]] void operator()(const Member& member, const T& value) const {
        if constexpr (std::is_same_v<T, std::vector<ShapeDef>>) {
            for (std::size_t i = 0; i < value.size(); ++i)
                requireShape(value[i], path.text(member.name) + "[" + std::to_string(i) + "]");
        } else if constexpr (!std::is_same_v<T, std::optional<Mass>> && !std::is_same_v<T, Lock>) {
            requireMember(member, value, path);
        }
    }
};

/// Checks the conditions between a body's members.
void validateTogether(const BodyDef& def, const std::string& field) {
    if (def.fixedRotation && def.angularVelocity != 0)
        refuse(field + ".angularVelocity", toText(def.angularVelocity) + " on a body of fixed rotation, not 0");
    if (def.mass && def.type != BodyType::Dynamic)
        refuse(field + ".mass", toText(def.mass->mass) + " kg given to a body that is not dynamic");
    if (def.type == BodyType::Dynamic) requireThickness(def.shapes, field + ".shapes");
    if (def.type == BodyType::Dynamic) validateMass(def, field);
    if (def.type != BodyType::Static) return;
    if (!def.velocity.isZero(0)) refuse(field + ".velocity", toText(def.velocity) + " on a static body, not (0, 0)");
    if (def.angularVelocity != 0)
        refuse(field + ".angularVelocity", toText(def.angularVelocity) + " on a static body, not 0");
}

}  // namespace

/// The sum of the shapes, unless the mass was given.
Mass massOf(const BodyDef& def) {
    if (def.mass) return *def.mass;
    std::vector<Mass> parts;
    for (const ShapeDef& shape : def.shapes) parts.push_back(massOf(shape.shape, shape.material.density));
    return combine(parts);
}

/// Contacts are soft, and predicted a few millimetres ahead: thinner bodies would sink into each other. Test: "a box of
/// 10 um on a floor, which went 9.6 m/s, is refused, with the smallest size and what to do"
void requireThickness(std::span<const ShapeDef> shapes, const std::string& field) {
    const double radius = halfThicknessOf(shapes);
    if (radius < leastHalfThickness * (1 - 1e-9))
        refuse(field, toText(radius) + " m is the radius of the largest disc that fits into one, and less than " +
                          toText(leastHalfThickness) +
                          " m, the smallest for a dynamic body: use a smaller unit of length, as "
                          "millimetres, and multiply all lengths and WorldDef.gravity");
}

/// First each member alone, by its description, then what members say together: so a message names the simplest fault.
void validate(const BodyDef& def, const std::string& field) {
    const MemberPath path{field};
    describe(def, BodyCheck{path});
    validateTogether(def, field);
}

}  // namespace plumb
