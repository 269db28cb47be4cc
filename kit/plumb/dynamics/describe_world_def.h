// SPDX-License-Identifier: MIT
// What is each member of a WorldDef and of its SolverSettings, and what may it hold?
#pragma once
#include <array>

#include <plumb/dynamics/world.h>
#include <plumb/math/member.h>
#include <plumb/space/describe_shape_def.h>

namespace plumb {

inline constexpr std::array<int, 4> laneCounts{1, 4, 8, 16};

template <>
inline constexpr DefinitionName definitionName<SolverSettings>{"SolverSettings"};
void describe(OrConst<SolverSettings> auto& def, auto&& visit) {
    visit({"subSteps", "-", Allowed::within(1, 64), "in how many parts each step is solved"}, def.subSteps);
    visit({"contactFrequency", "Hz", Allowed::positive, "of contacts, as springs"}, def.contactFrequency);
    visit({"contactDampingRatio", "-", Allowed::positive, "of contacts, as springs"}, def.contactDampingRatio);
    visit({"contactPushSpeed", "m/s", Allowed::positive, "the fastest that overlap is pushed out"},
          def.contactPushSpeed);
    visit({"sleepSpeed", "m/s", Allowed::notNegative, "slower than this everywhere on it, a body counts as still"},
          def.sleepSpeed);
    visit({"sleepTime", "s", Allowed::notNegative, "still for as long as this, an island falls asleep"}, def.sleepTime);
    visit({"jointsAtOnce", "-", Allowed::notNegative, "machines of up to so many joints are solved exactly"},
          def.jointsAtOnce);
    visit({"lanes", "-", Allowed::among(laneCounts), "at most so many contacts are solved side by side"}, def.lanes);
}

template <>
inline constexpr DefinitionName definitionName<WorldDef>{"WorldDef"};
void describe(OrConst<WorldDef> auto& def, auto&& visit) {
    visit({"gravity", "m/s^2", Allowed::finite, "the same everywhere"}, def.gravity);
    visit({"sleeping", "", Allowed::any, "may what rests be left out of the step?"}, def.sleeping);
    visit({"hitSpeed", "m/s", Allowed::notNegative.orInfinite(), "what comes together faster is a ContactHit"},
          def.hitSpeed);
    visit({"wrap", "", Allowed::any, "how wide and high the world is, if it goes on at its other side"}, def.wrap);
    visit({"ledger", "", Allowed::any, "is account kept of energy and momentum?"}, def.ledger);
    visit({"solver", "", Allowed::any, "how hard the solver tries"}, def.solver);
}

}  // namespace plumb
