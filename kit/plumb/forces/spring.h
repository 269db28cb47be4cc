// SPDX-License-Identifier: MIT
// Which force do a spring and a damper exert at their ends?
#pragma once
#include <plumb/math/vec2.h>

namespace plumb {

struct SpringDamper {
    double stiffness = 100;  ///< k, >= 0 [N/m]
    double damping = 0;      ///< c, along the spring, >= 0 [N s/m]
    double restLength = 0;   ///< L, >= 0 [m]
};

/// An end of a spring; by default, one that is fixed at the origin.
struct SpringEnd {
    Vec2 position{0, 0};  ///< [m]
    Vec2 velocity{0, 0};  ///< [m/s]
};

/// The force on B; A has the opposite one:  F = -(k (d - L) + c (vB - vA) . n) n [N]
/// d distance [m], n unit vector from A to B [-]. Two ends at the same position have no direction: the force is 0.
/// Source: Hooke, "De potentia restitutiva", 1678. Throws std::invalid_argument on a stiffness, damping or length
/// that is negative or not finite. Tests: "a mass on a spring is back after 2 pi sqrt(m / k)",
///        "a mass of 1 kg on 4 N/m with 0.4 N s/m is at -0.2580702634 m after 1 s"
Vec2 springForce(const SpringDamper& spring, const SpringEnd& a, const SpringEnd& b);

/// U = k (d - L)^2 / 2 [J]. Test: "the slope of every potential energy is its force, in 100,000 places each"
double potentialEnergy(const SpringDamper& spring, const Vec2& a, const Vec2& b);

/// The power that the damper dissipates [W]: c ((vB - vA) . n)^2.
double dampingPower(const SpringDamper& spring, const SpringEnd& a, const SpringEnd& b);

}  // namespace plumb
