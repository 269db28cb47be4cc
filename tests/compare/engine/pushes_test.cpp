// SPDX-License-Identifier: MIT
// Do the forces that an engine tells of move its bodies as Newton says?
#include <compare/engine/engine.h>
#include <compare/scene/body_mass.h>
#include <compare/scene/builtin.h>

#include "catch.h"

namespace plumb::compare {
namespace {

/// Of all forces on a body: its weight, and what the engine tells of.
Vec2 forceOn(const Scene& scene, const Simulation& simulation, std::size_t body) {
    Vec2 sum = plumb::massOf(scene.bodies[body].def).mass * scene.gravity;
    for (const Push& push : simulation.pushes())
        if (push.body == body) sum += push.force;
    return sum;
}

/// The largest difference of a body's change of momentum in a step and the force on it, in weights.
double farthestFromNewton(const Scene& scene, const Engine& engine, const std::string& body, int from, int steps) {
    const std::size_t index = bodyIndex(scene, body);
    const double mass = plumb::massOf(scene.bodies[index].def).mass;
    const auto simulation = engine.build(scene);
    double farthest = 0;
    for (int step = 0; step < steps; ++step) {
        const Vec2 before = simulation->states()[index].velocity;
        simulation->step(scene.dt);
        if (step < from) continue;
        const Vec2 force = mass * (simulation->states()[index].velocity - before) / scene.dt;
        farthest = std::max(farthest, (force - forceOn(scene, *simulation, index)).norm() / (mass * 9.81));
    }
    return farthest;
}

}  // namespace

TEST_CASE("what the engine under test tells of forces is what changes the momentum, in every step",
          "[compare][engine]") {
    const Engine& subject = *findKnown(subjectName());
    CHECK(farthestFromNewton(findScene("block_slides").value(), subject, "block", 0, 100) < 1e-4);
    CHECK(farthestFromNewton(findScene("box_at_rest").value(), subject, "box", 0, 100) < 1e-4);
    CHECK(farthestFromNewton(findScene("pendulum_45").value(), subject, "bob", 0, 200) < 1e-4);
    CHECK(farthestFromNewton(findScene("slide_to_roll").value(), subject, "disc", 0, 100) < 1e-4);
    CHECK(farthestFromNewton(findScene("spring_undamped").value(), subject, "weight", 0, 100) < 1e-4);
}

TEST_CASE("the rope of a pulley pulls both bodies up, also with a ratio", "[compare][engine]") {
    Scene scene = findScene("atwood_machine").value();
    for (const double ratio : {1.0, 2.0, 0.5}) {
        std::get<PulleyJointDef>(scene.joints[0].def).ratio = ratio;
        CAPTURE(ratio);
        for (const char* body : {"light", "heavy"})
            CHECK(farthestFromNewton(scene, *findKnown(subjectName()), body, 0, 50) < 1e-4);
    }
}

TEST_CASE("a hand pulls a free disc to its target in every engine that can be touched, and lets it go",
          "[compare][engine]") {
    const Scene scene = findScene("projectile").value();
    for (const Engine& engine : engines()) {
        const auto simulation = engine.build(scene);
        const bool canTouch = engine.role == Role::Subject || engine.isRival;
        simulation->hold(Hand{0, {0, 0}, {3, 4}});
        for (int step = 0; step < 120; ++step) simulation->step(scene.dt);
        CAPTURE(engine.name, simulation->states()[0].position.transpose());
        CHECK(((simulation->states()[0].position - Vec2(3, 4)).norm() < 0.05) == canTouch);
        simulation->hold({});
        for (int step = 0; step < 60; ++step) simulation->step(scene.dt);
        CHECK((!canTouch || simulation->states()[0].position.y() < 0));
    }
}

}  // namespace plumb::compare
