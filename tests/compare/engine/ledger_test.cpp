// SPDX-License-Identifier: MIT
// Does the world's own account of its energy close in every scene, and is what it says is stored what there is?
#include <algorithm>
#include <cmath>
#include <string_view>

#include <compare/engine/engine.h>
#include <compare/engine/plumb_world.h>
#include <compare/metric/mechanics.h>
#include <compare/metric/observation.h>
#include <compare/scene/builtin.h>

#include "catch.h"

namespace plumb::compare {
namespace {

/// What is worked out from the scene's masses and springs and the states that are seen.
Mechanics lookAt(const PlumbWorld& made, const MassModel& masses) {
    std::vector<BodyState> states;
    for (const BodyId& id : made.bodies) {
        const BodyView body = made.world.body(id);
        states.push_back({body.position(), body.angle(), body.velocity(), body.angularVelocity()});
    }
    Broken broken;
    for (const JointId& joint : made.joints) broken.push_back(!made.world.contains(joint));
    return masses.at(states, broken).value();
}

}  // namespace

TEST_CASE("the ledger closes over every scene, and what it says is stored is what is seen", "[compare][ledger][law]") {
    for (const Scene& scene : builtinScenes()) {
        INFO(scene.name);
        PlumbWorld made = plumbWorld(scene, {.ledger = true});
        const MassModel masses(scene);
        double largest = 0, worstOpen = 0, worstSeen = 0;
        for (int tick = 0; tick < stepCount(scene); ++tick) {
            made.world.step(scene.dt);
            const Ledger ledger = made.world.ledger();
            const EnergyLedger& e = ledger.energy;
            const Mechanics seen = lookAt(made, masses);
            largest = std::max({largest, std::fabs(seen.kinetic), std::fabs(seen.potential), seen.elastic});
            worstOpen = std::max(worstOpen, std::fabs(e.stored() - e.gained()));
            worstSeen = std::max({worstSeen, std::fabs(e.kinetic - seen.kinetic),
                                  std::fabs(e.gravitational - seen.potential), std::fabs(e.spring - seen.elastic)});
        }
        CHECK(worstOpen <= 1e-6 * largest);
        CHECK(worstSeen <= 1e-6 * largest);
    }
}

TEST_CASE("friction, blows and dampers never give, in any scene, and few joules go without a cause",
          "[compare][ledger][law][slow]") {
    for (const Scene& scene : builtinScenes()) {
        INFO(scene.name);
        PlumbWorld made = plumbWorld(scene, {.ledger = true});
        double largest = 1e-6;
        for (int tick = 0; tick < stepCount(scene); ++tick) {
            made.world.step(scene.dt);
            const EnergyLedger e = made.world.ledger().energy;
            largest = std::max({largest, e.kinetic, std::fabs(e.gravitational), e.spring, e.drivers});
            CHECK(e.friction < 3e-3 * largest);  // a joint has the last word, and may turn a limb back a little
            CHECK(e.impacts < 1e-4 * largest);
            CHECK(e.damping <= 0);
        }
        // The worst is the doll, whose limbs the floor stops at 8 m/s: 15 %.
        CHECK(std::fabs(made.world.ledger().energy.solver) < 0.2 * largest);
    }
}

TEST_CASE("an engine that accounts for energy says that friction and impacts took what kinetic energy is gone",
          "[compare][ledger]") {
    Scene scene = *findScene("slide_to_roll");
    const Engine& plumb = *findKnown(subjectName());
    CHECK(observe(scene, plumb).energyByCause.empty());
    const Observation quiet = observe(scene, plumb);
    scene.engines[subjectName()]["solver.ledger"] = "1";
    const Observation run = observe(scene, plumb);
    REQUIRE(run.energyByCause.size() == run.states.size());
    CHECK(run.hash == quiet.hash);
    const std::size_t disc = bodyIndex(scene, "disc");
    const Mass mass = massOf(scene.bodies[disc].def);
    const auto kinetic = [&](const BodyState& state) {
        return (mass.mass * state.velocity.squaredNorm() +
                mass.inertia * state.angularVelocity * state.angularVelocity) /
               2;
    };
    const auto friction =
        static_cast<std::size_t>(std::ranges::find(energyCauses, std::string_view("friction")) - energyCauses.begin());
    const double lost = kinetic(run.states.back()[disc]) - kinetic(run.states.front()[disc]);
    CHECK(lost < -0.1);
    CHECK(run.energyByCause.back()[friction] == Approx(lost).epsilon(0.01));
}

}  // namespace plumb::compare
