// SPDX-License-Identifier: MIT
// Where did the time of a step go?
#pragma once

namespace plumb {

/// Time of the last step, by phase [s].
struct StepProfile {
    double pairs = 0;    ///< which shapes have come near each other
    double collide = 0;  ///< where near shapes touch, and what the solver needs to know of it
    double impacts = 0;  ///< single bounces, at their time
    double solve = 0;    ///< contacts and joints
    double finish = 0;   ///< new places, fast bodies, events, sleep
    double total = 0;
};

}  // namespace plumb
