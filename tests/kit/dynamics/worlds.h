// SPDX-License-Identifier: MIT
// Which world do many tests begin with, and how does it come so many steps, or seconds, further?
#pragma once
#include <cmath>

#include <plumb/dynamics/world.h>

#include "kit/usual_world.h"

namespace plumb::test {

inline World weightless() {
    return World({.gravity = {0, 0}});
}

inline void steps(World& world, int count) {
    for (int i = 0; i < count; ++i) world.step(dt);
}

inline void run(World& world, double seconds, double step = dt) {
    for (long tick = std::lround(seconds / step); tick > 0; --tick) world.step(step);
}

}  // namespace plumb::test
