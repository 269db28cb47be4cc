// SPDX-License-Identifier: MIT
// What is each member of a law of force, and what may it hold?
#pragma once
#include <plumb/forces/attractor.h>
#include <plumb/forces/buoyancy.h>
#include <plumb/forces/drag.h>
#include <plumb/forces/friction.h>
#include <plumb/forces/gravity.h>
#include <plumb/math/member.h>

namespace plumb {

template <>
inline constexpr DefinitionName definitionName<UniformGravity>{"UniformGravity", "uniformGravity"};
void describe(OrConst<UniformGravity> auto& def, auto&& visit) {
    visit({"acceleration", "m/s^2", Allowed::finite, "of whatever falls"}, def.acceleration);
}

template <>
inline constexpr DefinitionName definitionName<MutualGravity>{"MutualGravity", "mutualGravity"};
void describe(OrConst<MutualGravity> auto& def, auto&& visit) {
    visit({"constant", "m^3/(kg s^2)", Allowed::notNegative, "of gravitation"}, def.constant);
    visit({"softening", "m", Allowed::notNegative, "what is nearer than this pulls hardly stronger"}, def.softening);
}

template <>
inline constexpr DefinitionName definitionName<Drag>{"Drag", "drag"};
void describe(OrConst<Drag> auto& def, auto&& visit) {
    visit({"linear", "kg/s", Allowed::notNegative, "force per speed"}, def.linear);
    visit({"quadratic", "kg/m", Allowed::notNegative, "force per square of the speed"}, def.quadratic);
    visit({"wind", "m/s", Allowed::finite, "the velocity of the air"}, def.wind);
}

template <>
inline constexpr DefinitionName definitionName<Attractor>{"Attractor", "attractor"};
void describe(OrConst<Attractor> auto& def, auto&& visit) {
    visit({"center", "m", Allowed::finite, "to which it pulls"}, def.center);
    visit({"strength", "N m^n", Allowed::finite, "the pull at 1 m; negative repels; n is the power"}, def.strength);
    visit({"power", "-", Allowed::within(1, 8), "of the distance, by which the pull falls"}, def.power);
    visit({"softening", "m", Allowed::notNegative, "what is nearer than this is pulled hardly stronger"},
          def.softening);
    visit({"range", "m", Allowed::positive.orInfinite(), "beyond it there is no pull"}, def.range);
}

template <>
inline constexpr DefinitionName definitionName<Fluid>{"Fluid"};
void describe(OrConst<Fluid> auto& def, auto&& visit) {
    visit({"density", "kg/m^2", Allowed::notNegative, "mass per area"}, def.density);
    visit({"surface", "m", Allowed::finite, "any point of the surface"}, def.surface);
    visit({"gravity", "m/s^2", Allowed::finite, "the surface lies across it"}, def.gravity);
}

template <>
inline constexpr DefinitionName definitionName<GroundFriction>{"GroundFriction", "groundFriction"};
void describe(OrConst<GroundFriction> auto& def, auto&& visit) {
    visit({"friction", "-", Allowed::notNegative, "Coulomb's coefficient"}, def.friction);
    visit({"gravity", "m/s^2", Allowed::notNegative, "into the ground"}, def.gravity);
    visit({"lever", "m", Allowed::notNegative, "at which friction brakes turning"}, def.lever);
}

}  // namespace plumb
