// SPDX-License-Identifier: MIT
#include <plumb/ballistics/linear_drag.h>

#include <optional>

#include <plumb/kinematics/linear_drag.h>

#include "cases.h"
#include "catch.h"
#include "kit/ballistics/drag_paths.h"

namespace {

using namespace plumb::test;
using namespace plumb;

LinearDrag randomDrag(Random& random) {
    return {.rate = magnitude(random, 1e-3, 10),
            .wind = towards(random.uniform(-pi, pi), magnitude(random, 0.01, 30)),
            .gravity = randomGravity(random)};
}

PointMotion linearDragFlight(const Vec2& velocity, double time, const LinearDrag& drag) {
    return moveWithDrag({{0, 0}, velocity}, {drag.rate, drag.wind, drag.gravity}, time);
}

/// W0: Halley's method on w e^w = x, for x in (-1/e, 0), to rounding (Corless et al., "On the Lambert W function",
/// 1996).
double lambert(double x) {
    double w = x > -0.25 ? x : -1 + std::sqrt(2 * (1 + std::exp(1) * x));
    for (int i = 0; i < 30; ++i) {
        const double e = std::exp(w), f = w * e - x;
        w -= f / (e * (w + 1) - (w + 2) * f / (2 * w + 2));
    }
    return w;
}

}  // namespace

// Worked numbers of the firing solution, "k = 0.2, 45 degrees, v = 20": T 2.6501815833 s, R 29.091533064 m,
// apex 8.5791237899 m at 1.2666983553 s; "plus wind -5": same T, R 26.126035300 m.
TEST_CASE("20 m/s at 45 degrees with drag of 0.2 / s lands after 2.6501815833 s, wind or not", "[ballistics][facts]") {
    const Vec2 velocity = towards(pi / 4, 20);
    const std::optional<PathPoint> landing = linearDragLanding(velocity, 0, {.rate = 0.2});
    REQUIRE(landing);
    CHECK(std::fabs(landing->time - 2.6501815833) < 5e-11);
    CHECK((landing->position - Vec2(29.091533064, 0)).norm() < 5e-10);
    const std::optional<PathPoint> apex = linearDragApex(velocity, {.rate = 0.2});
    REQUIRE(apex);
    CHECK(std::fabs(apex->time - 1.2666983553) < 5e-11);
    CHECK(std::fabs(apex->position.y() - 8.5791237899) < 5e-11);

    const std::optional<PathPoint> blown = linearDragLanding(velocity, 0, {.rate = 0.2, .wind = {-5, 0}});
    REQUIRE(blown);
    CHECK(std::fabs(blown->time - 2.6501815833) < 5e-11);
    CHECK((blown->position - Vec2(26.126035300, 0)).norm() < 5e-10);
}

TEST_CASE("10,000 flights through linear drag agree with a Runge-Kutta method of order 4", "[ballistics]") {
    Random random(167);
    Worst place("linear drag: place off / path"), speed("linear drag: velocity off / largest speed");
    for (int i = 0; i < 10'000; ++i) {
        const LinearDrag drag = randomDrag(random);
        const Vec2 start = towards(random.uniform(-pi, pi), magnitude(random, 0.1, 100));
        const double end = magnitude(random, 1e-3, 3) / std::max(drag.rate, 0.3);
        const PointMotion state = linearDragFlight(start, end, drag);
        // The classical method of order 4 in 400 steps of at most 0.0075 / k: its error is (k h)^4 / 120 = 3e-11.
        const auto rateAt = [&](const FlightVector& s) {
            const Vec2 a = drag.gravity - drag.rate * (Vec2(s[2], s[3]) - drag.wind);
            return FlightVector(s[2], s[3], a.x(), a.y());
        };
        FlightVector s(0, 0, start.x(), start.y());
        const double h = end / 400;
        double path = 0, fastest = start.norm();
        for (int k = 0; k < 400; ++k) {
            const FlightVector k1 = rateAt(s), k2 = rateAt(s + h / 2 * k1), k3 = rateAt(s + h / 2 * k2);
            const FlightVector k4 = rateAt(s + h * k3);
            s += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
            path += h * s.tail<2>().norm();
            fastest = std::max(fastest, s.tail<2>().norm());
        }
        const auto where = [&] {
            return describe("velocity", start, "time", end, "rate", drag.rate, "wind", drag.wind);
        };
        place.hold((state.position - s.head<2>()).norm() / path, where);
        speed.hold((state.velocity - s.tail<2>()).norm() / fastest, where);
    }
    place.print();
    speed.print();
    CHECK(place.value() < 1e-10);
    CHECK(speed.value() < 1e-10);
}

TEST_CASE("apex and landing through linear drag are where 100,000 flights turn and touch the ground", "[ballistics]") {
    Random random(173);
    Worst turn("linear drag apex: upward speed / launch speed"), ground("linear drag landing: height off / path");
    Worst wright("linear drag landing: time off Lambert's W, relative");
    int wrong = 0, apexes = 0, landings = 0;
    for (int i = 0; i < cases(100'000); ++i) {
        const LinearDrag drag = randomDrag(random);
        const Vec2 start = towards(random.uniform(-pi, pi), magnitude(random, 0.1, 100));
        const double height = random.integer(0, 2) == 0 ? 0 : random.uniform(-1, 3) * magnitude(random, 0.01, 100);
        const auto where = [&] {
            return describe("velocity", start, "height", height, "rate", drag.rate, "wind", drag.wind, "gravity",
                            drag.gravity);
        };
        const std::optional<PathPoint> apex = linearDragApex(start, drag);
        const std::optional<PathPoint> landing = linearDragLanding(start, height, drag);
        const auto heightAt = [&](double t) {
            return static_cast<double>(seenUpright(linearDragFlight(start, t, drag).position, drag.gravity).y) + height;
        };
        const double scale = (start.norm() + drag.wind.norm()) / drag.gravity.norm();
        double path = 0;
        if (apex) {
            ++apexes;
            const Vec2 there = linearDragFlight(start, apex->time, drag).velocity;
            turn.hold(
                std::fabs(static_cast<double>(seenUpright(there, drag.gravity).y)) / (start.norm() + drag.wind.norm()),
                where);
        }
        if (landing) {
            ++landings;
            for (int k = 1; k <= 64; ++k)
                path += linearDragFlight(start, landing->time * k / 64, drag).velocity.norm() * landing->time / 64;
            if (landing->time > 0) ground.hold(std::fabs(heightAt(landing->time)) / path, where);
        }
        // Is it above the ground at the launch, or at the apex, and below it later, at a time long after?
        const bool above = height > 0 || (apex && heightAt(apex->time) > 0) || (height == 0 && !apex);
        const bool below = heightAt(1e5 * (scale + 1 / drag.rate)) < 0;
        const bool upwind = drag.rate * seenUpright(drag.wind, drag.gravity).y > 0.99 * drag.gravity.norm();
        if (!upwind) wrong += (above && below) != landing.has_value();
        // T = (q + W0(-q e^-q)) / k, without wind along gravity, Worked numbers of the firing solution.
        const double rise = static_cast<double>(seenUpright(start, drag.gravity).y);
        LinearDrag level = drag;
        level.wind = perp(drag.gravity) * 0.3;
        const std::optional<PathPoint> back = linearDragLanding(start, 0, level);
        const double q = 1 + drag.rate * rise / drag.gravity.norm();
        if (rise > 0 && q > 1.1)  // towards q = 1 W0 cancels q
            wright.hold(back ? std::fabs(back->time * drag.rate / (q + lambert(-q * std::exp(-q))) - 1) : 1, where);
    }
    for (const Worst* worst : {&turn, &ground, &wright}) worst->print();
    CHECK(wrong == 0);
    CHECK(apexes > cases(100'000) / 10);
    CHECK(landings > cases(100'000) / 10);
    CHECK(turn.value() < 1e-13);
    CHECK(ground.value() < 1e-12);
    CHECK(wright.value() < 1e-12);
}

TEST_CASE("as drag goes to 0, apex and landing go to those without it, and updraught carries a shot away",
          "[ballistics]") {
    for (const double rate : {1e-6, 1e-9, 1e-100, 0.0}) {
        const std::optional<PathPoint> landing = linearDragLanding({10, 9.81}, 0, {.rate = rate});
        REQUIRE(landing);
        CHECK(std::fabs(landing->time - 2) < 2 * rate + 1e-15);
        CHECK((landing->position - Vec2(20, 0)).norm() < 40 * rate + 1e-14);
        CHECK(std::fabs(linearDragApex({10, 9.81}, {.rate = rate})->time - 1) < rate + 1e-15);
    }
    CHECK_FALSE(linearDragLanding({10, 5}, 0, {.rate = 1, .wind = {0, 10}}));
    CHECK_FALSE(linearDragApex({10, 5}, {.rate = 1, .wind = {0, 10}}));
    // Thrown down at 1 m/s into an updraught that holds it up: 1 / (1 s) deep at most.
    CHECK(linearDragLanding({0, -1}, 0.9, {.rate = 1, .wind = {0, 9.81}}));
    CHECK_FALSE(linearDragLanding({0, -1}, 1.1, {.rate = 1, .wind = {0, 9.81}}));
    CHECK_FALSE(linearDragLanding({1, 1}, 0, {.rate = 1, .gravity = {0, 0}}));
    CHECK_THROWS_WITH(linearDragApex({1, 1}, {.rate = -1}), containsText("LinearDrag.rate: -1 is not within"));
}
