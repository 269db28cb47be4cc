// SPDX-License-Identifier: MIT
// How many problems of aiming are solved a second? ./tests/run "[!benchmark]"; one over the mean is the answer.
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
#include <plumb/ballistics/quadratic_drag_aim.h>
#include <plumb/ballistics/range.h>
#include <plumb/math/random.h>

#include "catch.h"

namespace {

using namespace plumb;

/// A thousand targets 5 to 35 m away, most of them in reach of 20 m/s; by turns.
class Targets {
public:
    Targets() {
        Random random(1);
        for (int i = 0; i < 1000; ++i) targets_.push_back({random.uniform(5, 30), random.uniform(-15, 15)});
    }
    const Vec2& next() {
        at_ = (at_ + 1) % targets_.size();
        return targets_[at_];
    }

private:
    std::vector<Vec2> targets_;
    std::size_t at_ = 0;
};

}  // namespace

TEST_CASE("shots solved a second", "[.][!benchmark][shots]") {
    Targets targets;
    BENCHMARK("fixed speed, both arcs") {
        return aim({.target = targets.next(), .speed = 20});
    };
    BENCHMARK("fixed angle") {
        return aimAtAngle({.target = targets.next(), .angle = 1});
    };
    BENCHMARK("fixed time") {
        return aimInTime({.target = targets.next(), .time = 2});
    };
    BENCHMARK("least speed") {
        return aimSlowest({.target = targets.next()});
    };
    BENCHMARK("greatest range") {
        return greatestRange({.speed = 20, .height = targets.next().x()});
    };
    BENCHMARK("given apex") {
        return aimByApex({.target = targets.next(), .apex = 16});
    };
    BENCHMARK("moving target, all shots") {
        return aimAtMoving({.target = targets.next(), .targetVelocity = {-4, 3}, .speed = 20});
    };
    BENCHMARK("beam at a moving target") {
        return aimBeam({.target = targets.next(), .targetVelocity = {-4, 3}, .speed = 20});
    };
    BENCHMARK("over a wall") {
        return aimOver({.target = targets.next(), .walls = {{4, 3}}, .speed = 20});
    };
    BENCHMARK("over a wall, least speed") {
        return aimSlowestOver({.target = targets.next(), .walls = {{4, 3}}});
    };
    BENCHMARK("linear drag and wind, both arcs") {
        return aimThroughLinearDrag({.target = targets.next(), .speed = 20, .drag = {.rate = 0.2, .wind = {-5, 0}}});
    };
    BENCHMARK("linear drag and wind, fixed time") {
        return aimThroughLinearDragInTime(
            {.target = targets.next(), .time = 2, .drag = {.rate = 0.2, .wind = {-5, 0}}});
    };
    BENCHMARK("quadratic drag, both arcs") {
        return aimThroughQuadraticDrag({.target = targets.next(), .speed = 20, .coefficient = 0.005});
    };
}
