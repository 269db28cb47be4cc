// SPDX-License-Identifier: MIT
// Where did the time of a step go?
#pragma once

namespace plumb {

/// Time of the last step, by phase [s].
struct StepProfile {
    double pairs = 0;    ///< finding shapes that have come near each other
    double collide = 0;  ///< finding where near shapes touch, and preparing the solver's data
    double impacts = 0;  ///< single bounces, at their exact times
    double solve = 0;    ///< contacts and joints
    double finish = 0;   ///< new positions, fast bodies, events, sleep
    double total = 0;
};

}  // namespace plumb
