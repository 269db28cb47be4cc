// SPDX-License-Identifier: MIT
// Which scenes have a known reason for two engines to part?
#pragma once
#include <string>
#include <vector>

#include <compare/parting/parting.h>

namespace plumb::compare {

/// What the sentence has to tell.
struct Planted {
    std::string engineA{}, engineB{};
    Scene scene{};
    Difference quantity{};
    std::string body{};
    std::string at{};
    double earliest = 0, latest = 0;  ///< when it parts [s]
};

/// A hinge that stretches, a restitution threshold, a snag, tunnelling, a sinking stack; and by settings for one engine
/// alone another mass, friction, damping, number of sub-steps, speed limit, gravity, spring, motor, hook, lift and
/// ramp. And two ways of stepping: of a spring, and of a throw; and a bounce beside
/// such a difference.
std::vector<Planted> plantedScenes();

}  // namespace plumb::compare
