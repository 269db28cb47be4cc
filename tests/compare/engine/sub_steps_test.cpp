// SPDX-License-Identifier: MIT
#include <compare/engine/engine.h>

#include <algorithm>

#include <compare/lab/builtin/parts.h>
#include <compare/scene/builtin.h>

#include "catch.h"

namespace plumb::compare {
namespace {

/// What the engine's settings say, and where the bob of the level pendulum is after a step.
struct Shown {
    std::string subSteps{};
    Vec2 bob{0, 0};
};

Shown shownBy(const Engine& engine) {
    const Scene scene = findScene("pendulum_horizontal").value();
    Shown shown;
    for (const auto& [name, value] : engine.settings(scene))
        if (name == "sub-steps") shown.subSteps = value;
    const std::unique_ptr<Simulation> simulation = engine.build(scene);
    simulation->step(scene.dt);
    shown.bob = simulation->states().at(1).position;
    return shown;
}

}  // namespace

TEST_CASE("an engine with one sub-step says so, and is another one, without sub-steps it is the same",
          "[compare][engine]") {
    for (const Engine& engine : engines()) {
        if (engine.role == Role::Truth) continue;
        INFO(engine.name);
        const Engine one = withOneSubStep(engine);
        CHECK(one.name == engine.name);
        const Shown before = shownBy(engine), after = shownBy(one);
        if (!engine.withOneSubStep) {
            CHECK(after.bob == before.bob);
            continue;
        }
        CHECK(before.subSteps == "4");
        CHECK(after.subSteps == "1");
        CHECK(after.bob != before.bob);
    }
}

}  // namespace plumb::compare
