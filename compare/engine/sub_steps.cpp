// SPDX-License-Identifier: MIT
#include <compare/engine/sub_steps.h>

#include <compare/engine/box2d3/box2d3_engine.h>
#include <compare/engine/plumb_engine.h>

namespace plumb::compare {

Engine withOneSubStep(const Engine& engine) {
    if (engine.name == plumbName) return plumbEngine({.subSteps = 1});
    if (engine.name == "box2d-3") return box2d3Engine(false, 1).value_or(engine);
    return engine;
}

}  // namespace plumb::compare
