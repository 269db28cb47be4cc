// SPDX-License-Identifier: MIT
// What holds a body, what pulls at it, and how does it hang?
#pragma once
#include <string>
#include <vector>

#include <compare/scene/joint_geometry.h>
#include <compare/scene/scene.h>
#include <plumb/shapes/mass.h>

namespace plumb::compare {

/// A body of the scene with the values that a formula needs.
struct HeldBody {
    const SceneBody* scene = nullptr;
    std::size_t index = 0;
    Mass mass{};
    Vec2 center{0, 0};   ///< centre of mass at the start [m]
    Vec2 gravity{0, 0};  ///< acceleration in free fall [m/s^2]
};

/// Throws Unsupported for a body that is not dynamic, is locked, damped or disabled, or has a field acting on it other
/// than the named one.
HeldBody heldBodyOf(const Scene& scene, const std::string& body, const std::string& field = "");

/// One end of a joint to a body that does not move.
struct Holding {
    std::size_t joint = 0;  ///< place in the scene
    Vec2 fixed{0, 0};       ///< the fixed end, in the world [m]
    Vec2 held{0, 0};        ///< the point where it holds the body, at the start [m]
};

/// All of the scene's joints that hold the body, in their order. Throws Unsupported if the other body of a joint can
/// move.
std::vector<Holding> holdingsOf(const Scene& scene, const HeldBody& body);

/// g, straight down. Throws Unsupported if gravity is not straight down or not > 0.
double downwardGravity(const HeldBody& body);

struct Hung {
    HeldBody body{};
    Vec2 pivot{0, 0};       ///< the point about which its origin swings [m]
    double length = 0;      ///< from there to its origin [m]
    double equivalent = 0;  ///< L = I_pivot / (m l) [m]
    double gravity = 0;     ///< downward [m/s^2]
    double angle = 0;       ///< from straight down, at the start [rad]
    bool turns = false;     ///< it turns with the angle: true on a hinge, false on rods
};

/// It hangs by a hinge, or by a rod and the rods parallel to it. Throws Unsupported if another joint holds it too.
Hung hungOf(const Scene& scene, const std::string& body, const std::string& joint);

}  // namespace plumb::compare
