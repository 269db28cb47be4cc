// SPDX-License-Identifier: MIT
#include <plumb/integrate/adaptive_integrator.h>

#include <plumb/integrate/integrate.h>

#include <cmath>
#include <iostream>

#include "catch.h"
#include "kit/integrate/methods.h"
#include "kit/integrate/oscillator.h"

using namespace plumb;
using namespace plumb::test;

TEST_CASE("an oscillator is within the tolerance times the steps after 100 s", "[integrate]") {
    for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
        const Integration<Vector2> found = integrate(oscillator, 0, Vector2(1, 0), 100,
                                                     {.absoluteTolerance = tolerance, .relativeTolerance = tolerance});
        const double error = (found.state - Vector2(std::cos(100.0), -std::sin(100.0))).norm();
        std::cout << "integrate, oscillator at tolerance " << tolerance << ": off by " << error << " in "
                  << found.accepted << " steps\n";
        CHECK(found.end == IntegrationEnd::Reached);
        CHECK(found.time == 100);
        CHECK(error < tolerance * found.accepted);
        CHECK(std::fabs(found.state.squaredNorm() - 1) < tolerance * found.accepted);  // its energy drifts slowly
    }
}

// The error allowed is relative to e^t: each step adds its own, and e^t carries it on unchanged.
TEST_CASE("growth to e^20 is as exact, relatively, as decay to e^-20", "[integrate]") {
    const AdaptiveSettings relative{.absoluteTolerance = 0, .relativeTolerance = 1e-10};
    for (const double rate : {1.0, -1.0}) {
        const auto slope = [=](double, const Number& y) -> Number { return rate * y; };
        const Integration<Number> found = integrate(slope, 0, Number(1), 20, relative);
        CHECK(std::fabs(found.state[0] / std::exp(20 * rate) - 1) < 1e-10 * found.accepted);
    }
}

TEST_CASE("a walk backwards in time comes back to where it was", "[integrate]") {
    const auto swing = [](double t, const Vector2& y) -> Vector2 {
        return {y[1], -std::sin(y[0]) + 0.3 * std::cos(t)};
    };
    const Vector2 start(2, 0.5);
    const Integration<Vector2> there = integrate(swing, 1, start, 9);
    const Integration<Vector2> back = integrate(swing, 9, there.state, 1);
    CHECK(back.time == 1);
    CHECK((back.state - start).norm() < 1e-9 * (there.accepted + back.accepted) * 10);  // the pendulum amplifies
}

TEST_CASE("no step is longer than asked, and the steps of a walk join up", "[integrate]") {
    AdaptiveIntegrator walk(oscillator, 0.0, Vector2(1, 0), 7.0, {.maxStep = 0.1});
    double last = 0;
    int steps = 0;
    while (walk.advance()) {
        ++steps;
        CHECK(walk.startTime() == last);
        CHECK(walk.time() - walk.startTime() <= 0.1 * (1 + 1e-12));
        CHECK(walk.lastStep().at(0) == walk.lastStep().start);
        CHECK((walk.lastStep().at(1) - walk.lastStep().end).norm() < 1e-15);
        last = walk.time();
    }
    CHECK(walk.end() == IntegrationEnd::Reached);
    CHECK(last == 7);
    CHECK(walk.accepted() == steps);
    CHECK(steps >= 70);
    CHECK_FALSE(walk.advance());
}

// Of fourth order everywhere, so halving the step divides a single step's error by 2^5, within the next term of
// it.
TEST_CASE("the state within a step is of fourth order", "[integrate]") {
    const auto errorAt = [](double fraction, double h) {
        const Vector2 start(std::cos(0.3), -std::sin(0.3));
        const DormandPrinceStep<Vector2> step = dormandPrinceStep(oscillator, 0, start, oscillator(0, start), h);
        const double t = 0.3 + fraction * h;
        return (step.at(fraction) - Vector2(std::cos(t), -std::sin(t))).norm();
    };
    for (const double fraction : {0.2, 0.5, 0.77})
        CHECK(std::fabs(std::log2(errorAt(fraction, 0.1) / errorAt(fraction, 0.05)) - 5) < 0.1);
}

TEST_CASE("whatever is integrated ends, and says why", "[integrate]") {
    const auto run = [](auto slope, double start, double endTime, const AdaptiveSettings& settings = {}) {
        const auto ofNumber = [&](double t, const Number& y) -> Number { return Number(slope(t, y[0])); };
        const Integration<Number> found = integrate(ofNumber, 0, Number(start), endTime, settings);
        CHECK(found.accepted + found.rejected <= settings.maxSteps);
        CHECK(std::isfinite(found.state[0]));
        return found;
    };
    const Integration<Number> pole = run([](double, double y) { return y * y; }, 1, 2);
    CHECK(pole.end == IntegrationEnd::StepTooSmall);
    CHECK(std::fabs(pole.time - 1) < 1e-6);
    const Integration<Number> nan = run([](double t, double) { return t < 0.5 ? 1 : NAN; }, 1, 2);
    CHECK(nan.end == IntegrationEnd::NotFinite);
    CHECK(std::fabs(nan.time - 0.5) < 1e-12);
    CHECK(std::fabs(nan.state[0] - 1.5) < 1e-12);
    const Integration<Number> jump = run([](double t, double) { return t < 0.3 ? 1 : -1; }, 1, 2);
    CHECK(jump.end == IntegrationEnd::Reached);
    CHECK(std::fabs(jump.state[0] + 0.4) < 1e-6);  // the estimate sees a jump, but not all of it
    CHECK(run([](double, double y) { return -1e9 * y; }, 1, 2, {.maxSteps = 1000}).end == IntegrationEnd::TooManySteps);
    CHECK(run([](double t, double) { return 1e9 * (std::fmod(t * 1e9, 1) - 0.5); }, 1, 2).end ==
          IntegrationEnd::TooManySteps);
    CHECK(run([](double, double) { return INFINITY; }, 1, 2).end == IntegrationEnd::NotFinite);
    CHECK(run([](double, double y) { return y; }, 1e308, 20).end == IntegrationEnd::NotFinite);
    CHECK(run([](double, double) { return 1e307; }, 0, 20).end == IntegrationEnd::NotFinite);
    CHECK(run([](double, double) { return 0; }, 0, 1e300).end == IntegrationEnd::Reached);
    CHECK(run([](double, double) { return 0; }, 3, 0).accepted == 0);
}

TEST_CASE("a start that is no number is refused by name", "[integrate]") {
    CHECK_THROWS_WITH(integrate(oscillator, NAN, Vector2(1, 0), 1), "time: nan is not finite");
    CHECK_THROWS_WITH(integrate(oscillator, 0, Vector2(1, 0), INFINITY), "endTime: inf is not finite");
    CHECK_THROWS_WITH(integrate(oscillator, -1e308, Vector2(1, 0), 1e308), "endTime - time: inf is not finite");
    CHECK_THROWS_WITH(integrate(oscillator, 0, Vector2(1, NAN), 1), "state: nan is not finite");
    CHECK_THROWS_WITH(integrate(oscillator, 0, Vector2(1, 0), 1, {.maxSteps = -3}),
                      "AdaptiveSettings.maxSteps: -3 is not positive");
    const auto longer = [](double, const Eigen::VectorXd&) -> Eigen::VectorXd { return Eigen::Vector3d(1, 2, 3); };
    CHECK_THROWS_WITH(integrate(longer, 0, Eigen::VectorXd(Vector2(1, 0)), 1),
                      "derivative: size 3 is not the state's, 2");
}

TEST_CASE("an equation that has no slope where the first guess tries it is followed to where its slopes end",
          "[integrate]") {
    // y' = sqrt(end - t) from 1: y = 1 + 2 (end^1.5 - (end - t)^1.5) / 3 until the end, and nothing beyond.
    for (const double end : {0.005, 1e-4, 1e-7, 1e-12}) {
        const auto slope = [=](double t, const Number&) -> Number { return Number(std::sqrt(end - t)); };
        const Integration<Number> found = integrate(slope, 0, Number(1), 2 * end);
        CHECK(found.end == IntegrationEnd::NotFinite);
        CHECK(found.time <= end);
        CHECK(found.time > end * (1 - 1e-9));
        const double left = end - found.time, truth = 1 + 2.0 / 3 * (end * std::sqrt(end) - left * std::sqrt(left));
        CHECK(std::fabs(found.state[0] - truth) < 2e-9 * found.accepted);
    }
    // Backwards as well, and where there is a slope at the start and no other.
    const auto before = [](double t, const Number&) -> Number { return Number(std::sqrt(t - 1)); };
    const Integration<Number> back = integrate(before, 1.005, Number(1), 0);
    CHECK(back.end == IntegrationEnd::NotFinite);
    CHECK(std::fabs(back.time - 1) < 1e-9);
    const auto only = [](double t, const Number&) -> Number { return Number(t == 0 ? 1 : NAN); };
    CHECK(integrate(only, 0, Number(1), 1).end == IntegrationEnd::NotFinite);
    CHECK(integrate(only, 0, Number(1), 1).time == 0);
}
