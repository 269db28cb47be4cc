// SPDX-License-Identifier: MIT
// Which fields may come in? Each law refuses its own numbers, by name; what only a world knows is looked at here.
#include <plumb/dynamics/edit/validate.h>
#include <plumb/math/check.h>

namespace plumb {

namespace {

void validate(const WorldState&, const UniformGravity& law) {
    requireFinite(law.acceleration, "UniformGravity.acceleration");
}

void validate(const WorldState&, const MutualGravity& law) {
    (void)gravityForce(law, {}, {});
}

void validate(const WorldState&, const Drag& law) {
    (void)dragForce(law, {0, 0});
    requireFinite(law.wind, "Drag.wind");
}

void validate(const WorldState&, const Attractor& law) {
    (void)attraction(law, {1, 0});
    requireFinite(law.center, "Attractor.center");
}

void validate(const WorldState& world, const Magnet& law) {
    requireBody(world, law.body, "Magnet.body");
    validate(world, law.pull);
}

void validate(const WorldState&, const Pool& law) {
    const Vec2 point[] = {{0, 0}};
    (void)submergedPart(point, 1, law.fluid);
    requireNotNegative(law.drag, "Pool.drag");
    requireFinite(law.flow, "Pool.flow");
}

void validate(const WorldState&, const GroundFriction& law) {
    (void)frictionForce(law, 1, {0, 0});
}

void validateRegion(const Shape& region) {
    validate(region, "FieldDef.region");
    if (std::holds_alternative<Segment>(region) || std::holds_alternative<Chain>(region))
        refuse("FieldDef.region", "a line has no area that a field could fill");
    if (std::holds_alternative<TileMap>(region))
        refuse("FieldDef.region", "a tile map is not one area: give a field to each part of it");
}

}  // namespace

void validate(const WorldState& world, const FieldDef& def) {
    std::visit([&world](const auto& law) { validate(world, law); }, def.law);
    if (def.region) validateRegion(*def.region);
}

}  // namespace plumb
