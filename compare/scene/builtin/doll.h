// SPDX-License-Identifier: MIT
// How is a doll of ten parts put together?
#pragma once
#include <string>

#include <compare/scene/scene.h>

namespace plumb::compare {

/// Upright its toes are 1.4 m below its neck and the top of its head 0.36 m above; 65 kg.
struct Doll {
    std::string name{};  ///< stands before the names of its parts
    Vec2 neck{0, 1.4};   ///< [m]
    double angle = 0;    ///< turned about its neck by this [rad]
    Vec2 velocity{0, 0};
    int group = 1;  ///< > 0: its parts pass each other, and those of other dolls of this group
};

/// Adds a torso, a head and four limbs of two parts, and a hinge with limits, "<part>_joint", over each but the torso.
void addDoll(Scene& scene, const Doll& doll);

}  // namespace plumb::compare
