// SPDX-License-Identifier: MIT
// What do many labs have in common?
#pragma once
#include <string>
#include <vector>

#include <compare/lab/lab.h>

namespace plumb::compare {

/// As a person calls the engine: "Box2D 2.4" for "box2d-2.4", "Box2D 3 with bullets" for "box2d-3 bullets".
std::string engineLabel(const std::string& name);

/// count values from low to high, each the same multiple of the one before.
std::vector<double> geometricSteps(double low, double high, int count);

}  // namespace plumb::compare
