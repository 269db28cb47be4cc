// SPDX-License-Identifier: MIT
// What does a broad phase look at? Many boxes on a plane, lying evenly, or half of them in a heap and of many sizes.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include <compare/scene/scene.h>
#include <plumb/math/random.h>
#include <plumb/shapes/aabb.h>

namespace plumb::compare {

/// Boxes of 1 m at random places, with 4 m^2 for each.
std::vector<Aabb> evenBoxes(int n, Random& random);

/// On the same plane every second box lies in a heap that is a fifth as wide. Sides are from 0.2 to 5 m long, most of
/// them short: 0.2 m / (1 - 0.96 u), with u uniform from 0 to 1.
std::vector<Aabb> unevenBoxes(int n, Random& random);

/// "even_200" or "uneven_200": as many such boxes, which drift through each other. None for another name, and for fewer
/// than 2 or more than 5,000.
std::optional<Scene> crowdScene(const std::string& name);

}  // namespace plumb::compare
