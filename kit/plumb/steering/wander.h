// SPDX-License-Identifier: MIT
// How does an agent wander randomly, and yet reproducibly?
#pragma once
#include <plumb/math/random.h>
#include <plumb/steering/agent.h>

namespace plumb {

struct WanderSettings {
    double ahead = 2;   ///< distance of the circle's centre, more than its radius, so that the agent moves forward [m]
    double radius = 1;  ///< of the circle on which the target moves, > 0: larger gives sharper turns [m]
    double jitter = 2;  ///< standard deviation of the target's angle after one second, >= 0 [rad]
};

/// The state of the random walk: pass it to the next call.
struct WanderState {
    Random random;     ///< the same seed gives the same path
    double angle = 0;  ///< of the target on the circle, relative to the heading [rad]
};

struct WanderStep {
    Vec2 acceleration{0, 0};  ///< [m/s^2]
    WanderState state;        ///< for the next call
};

/// Seeks a target on a circle ahead of it, whose angle changes randomly: by sqrt(dt) jitter (root mean square), so that
/// the motion is statistically the same at any frame rate. Source: Reynolds 1999, "Wander". Throws
/// std::invalid_argument on settings that are not as above and a dt that is negative or not finite. Tests: "who wanders
/// keeps to 85 % of the speed or more, and goes the same way for the same seed", "who wanders strays alike at 30 and at
/// 240 Hz"
WanderStep wander(const Agent& agent, const WanderState& state, double dt, const WanderSettings& settings = {});

}  // namespace plumb
