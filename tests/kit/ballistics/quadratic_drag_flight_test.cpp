// SPDX-License-Identifier: MIT
#include <plumb/ballistics/quadratic_drag_aim.h>
#include <plumb/ballistics/quadratic_drag_flight.h>

#include "cases.h"
#include "catch.h"
#include "kit/ballistics/shots.h"

using namespace plumb::test;
using namespace plumb;

namespace {

/// Runge and Kutta's classical method of order 4 in equal steps.
FlightPoint inSmallSteps(const Vec2& velocity, double time, int steps, const QuadraticDrag& drag) {
    const auto slope = [&](const Vec2& u) -> Vec2 { return Vec2(0, -drag.gravity) - drag.coefficient * u.norm() * u; };
    FlightPoint at{{0, 0}, velocity, time};
    const double h = time / steps;
    for (int i = 0; i < steps; ++i) {
        const Vec2 u = at.velocity;
        const Vec2 k1 = slope(u), k2 = slope(u + h / 2 * k1), k3 = slope(u + h / 2 * k2), k4 = slope(u + h * k3);
        at.position += h * u + h * h / 6 * (k1 + k2 + k3);
        at.velocity += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return at;
}

}  // namespace

TEST_CASE("a vertical flight through quadratic drag is the closed form's", "[ballistics]") {
    Random random(192);
    Worst apex("vertical flight: apex off, relative"), landing("vertical flight: landing off, relative");
    for (int i = 0; i < cases(3000); ++i) {
        const QuadraticDrag drag{magnitude(random, 1e-6, 10), magnitude(random, 0.1, 100)};
        const double speed = magnitude(random, 1e-4, 1e3) * terminalSpeed(drag);
        const auto where = [&] { return describe("c", drag.coefficient, "g", drag.gravity, "speed", speed); };
        const VerticalShot shot = shootUp(speed, drag);
        const auto top = quadraticDragApex({0, speed}, drag);
        const auto down = quadraticDragLanding({0, speed}, 0, drag);
        REQUIRE((top && down));
        apex.hold(std::fabs(top->position.y() / shot.height - 1), where);
        apex.hold(std::fabs(top->time / shot.riseTime - 1), where);
        landing.hold(std::fabs(down->time / (shot.riseTime + shot.fallTime) - 1), where);
        landing.hold(std::fabs(-down->velocity.y() / shot.returnSpeed - 1), where);
        landing.hold(std::fabs(down->position.y()) / shot.height, where);
        const double time = magnitude(random, 1e-3, 1e3) * terminalSpeed(drag) / drag.gravity;
        const Fall fall = fallFor(time, drag);
        const auto fallen = quadraticDragFlight({0, 0}, time, drag);
        const auto dropped = quadraticDragLanding({0, 0}, fall.distance, drag);
        REQUIRE((fallen && dropped));
        landing.hold(std::fabs(-fallen->position.y() / fall.distance - 1), where);
        landing.hold(std::fabs(dropped->time / time - 1), where);
    }
    for (const Worst* worst : {&apex, &landing}) worst->print();
    CHECK(apex.value() < 1e-11);
    CHECK(landing.value() < 1e-11);
}

TEST_CASE("an oblique flight through quadratic drag is that of 100,000 small steps", "[ballistics]") {
    for (const double angle : {-1.2, 0.0, 0.3, 0.8, 1.5}) {
        for (const double coefficient : {1e-4, 5e-3, 0.2}) {
            const QuadraticDrag drag{.coefficient = coefficient};
            const Vec2 velocity = 40 * Vec2(std::cos(angle), std::sin(angle));
            INFO("angle " << angle << ", c " << coefficient);
            // The order is 4: 1e5 steps of 8 s are wrong by rounding alone.
            const auto flight = quadraticDragFlight(velocity, 8, drag);
            REQUIRE(flight);
            const FlightPoint truth = inSmallSteps(velocity, 8, 100'000, drag);
            CHECK((flight->position - truth.position).norm() < 1e-10 * (1 + truth.position.norm()));
            CHECK((flight->velocity - truth.velocity).norm() < 1e-10 * 40);
            const auto landing = quadraticDragLanding(velocity, 20, drag);
            REQUIRE(landing);
            const FlightPoint there = inSmallSteps(velocity, landing->time, 100'000, drag);
            CHECK((landing->position - there.position).norm() < 1e-9);
            CHECK(std::fabs(landing->position.y() + 20) < 1e-10);
            const auto apex = quadraticDragApex(velocity, drag);
            CHECK(apex.has_value() == (angle > 0));
            if (!apex) continue;
            CHECK(std::fabs(apex->velocity.y()) < 1e-10);
            CHECK((inSmallSteps(velocity, apex->time, 100'000, drag).position - apex->position).norm() < 1e-9);
        }
    }
}

TEST_CASE("a shot aimed through quadratic drag passes its target when the aim says", "[ballistics]") {
    Random random(193);
    int shots = 0;
    Worst missed("quadratic drag flight: distance from the target, relative");
    for (int i = 0; i < cases(5000); ++i) {
        const QuadraticDragAim aim{.target = {random.uniform(-60, 60), random.uniform(-40, 40)},
                                   .speed = random.uniform(5, 80),
                                   .coefficient = magnitude(random, 1e-5, 0.1)};
        for (const Shot& shot : aimThroughQuadraticDrag(aim)) {
            const auto there = quadraticDragFlight(shot.velocity, shot.time, {.coefficient = aim.coefficient});
            REQUIRE(there);
            const double length = aim.speed * shot.time;
            missed.hold((there->position - aim.target).norm() / length,
                        [&] { return describe("c", aim.coefficient, "speed", aim.speed, "time", shot.time); });
            ++shots;
        }
    }
    missed.print();
    CHECK(shots > cases(5000) / 2);
    CHECK(missed.value() < 2e-9);  // the aim's own bound is 1e-9
}

TEST_CASE("flights without drag are parabolas, and those that cannot land have no landing", "[ballistics]") {
    const auto apex = quadraticDragApex({3, 20}, {.gravity = 10});
    REQUIRE(apex);
    CHECK((apex->position - Vec2(6, 20)).norm() < 1e-14);
    const auto landing = quadraticDragLanding({3, 20}, 25, {.gravity = 10});
    REQUIRE(landing);
    CHECK(std::fabs(landing->time - 5) < 1e-14);
    CHECK((landing->position - Vec2(15, -25)).norm() < 1e-13);
    for (const double c : {0.0, 1e-3}) {
        const QuadraticDrag drag{.coefficient = c};
        CHECK(!quadraticDragApex({3, 0}, drag));
        CHECK(!quadraticDragLanding({3, 1}, -1, drag));
        CHECK(!quadraticDragLanding({3, -1}, -1, drag));
        CHECK(quadraticDragLanding({3, -1}, 0, drag)->time == 0);
        CHECK(std::fabs(quadraticDragLanding({3, 10}, -1, drag)->position.y() - 1) < 1e-12);
    }
    // The least drag makes no difference to either.
    const auto slight = quadraticDragLanding({3, 20}, 25, {.coefficient = 1e-20, .gravity = 10});
    REQUIRE(slight);
    CHECK((slight->position - Vec2(15, -25)).norm() < 1e-10);
    // After long it has gone as far as it can, and falls straight.
    const auto late = quadraticDragFlight({30, 10}, 1e6, {.coefficient = 0.1});
    const double terminal = terminalSpeed({.coefficient = 0.1});
    REQUIRE(late);
    CHECK(late->velocity.x() == 0);
    CHECK(std::fabs(late->velocity.y() / terminal + 1) < 1e-12);
    CHECK(std::fabs(late->position.y() / (-1e6 * terminal) - 1) < 1e-4);
    CHECK_THROWS_WITH(quadraticDragFlight({1, 1}, -1, {}), containsText("time: -1 is not within"));
    CHECK_THROWS_WITH(quadraticDragApex({1, 1}, {.coefficient = -1}), containsText("QuadraticDrag.coefficient: -1"));
    CHECK_THROWS_WITH(quadraticDragLanding({INFINITY, 1}, 0, {}), containsText("velocity"));
}
