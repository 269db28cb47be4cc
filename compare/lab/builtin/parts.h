// SPDX-License-Identifier: MIT
// What do many labs have in common?
#pragma once
#include <vector>

#include <compare/lab/lab.h>

namespace plumb::compare {

/// One that has no sub-steps is returned as it is.
Engine withOneSubStep(const Engine& engine);

/// count values from low to high, each the same multiple of the one before.
std::vector<double> geometricSteps(double low, double high, int count);

}  // namespace plumb::compare
