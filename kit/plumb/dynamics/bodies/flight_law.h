// SPDX-License-Identifier: MIT
// How does a body move through a step in which nothing touches it?
#pragma once
#include <cstdint>

#include <plumb/math/vec2.h>

namespace plumb {

using BodyIndex = std::uint32_t;
inline constexpr BodyIndex noBody = 0;  ///< slot 0 stands for whatever nothing can move
inline constexpr std::uint32_t none = ~std::uint32_t{0};

/// Of a body's centre of mass and its angle over a step [m/s^2, rad/s^2].
struct Acceleration {
    Vec2 linear{0, 0};
    double angular = 0;
};

/// What does not change in a step of free motion.
struct FlightLaw {
    Acceleration acceleration;
    double linearDamping = 0, angularDamping = 0;  ///< [1/s]
};

/// Of a velocity and an angular velocity.
struct VelocityChange {
    Vec2 velocity{0, 0};  ///< [m/s]
    double spin = 0;      ///< [rad/s]
    VelocityChange& operator+=(const VelocityChange& other) {
        velocity += other.velocity;
        spin += other.spin;
        return *this;
    }
};

/// How a body that feels fields moves through the step, or what is left of it, unless something touches it.
struct PredictedFlight {
    BodyIndex body = noBody;
    bool steady = false;  ///< what acts on it is the same wherever it is: its law is exact, and nothing is left over
    FlightLaw law;        ///< a closed form that comes to where it will be
    VelocityChange rest;  ///< what its velocity will be beyond what that says
};

}  // namespace plumb
