// SPDX-License-Identifier: MIT
#include <array>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include <plumb/ballistics/apex.h>
#include <plumb/ballistics/beam.h>
#include <plumb/ballistics/fixed_angle.h>
#include <plumb/ballistics/fixed_speed.h>
#include <plumb/ballistics/fixed_time.h>
#include <plumb/ballistics/least_speed.h>
#include <plumb/ballistics/linear_drag_aim.h>
#include <plumb/ballistics/moving_target.h>
#include <plumb/ballistics/obstacle.h>
#include <plumb/ballistics/quadratic_drag.h>
#include <plumb/ballistics/quadratic_drag_aim.h>
#include <plumb/ballistics/range.h>

#include "cases.h"
#include "catch.h"
#include "kit/ballistics/shots.h"

namespace {

using namespace plumb;
using namespace plumb::test;

/// What was asked, what was refused, and what came back as no number.
struct Tally {
    int answers = 0, refusals = 0, bad = 0;
    void see(double value) { bad += !std::isfinite(value); }
    void see(const Vec2& value) { bad += !value.allFinite(); }
    void see(const Shot& shot) {
        see(shot.velocity);
        bad += !(shot.time >= 0 && std::isfinite(shot.time));
    }
    void see(const PathPoint& point) {
        see(point.position);
        see(point.time);
    }
    void see(const GreatestRange& range) {
        see(range.range);
        see(range.shot);
    }
    template <typename Part>
    void see(const std::vector<Part>& parts) {
        for (const Part& part : parts) see(part);
    }
    template <typename Part>
    void see(const std::optional<Part>& part) {
        if (part) see(*part);
    }
    template <typename Ask>
    void ask(const Ask& answer) {
        try {
            see(answer());
            ++answers;
        } catch (const std::invalid_argument&) {
            ++refusals;
        }
    }
};

/// Mostly what any number may be, at times what none may.
class Extremes {
public:
    explicit Extremes(std::uint64_t seed) : random_(seed) {}
    double amount() {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        constexpr std::array<double, 20> values = {0,     5e-324, 1e-310, 1e-200, 1e-160, 1e-100,  1e-50,
                                                   1e-20, 1e-8,   0.1,    1,      2,      9.81,    1e3,
                                                   1e8,   1e20,   1e50,   1e51,   1e300,  infinity};
        const double value = values[static_cast<std::size_t>(random_.integer(0, random_.integer(0, 9) == 0 ? 19 : 16))];
        return random_.integer(0, 200) == 0 ? std::numeric_limits<double>::quiet_NaN() : value;
    }
    double number() { return random_.integer(0, 1) == 0 ? amount() : -amount(); }
    Vec2 vector() {
        const double x = number();
        return {x, random_.integer(0, 3) == 0 ? x : number()};
    }

private:
    Random random_;
};

}  // namespace

TEST_CASE("nothing, next to nothing, huge numbers and what is no number are answered or refused 50,000 times",
          "[ballistics]") {
    Extremes any(211);
    Tally tally;
    for (int i = 0; i < cases(50'000); ++i) {
        const Vec2 target = any.vector(), gravity = any.vector(), wind = any.vector(), velocity = any.vector();
        const double speed = any.amount(), other = any.number(), amount = any.amount();
        const LinearDrag drag{amount, wind, gravity};
        tally.ask([&] { return aim({target, speed, gravity}); });
        tally.ask([&] { return aimAtAngle({target, other, gravity}); });
        tally.ask([&] { return aimInTime({target, amount, gravity}); });
        tally.ask([&] { return aimSlowest({target, gravity}); });
        tally.ask([&] { return aimByApex({target, amount, gravity}); });
        tally.ask([&] { return apexOf({velocity, other, gravity}); });
        tally.ask([&] { return landingOf({velocity, other, gravity}); });
        tally.ask([&] { return greatestRange({speed, other, gravity}); });
        tally.ask([&] { return aimAtMoving({target, velocity, wind, speed, gravity}); });
        tally.ask([&] { return aimBeam({target, velocity, wind, speed}); });
        tally.ask([&] { return aimOver({target, {velocity, wind}, amount, speed, gravity}); });
        tally.ask([&] { return aimSlowestOver({target, {velocity, wind}, amount, speed, gravity}); });
        tally.ask([&] { return linearDragApex(velocity, drag); });
        tally.ask([&] { return linearDragLanding(velocity, other, drag); });
        tally.ask([&] { return aimThroughLinearDrag({target, speed, drag}); });
        tally.ask([&] { return aimThroughLinearDragInTime({target, speed, drag}); });
        tally.ask([&] { return aimThroughQuadraticDrag({target, speed, amount, gravity}); });
        tally.ask([&] { return shootUp(speed, {amount, std::fabs(other)}).height; });
        tally.ask([&] { return shootUp(speed, {amount, std::fabs(other)}).fallTime; });
        tally.ask([&] { return fallFor(speed, {amount, std::fabs(other)}).distance; });
    }
    std::cout << "extremes: " << tally.answers << " answered, " << tally.refusals << " refused\n";
    CHECK(tally.bad == 0);
    CHECK(tally.answers > 5 * cases(50'000));
    CHECK(tally.refusals > cases(50'000));
}

TEST_CASE("tiny targets, speeds and gravity are aimed at as their large likes are", "[ballistics]") {
    // The case of the worked numbers of the firing solution, with lengths in units of 1e-30 to 1e30 m and times in
    // units of 1e-8 to 1e8 s.
    const std::vector<Shot> plain = aim({.target = {30, 5}, .speed = 20});
    for (const double metre : {1e-30, 1e-10, 1.0, 1e10, 1e30})
        for (const double second : {1e-8, 1.0, 1e8}) {
            const double speed = metre / second;
            const std::vector<Shot> shots =
                aim({.target = Vec2(30, 5) * metre, .speed = 20 * speed, .gravity = {0, -9.81 * speed / second}});
            REQUIRE(shots.size() == 2);
            for (std::size_t k = 0; k < 2; ++k) {
                CHECK(std::fabs(shots[k].time / second / plain[k].time - 1) < 1e-14);
                CHECK((shots[k].velocity / speed - plain[k].velocity).norm() < 1e-12);
            }
        }
}
