// SPDX-License-Identifier: MIT
// Which motions have a closed form that a method can be held against at any time?
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

/// x = cos t: x'' = -x, from 1 m at rest.
MotionProblem oscillator();

/// x'' = -x / |x|^3 about the origin, semi-major axis 1 m, period 2 pi s, from the nearest point (1 - e, 0) on.
/// x = (cos E - e, sqrt(1 - e^2) sin E), with the eccentric anomaly E [rad] from Kepler's E - e sin E = t.
/// e eccentricity, 0 to below 1 [-]. Source: textbook. Test: "Kepler's orbit closes, keeps its energy, and sweeps ..."
MotionProblem keplerOrbit(double eccentricity);

}  // namespace plumb::compare
