// SPDX-License-Identifier: MIT
// Can the labs' checks fail? Each lab is given something wrong to put to the test, and those that watch it turn red.
#include <compare/lab/builtin/labs.h>

#include <algorithm>
#include <set>
#include <string>

#include "catch.h"
#include "compare/scripted.h"

namespace plumb::compare {
namespace {

using Names = std::set<std::string>;

Names failing(const LabResult& result) {
    Names names;
    for (const LabOutcome& outcome : result.outcomes)
        if (!outcome.pass) names.insert(outcome.check.name);
    return names;
}

/// The engine of this build that has this name, called Plumb.
Engine disguised(const std::string& name) {
    const std::vector<Engine>& all = engines();
    Engine engine = *std::ranges::find(all, name, &Engine::name);
    engine.name = "plumb";
    return engine;
}

/// All bodies but the windows go on as if there were none.
Engine ghostly() {
    Engine engine = disguised("plumb");
    engine.build = [build = engine.build](const Scene& scene) {
        Scene ghosts = scene;
        for (SceneBody& body : ghosts.bodies)
            for (ShapeDef& shape : body.def.shapes) shape.filter.mask = 0;
        return build(ghosts);
    };
    return engine;
}

std::vector<Method> withWrong(const std::string& tag, decltype(Method::step) step) {
    std::vector<Method> methods = knownMethods();
    std::ranges::find(methods, tag, &Method::tag)->step = std::move(step);
    return methods;
}

PairFinder without(BroadPhase wrong, BroadPhase instead) {
    return [=](BroadPhase way, std::span<const Aabb> boxes) { return findPairs(way == wrong ? instead : way, boxes); };
}

}  // namespace

TEST_CASE("a clock that cuts frames of 1/20 s, or has another interval, turns the frame rate lab red",
          "[compare][lab]") {
    CHECK(failing(runLab(frameRate({.interval = 0.02, .longestElapsed = 0.045}), {}, {})) ==
          Names{"clock.states_that_differ", "clock.ticks_off", "clock.spread", "clock.error"});
    CHECK(failing(runLab(frameRate({.interval = 0.021}), {}, {})).contains("clock.ticks_off"));
}

TEST_CASE("a textbook ball that ends in the same place at any rate turns the frame rate lab red", "[compare][lab]") {
    Method still = textbookMethod();
    still.step = [](const MotionProblem&, const Motion& from, double) { return from; };
    CHECK(failing(runLab(frameRate({.interval = 0.02}, still), {}, {})) == Names{"textbook.spread"});
}

TEST_CASE("an engine whose ball depends on the step turns the frame rate lab red", "[compare][lab]") {
    CHECK(failing(runLab(frameRate(), {}, {disguised("box2d-2.4")})) == Names{"variable.spread.plumb"});
}

TEST_CASE("an RK4 with a weight 1 % off is of first order, and its energy drifts", "[compare][lab]") {
    const auto wrong = [rk4 = knownMethods().at(4).step](const MotionProblem& problem, const Motion& from, double h) {
        Motion to = rk4(problem, from, h);
        to.velocity += 0.01 * h * problem.acceleration(from.position);
        return to;
    };
    CHECK(failing(runLab(integrators(withWrong("rk4", wrong)), {}, {})) ==
          Names{"energy.oscillator.rk4", "order.oscillator.rk4", "order.orbit.rk4"});
}

TEST_CASE("methods that change places turn the integrators lab red", "[compare][lab]") {
    std::vector<Method> methods = knownMethods();
    std::swap(methods.at(0).step, methods.at(1).step);
    std::swap(methods.at(2).step, methods.at(3).step);
    const Names red = failing(runLab(integrators(methods), {}, {}));
    CHECK(red == Names{"energy.oscillator.explicit_euler.off", "energy.oscillator.semi_implicit_euler",
                       "energy.oscillator.velocity_verlet"});
}

TEST_CASE("an engine of first order turns the convergence lab red", "[compare][lab][slow]") {
    const auto asItIs = [](const Engine& engine) { return engine; };
    CHECK(failing(runLab(convergence(asItIs), {}, {disguised("box2d-2.4")})) ==
          Names{"plumb.double_four_bar.energy.coarse", "plumb.double_four_bar.energy.fine", "plumb.pendulum.order"});
}

TEST_CASE("a grid that tests as sweep and prune does, and a hierarchy that tests each against each, turn red",
          "[compare][lab][slow]") {
    CHECK(failing(runLab(broadPhases(without(BroadPhase::Grid, BroadPhase::SweepAndPrune)), {}, {})) ==
          Names{"tests.even.grid"});
    CHECK(failing(runLab(broadPhases(without(BroadPhase::Bvh, BroadPhase::BruteForce)), {}, {})) ==
          Names{"tests.even.bvh"});
    CHECK(failing(runLab(broadPhases(without(BroadPhase::BruteForce, BroadPhase::Bvh)), {}, {})) ==
          Names{"tests.even.brute_force.off"});
    for (const BroadPhase other : {BroadPhase::BruteForce, BroadPhase::Grid, BroadPhase::Bvh})
        CHECK(failing(runLab(broadPhases(without(BroadPhase::SweepAndPrune, other)), {}, {})) ==
              Names{"tests.even.sweep_and_prune.off"});
}

TEST_CASE("a broad phase that loses one pair of thousands turns red", "[compare][lab]") {
    const PairFinder careless = [](BroadPhase way, std::span<const Aabb> boxes) {
        PairSearch search = findPairs(way, boxes);
        if (way == BroadPhase::Grid && search.pairs.size() > 1000) search.pairs.pop_back();
        return search;
    };
    CHECK(failing(runLab(broadPhases(careless), {}, {})) == Names{"pairs_that_differ"});
}

TEST_CASE("a swept test that looks at the ends only, and an overlap test that is swept, turn red", "[compare][lab]") {
    FrameTests tests = lectureTests();
    tests.swept = tests.overlapAtEnd;
    CHECK(failing(runLab(bulletAndWindow(tests), {}, {})) == Names{"swept.missed"});
    tests = lectureTests();
    tests.overlapAtEnd = tests.swept;
    CHECK(failing(runLab(bulletAndWindow(tests), {}, {})) ==
          Names{"overlap.off_expected", "overlap.missed_fastest", "bisection.differs_from_overlap"});
    tests = lectureTests();
    tests.overlapAtEnd = [](const Scene&, int) { return false; };
    CHECK(failing(runLab(bulletAndWindow(tests), {}, {})).contains("overlap.missed_below_safe_speed"));
}

TEST_CASE("an engine that lets bullets through what is fixed turns red", "[compare][lab]") {
    CHECK(failing(runLab(bulletAndWindow(), {}, {ghostly()})) == Names{"plumb.missed.fixed"});
}

TEST_CASE("the forecast lab fails a forecast that is off by a billionth of a step", "[compare][lab]") {
    const auto ofPlumb = [](const Lab& lab) { return failing(runLab(lab, {subjectName()}, engines())); };
    CHECK(ofPlumb(forecasts()).empty());
    CHECK(ofPlumb(forecasts([](const World& world, const BodyDef& shot, int ticks, double dt) {
              return forecast(world, shot, ticks, dt * (1 + 1e-9));
          })) == Names{"hits_off", "ticks_off"});
}

TEST_CASE("the forecast lab fails a forecast whose velocities are a tick late, or that leaves out a hit",
          "[compare][lab]") {
    const auto ofPlumb = [](const Lab& lab) { return failing(runLab(lab, {subjectName()}, engines())); };
    CHECK(ofPlumb(forecasts([](const World& world, const BodyDef& shot, int ticks, double dt) {
              Forecast late = forecast(world, shot, ticks, dt);
              std::rotate(late.velocities.begin(), late.velocities.end() - 1, late.velocities.end());
              return late;
          })) == Names{"ticks_off"});
    CHECK(ofPlumb(forecasts([](const World& world, const BodyDef& shot, int ticks, double dt) {
              Forecast careless = forecast(world, shot, ticks, dt);
              if (careless.hits.size() > 3) careless.hits.pop_back();
              return careless;
          })) == Names{"hits_off"});
}

}  // namespace plumb::compare
