// SPDX-License-Identifier: MIT
// What is each member of a ShapeDef and of a Wrap, and what may it hold?
#pragma once
#include <array>
#include <span>

#include <plumb/math/member.h>
#include <plumb/shapes/describe_shape.h>
#include <plumb/space/shape_def.h>
#include <plumb/space/wrap.h>

namespace plumb {

// What the enumerators are called in a file, in their order.
inline constexpr std::array<const char*, 5> mixTags{"average", "geometricMean", "minimum", "product", "maximum"};
constexpr std::span<const char* const> tagsOf(Mix) {
    return mixTags;
}

template <>
inline constexpr DefinitionName definitionName<Material>{"Material"};
void describe(OrConst<Material> auto& def, auto&& visit) {
    visit({"density", "kg/m^2", Allowed::notNegative, "mass per area"}, def.density);
    visit({"friction", "-", Allowed::notNegative, "Coulomb's coefficient"}, def.friction);
    constexpr const char* bumper =
        "for a bumper, which adds speed, apply an impulse at each ContactBegin: see dynamics/events.md, Bumpers";
    visit({"restitution", "-", Allowed::within(0, 1).insteadOfMore(bumper),
           "the share of its speed with which it bounces"},
          def.restitution);
    visit({"rollingResistance", "-", Allowed::notNegative, "torque over the radius times the normal force"},
          def.rollingResistance);
    visit({"surfaceSpeed", "m/s", Allowed::finite, "of a belt, clockwise around the outline"}, def.surfaceSpeed);
    visit({"frictionMix", "", Allowed::any, "how a pair's friction comes from both"}, def.frictionMix);
    visit({"restitutionMix", "", Allowed::any, "how a pair's restitution comes from both"}, def.restitutionMix);
}

template <>
inline constexpr DefinitionName definitionName<Filter>{"Filter"};
void describe(OrConst<Filter> auto& def, auto&& visit) {
    visit({"category", "", Allowed::any, "bits of what it is"}, def.category);
    visit({"mask", "", Allowed::any, "bits of what it collides with"}, def.mask);
    visit({"group", "", Allowed::any, "of one group other than 0: always if positive, never if negative"}, def.group);
}

template <>
inline constexpr DefinitionName definitionName<ShapeDef>{"ShapeDef"};
void describe(OrConst<ShapeDef> auto& def, auto&& visit) {
    visit({"shape", "", Allowed::any, "its outline"}, def.shape);
    visit({"material", "", Allowed::any, "what it is made of"}, def.material);
    visit({"filter", "", Allowed::any, "what it collides with"}, def.filter);
    visit({"sensor", "", Allowed::any, "does it touch nothing, and only tell what overlaps it?"}, def.sensor);
    visit({"oneWay", "-", Allowed::finite.butNotZero("is no direction"), "solid only to what comes from there"},
          def.oneWay);
    visit({"rule", "", Allowed::any, "asked which contacts are made; it is code, and stands in no file"}, def.rule);
    visit({"tag", "", Allowed::any, "whatever its owner wants to know it by"}, def.tag);
}

template <>
inline constexpr DefinitionName definitionName<Wrap>{"Wrap"};
void describe(OrConst<Wrap> auto& def, auto&& visit) {
    constexpr double least = 1e-3, most = 1e9;  // counts of rounds are to stay whole numbers
    visit({"width", "m", Allowed::within(least, most), "x goes on at its other side; none: for ever"}, def.width);
    visit({"height", "m", Allowed::within(least, most), "y goes on at its other side; none: for ever"}, def.height);
}

}  // namespace plumb
