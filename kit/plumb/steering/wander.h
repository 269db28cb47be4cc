// SPDX-License-Identifier: MIT
// How does one stroll about without an aim, and yet the same way each time?
#pragma once
#include <plumb/math/random.h>
#include <plumb/steering/agent.h>

namespace plumb {

struct WanderSettings {
    double ahead = 2;   ///< of the circle's centre, more than its radius, so that it goes on [m]
    double radius = 1;  ///< of the circle on which the target moves, > 0: the wider, the sharper it turns [m]
    double jitter = 2;  ///< how far the target turns on the circle, in the mean of a second, >= 0 [rad]
};

/// What it goes on from: keep it, and give it back the next time.
struct WanderState {
    Random random;     ///< of the same seed, the same way
    double angle = 0;  ///< of the target on the circle, against the heading [rad]
};

struct WanderStep {
    Vec2 acceleration{0, 0};  ///< [m/s^2]
    WanderState state;        ///< for the next time
};

/// Seeks a target on a circle ahead of it, that is turned by chance: by sqrt(dt) jitter in the mean of squares, so
/// that it strolls alike at any frame rate. Source: Reynolds 1999, "Wander". Throws std::invalid_argument on
/// settings that are not as above and a dt that is negative or not finite. Tests: "who wanders keeps to 85 % of
/// the speed or more, and goes the same way for the same seed", "who wanders strays alike at 30 and at 240 Hz"
WanderStep wander(const Agent& agent, const WanderState& state, double dt, const WanderSettings& settings = {});

}  // namespace plumb
