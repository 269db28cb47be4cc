// SPDX-License-Identifier: MIT
#include <compare/metric/observation.h>

#include "catch.h"
#include "compare/scripted.h"

namespace plumb::compare {

TEST_CASE("a run of ten steps is seen at eleven ticks, the start included", "[compare][metric]") {
    const Scene scene = oneDisc();
    const Observation seen =
        observe(scene, scripted("plumb", {[](double t) { return std::vector<BodyState>{at(t, 0)}; }}));
    REQUIRE(seen.states.size() == 11);
    REQUIRE(seen.probes.size() == 11);
    CHECK(seen.states[0][0].position.x() == 0);
    CHECK(seen.states[10][0].position.x() == 1.0);
    CHECK(seen.dt == 0.1);
    CHECK(seen.unsupported.empty());
    CHECK(seen.msPerStep.has_value());
    CHECK_FALSE(seen.partial);
}

TEST_CASE("an engine that cannot build a scene is seen as such, with its reason and no states", "[compare][metric]") {
    const Observation seen = observe(oneDisc(), unsupporting("box2d-3"));
    CHECK(seen.unsupported == "it has no such thing");
    CHECK(seen.states.empty());
    CHECK_FALSE(seen.msPerStep);
}

TEST_CASE("an angle probe is read from the states, a force probe from the simulation", "[compare][metric]") {
    Scene scene = oneDisc();
    Probe angle, force;
    angle.quantity = AngleProbe{"disc"};
    force.quantity = NormalForceProbe{"disc", "disc"};
    scene.probes = {angle, force};
    const Script script{[](double t) {
                            BodyState state;
                            state.angle = 7 * t;
                            return std::vector<BodyState>{state};
                        },
                        [](double t) {
                            return std::vector<double>{-1, 3 * t};
                        }};
    const Observation seen = observe(scene, scripted("plumb", script));
    CHECK(seen.probes[10][0] == 7.0);
    CHECK(seen.probes[10][1] == 3.0);
}

TEST_CASE("only the closed form may be silent about a body", "[compare][metric]") {
    CHECK(observe(oneDisc(), standing("closed-form", 0)).partial);
    CHECK_FALSE(observe(oneDisc(), standing("box2d-3", 0)).partial);
}

}  // namespace plumb::compare
