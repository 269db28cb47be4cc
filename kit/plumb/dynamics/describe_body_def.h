// SPDX-License-Identifier: MIT
// What is each member of a BodyDef, and what may it hold?
#pragma once
#include <array>
#include <span>

#include <plumb/dynamics/body_def.h>
#include <plumb/math/member.h>
#include <plumb/space/describe_shape_def.h>

namespace plumb {

// What the enumerators are called in a file, in their order.
inline constexpr std::array<const char*, 3> bodyTypeTags{"static", "kinematic", "dynamic"};
constexpr std::span<const char* const> tagsOf(BodyType) {
    return bodyTypeTags;
}

template <>
inline constexpr DefinitionName definitionName<BodyDef>{"BodyDef"};
void describe(OrConst<BodyDef> auto& def, auto&& visit) {
    visit({"type", "", Allowed::any, "what moves it"}, def.type);
    visit({"position", "m", Allowed::finite, "of the body's origin"}, def.position);
    visit({"angle", "rad", Allowed::finite, "of the body's frame"}, def.angle);
    visit({"velocity", "m/s", Allowed::finite, "of the centre of mass; zero for a static body"}, def.velocity);
    visit({"angularVelocity", "rad/s", Allowed::finite, "zero for a static body"}, def.angularVelocity);
    visit({"gravityScale", "-", Allowed::finite, "how many times the world's gravity it feels"}, def.gravityScale);
    visit({"linearDamping", "1/s", Allowed::notNegative, "its velocity decays as exp(-damping t)"}, def.linearDamping);
    visit({"angularDamping", "1/s", Allowed::notNegative, "its angular velocity decays likewise"}, def.angularDamping);
    visit({"fixedRotation", "", Allowed::any, "does nothing turn it?"}, def.fixedRotation);
    visit({"lockX", "", Allowed::any, "does a dynamic body stay where it is along x?"}, def.lockX);
    visit({"lockY", "", Allowed::any, "does a dynamic body stay where it is along y?"}, def.lockY);
    visit({"canSleep", "", Allowed::any, "may it fall asleep when it rests?"}, def.canSleep);
    visit({"awake", "", Allowed::any, "false: asleep until something touches it"}, def.awake);
    visit({"enabled", "", Allowed::any, "false: it stays where it is, and nothing meets it"}, def.enabled);
    visit({"tag", "", Allowed::any, "whatever its owner wants to know it by"}, def.tag);
    visit({"mass", "", Allowed::any, "instead of what the shapes and their densities give"}, def.mass);
    visit({"shapes", "", Allowed::any, "its outline"}, def.shapes);
}

}  // namespace plumb
