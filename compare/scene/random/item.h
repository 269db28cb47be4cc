// SPDX-License-Identifier: MIT
// What is put into a random scene as one piece, a body or a machine of several bodies?
#pragma once
#include <vector>

#include <compare/scene/scene.h>

namespace plumb::compare {

/// The name of the static body of each random scene. Machines may hang on it.
inline constexpr const char* worldName = "world";

/// Bodies and joints around an origin. Names are unique within the item; worldName is the scene's static body.
struct Item {
    std::vector<SceneBody> bodies{};
    std::vector<SceneJoint> joints{};
    Vec2 half{0, 0};  ///< half of the width and the height that it takes at the start [m]
};

/// The same item, turned around its origin. Its half sizes must be large enough for the turned item.
Item turned(Item item, double angle);

/// Adds the item with its origin at a point. A single body is called body_<its place>. A body of a machine has its own
/// name after that.
void addItem(Scene& scene, const Item& item, const Vec2& origin);

}  // namespace plumb::compare
