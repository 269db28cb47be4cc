// SPDX-License-Identifier: MIT
// When do two flying shapes meet?
#pragma once
#include <optional>

#include <plumb/collide/distance.h>
#include <plumb/dynamics/bodies/free_motion.h>

namespace plumb {

/// A shape on a body in free flight.
struct FlyingShape {
    const Shape* shape = nullptr;
    Vec2 localCenter{0, 0};     ///< of the body's mass, in its frame [m]
    double boundingRadius = 0;  ///< farthest point of the body from its centre of mass [m]
    BodyMotion from;            ///< at time
    double time = 0;            ///< [s]
    FlightLaw law;
};

/// How two flying shapes stand to each other at a time.
struct Encounter {
    Distance distance;
    BodyMotion a, b;
    double closingSpeed = 0;  ///< of their nearest points along the normal, positive when they approach [m/s]
};
Encounter encounterAt(const FlyingShape& a, const FlyingShape& b, double time);

/// The first time in [from, to] at which the shapes touch while they approach, to rounding; empty when there is none.
/// A touch that goes less deep than a hundredth of their thickness before they part may be passed over. Of two that
/// spin so fast that the search takes too long, a time until which they do not meet. Conservative advancement in the
/// frame of the larger one, with the bound of collide/sweep.h and what the accelerations add to it; near a contact
/// Newton's method, held in a bracket. Source: Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996,
/// section 2.3.
std::optional<double> timeOfImpact(const FlyingShape& a, const FlyingShape& b, double from, double to);

}  // namespace plumb
