// SPDX-License-Identifier: MIT
#include <compare/engine/engine.h>

#include "catch.h"

namespace plumb::compare {
namespace {

/// A disc of 5 cm at 100 m/s, 1.67 m a step, and a board of 5 cm that nothing holds.
Scene looseBoard() {
    return {.name = "loose_board",
            .gravity = {0, 0},
            .duration = 0.1,
            .bodies = {{"board", {.shapes = {box({0.025, 0.5})}}},
                       {"disc", {.position = {-1, 0}, .velocity = {100, 0}, .shapes = {circle(0.025)}}}}};
}

bool goesThrough(const Engine& engine) {
    const std::unique_ptr<Simulation> simulation = engine.build(looseBoard());
    for (int i = 0; i < 6; ++i) simulation->step(1.0 / 60);
    const std::vector<BodyState> states = simulation->states();
    return states[1].position.x() > states[0].position.x();
}

}  // namespace

TEST_CASE("a disc at 100 m/s goes through a loose board of 5 cm in each Box2D, and as a bullet in none",
          "[compare][engine]") {
    for (const Engine& engine : engines()) {
        if (engine.role != Role::Peer) continue;
        INFO(engine.name);
        CHECK(goesThrough(engine));
        REQUIRE(engine.withBullets);
        const Engine bullets = engine.withBullets();
        CHECK(bullets.name == engine.name + " bullets");
        CHECK_FALSE(goesThrough(bullets));
    }
}

TEST_CASE("Plumb, Chipmunk and the closed form have no flag for bullets", "[compare][engine]") {
    for (const Engine& engine : engines())
        if (engine.role == Role::Subject || engine.role == Role::Truth) CHECK_FALSE(engine.withBullets);
}

}  // namespace plumb::compare
