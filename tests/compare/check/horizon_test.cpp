// SPDX-License-Identifier: MIT
#include <compare/check/horizon.h>

#include <algorithm>
#include <cmath>

#include <compare/engine/engine.h>
#include <compare/scene/builtin.h>

#include "catch.h"

namespace plumb::compare {
namespace {

const Engine& engineCalled(const std::string& name) {
    return *std::ranges::find(engines(), name, &Engine::name);
}

OwnSteps ownStepsOf(const Scene& scene, const std::string& engine) {
    return ownSteps(scene, engineCalled(engine), observe(scene, engineCalled(engine)));
}

/// Two bobs on rods of 1 m, let go at two angles from straight down [rad]; the lower one is pushed aside [m].
Scene doublePendulum(double upper, double lower, double aside = 0) {
    const Vec2 first(std::sin(upper), -std::cos(upper));
    const Vec2 second = first + Vec2(std::sin(lower) + aside, -std::cos(lower));
    return {.name = "double",
            .duration = 40,
            .bodies = {{"post", {.type = BodyType::Static, .shapes = {circle(0.05)}}},
                       {"upper", {.position = first, .shapes = {circle(0.1)}}},
                       {"lower", {.position = second, .shapes = {circle(0.1)}}}},
            .joints = {{"rod_1", "post", "upper", DistanceJointDef{.anchorA = {0, 0}, .anchorB = first}},
                       {"rod_2", "upper", "lower", DistanceJointDef{.anchorA = first, .anchorB = second}}}};
}

/// When two runs, of steps dt and dt / parts, are first 1 cm apart at the same time [s].
double centimetreApart(const Observation& a, const Observation& b, std::size_t parts) {
    for (std::size_t tick = 0; tick < a.states.size(); ++tick)
        for (const std::size_t body : {1u, 2u})
            if ((a.states[tick][body].position - b.states[tick * parts][body].position).norm() > 0.01)
                return static_cast<double>(tick) * a.dt;
    return 1e9;
}

}  // namespace

TEST_CASE("a wild double pendulum has a horizon: after its steps are seen, and before two copies 1e-9 apart part",
          "[compare][horizon]") {
    for (const double upper : {2.0, 2.6, 3.0})
        for (const double lower : {1.0, 2.9}) {
            const Scene scene = doublePendulum(upper, lower);
            const Engine& engine = engineCalled("plumb");
            const Observation run = observe(scene, engine);
            Scene halved = scene;
            halved.dt /= 2;
            const double stepsSeen = centimetreApart(run, observe(halved, engine), 2);
            const double copiesPart = centimetreApart(run, observe(doublePendulum(upper, lower, 1e-9), engine), 1);
            const OwnSteps steps = ownSteps(scene, engine, run);
            INFO(upper << ", " << lower << ": steps seen at " << stepsSeen << " s, copies part at " << copiesPart);
            REQUIRE(steps.horizon);
            CHECK(*steps.horizon >= 0.9 * stepsSeen);
            CHECK(*steps.horizon <= copiesPart);
        }
}

TEST_CASE("a throw has no horizon in any engine, and the order of its integration", "[compare][horizon]") {
    const Scene scene = *findScene("projectile");
    for (const Engine& engine : engines()) {
        if (engine.role == Role::Truth) continue;
        const OwnSteps steps = ownSteps(scene, engine, observe(scene, engine));
        INFO(engine.name << ": " << ownStepsText(steps));
        CHECK_FALSE(steps.horizon);
        if (engine.role != Role::Subject) CHECK(steps.order.value_or(0) == Approx(1).margin(0.05));
    }
}

TEST_CASE("a doll that falls has a horizon below 1 s", "[compare][horizon]") {
    Scene doll = *findScene("ragdoll");
    for (const double rate : {60.0, 120.0}) {
        doll.dt = 1 / rate;
        const OwnSteps steps = ownStepsOf(doll, "plumb");
        INFO(rate << " Hz: " << ownStepsText(steps));
        CHECK(steps.horizon.value_or(9) < 1);
        CHECK(steps.horizon.value_or(0) > 0.2);  // it flies until then
    }
}

TEST_CASE("a pendulum shows second order without a closed form, and a gas that no step is small enough",
          "[compare][horizon]") {
    Scene pendulum = *findScene("pendulum_45");
    pendulum.closedForm.reset();
    pendulum.checks.clear();
    CHECK(ownStepsOf(pendulum, "plumb").order.value_or(0) == Approx(2).margin(0.1));
    CHECK(ownStepsOf(pendulum, "box2d-2.4").order.value_or(0) == Approx(1).margin(0.1));
    CHECK(ownStepsOf(*findScene("elastic_gas"), "plumb").horizon);
}

}  // namespace plumb::compare
