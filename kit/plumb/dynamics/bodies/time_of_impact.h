// SPDX-License-Identifier: MIT
// When do two shapes in free motion meet?
#pragma once
#include <optional>

#include <plumb/collide/distance.h>
#include <plumb/dynamics/bodies/free_motion.h>

namespace plumb {

/// A shape on a body in free motion.
struct MovingShape {
    const Shape* shape = nullptr;
    Vec2 localCenter{0, 0};     ///< the body's centre of mass, in its frame [m]
    double boundingRadius = 0;  ///< distance of the body's farthest point from its centre of mass [m]
    BodyMotion from;            ///< the body's state at the given time
    double time = 0;            ///< [s]
    FlightLaw law;
};

/// The disc of a shape whose centre is the body's centre of mass; null for other shapes.
const Circle* discOf(const MovingShape& s);

/// Two moving shapes at one time: their distance, their states and how fast they approach.
struct Encounter {
    Distance distance;
    BodyMotion a, b;
    double closingSpeed = 0;  ///< of the nearest points along the normal, positive if they approach [m/s]
};
Encounter encounterAt(const MovingShape& a, const MovingShape& b, double time);

/// The first time in [from, to] at which the shapes touch while they approach, exact to rounding; empty if there is
/// none. The search may miss a touch that is less deep than a hundredth of the shapes' thickness before they part. If
/// the shapes spin so fast that the search needs too many steps, the result is a time before which they do not meet.
/// Method: for two discs that fall alike, a quadratic equation; else conservative advancement in the frame of the
/// larger body, with the bound of collide/sweep.h, extended by the accelerations; near a contact, Newton's method, kept
/// in a bracket. Source: Mirtich, "Impulse-based dynamic simulation of rigid body systems", 1996, section 2.3.
std::optional<double> timeOfImpact(const MovingShape& a, const MovingShape& b, double from, double to);

}  // namespace plumb
