// SPDX-License-Identifier: MIT
#include <compare/metric/metrics.h>

#include <cmath>

#include "catch.h"
#include "compare/scripted.h"

namespace plumb::compare {
namespace {

using Catch::Matchers::WithinAbs;

constexpr double probeRounding = 1e-12;

/// A force that settles: 20 N, from 0.5 s on 10 N and a bit.
Scene withForce(double expected, double from) {
    Scene scene = oneDisc();
    Probe probe;
    probe.name = "normal";
    probe.quantity = NormalForceProbe{"disc", "disc"};
    probe.expected = expected;
    probe.from = from;
    scene.probes = {probe};
    return scene;
}

Observation settling(const Scene& scene) {
    return observe(scene, scripted("plumb", {[](double) { return std::vector<BodyState>{at(0, 0)}; },
                                             [](double t) { return std::vector<double>{t < 0.45 ? 20 : 10.25}; }}));
}

Scene withAngle(double expected) {
    Scene scene = oneDisc();
    Probe probe;
    probe.name = "turn";
    probe.quantity = AngleProbe{"disc"};
    probe.expected = expected;
    scene.probes = {probe};
    return scene;
}

Observation turning(const Scene& scene, const std::string& engine, double rate) {
    return observe(scene, scripted(engine, {[rate](double t) {
                                       BodyState state;
                                       state.angle = rate * t;
                                       return std::vector<BodyState>{state};
                                   }}));
}

}  // namespace

TEST_CASE("a force is watched from its time on: 0.25 N off from 0.5 s, 10 N off from the start", "[compare][metric]") {
    const Scene late = withForce(10, 0.5);
    CHECK_THAT(*probeError(late, 0, settling(late), nullptr), WithinAbs(0.25, probeRounding));
    const Scene early = withForce(10, 0);
    CHECK_THAT(*probeError(early, 0, settling(early), nullptr), WithinAbs(10, probeRounding));
}

TEST_CASE("a probe that is watched from later than the run lasts has no error", "[compare][metric]") {
    const Scene scene = withForce(10, 1.5);
    CHECK_FALSE(probeError(scene, 0, settling(scene), nullptr));
}

TEST_CASE("a force that the engine cannot tell has no error", "[compare][metric]") {
    const Scene scene = withForce(10, 0);
    CHECK_FALSE(probeError(scene, 0, observe(scene, standing("box2d-2.4", 0)), nullptr));
}

TEST_CASE("an angle is held against the closed form where there is one, else against what is expected",
          "[compare][metric]") {
    const Scene scene = withAngle(2);
    const Observation seen = turning(scene, "plumb", 3);
    const Observation truth = turning(scene, "closed-form", 2.5);
    CHECK_THAT(*probeError(scene, 0, seen, &truth), WithinAbs(0.5, probeRounding));  // after 1 s
    CHECK_THAT(*probeError(scene, 0, seen, nullptr), WithinAbs(2, probeRounding));   // at the start
    const Observation silent = turning(scene, "closed-form", nan);
    CHECK_THAT(*probeError(scene, 0, seen, &silent), WithinAbs(2, probeRounding));
}

TEST_CASE("an angle watched after the closed form has ended is held against what is expected", "[compare][metric]") {
    Scene scene = withAngle(2.75);
    scene.probes[0].from = 1;
    Observation truth = turning(scene, "closed-form", 2.5);
    truth.states.back()[0].angle = nan;
    CHECK_THAT(*probeError(scene, 0, turning(scene, "plumb", 3), &truth), WithinAbs(0.25, probeRounding));
}

TEST_CASE("an angle that is not a number is an error without bound", "[compare][metric]") {
    const Scene scene = withAngle(2);
    const Observation truth = turning(scene, "closed-form", 2.5);
    CHECK(probeError(scene, 0, turning(scene, "box2d-3", nan), &truth) == infinity);
    CHECK(probeError(scene, 0, turning(scene, "box2d-3", nan), nullptr) == infinity);
}

TEST_CASE("of a swing that grows, the largest and the last value are watched, and none after the end",
          "[compare][metric]") {
    // 0.1 s a step: -t at even ticks, t at odd ones
    const auto swing = [](double t) {
        BodyState state;
        state.angle = std::lround(t * 10) % 2 == 0 ? -t : t;
        return std::vector<BodyState>{state};
    };
    Scene scene = withAngle(0.7);
    scene.probes[0].until = 0.8;
    scene.probes[0].watch = Watch::Largest;
    const Observation seen = observe(scene, scripted("plumb", {swing}));
    CHECK_THAT(*probeError(scene, 0, seen, nullptr), WithinAbs(1.5, probeRounding));  // -0.8 is the farthest
    scene.probes[0].until = 0.7;
    CHECK_THAT(*probeError(scene, 0, seen, nullptr), WithinAbs(0, probeRounding));
    scene.probes[0].watch = Watch::Last;
    scene.probes[0].until = 0.6;
    CHECK_THAT(*probeError(scene, 0, seen, nullptr), WithinAbs(1.3, probeRounding));
    scene.probes[0].watch = Watch::Every;
    scene.probes[0].from = 0.3;
    CHECK_THAT(*probeError(scene, 0, seen, nullptr), WithinAbs(1.3, probeRounding));
}

TEST_CASE("the largest angle is held against the largest of the closed form, whenever that comes",
          "[compare][metric]") {
    Scene scene = withAngle(9);
    scene.probes[0].watch = Watch::Largest;
    const auto rising = [](double peak) {
        return [peak](double t) {
            BodyState state;
            state.angle = t < 0.55 ? peak * t : peak * (1 - t);
            return std::vector<BodyState>{state};
        };
    };
    const Observation truth = observe(scene, scripted("closed-form", {rising(1)}));
    const Observation seen = observe(scene, scripted("plumb", {rising(1.5)}));
    CHECK_THAT(*probeError(scene, 0, seen, &truth), WithinAbs(0.25, probeRounding));  // 0.75 for 0.5
}

TEST_CASE("places, speeds, limits and broken joints are read from what is seen", "[compare][metric]") {
    Scene scene = oneDisc();
    scene.bodies.push_back({"post", {.type = BodyType::Static}});
    scene.joints = {{"hinge", "post", "disc", RevoluteJointDef{.limit = Limit{-0.25, 0.25}, .breaking = {.force = 1}}}};
    const std::vector<std::pair<Quantity, double>> expected{{PositionProbe{"disc", {0, 1}}, 2},
                                                            {PositionProbe{"disc", {0.6, 0.8}}, 2.2},
                                                            {VelocityProbe{"disc", {1, 0}}, 3},
                                                            {LimitProbe{"hinge"}, 0.75},
                                                            {JointBrokenProbe{"hinge"}, 0}};
    for (const auto& [quantity, value] : expected) {
        scene.probes = {{.name = "p", .quantity = quantity, .expected = value}};
        BodyState disc = at(1, 2);
        disc.velocity = {3, 4};
        disc.angle = 1;
        const auto states = [disc](double) { return std::vector<BodyState>{disc, at(0, 0)}; };
        INFO(value);
        const Observation seen = observe(scene, scripted("plumb", {states}));
        CHECK_THAT(*probeError(scene, 0, seen, nullptr), WithinAbs(0, probeRounding));
    }
}

}  // namespace plumb::compare
