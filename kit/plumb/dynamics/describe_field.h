// SPDX-License-Identifier: MIT
// What is each member of a FieldDef and of its laws, and what may it hold?
#pragma once
#include <plumb/dynamics/field.h>
#include <plumb/forces/describe_law.h>
#include <plumb/math/member.h>
#include <plumb/space/describe_shape_def.h>

namespace plumb {

template <>
inline constexpr DefinitionName definitionName<Magnet>{"Magnet", "magnet"};
void describe(OrConst<Magnet> auto& def, auto&& visit) {
    visit({"body", "", Allowed::any, "the body that carries it"}, def.body);
    visit({"pull", "", Allowed::any, "how it draws others; its centre is in the body's frame"}, def.pull);
}

template <>
inline constexpr DefinitionName definitionName<Pool>{"Pool", "pool"};
void describe(OrConst<Pool> auto& def, auto&& visit) {
    visit({"fluid", "", Allowed::any, "what bears the bodies"}, def.fluid);
    visit({"drag", "kg/(m^2 s)", Allowed::notNegative, "force per area under water and speed"}, def.drag);
    visit({"flow", "m/s", Allowed::finite, "the velocity of the fluid"}, def.flow);
}

template <>
inline constexpr DefinitionName definitionName<FieldDef>{"FieldDef"};
void describe(OrConst<FieldDef> auto& def, auto&& visit) {
    visit({"law", "", Allowed::any, "the force that acts on a body"}, def.law);
    visit({"region", "m", Allowed::any, "only on what has its centre of mass here; with an area"}, def.region);
    visit({"filter", "", Allowed::any, "only on what has a shape that collides with a shape of this"}, def.filter);
}

}  // namespace plumb
