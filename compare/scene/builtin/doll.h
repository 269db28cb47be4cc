// SPDX-License-Identifier: MIT
// How is a doll of ten parts put together?
#pragma once
#include <string>

#include <compare/scene/scene.h>

namespace plumb::compare {

/// In an upright doll, the toes are 1.4 m below the neck and the top of the head 0.36 m above it; 65 kg.
struct Doll {
    std::string name{};  ///< put before the names of its parts
    Vec2 neck{0, 1.4};   ///< [m]
    double angle = 0;    ///< turned about its neck by this [rad]
    Vec2 velocity{0, 0};
    int group = 1;  ///< > 0: its parts pass through each other and through other dolls of this group
};

/// Adds a torso, a head and four limbs of two parts. Each part except the torso has a hinge with limits,
/// "<part>_joint".
void addDoll(Scene& scene, const Doll& doll);

}  // namespace plumb::compare
