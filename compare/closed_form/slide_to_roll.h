// SPDX-License-Identifier: MIT
// How does a round thing go on that is thrown along a floor without turning?
#pragma once
#include <vector>

#include <compare/scene/closed_form.h>

namespace plumb::compare {

struct ThrownDisc {
    Vec2 position{0, 0};        ///< of its centre at t = 0, touching the floor [m]
    double speed = 3;           ///< to +x at t = 0, >= 0 [m/s]
    double radius = 0.5;        ///< [m]
    double friction = 0.2;      ///< [-]
    double inertiaRatio = 0.5;  ///< k = I / (m r^2) [-]
    double gravity = 9.81;      ///< [m/s^2]
};

/// First v = v0 - mu g t and w = -mu g t / (k r); from t = v0 k / ((1 + k) mu g) on it rolls at v0 / (1 + k).
/// v speed [m/s], w angular velocity [rad/s], mu friction [-], r radius [m], g gravity [m/s^2]
/// Source: Coriolis 1835; N = m g, and slip v + w r falls by mu g (1 + 1 / k) t. Exact.
/// Test: "a disc thrown at 3 m/s with a friction of 0.2 rolls at 2 m/s after 0.5096839959 s and 1.2742099898 m"
std::vector<Flight> slideToRollFlights(const ThrownDisc& disc);

}  // namespace plumb::compare
