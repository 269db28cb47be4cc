// SPDX-License-Identifier: MIT
// Which motions have a closed form with which a method can be compared at any time?
#pragma once
#include <functional>
#include <string>

#include <plumb/integrate/symplectic.h>
#include <plumb/math/vec2.h>

namespace plumb::compare {

using Motion = plumb::Phase<Vec2>;  ///< position [m], velocity [m/s]

/// x'' = acceleration(x).
struct MotionProblem {
    std::string name{};
    std::function<Vec2(const Vec2& position)> acceleration{};
    Motion start{};
    std::function<double(const Motion&)> energy{};    ///< of 1 kg, constant [J]
    std::function<Vec2(double time)> truePosition{};  ///< [m]
    double period = 0;                                ///< [s]
};

/// x'' = -x, from 1 m at rest: x = cos t.
MotionProblem oscillator();

/// x'' = -x / |x|^3 about the origin. It starts at the nearest point (1 - e, 0); semi-major axis 1 m, period 2 pi s.
/// The closed form is keplerState (compare/formula/kepler.h). e: eccentricity, from 0 to below 1 [-].
/// Test: "the true paths obey their accelerations, start where they should, and keep their energy"
MotionProblem keplerOrbit(double eccentricity);

}  // namespace plumb::compare
