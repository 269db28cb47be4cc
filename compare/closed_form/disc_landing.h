// SPDX-License-Identifier: MIT
// How does a spinning disc go on that is dropped on a rough floor?
#pragma once
#include <vector>

#include <compare/scene/closed_form.h>

namespace plumb::compare {

struct DroppedDisc {
    Vec2 rest{0, 0};             ///< where its centre would first touch the floor, straight below its start [m]
    double height = 1;           ///< from which it is dropped, above rest [m]
    double speed = 0;            ///< to +x at t = 0 [m/s]
    double angularVelocity = 0;  ///< at t = 0 [rad/s]
    double radius = 0.5;         ///< [m]
    double inertiaRatio = 0.5;   ///< k = I / (m r^2) [-]
    double friction = 0.5;       ///< mu [-]
    double restitution = 0.5;    ///< e, 0 to 1 [-]
    double gravity = 9.81;       ///< [m/s^2]
    int landings = 2;            ///< how many are told: one flight more [-]
};

/// At each landing vn' = e vn, j = (1 + e) vn, slip s = vx + w r; vx' = vx + f, w' = w + f / (k r)
///   f = -s k / (1 + k) where that is at most mu j: it sticks, s' = 0; else mu j against the slip.
/// vn speed into the floor [m/s], j and f impulses over the mass [m/s], w angular velocity [rad/s], r radius [m]
/// Source: Routh, "Dynamics of a System of Rigid Bodies", part 1, 1905, ch. 5; Newton's and Coulomb's laws. Exact.
/// Test: "a disc that lands at (4, -3) m/s with e = 0.5 sticks from a friction of 8/27 on"
std::vector<Flight> landingFlights(const DroppedDisc& disc);

}  // namespace plumb::compare
