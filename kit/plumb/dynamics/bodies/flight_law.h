// SPDX-License-Identifier: MIT
// How does a body move through a step in which nothing touches it?
#pragma once
#include <cstdint>

#include <plumb/math/vec2.h>

namespace plumb {

using BodyIndex = std::uint32_t;
inline constexpr BodyIndex noBody = 0;  ///< slot 0 stands for everything that cannot be moved
inline constexpr std::uint32_t none = ~std::uint32_t{0};

/// Acceleration of a body's centre of mass, and its angular acceleration, during a step [m/s^2, rad/s^2].
struct Acceleration {
    Vec2 linear{0, 0};
    double angular = 0;
};

/// The constants of a body's free motion during a step: acceleration and damping.
struct FlightLaw {
    Acceleration acceleration;
    double linearDamping = 0, angularDamping = 0;  ///< [1/s]
};

/// A change of a body's velocity and angular velocity.
struct VelocityChange {
    Vec2 velocity{0, 0};  ///< [m/s]
    double spin = 0;      ///< [rad/s]
    VelocityChange& operator+=(const VelocityChange& other) {
        velocity += other.velocity;
        spin += other.spin;
        return *this;
    }
};

/// How a body on which fields act will move through the step, or through the rest of it, if nothing touches it.
struct PredictedFlight {
    BodyIndex body = noBody;
    bool steady = false;  ///< the fields are the same everywhere on its path: the law is exact, and rest is zero
    FlightLaw law;        ///< a closed form that leads to the body's predicted place
    VelocityChange rest;  ///< predicted velocity minus the one that the law gives at the end
};

}  // namespace plumb
