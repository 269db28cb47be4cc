// SPDX-License-Identifier: MIT
#include <compare/lab/builtin/orbits.h>

#include <algorithm>
#include <cmath>

#include "catch.h"

namespace plumb::compare {
namespace {

/// Of the true path, by differences over 2 s [m/s, m/s^2].
Vec2 slopeOf(const MotionProblem& problem, double time, double s) {
    return (problem.truePosition(time + s) - problem.truePosition(time - s)) / (2 * s);
}
Vec2 bendOf(const MotionProblem& problem, double time, double s) {
    return (problem.truePosition(time + s) - 2 * problem.truePosition(time) + problem.truePosition(time - s)) / (s * s);
}

}  // namespace

TEST_CASE("the true paths obey their accelerations, start where they should, and keep their energy", "[compare][lab]") {
    for (const MotionProblem& problem : {oscillator(), keplerOrbit(0.5)}) {
        INFO(problem.name);
        CHECK((problem.truePosition(0) - problem.start.position).norm() < 1e-15);
        CHECK((problem.truePosition(problem.period) - problem.start.position).norm() < 1e-12);
        const double energy = problem.energy(problem.start);
        double worstForce = 0, worstEnergy = 0;
        for (double time = 0; time < 2 * problem.period; time += 0.01) {
            const Vec2 place = problem.truePosition(time);
            const Vec2 off = bendOf(problem, time, 1e-3) - problem.acceleration(place);
            worstForce = std::max(worstForce, off.norm());
            const double now = problem.energy({place, slopeOf(problem, time, 1e-4)});
            worstEnergy = std::max(worstEnergy, std::fabs(now - energy));
        }
        // s^2 / 12 times the fourth derivative, at the near end of the orbit 300 m/s^4, and rounding, 1e-15 m / s^2.
        CHECK(worstForce < 1e-4);
        // s^2 / 6 times the third derivative, there 30 m/s^3, at 1.7 m/s.
        CHECK(worstEnergy < 2e-7);
    }
}

}  // namespace plumb::compare
