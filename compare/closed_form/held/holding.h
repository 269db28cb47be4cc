// SPDX-License-Identifier: MIT
// What holds a body, and what pulls at it?
#pragma once
#include <string>
#include <vector>

#include <compare/engine/joint_geometry.h>
#include <compare/scene/scene.h>
#include <plumb/shapes/mass.h>

namespace plumb::compare {

/// A body of the scene with what a formula needs of it.
struct HeldBody {
    const SceneBody* scene = nullptr;
    std::size_t index = 0;
    Mass mass{};
    Vec2 center{0, 0};   ///< of mass, at the start [m]
    Vec2 gravity{0, 0};  ///< what it would fall at [m/s^2]
};

/// Throws Unsupported for one that is not dynamic, is locked, damped or disabled, or that a field acts on beside the
/// one that is named.
HeldBody heldBodyOf(const Scene& scene, const std::string& body, const std::string& field = "");

/// One end of a joint to a body that stays.
struct Holding {
    std::size_t joint = 0;  ///< place in the scene
    Vec2 fixed{0, 0};       ///< where it is held, in the world [m]
    Vec2 held{0, 0};        ///< where it holds the body, at the start [m]
};

/// By all of the scene's joints that hold the body, in their order. Throws Unsupported where the other body of one does
/// not stay where it is.
std::vector<Holding> holdingsOf(const Scene& scene, const HeldBody& body);

/// g, straight down. Throws Unsupported where it is not, or is not > 0.
double downwardGravity(const HeldBody& body);

}  // namespace plumb::compare
