// SPDX-License-Identifier: MIT
// When do two frictionless discs meet, and how do they part?
#pragma once
#include <optional>
#include <vector>

#include <compare/scene/closed_form.h>

namespace plumb::compare {

/// A disc that flies on without a force.
struct FlyingDisc {
    Vec2 position{0, 0};  ///< at t = 0 [m]
    Vec2 velocity{0, 0};  ///< [m/s]
    double radius = 0.5;  ///< [m]
    double mass = 1;      ///< [kg]
};

/// The first t >= 0 at which |d + w t| = r: the lesser root of w.w t^2 + 2 d.w t + d.d - r^2 = 0.
/// d from A to B at t = 0 [m], w velocity of B seen from A [m/s], r sum of the radii [m]
/// Holds: the discs start apart. Empty when they miss or part.
std::optional<double> meetingTime(const FlyingDisc& a, const FlyingDisc& b);

struct DiscFlights {
    std::vector<Flight> a, b;  ///< before the impact and, where they meet, after it
};

/// j = (1 + e) v / (1 / mA + 1 / mB),  vA' = vA - j n / mA,  vB' = vB + j n / mB
/// n unit vector from A to B at the impact [-], v speed at which they approach along it [m/s], e restitution [-],
/// j impulse [N s], m masses [kg]
/// Source: Newton's law of impact, momentum along n; nothing acts across it. Exact.
/// Tests: "discs of 2 kg and 1 kg at 3 and -1 m/s part at 1/3 and 13/3 m/s when e = 1",
///        "equal discs that meet at 30 degrees part at right angles when e = 1"
DiscFlights collide(const FlyingDisc& a, const FlyingDisc& b, double restitution);

}  // namespace plumb::compare
