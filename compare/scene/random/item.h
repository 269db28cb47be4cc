// SPDX-License-Identifier: MIT
// What is put into a random scene as one piece: a body, or a machine of several?
#pragma once
#include <vector>

#include <compare/scene/scene.h>

namespace plumb::compare {

/// The static body of each random scene that machines may hang on.
inline constexpr const char* worldName = "world";

/// Around its own origin; names are unique in it, and worldName is the scene's.
struct Item {
    std::vector<SceneBody> bodies{};
    std::vector<SceneJoint> joints{};
    Vec2 half{0, 0};  ///< half of the width and the height that it takes at the start [m]
};

/// The same, turned around its origin. Its half sizes must allow for it.
Item turned(Item item, double angle);

/// Adds the item with its origin at a point. A body alone is called body_<its place>, one of a machine likewise and its
/// own name after it.
void addItem(Scene& scene, const Item& item, const Vec2& origin);

}  // namespace plumb::compare
