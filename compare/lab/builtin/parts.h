// SPDX-License-Identifier: MIT
// Which functions do several labs share?
#pragma once
#include <vector>

#include <compare/lab/lab.h>

namespace plumb::compare {

/// The engine with one sub-step. An engine without sub-steps is returned as it is.
Engine withOneSubStep(const Engine& engine);

/// count values from low to high; each is the same multiple of the one before.
std::vector<double> geometricSteps(double low, double high, int count);

}  // namespace plumb::compare
